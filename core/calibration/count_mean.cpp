// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/count_mean.h"

#include <cmath>
#include <map>

#include "core/job/contract.h"

namespace noctule {
namespace {

constexpr double kLeastNoise_counts = 0.08, kMostNoise_counts = 0.8;  ///< above it rounding does no harm
constexpr double kMeanReach_counts = 0.8, kMeanStep_counts = 0.02;
constexpr int kNoiseSteps = 16;
constexpr double kMostLogSigma = 0.5;
constexpr size_t kWitnesses = 20;  ///< stretches that tell the noise: enough, and the time is bounded

/// One axis of one stretch.
struct AxisCounts {
    std::map<double, int> times;
    double mean = 0, deviation = 0;
    int count = 0;
    bool whole = true;

    double plainSigma() const { return deviation / std::sqrt(count); }
};

AxisCounts countsOfAxis(std::span<const CountReading> stretch, Vector3d CountReading::*sensor, int axis) {
    AxisCounts counts;
    counts.count = static_cast<int>(stretch.size());
    for (const CountReading& reading : stretch) {
        const double value = (reading.*sensor)[axis];
        counts.mean += value / counts.count;
        counts.whole = counts.whole && value == std::floor(value);
        ++counts.times[value];
    }
    for (const auto& [value, times] : counts.times)
        counts.deviation += times * (value - counts.mean) * (value - counts.mean);
    counts.deviation = std::sqrt(counts.deviation / counts.count);
    return counts;
}

double below(double count, double mean, double noise) {
    return 0.5 * std::erfc((mean - count) / (noise * std::numbers::sqrt2));
}

/// What the counts say about their true mean when the noise is known; the prior is flat.
struct MeanBelief {
    double mean = 0, sigma = 0, log_evidence = 0;
};

double logLikelihood(const AxisCounts& counts, double mean, double noise) {
    double sum = 0;
    for (const auto& [value, times] : counts.times) {
        const double share = below(value + 0.5, mean, noise) - below(value - 0.5, mean, noise);
        sum += times * std::log(std::max(share, 1e-12));  // an outlier must not decide alone
    }
    return sum;
}

MeanBelief believeMean(const AxisCounts& counts, double noise) {
    std::vector<double> logs;
    for (double off = -kMeanReach_counts; off <= kMeanReach_counts; off += kMeanStep_counts)
        logs.push_back(logLikelihood(counts, counts.mean + off, noise));
    const double most = *std::ranges::max_element(logs);
    double mass = 0, first = 0, second = 0;
    for (size_t i = 0; i < logs.size(); ++i) {
        const double weight = std::exp(logs[i] - most);
        const double off = -kMeanReach_counts + static_cast<double>(i) * kMeanStep_counts;
        mass += weight;
        first += weight * off;
        second += weight * off * off;
    }
    const double variance = std::max(0.0, second / mass - first / mass * first / mass);
    return {counts.mean + first / mass, std::max(std::sqrt(variance), kMeanStep_counts / 2),
            most + std::log(mass)};
}

/// The logarithm of the noise and how well it is known.
struct LogNoise {
    double value = 0, sigma = 0;
};

double evidenceOf(const std::vector<AxisCounts>& stretches, double log_noise) {
    double sum = 0;
    for (const AxisCounts& counts : stretches)
        sum += believeMean(counts, std::exp(log_noise)).log_evidence;
    return sum;
}

/// Where the evidence of all stretches together is greatest, by golden section; its curvature there.
LogNoise likeliestNoise(const std::vector<AxisCounts>& stretches) {
    constexpr double kGolden = 0.6180339887498949, kCurvatureStep = 0.05;
    double low = std::log(kLeastNoise_counts), high = std::log(kMostNoise_counts);
    double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    double at_left = evidenceOf(stretches, left), at_right = evidenceOf(stretches, right);
    for (int step = 0; step < kNoiseSteps; ++step) {
        if (at_left > at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - kGolden * (high - low);
            at_left = evidenceOf(stretches, left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + kGolden * (high - low);
            at_right = evidenceOf(stretches, right);
        }
    }
    const double most = (low + high) / 2;
    const double bend = 2 * evidenceOf(stretches, most) - evidenceOf(stretches, most - kCurvatureStep) -
                        evidenceOf(stretches, most + kCurvatureStep);
    return {most, std::min(kCurvatureStep / std::sqrt(std::max(bend, 1e-9)), kMostLogSigma)};
}

/// The noise's own uncertainty included.
MeanBelief believeMean(const AxisCounts& counts, const LogNoise& noise) {
    MeanBelief belief = believeMean(counts, std::exp(noise.value));
    const double more = believeMean(counts, std::exp(noise.value + noise.sigma)).mean,
                 less = believeMean(counts, std::exp(noise.value - noise.sigma)).mean;
    belief.sigma = std::hypot(belief.sigma, (more - less) / 2);
    return belief;
}

}  // namespace

std::vector<CountMean> countMeans(const std::vector<std::span<const CountReading>>& stretches,
                                  Vector3d CountReading::*sensor) {
    std::vector<CountMean> means(stretches.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<AxisCounts> all, rounded;
        for (const auto& stretch : stretches) {
            require(!stretch.empty(), "countMeans: an empty stretch");
            all.push_back(countsOfAxis(stretch, sensor, axis));
            if (rounded.size() < kWitnesses && all.back().whole && all.back().deviation < kMostNoise_counts)
                rounded.push_back(all.back());
        }
        const LogNoise noise = rounded.empty() ? LogNoise{} : likeliestNoise(rounded);
        for (size_t k = 0; k < all.size(); ++k) {
            MeanBelief belief{all[k].mean, all[k].plainSigma(), 0};
            if (all[k].whole && all[k].deviation < kMostNoise_counts)
                belief = believeMean(all[k], noise);
            means[k].counts[axis] = belief.mean;
            means[k].sigma[axis] = belief.sigma;
        }
    }
    return means;
}

}  // namespace noctule
