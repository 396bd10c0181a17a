// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/path_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace noctule {
namespace {

constexpr int kMaxValues = 40, kMaxIterations = 8;
constexpr double kSettled = 1e-3;                                             // samples: 2 um
constexpr double kLongestStep = 12;                                           // samples per iteration
constexpr double kFastest = 0.03;                                             // stretch: 10 m/s
constexpr double kSearchedBefore = 30, kSearchedAfter = 20, kSearchStep = 5;  // samples
constexpr double kEchoMisfit = 3, kEchoGain = 0.7;
constexpr std::array kEchoDelays{12.0, 24.0, 36.0, 48.0};  // samples behind the first path

using Vector = Eigen::Matrix<std::complex<float>, Eigen::Dynamic, 1, 0, kMaxValues, 1>;
using Basis =
    Eigen::Matrix<std::complex<float>, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxValues, PathFit::kMaxPaths>;
using Gram = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, PathFit::kMaxPaths,
                           PathFit::kMaxPaths>;
using Gains = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 1, 0, PathFit::kMaxPaths, 1>;
constexpr int kMaxUnknowns = PathFit::kMaxPaths + 1;
using Jacobian =
    Eigen::Matrix<std::complex<float>, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxValues, kMaxUnknowns>;
using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxUnknowns, kMaxUnknowns>;
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxUnknowns, 1>;

/// The model at one set of unknowns.
struct Model {
    Basis paths, by_onset, by_stretch;

    void evaluate(const PulseTemplate& pulse, double drive, const Baseband& sound, const PathFit& at) {
        const Eigen::Index n = std::ssize(sound.values);
        paths.resize(n, at.paths);
        by_onset.resize(n, at.paths);
        by_stretch.resize(n, at.paths);
        const auto turning = static_cast<float>(drive * at.stretch);
        const std::complex<float> step = std::polar(1.0F, turning * static_cast<float>(sound.step));
        for (int k = 0; k < at.paths; ++k) {
            double u = sound.first - at.onset[static_cast<size_t>(k)];
            std::complex<float> turn = std::polar(1.0F, turning * static_cast<float>(u));
            for (Eigen::Index i = 0; i < n; ++i, u += sound.step) {
                const auto [value, slope] = pulse.at(u);
                const auto time = static_cast<float>(u);
                const auto stretched = value + static_cast<float>(at.stretch) * time * slope;
                paths(i, k) = product(stretched, turn);
                by_onset(i, k) = -product(slope + std::complex<float>(0, turning) * value, turn);
                by_stretch(i, k) =
                    time * product(slope + static_cast<float>(drive) *
                                               std::complex<float>(-value.imag(), value.real()),
                                   turn);
                turn = product(turn, step);
            }
        }
    }

    static std::complex<float> product(std::complex<float> a, std::complex<float> b) {
        return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
    }
};

Gains gainsOf(const Basis& paths, const Vector& y, const Eigen::LLT<Gram>& gram) {
    return gram.solve((paths.adjoint() * y).template cast<std::complex<double>>());
}

Gram gramOf(const Basis& paths) {
    Gram gram = (paths.adjoint() * paths).template cast<std::complex<double>>();
    gram.diagonal().array() += 1e-9 + 1e-7 * gram.trace().real();
    return gram;
}

}  // namespace

double PathFitter::misfitOf(const Baseband& sound, double onset, double stretch) const {
    PathFit at;
    at.paths = 1;
    at.onset[0] = onset;
    at.stretch = stretch;
    Model model;
    model.evaluate(pulse_, drive_, sound, at);
    const Eigen::Map<const Eigen::VectorXcf> y(sound.values.data(), std::ssize(sound.values));
    const double energy = y.squaredNorm(), own = model.paths.squaredNorm() + 1e-20;
    const double explained = std::norm(std::complex<double>(model.paths.col(0).dot(y))) / own;
    return (energy - explained) / (sound.noise_power * static_cast<double>(std::ssize(sound.values)));
}

PathFit PathFitter::fitAlone(const Baseband& sound, double near_onset, const StretchPrior& prior) const {
    PathFit start;
    start.paths = 1;
    start.stretch = prior.mean;
    double least = std::numeric_limits<double>::infinity();
    for (double onset = near_onset - kSearchedBefore; onset <= near_onset + kSearchedAfter;
         onset += kSearchStep)
        if (const double misfit = misfitOf(sound, onset, prior.mean); misfit < least) {
            least = misfit;
            start.onset[0] = onset;
        }
    return refine(sound, start, prior);
}

PathFit PathFitter::fit(const Baseband& sound, double near_onset, const StretchPrior& prior) const {
    const PathFit alone = fitAlone(sound, near_onset, prior);
    PathFit best = alone;
    if (alone.misfit < kEchoMisfit)
        return best;
    for (const double apart : kEchoDelays)
        for (const double earlier : {0.0, 12.0}) {
            PathFit start = alone;
            start.paths = 2;
            start.stretch = prior.mean;
            start.onset = {alone.onset[0] - earlier, alone.onset[0] - earlier + apart};
            const PathFit both = refine(sound, start, prior);
            if (both.onset[0] < both.onset[1] && both.misfit < kEchoGain * best.misfit)
                best = both;
        }
    return best;
}

PathFit PathFitter::refine(const Baseband& sound, const PathFit& start, const StretchPrior& prior) const {
    const Eigen::Map<const Eigen::VectorXcf> values(sound.values.data(), std::ssize(sound.values));
    const Vector y = values;
    PathFit fit = start;
    const int paths = fit.paths, unknowns = paths + 1;
    const double weight = 2 / sound.noise_power;
    Model model;
    Jacobian J(y.size(), unknowns);
    Normal normal(unknowns, unknowns);
    Vector residual;
    Gains gains;
    for (int iteration = 0;; ++iteration) {
        model.evaluate(pulse_, drive_, sound, fit);
        const Eigen::LLT<Gram> gram(gramOf(model.paths));
        gains = gainsOf(model.paths, y, gram);
        residual = y - model.paths * gains.cast<std::complex<float>>();
        J.col(paths).setZero();
        for (int k = 0; k < paths; ++k) {
            const auto gain = static_cast<std::complex<float>>(gains[k]);
            J.col(k) = gain * model.by_onset.col(k);
            J.col(paths) += gain * model.by_stretch.col(k);
        }
        for (int k = 0; k < unknowns; ++k) {
            const Gains part =
                gram.solve((model.paths.adjoint() * J.col(k)).template cast<std::complex<double>>());
            J.col(k) -= model.paths * part.cast<std::complex<float>>();
        }
        normal = weight * (J.adjoint() * J).real().cast<double>();
        normal(paths, paths) += 1 / (prior.sigma * prior.sigma);
        normal.diagonal().array() *= 1 + 1e-6;
        if (iteration == kMaxIterations)
            break;
        Unknowns gradient = weight * (J.adjoint() * residual).real().cast<double>();
        gradient[paths] += (prior.mean - fit.stretch) / (prior.sigma * prior.sigma);
        const Unknowns step = normal.ldlt().solve(gradient);
        double largest = 0;
        for (int k = 0; k < paths; ++k) {
            const double moved = std::clamp(step[k], -kLongestStep, kLongestStep);
            fit.onset[static_cast<size_t>(k)] += moved;
            largest = std::max(largest, std::abs(moved));
        }
        fit.stretch = std::clamp(fit.stretch + step[paths], -kFastest, kFastest);
        if (largest < kSettled)
            break;
    }
    const Normal covariance = normal.inverse();
    for (int k = 0; k < paths; ++k)
        fit.gain[static_cast<size_t>(k)] = gains[k];
    const double freedoms = std::max(1.0, static_cast<double>(y.size() - paths) - 0.5 * unknowns);
    fit.misfit = residual.squaredNorm() / (sound.noise_power * freedoms);
    fit.sigma_onset = std::sqrt(covariance(0, 0));
    // The phase is best known in the middle of the pulse's energy and runs back to its onset with the
    // stretch.
    double energy = 0, moment = 0, u = sound.first - fit.onset[0];
    for (Eigen::Index i = 0; i < y.size(); ++i, u += sound.step) {
        energy += std::norm(model.paths(i, 0));
        moment += u * std::norm(model.paths(i, 0));
    }
    const double power = std::norm(gains[0]) * energy;
    fit.sigma_carrier = std::hypot(std::sqrt(1 / (weight * power)) / drive_,
                                   moment / energy * std::sqrt(covariance(paths, paths)));
    return fit;
}

}  // namespace noctule
