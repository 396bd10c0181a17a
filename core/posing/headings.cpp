// SPDX-License-Identifier: Apache-2.0
#include "core/posing/headings.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <complex>

#include "core/assignment/joint_evidence.h"
#include "core/math/rotation.h"

namespace noctule::posing {

namespace {

using Complex = std::complex<double>;

constexpr double kMostKnots = 2000;  ///< per sensor
constexpr int kGaussNewtonSteps = 8;
constexpr double kSmoothed_s = 10;  ///< of the first guess
constexpr double kLeastRows = 8;    ///< in a window
constexpr double kUnknown_rad = 3;  ///< heading sigma from which a sensor has no north
constexpr size_t kSigmaKnots = 40;  ///< per sensor, at which the standard deviation is worked out
constexpr double kUnclear_rad = 0.35;

double wrapped(double angle_rad) {
    return std::remainder(angle_rad, 2 * std::numbers::pi);
}

/// The horizontal part as a number that a turn about Y by d multiplies by exp(i d).
Complex horizontal(const Vector3d& v) {
    return {v.z(), v.x()};
}

struct Window {
    Complex sum = 0;         ///< of above * conj(below)
    double information = 0;  ///< 1/rad^2; 0: nothing to tell
};

/// What one pair tells at each knot.
class PairWindows {
public:
    PairWindows(const SensorTracks& tracks, const SensorPair& pair, size_t knots, double knot_s,
                const HeadingSettings& settings)
        : tracks_(tracks), pair_(pair), knot_s_(knot_s), settings_(settings), windows_(knots) {}

    std::vector<Window> tell(const assignment::SmoothMotion& above, const assignment::SmoothMotion& below,
                             size_t step) {
        const auto evidence = assignment::jointEvidence(above, below);
        struct Sums {
            Complex cross = 0, above = 0, below = 0;
            double squares = 0, count = 0;
        };
        std::vector<Sums> sums(windows_.size());
        const SensorTrack &a = tracks_.sensors[pair_.above], &b = tracks_.sensors[pair_.below];
        const size_t rows = std::min(above.lever.size(), below.lever.size());
        for (size_t k = 0; k < rows; ++k) {
            const size_t i = 1 + k * step;
            if (!known(a, i) || !known(b, i))
                continue;
            const auto u = horizontal(a.q_world_sensor[i] *
                                      (above.accel_m_per_s2[k] - above.lever[k] * evidence.lever_first_m));
            const auto v = horizontal(b.q_world_sensor[i] *
                                      (below.accel_m_per_s2[k] - below.lever[k] * evidence.lever_second_m));
            Sums& s = sums[std::min(windows_.size() - 1,
                                    size_t(std::lround(double(i) / tracks_.rate_hz / knot_s_)))];
            s.cross += u * std::conj(v);
            s.squares += std::norm(u) + std::norm(v);
            s.above += u;
            s.below += v;
            s.count += 1;
        }
        for (size_t k = 0; k < sums.size(); ++k) {
            if (sums[k].count < kLeastRows)
                continue;
            // What stays within a window is tilt and bias, not the joint's movement.
            sums[k].cross -= sums[k].above * std::conj(sums[k].below) / sums[k].count;
            sums[k].squares -= (std::norm(sums[k].above) + std::norm(sums[k].below)) / sums[k].count;
            // At the best turn the residuals' squares sum to squares - 2 |cross|, in two components.
            const double left = std::max(sums[k].squares - 2 * std::abs(sums[k].cross), 0.0);
            const double variance = left / (2 * sums[k].count) + std::pow(settings_.accel_m_per_s2, 2);
            const double told = std::abs(sums[k].cross) / (variance * settings_.correlated_rows);
            windows_[k].sum = sums[k].cross;
            windows_[k].information = 1 / (1 / std::max(told, 1e-9) + std::pow(settings_.least_pair_rad, 2));
        }
        return windows_;
    }

private:
    static bool known(const SensorTrack& track, size_t i) {
        return track.has(i) && track.rate_rad_per_s[i].allFinite() && track.accel_m_per_s2[i].allFinite();
    }

    const SensorTracks& tracks_;
    const SensorPair& pair_;
    double knot_s_;
    const HeadingSettings& settings_;
    std::vector<Window> windows_;
};

ImuSamples samplesOf(const SensorTracks& tracks, size_t sensor) {
    ImuSamples samples;
    samples.rate_hz = tracks.rate_hz;
    samples.gyro_rad_per_s = tracks.sensors[sensor].rate_rad_per_s;
    samples.accel_m_per_s2 = tracks.sensors[sensor].accel_m_per_s2;
    return samples;
}

class Problem {
public:
    Problem(const SensorTracks& tracks, const std::vector<SensorPair>& pairs,
            const StandingHeadings& standing, const HeadingSettings& settings)
        : tracks_(tracks), pairs_(pairs), stated_(standing.of_sensor), settings_(settings) {
        const double duration_s = double(tracks.size()) / tracks.rate_hz;
        knot_s_ = std::max(settings.knot_s, duration_s / kMostKnots);
        knots_ = size_t(std::ceil(duration_s / knot_s_)) + 1;
        standing_ =
            std::min(knots_ - 1, size_t(std::lround(double(standing.instant) / tracks.rate_hz / knot_s_)));
        x_ = Eigen::VectorXd::Zero(Eigen::Index(tracks.sensors.size() * (knots_ + 1) + 1));
    }

    Status gather(const JobContext& job) {
        std::vector<assignment::SmoothMotion> motions;
        for (size_t s = 0; s < tracks_.sensors.size(); ++s)
            motions.push_back(assignment::smoothMotion(samplesOf(tracks_, s)));
        const auto step = std::max<size_t>(1, size_t(std::lround(tracks_.rate_hz / 25)));
        for (const SensorPair& pair : pairs_) {
            windows_.push_back(PairWindows(tracks_, pair, knots_, knot_s_, settings_)
                                   .tell(motions[pair.above], motions[pair.below], step));
            if (job.cancelled())
                return JobContext::cancelledError();
        }
        return Done{};
    }

    /// Down the tree, each pair smoothed along time.
    void guess() {
        for (size_t p = 0; p < pairs_.size(); ++p) {
            double last = 0;
            for (size_t k = 0; k < knots_; ++k) {
                const auto fade = [&](size_t j) {
                    return std::exp(-std::abs(double(j) - double(k)) * knot_s_ / kSmoothed_s);
                };
                Complex sum = 1e-6 * std::polar(1.0, last);
                if (const auto& above = stated_[pairs_[p].above], &below = stated_[pairs_[p].below];
                    above && below)
                    sum += std::polar(
                        fade(standing_) / (std::pow(above->sigma_rad, 2) + std::pow(below->sigma_rad, 2)),
                        below->heading_rad - above->heading_rad);
                for (size_t j = 0; j < knots_; ++j) {
                    const Window& w = windows_[p][j];
                    if (w.information > 0 && std::abs(w.sum) > 0)
                        sum += w.information * w.sum / std::abs(w.sum) * fade(j);
                }
                last += wrapped(std::arg(sum) - last);
                x_[at(pairs_[p].below, k)] = x_[at(pairs_[p].above, k)] + last;
            }
        }
        for (size_t s = 0; s < stated_.size(); ++s)
            if (stated_[s]) {
                x_[facing()] = x_[at(s, standing_)] - stated_[s]->heading_rad;
                break;
            }
    }

    Status solve(const JobContext& job) {
        for (int step = 0; step < kGaussNewtonSteps; ++step) {
            begin();
            addPairs();
            addStated();
            addDrift();
            addNorth();
            // The first sensor's heading while the body stands is where all are counted from.
            add({{at(0, standing_), 1}}, -x_[at(0, standing_)], hasNorth() ? 3 : 1e-3, false);
            Eigen::SparseMatrix<double> N(x_.size(), x_.size());
            N.setFromTriplets(triplets_.begin(), triplets_.end());
            solver_.compute(N);
            x_ += solver_.solve(right_);
            if (job.cancelled())
                return JobContext::cancelledError();
        }
        return Done{};
    }

    Headings result() {
        Headings out;
        const size_t rows = tracks_.size();
        for (size_t s = 0; s < tracks_.sensors.size(); ++s) {
            const auto sigma = sigmas(s);
            out.heading_rad.emplace_back(rows);
            out.sigma_rad.emplace_back(rows);
            for (size_t i = 0; i < rows; ++i) {
                const double knot = double(i) / tracks_.rate_hz / knot_s_;
                const size_t k = std::min(size_t(knot), knots_ - 2);
                const double part = std::min(knot - double(k), 1.0);
                out.heading_rad[s][i] = (1 - part) * x_[at(s, k)] + part * x_[at(s, k + 1)];
                out.sigma_rad[s][i] = (1 - part) * sigma[k] + part * sigma[k + 1];
            }
            if (sigma[knots_ / 2] > kUnclear_rad && s > 0)
                out.warnings.push_back("The heading of sensor " + tracks_.sensors[s].id +
                                       " is hardly known: neither its field nor its joints' movement tells "
                                       "it. Walk for ten seconds and more.");
        }
        if (std::ranges::any_of(stated_, [](const auto& one) { return one.has_value(); }))
            out.facing_rad = x_[facing()];
        return out;
    }

private:
    Eigen::Index at(size_t sensor, size_t knot) const { return Eigen::Index(sensor * (knots_ + 1) + knot); }
    Eigen::Index drift(size_t sensor) const { return at(sensor, knots_); }
    Eigen::Index facing() const { return x_.size() - 1; }

    void begin() {
        triplets_.clear();
        right_ = Eigen::VectorXd::Zero(x_.size());
        for (Eigen::Index i = 0; i < x_.size(); ++i)
            triplets_.emplace_back(i, i, 1e-9);
    }

    using Row = std::vector<std::pair<Eigen::Index, double>>;
    void add(const Row& row, double error, double sigma, bool robust) {
        double weight = 1 / (sigma * sigma);
        if (robust && std::abs(error) > settings_.huber_sigma * sigma)
            weight *= settings_.huber_sigma * sigma / std::abs(error);
        for (const auto& [i, a] : row) {
            right_[i] += weight * a * error;
            for (const auto& [j, b] : row)
                triplets_.emplace_back(i, j, weight * a * b);
        }
    }

    void addPairs() {
        for (size_t p = 0; p < pairs_.size(); ++p)
            for (size_t k = 0; k < knots_; ++k) {
                const Window& w = windows_[p][k];
                if (w.information <= 0)
                    continue;
                const Eigen::Index a = at(pairs_[p].above, k), b = at(pairs_[p].below, k);
                add({{b, 1}, {a, -1}}, wrapped(std::arg(w.sum) - (x_[b] - x_[a])),
                    1 / std::sqrt(w.information), true);
            }
    }

    /// Against the direction that the body faces, which is one more unknown.
    void addStated() {
        for (size_t s = 0; s < stated_.size(); ++s)
            if (stated_[s])
                add({{at(s, standing_), 1}, {facing(), -1}},
                    wrapped(stated_[s]->heading_rad - (x_[at(s, standing_)] - x_[facing()])),
                    stated_[s]->sigma_rad, true);
    }

    void addDrift() {
        for (size_t s = 0; s < tracks_.sensors.size(); ++s) {
            add({{drift(s), 1}}, -x_[drift(s)], settings_.drift_rad_per_s, false);
            for (size_t k = 0; k + 1 < knots_; ++k) {
                const double gap = gap_s(s, k) * settings_.gap_rad_per_s;
                const double sigma = std::hypot(settings_.walk_rad_per_sqrt_s * std::sqrt(knot_s_), gap);
                add({{at(s, k + 1), 1}, {at(s, k), -1}, {drift(s), -knot_s_}},
                    -(x_[at(s, k + 1)] - x_[at(s, k)] - knot_s_ * x_[drift(s)]), sigma, false);
            }
        }
    }

    void addNorth() {
        for (size_t s = 0; s < tracks_.sensors.size(); ++s)
            for (size_t k = 0; k < knots_; ++k) {
                const size_t i = std::min(tracks_.size() - 1, size_t(double(k) * knot_s_ * tracks_.rate_hz));
                const double sigma = tracks_.sensors[s].heading_sigma_rad[i];
                if (sigma < kUnknown_rad && tracks_.sensors[s].has(i))
                    add({{at(s, k), 1}}, wrapped(-x_[at(s, k)]), std::hypot(sigma, settings_.field_rad),
                        true);
            }
    }

    bool hasNorth() const {
        return std::any_of(tracks_.sensors.begin(), tracks_.sensors.end(), [](const SensorTrack& track) {
            return std::any_of(track.heading_sigma_rad.begin(), track.heading_sigma_rad.end(),
                               [](double sigma) { return sigma < kUnknown_rad; });
        });
    }

    double gap_s(size_t sensor, size_t knot) const {
        const auto row = [&](size_t k) {
            return std::min(tracks_.size(), size_t(double(k) * knot_s_ * tracks_.rate_hz));
        };
        size_t missing = 0;
        for (size_t i = row(knot); i < row(knot + 1); ++i)
            missing += !tracks_.sensors[sensor].has(i);
        return double(missing) / tracks_.rate_hz;
    }

    std::vector<double> sigmas(size_t sensor) {
        std::vector<double> out(knots_, 0.0);
        if (sensor == 0)
            return out;
        const size_t stride = std::max<size_t>(1, knots_ / kSigmaKnots);
        // The error while standing turns the mounting, that of the change since then the heading.
        Eigen::VectorXd stands = Eigen::VectorXd::Zero(x_.size());
        stands[at(sensor, standing_)] = 1;
        stands[at(0, standing_)] = -1;
        const double mounting = deviation(stands);
        double last = 0;
        for (size_t k = 0; k < knots_; ++k) {
            if (k % stride == 0) {
                Eigen::VectorXd change = Eigen::VectorXd::Zero(x_.size());
                change[at(sensor, k)] += 1;
                change[at(0, k)] -= 1;
                change[at(sensor, standing_)] -= 1;
                change[at(0, standing_)] += 1;
                last = std::min(std::numbers::pi, std::hypot(deviation(change), mounting));
            }
            out[k] = last;
        }
        return out;
    }

    double deviation(const Eigen::VectorXd& combination) {
        return std::sqrt(std::max(0.0, combination.dot(solver_.solve(combination))));
    }

    const SensorTracks& tracks_;
    const std::vector<SensorPair>& pairs_;
    const std::vector<std::optional<StatedHeading>>& stated_;  ///< while standing
    HeadingSettings settings_;
    double knot_s_ = 1;
    size_t knots_ = 0, standing_ = 0;
    std::vector<std::vector<Window>> windows_;
    Eigen::VectorXd x_, right_;
    std::vector<Eigen::Triplet<double>> triplets_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace

Quaterniond Headings::turned(const SensorTracks& tracks, size_t sensor, size_t i) const {
    return axisAngle(Vector3d::UnitY(), heading_rad[sensor][i]) * tracks.sensors[sensor].q_world_sensor[i];
}

Result<Headings> agreeHeadings(const SensorTracks& tracks, const std::vector<SensorPair>& pairs,
                               const StandingHeadings& standing, const HeadingSettings& settings,
                               const JobContext& job) {
    Problem problem(tracks, pairs, standing, settings);
    if (Status gathered = problem.gather(job); !gathered)
        return gathered.error();
    problem.guess();
    if (Status solved = problem.solve(job); !solved)
        return solved.error();
    return problem.result();
}

}  // namespace noctule::posing
