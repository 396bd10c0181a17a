// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/path_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/job/contract.h"

namespace noctule {
namespace {

constexpr int kMaxIterations = 8, kBriefly = 4;
constexpr double kSettled = 5e-3;    // samples: 11 um, of an envelope good to 80 um at best
constexpr double kLongestStep = 12;  // samples per iteration
constexpr double kFastest = 0.03;    // stretch: 10 m/s
constexpr double kSearchedBefore = 30, kSearchedAfter = 20, kSearchStep = 5;  // samples
constexpr double kEchoMisfit = 2, kEchoGain = 0.7, kLostMisfit = 30;
/// Where the search for two paths begins: the first against where one alone fits best, the second behind it.
constexpr std::array<std::array<double, 2>, 4> kEchoStarts{{{0, 18}, {0, 40}, {-12, 18}, {-12, 40}}};

constexpr int kMaxUnknowns = PathFit::kMaxPaths + 1;
using Complex = std::complex<double>;
using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxUnknowns, kMaxUnknowns>;
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxUnknowns, 1>;

/// Real and imaginary parts apart, zeros to the end of the last vector of four.
struct Column {
    static constexpr int kMost = 32;
    alignas(16) std::array<float, kMost> re{}, im{};

    Complex dot(const Column& other, int count) const {  // this one conjugated
        using Lanes = Eigen::Map<const Eigen::Array4f, Eigen::Aligned16>;
        Eigen::Array4f real = Eigen::Array4f::Zero(), imaginary = real;
        for (int i = 0; i < count; i += 4) {
            const Lanes a(&re[i]), b(&im[i]), c(&other.re[i]), d(&other.im[i]);
            real += a * c + b * d;
            imaginary += a * d - b * c;
        }
        return {real.sum(), imaginary.sum()};
    }
    void addTimes(Complex factor, const Column& other, int count) {
        const auto f = static_cast<float>(factor.real()), g = static_cast<float>(factor.imag());
        for (int i = 0; i < count; ++i) {
            re[i] += f * other.re[i] - g * other.im[i];
            im[i] += f * other.im[i] + g * other.re[i];
        }
    }
};

/// A path and how it changes with its onset and with the stretch.
struct Path {
    Column value, by_onset, by_stretch;

    void evaluate(const PulseTemplate& pulse, double drive, const Baseband& sound, double onset,
                  double stretch) {
        const double begin = sound.first - onset;
        pulse.sample(begin, static_cast<int>(sound.step), static_cast<int>(sound.values.size()),
                     [&, turning = static_cast<float>(drive * stretch), omega = static_cast<float>(drive),
                      squeeze = static_cast<float>(stretch), u = static_cast<float>(begin),
                      turn = std::polar(1.0F, static_cast<float>(drive * stretch * begin)),
                      step = std::polar(1.0F, static_cast<float>(drive * stretch * sound.step))](
                         int i, float re, float im, float slope_re, float slope_im) mutable {
                         const auto put = [&](Column& column, float x, float y) {
                             column.re[i] = x * turn.real() - y * turn.imag();
                             column.im[i] = x * turn.imag() + y * turn.real();
                         };
                         put(value, re + squeeze * u * slope_re, im + squeeze * u * slope_im);
                         put(by_onset, turning * im - slope_re, -turning * re - slope_im);
                         put(by_stretch, u * (slope_re - omega * im), u * (slope_im + omega * re));
                         turn = {turn.real() * step.real() - turn.imag() * step.imag(),
                                 turn.real() * step.imag() + turn.imag() * step.real()};
                         u += static_cast<float>(sound.step);
                     });
    }
};

using Gains = std::array<Complex, PathFit::kMaxPaths>;

/// Hermitian, of one or two paths.
struct Gram {
    double a = 0, c = 0, determinant = 1;
    Complex b = 0;
    int size = 1;

    Gram(const std::array<Path, PathFit::kMaxPaths>& paths, int count, int values) : size(count) {
        a = paths[0].value.dot(paths[0].value, values).real() + 1e-12;
        if (count == 2) {
            b = paths[0].value.dot(paths[1].value, values);
            c = paths[1].value.dot(paths[1].value, values).real() + 1e-12;
            a *= 1 + 1e-7;  // two paths may become one
            c *= 1 + 1e-7;
            determinant = a * c - std::norm(b);
        }
    }
    Gains solve(const Gains& right) const {
        if (size == 1)
            return {right[0] / a, 0};
        return {(c * right[0] - b * right[1]) / determinant,
                (a * right[1] - std::conj(b) * right[0]) / determinant};
    }
};

/// The sums over the values that one step of the fit needs.
class Problem {
public:
    Problem(const PulseTemplate& pulse, double drive, const Baseband& sound)
        : pulse_(pulse),
          drive_(drive),
          sound_(sound),
          count_((static_cast<int>(sound.values.size()) + 3) / 4 * 4) {
        require(sound.values.size() <= Column::kMost, "more baseband than is fitted at once");
        for (size_t i = 0; i < sound.values.size(); ++i) {
            y_.re[i] = sound.values[i].real();
            y_.im[i] = sound.values[i].imag();
        }
    }

    void evaluate(const PathFit& at, bool with_derivatives) {
        for (int k = 0; k < at.paths; ++k)
            paths_[k].evaluate(pulse_, drive_, sound_, at.onset[k], at.stretch);
        const Gram gram(paths_, at.paths, count_);
        Gains right{};
        for (int k = 0; k < at.paths; ++k)
            right[k] = paths_[k].value.dot(y_, count_);
        gains = gram.solve(right);
        Column residual = y_;
        for (int k = 0; k < at.paths; ++k)
            residual.addTimes(-gains[k], paths_[k].value, count_);
        residual_power = residual.dot(residual, count_).real();
        if (with_derivatives)
            linearise(at.paths, gram, residual);
    }

    Gains gains{};
    double residual_power = 0;
    Normal normal;      ///< Re J'J, the gains eliminated
    Unknowns gradient;  ///< Re J'r

    /// Energy of the first path, and its mean instant after the onset.
    std::pair<double, double> middleOfFirst(double onset) const {
        double energy = 0, moment = 0, u = sound_.first - onset;
        for (size_t i = 0; i < sound_.values.size(); ++i, u += sound_.step) {
            const double power = std::norm(std::complex<float>(paths_[0].value.re[i], paths_[0].value.im[i]));
            energy += power;
            moment += u * power;
        }
        return {energy, moment / energy};
    }

private:
    void linearise(int paths, const Gram& gram, const Column& residual) {
        std::array<Column, kMaxUnknowns> J{};
        for (int k = 0; k < paths; ++k) {
            J[k].addTimes(gains[k], paths_[k].by_onset, count_);
            J[paths].addTimes(gains[k], paths_[k].by_stretch, count_);
        }
        const int unknowns = paths + 1;
        normal.resize(unknowns, unknowns);
        gradient.resize(unknowns);
        std::array<Gains, kMaxUnknowns> along{};
        for (int j = 0; j < unknowns; ++j) {
            for (int k = 0; k < paths; ++k)
                along[j][k] = paths_[k].value.dot(J[j], count_);
            gradient[j] = J[j].dot(residual, count_).real();
            const Gains taken = gram.solve(along[j]);
            for (int i = 0; i <= j; ++i) {
                Complex sum = J[i].dot(J[j], count_);
                for (int k = 0; k < paths; ++k)
                    sum -= std::conj(along[i][k]) * taken[k];
                normal(i, j) = normal(j, i) = sum.real();
            }
        }
    }

    const PulseTemplate& pulse_;
    double drive_;
    const Baseband& sound_;
    int count_;
    Column y_;
    std::array<Path, PathFit::kMaxPaths> paths_;
};

/// What the fit found and how sure it is.
void describe(const Problem& problem, const Baseband& sound, const Normal& normal, double drive,
              PathFit& fit) {
    const Normal covariance = normal.inverse();
    for (int k = 0; k < fit.paths; ++k)
        fit.gain[k] = problem.gains[k];
    const double freedoms =
        std::max(1.0, static_cast<double>(sound.values.size()) - fit.paths - 0.5 * (fit.paths + 1));
    fit.misfit = problem.residual_power / (sound.noise_power * freedoms);
    if (!(covariance(0, 0) > 0 && covariance(fit.paths, fit.paths) > 0))  // two paths have become one
        fit.misfit = std::numeric_limits<double>::infinity();
    fit.sigma_onset = std::sqrt(std::max(0.0, covariance(0, 0)));
    // The phase is best known amid the pulse's energy, from where it runs back to the onset with the stretch.
    const auto [energy, middle] = problem.middleOfFirst(fit.onset[0]);
    fit.sigma_carrier =
        std::hypot(std::sqrt(1 / (2 / sound.noise_power * std::norm(fit.gain[0]) * energy)) / drive,
                   middle * std::sqrt(std::max(0.0, covariance(fit.paths, fit.paths))));
}

}  // namespace

PathFit PathFitter::fitAlone(const Baseband& sound, double near_onset, const StretchPrior& prior) const {
    Problem problem(pulse_, drive_, sound);
    PathFit start, tried;
    start.paths = tried.paths = 1;
    start.stretch = tried.stretch = prior.mean;
    double least = std::numeric_limits<double>::infinity();
    for (double onset = near_onset - kSearchedBefore; onset <= near_onset + kSearchedAfter;
         onset += kSearchStep) {
        tried.onset[0] = onset;
        problem.evaluate(tried, false);
        if (problem.residual_power < least) {
            least = problem.residual_power;
            start.onset[0] = onset;
        }
    }
    return refine(sound, start, prior, kMaxIterations);
}

PathFit PathFitter::fit(const Baseband& sound, double near_onset, const StretchPrior& prior) const {
    PathFit start;
    start.paths = 1;
    start.stretch = prior.mean;
    start.onset[0] = near_onset;
    PathFit best = refine(sound, start, prior, kMaxIterations);
    if (best.misfit < kEchoMisfit)
        return best;
    if (best.misfit > kLostMisfit)
        if (const PathFit searched = fitAlone(sound, near_onset, prior); searched.misfit < best.misfit)
            best = searched;
    const PathFit alone = best;
    for (const auto& [earlier, apart] : kEchoStarts) {
        if (best.misfit < kEchoMisfit)
            break;
        start = alone;
        start.paths = 2;
        start.stretch = prior.mean;
        start.onset = {alone.onset[0] + earlier, alone.onset[0] + earlier + apart};
        const PathFit both = refine(sound, start, prior, kBriefly);
        if (both.onset[0] < both.onset[1] && both.misfit < kEchoGain * best.misfit)
            best = both;
    }
    if (best.paths == 1)
        return best;
    const PathFit settled = refine(sound, best, prior, kMaxIterations);
    return settled.misfit <= best.misfit ? settled : best;
}

PathFit PathFitter::refine(const Baseband& sound, const PathFit& start, const StretchPrior& prior,
                           int iterations) const {
    PathFit fit = start;
    const int paths = fit.paths;
    const double weight = 2 / sound.noise_power, prior_weight = 1 / (prior.sigma * prior.sigma);
    Problem problem(pulse_, drive_, sound);
    Normal normal;
    for (int iteration = 0;; ++iteration) {
        problem.evaluate(fit, true);
        normal = weight * problem.normal;
        normal(paths, paths) += prior_weight;
        normal.diagonal() *= 1 + 1e-6;
        if (iteration == iterations)
            break;
        Unknowns gradient = weight * problem.gradient;
        gradient[paths] += (prior.mean - fit.stretch) * prior_weight;
        const Unknowns step = normal.ldlt().solve(gradient);
        double largest = 0;
        for (int k = 0; k < paths; ++k) {
            const double moved = std::clamp(step[k], -kLongestStep, kLongestStep);
            fit.onset[k] += moved;
            largest = std::max(largest, std::abs(moved));
        }
        fit.stretch = std::clamp(fit.stretch + step[paths], -kFastest, kFastest);
        if (largest < kSettled)
            break;
    }
    describe(problem, sound, normal, drive_, fit);
    return fit;
}

}  // namespace noctule
