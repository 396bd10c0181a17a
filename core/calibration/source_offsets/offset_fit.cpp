// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/offset_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"

namespace noctule {
namespace {

constexpr double kBiweight = 4.685;      // 95 % efficient on normal residuals
constexpr double kLeastCut_s = 1e-6;     // spread below which no residual counts as wild: 0.3 mm
constexpr double kLeastSpread_s = 1e-7;  // of a perfect take
constexpr double kFree_s = 1;            // prior of an offset: none
constexpr double kMeanZero_s = 1e-7;     // of the applied delays' sum, which nothing else holds
constexpr double kLeastStretch = 1e-12;  // a thermometer that is exact
constexpr double kAnyStretch = 0.1;
constexpr double kLeastMic_s = 1e-12;
constexpr double kConverged_s = 1e-13;
constexpr int kMostIterations = 100;

class OffsetSolver {
public:
    OffsetSolver(const std::vector<OffsetSample>& samples, const OffsetFitSettings& settings)
        : samples_(samples),
          settings_(settings),
          size_(settings.sources + 1 + settings.boards + settings.placements),
          weights_(samples.size(), 1.0) {}

    OffsetFit solve() {
        startAtMedians();
        // Without the thermometer first: where it is far off, what it cannot explain would pass for noise and
        // give it the more weight.
        iterate(std::max(kAnyStretch, settings_.stretch_sigma));
        iterate(std::max(kLeastStretch, settings_.stretch_sigma));
        return result();
    }

private:
    void iterate(double stretch_sigma) {
        for (int i = 0; i < kMostIterations; ++i) {
            weigh();
            const Eigen::VectorXd before = state_;
            step(stretch_sigma);
            if ((state_ - before).cwiseAbs().maxCoeff() < kConverged_s)
                break;
        }
    }

    using Row = std::array<std::pair<int, double>, 4>;  // column, value

    int firstMic() const { return settings_.sources + 1; }
    int firstPlacement() const { return firstMic() + settings_.boards; }

    Row rowOf(const OffsetSample& sample) const {
        return {{{sample.source, 1.0},
                 {settings_.sources, sample.travel_s},
                 {firstMic() + sample.board, 1.0},
                 {firstPlacement() + sample.placement, sample.travel_s}}};
    }
    double product(const Row& row, const Eigen::VectorXd& x) const {
        double sum = 0;
        for (const auto& [column, value] : row)
            sum += value * x[column];
        return sum;
    }
    double misfit(const OffsetSample& sample) const {
        return sample.delay_s - product(rowOf(sample), state_);
    }

    void startAtMedians() {
        std::vector<std::vector<double>> delays(static_cast<size_t>(settings_.sources));
        for (const OffsetSample& sample : samples_)
            if (!sample.left_out)
                delays[static_cast<size_t>(sample.source)].push_back(sample.delay_s);
        state_ = Eigen::VectorXd::Zero(size_);
        for (int s = 0; s < settings_.sources; ++s)
            state_[s] = medianOf(delays[static_cast<size_t>(s)]);
        start_ = state_;
    }

    void weigh() {
        std::vector<double> misfits, known_variances;
        for (const OffsetSample& sample : samples_)
            if (!sample.left_out) {
                misfits.push_back(misfit(sample));
                known_variances.push_back(sample.sigma_s * sample.sigma_s);
            }
        spread_s_ = spreadAbout(0, misfits);
        common_variance_ = std::max(kLeastSpread_s * kLeastSpread_s,
                                    spread_s_ * spread_s_ - medianOf(std::move(known_variances)));
        for (size_t i = 0; i < samples_.size(); ++i) {
            const double cut_s = kBiweight * std::max(kLeastCut_s, sigma(samples_[i]));
            const double u = misfit(samples_[i]) / cut_s;
            const double shrink = std::max(0.0, 1 - u * u);
            weights_[i] = samples_[i].left_out ? 0 : shrink * shrink;
        }
    }

    double sigma(const OffsetSample& sample) const {
        return std::sqrt(sample.sigma_s * sample.sigma_s + common_variance_);
    }

    void step(double stretch_sigma) {
        Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size_, size_);
        Eigen::VectorXd pull = Eigen::VectorXd::Zero(size_);
        addPriors(stretch_sigma, information, pull);
        for (size_t i = 0; i < samples_.size(); ++i) {
            const Row row = rowOf(samples_[i]);
            const double weight = weights_[i] / std::pow(sigma(samples_[i]), 2);
            for (const auto& [column, value] : row) {
                pull[column] += weight * value * samples_[i].delay_s;
                for (const auto& [other, factor] : row)
                    information(column, other) += weight * value * factor;
            }
        }
        Eigen::MatrixXd right = Eigen::MatrixXd::Identity(size_, size_ + 1);
        right.rightCols<1>() = pull;
        const Eigen::MatrixXd solved = solveSymmetric(information, right);
        covariance_ = solved.leftCols(size_);
        state_ = solved.rightCols<1>();
    }

    void addPriors(double stretch_sigma, Eigen::MatrixXd& information, Eigen::VectorXd& pull) const {
        const auto inverse = [](double value) { return 1 / (value * value); };
        for (int s = 0; s < settings_.sources; ++s) {
            information(s, s) += inverse(kFree_s);
            pull[s] += inverse(kFree_s) * start_[s];
        }
        const int stretch = settings_.sources;
        information(stretch, stretch) += inverse(stretch_sigma);
        for (int b = 0; b < settings_.boards; ++b)
            information(firstMic() + b, firstMic() + b) +=
                inverse(std::max(kLeastMic_s, settings_.mic_sigma_s));
        for (int p = firstPlacement(); p < size_; ++p)
            information(p, p) += inverse(std::max(kLeastStretch, settings_.placement_sigma));
        if (settings_.apply_mics) {
            const Eigen::VectorXd heard = heardBoards();
            information.block(firstMic(), firstMic(), settings_.boards, settings_.boards) +=
                inverse(kMeanZero_s) * heard * heard.transpose();
        }
    }

    /// 1 for each board that has a say; a silent one would take up the others' mean.
    Eigen::VectorXd heardBoards() const {
        Eigen::VectorXd heard = Eigen::VectorXd::Zero(settings_.boards);
        for (size_t i = 0; i < samples_.size(); ++i)
            if (weights_[i] > 0)
                heard[samples_[i].board] = 1;
        return heard;
    }

    /// What the applied parameters leave; `state` may be that without the sample.
    double residual(const OffsetSample& sample, const Eigen::VectorXd& state) const {
        const Row row = rowOf(sample);
        return sample.delay_s - state[row[0].first] -
               (settings_.apply_stretch ? row[1].second * state[row[1].first] : 0) -
               (settings_.apply_mics ? state[row[2].first] : 0);
    }

    /// Exact for the weights that were found: one measurement fewer is a change of rank one.
    Eigen::VectorXd stateWithout(size_t i) const {
        const Row row = rowOf(samples_[i]);
        const double weight = weights_[i] / std::pow(sigma(samples_[i]), 2);
        Eigen::VectorXd gain = Eigen::VectorXd::Zero(size_);
        for (const auto& [column, value] : row)
            gain += value * covariance_.col(column);
        const double leverage = weight * product(row, gain);
        return state_ - gain * (weight * misfit(samples_[i]) / (1 - leverage));
    }

    OffsetFit result() const {
        OffsetFit fit;
        const int stretch = settings_.sources;
        for (int s = 0; s < settings_.sources; ++s) {
            fit.offset_s.push_back(state_[s]);
            fit.offset_sigma_s.push_back(std::sqrt(covariance_(s, s)));
        }
        for (int b = firstMic(); b < firstPlacement(); ++b) {
            fit.mic_s.push_back(state_[b]);
            fit.mic_sigma_s.push_back(std::sqrt(covariance_(b, b)));
        }
        fit.stretch = state_[stretch];
        fit.stretch_sigma = std::sqrt(covariance_(stretch, stretch));
        fit.spread_s = spread_s_;
        fit.weight = weights_;
        for (size_t i = 0; i < samples_.size(); ++i) {
            fit.misfit_s.push_back(misfit(samples_[i]));
            fit.residual_s.push_back(residual(samples_[i], state_));
            fit.left_out_s.push_back(residual(samples_[i], stateWithout(i)));
        }
        return fit;
    }

    const std::vector<OffsetSample>& samples_;
    const OffsetFitSettings& settings_;
    int size_;
    Eigen::VectorXd state_, start_;
    Eigen::MatrixXd covariance_;
    double spread_s_ = 0, common_variance_ = 0;
    std::vector<double> weights_;
};

}  // namespace

OffsetFit fitOffsets(const std::vector<OffsetSample>& samples, const OffsetFitSettings& settings) {
    return OffsetSolver(samples, settings).solve();
}

}  // namespace noctule
