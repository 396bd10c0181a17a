// SPDX-License-Identifier: Apache-2.0
#include "core/motion/curve_correlation.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr double kBlock_s = 0.25;
constexpr int kDependentBlocks = 4;  ///< errors of an estimate last for a second
constexpr double kStillShare = 0.2;  ///< of the least deviation: within an overlap even less is no curve

double deviation(const std::vector<float>& values) {
    double sum = 0, squares = 0;
    for (const float value : values) {
        sum += static_cast<double>(value);
        squares += static_cast<double>(value) * static_cast<double>(value);
    }
    const double n = static_cast<double>(std::max<size_t>(values.size(), 1));
    return std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)));
}

std::vector<float> inMeans(const std::vector<float>& values, size_t factor) {
    std::vector<float> means;
    for (size_t i = 0; i + factor <= values.size(); i += factor) {
        float sum = 0;
        for (size_t k = 0; k < factor; ++k)
            sum += values[i + k];
        means.push_back(sum / static_cast<float>(factor));
    }
    return means;
}

void addUp(const std::vector<float>& values, std::vector<double>& sum, std::vector<double>& squares) {
    sum.assign(1, 0);
    squares.assign(1, 0);
    for (const float value : values) {
        sum.push_back(sum.back() + static_cast<double>(value));
        squares.push_back(squares.back() + static_cast<double>(value) * static_cast<double>(value));
    }
}

double product(const float* a, const float* b, int count) {
    float lanes[8] = {};
    double sum = 0;
    int i = 0;
    while (i + 8 <= count) {
        const int end = std::min(count - 7, i + 4096);
        for (; i < end; i += 8)
            for (int k = 0; k < 8; ++k)
                lanes[k] += a[i + k] * b[i + k];
        for (float& lane : lanes) {
            sum += static_cast<double>(lane);
            lane = 0;
        }
    }
    for (; i < count; ++i)
        sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum;
}

void centre(std::vector<float>& values) {
    double sum = 0;
    for (const float value : values)
        sum += static_cast<double>(value);
    const auto mean = static_cast<float>(sum / static_cast<double>(std::max<size_t>(values.size(), 1)));
    for (float& value : values)
        value -= mean;
}

}  // namespace

CurveCorrelation::CurveCorrelation(std::vector<AlignmentCurve> first, std::vector<AlignmentCurve> second,
                                   int64_t step_ns, double least_overlap_s)
    : step_ns_(step_ns), least_overlap_s_(least_overlap_s) {
    for (size_t c = 0; c < std::min(first.size(), second.size()); ++c)
        if (deviation(first[c].values) > first[c].least_deviation &&
            deviation(second[c].values) > second[c].least_deviation)
            addPair(std::move(first[c]), std::move(second[c]));
}

void CurveCorrelation::addPair(AlignmentCurve first, AlignmentCurve second) {
    Pair pair{std::move(first), std::move(second), {}, {}, {}, {}};
    centre(pair.first.values);  // so that sums of squares lose no digits
    centre(pair.second.values);
    addUp(pair.first.values, pair.first_sum, pair.first_squares);
    addUp(pair.second.values, pair.second_sum, pair.second_squares);
    first_size_ = static_cast<int>(pair.first.values.size());
    second_size_ = static_cast<int>(pair.second.values.size());
    pairs_.push_back(std::move(pair));
}

CurveCorrelation CurveCorrelation::coarser(int factor) const {
    CurveCorrelation coarse({}, {}, step_ns_ * factor, least_overlap_s_);
    for (const Pair& pair : pairs_)
        coarse.addPair(
            {inMeans(pair.first.values, static_cast<size_t>(factor)), pair.first.least_deviation},
            {inMeans(pair.second.values, static_cast<size_t>(factor)), pair.second.least_deviation});
    return coarse;
}

std::pair<int, int> CurveCorrelation::range(int lag) const {
    return {std::max(0, lag), std::min(first_size_, second_size_ + lag)};
}

int CurveCorrelation::overlap(int lag) const {
    const auto [begin, end] = range(lag);
    return std::max(0, end - begin);
}

int CurveCorrelation::firstLag() const {
    return -second_size_;
}

int CurveCorrelation::lastLag() const {
    return first_size_;
}

CurveCorrelation::Fit CurveCorrelation::fitOf(const Pair& pair, int lag) const {
    const auto [begin, end] = range(lag);
    const auto b = static_cast<size_t>(begin), e = static_cast<size_t>(end);
    const auto second_b = static_cast<size_t>(begin - lag), second_e = static_cast<size_t>(end - lag);
    const double n = end - begin;
    Fit fit;
    fit.mean_x = (pair.first_sum[e] - pair.first_sum[b]) / n;
    fit.mean_y = (pair.second_sum[second_e] - pair.second_sum[second_b]) / n;
    const double var_x = (pair.first_squares[e] - pair.first_squares[b]) / n - fit.mean_x * fit.mean_x;
    const double var_y =
        (pair.second_squares[second_e] - pair.second_squares[second_b]) / n - fit.mean_y * fit.mean_y;
    fit.scale_x = std::sqrt(std::max(var_x, 0.0));
    fit.scale_y = std::sqrt(std::max(var_y, 0.0));
    if (fit.scale_x < kStillShare * pair.first.least_deviation ||
        fit.scale_y < kStillShare * pair.second.least_deviation)
        return fit;
    const double xy =
        product(pair.first.values.data() + begin, pair.second.values.data() + (begin - lag), end - begin);
    fit.correlation = (xy / n - fit.mean_x * fit.mean_y) / (fit.scale_x * fit.scale_y);
    return fit;
}

double CurveCorrelation::at(int lag) const {
    if (pairs_.empty() || overlap(lag) * static_cast<double>(step_ns_) < least_overlap_s_ * 1e9)
        return -1;
    double sum = 0;
    for (const Pair& pair : pairs_)
        sum += fitOf(pair, lag).correlation;
    return sum / static_cast<double>(pairs_.size());
}

double CurveCorrelation::excessOf(int worse, int better) const {
    const int begin = std::max(range(worse).first, range(better).first);
    const int end = std::min(range(worse).second, range(better).second);
    const int block = std::max(1, static_cast<int>(kBlock_s * 1e9 / static_cast<double>(step_ns_)));
    const int blocks = (end - begin) / block;
    if (blocks < 4)
        return 0;
    std::vector<double> excess(static_cast<size_t>(blocks), 0);
    for (const Pair& pair : pairs_)
        for (const auto& [lag, sign] : {std::pair{worse, 1.0}, std::pair{better, -1.0}}) {
            const Fit fit = fitOf(pair, lag);
            if (fit.correlation == 0)
                continue;
            for (int i = begin; i < begin + blocks * block; ++i) {
                const double x =
                    (static_cast<double>(pair.first.values[static_cast<size_t>(i)]) - fit.mean_x) /
                    fit.scale_x;
                const double y =
                    (static_cast<double>(pair.second.values[static_cast<size_t>(i - lag)]) - fit.mean_y) /
                    fit.scale_y;
                const double residual = x - std::max(fit.correlation, 0.0) * y;
                excess[static_cast<size_t>((i - begin) / block)] += sign * residual * residual;
            }
        }
    double sum = 0, squares = 0;
    for (const double value : excess)
        sum += value, squares += value * value;
    const double n = blocks, mean = sum / n;
    const double variance = std::max(squares / n - mean * mean, 1e-12) * n / (n - 1);
    return mean / std::sqrt(variance / n);
}

/// Score and information of a shift: derivatives of the correlation at a lag, by parts of time or by curves.
struct CurveCorrelation::ShiftTerms {
    std::vector<double> score, information;

    explicit ShiftTerms(size_t parts) : score(parts, 0), information(parts, 0) {}
    void add(size_t part, double s, double h) {
        score[part] += s;
        information[part] += h;
    }
    /// Sum of squares of the parts' scores once the total is zero, in which neighbours up to `reach` apart
    /// depend on each other (Newey and West 1987; Bartlett's weights).
    double squares(int reach) const {
        double total = 0, all = 0;
        for (size_t i = 0; i < score.size(); ++i)
            total += score[i], all += information[i];
        std::vector<double> left;
        for (size_t i = 0; i < score.size(); ++i)
            left.push_back(score[i] - total / all * information[i]);
        double sum = 0;
        for (size_t i = 0; i < left.size(); ++i)
            for (size_t k = 0; k <= static_cast<size_t>(reach) && i + k < left.size(); ++k)
                sum += (k == 0 ? 1 : 2 * (1 - static_cast<double>(k) / (reach + 1))) * left[i] * left[i + k];
        return std::max(sum, 0.0);
    }
};

int64_t CurveCorrelation::sigma_ns(int lag) const {
    const auto [begin, end] = range(lag);
    const double step_s = static_cast<double>(step_ns_) * 1e-9;
    const int block = std::max(1, static_cast<int>(kBlock_s / step_s));
    const size_t blocks = static_cast<size_t>(std::max(1, (end - begin) / block));
    ShiftTerms in_time(blocks), by_curve(pairs_.size());
    double information = 0;
    for (size_t c = 0; c < pairs_.size(); ++c) {
        const Fit fit = fitOf(pairs_[c], lag);
        if (fit.correlation <= 0)
            continue;
        const auto &first = pairs_[c].first.values, &second = pairs_[c].second.values;
        for (int i = std::max(begin, lag + 1); i < std::min(end, second_size_ + lag - 1); ++i) {
            const auto k = static_cast<size_t>(i - lag);
            const double x = (static_cast<double>(first[static_cast<size_t>(i)]) - fit.mean_x) / fit.scale_x;
            const double y = (static_cast<double>(second[k]) - fit.mean_y) / fit.scale_y;
            const double slope =
                static_cast<double>(second[k + 1] - second[k - 1]) / (2 * step_s * fit.scale_y);
            const double score = (x - fit.correlation * y) * slope;
            const double own = fit.correlation * slope * slope;
            in_time.add(std::min(static_cast<size_t>((i - begin) / block), blocks - 1), score, own);
            by_curve.add(c, score, own);
            information += own;
        }
    }
    if (information <= 0)
        return INT64_C(1'000'000'000);
    const double n = static_cast<double>(blocks);
    const double squares = in_time.squares(kDependentBlocks) * n / std::max(n - 1, 1.0) + by_curve.squares(0);
    return std::max<int64_t>(std::llround(1e9 * std::sqrt(squares) / information), 100'000);
}

}  // namespace noctule
