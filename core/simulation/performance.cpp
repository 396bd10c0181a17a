// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/performance.h"

#include <algorithm>
#include <cmath>

#include "core/job/contract.h"
#include "core/math/rotation.h"
#include "core/simulation/fade.h"
#include "core/simulation/to_and_fro.h"

namespace noctule::simulation {
namespace {

constexpr double kLongestFade_s = 1;

Spline splineOf(const FittedMotion& motion) {
    Eigen::MatrixXd rows(motion.rows.size(), motion.rows[0].size());
    for (size_t f = 0; f < motion.rows.size(); ++f)
        rows.row(f) = Eigen::Map<const Eigen::RowVectorXd>(motion.rows[f].data(), rows.cols());
    return Spline(std::move(rows), motion.step_s);
}

double headingOf(const Quaterniond& q) {
    const Vector3d forward = q * Vector3d::UnitZ();
    return std::atan2(forward.x(), forward.z());
}

/// By the chain rule.
Jet inTimeOf(const PlayedTime& played, const Jet& x) {
    return {x.value, x.rate * played.rate,
            x.acceleration * played.rate * played.rate + x.rate * played.acceleration_per_s};
}

}  // namespace

Performance::Performance(Coordinates coordinates, std::vector<double> rest_row, const FittedMotion* motion,
                         const Timing& timing)
    : coordinates_(std::move(coordinates)),
      rest_row_(std::move(rest_row)),
      rest_seconds_(timing.rest_seconds),
      duration_s_(timing.duration_s) {
    require(motion || duration_s_ > 0, "a performance without a motion needs a duration");
    if (!motion)
        return;
    motion_ = splineOf(*motion);
    if (duration_s_ <= 0)
        duration_s_ = rest_seconds_ + motion_.duration_s();
    transition_s_ = kLongestFade_s;
    seam_s_ = std::min(kLongestFade_s, motion_.duration_s() / 4);
    placeRepetitions();
}

void Performance::placeRepetitions() {
    const double period_s = motion_.duration_s() - seam_s_;
    std::vector<double> first, last;
    motion_.at(0, first);
    motion_.at(period_s, last);
    const Pose begin = coordinates_.toPose(first), end = coordinates_.toPose(last);
    Placement step;
    step.q =
        axisAngle(Vector3d::UnitY(), headingOf(end.q_parent_joint[0]) - headingOf(begin.q_parent_joint[0]));
    step.p = end.p_world_root - step.q * begin.p_world_root;
    step.p.y() = 0;
    repetitions_ = {Placement{}};
    while (rest_seconds_ + static_cast<double>(repetitions_.size()) * period_s + seam_s_ < duration_s_) {
        const Placement& before = repetitions_.back();
        repetitions_.push_back({(before.q * step.q).normalized(), before.p + before.q * step.p});
    }
}

template <class T>
void Performance::repetitionAt(size_t repetition, double t_s, std::vector<T>& row) const {
    motion_.at(t_s, row);
    if (repetition > 0)
        placeRoot(repetitions_[repetition], row);
}

template <class T>
void Performance::placeRoot(const Placement& placement, std::vector<T>& row) {
    const double c = 1 - 2 * placement.q.y() * placement.q.y(), s = 2 * placement.q.w() * placement.q.y();
    const T x = row[0], z = row[2];
    row[0] = x * c + z * s + placement.p.x();
    row[2] = z * c - x * s + placement.p.z();
    const double qw = placement.q.w(), qy = placement.q.y();  // q_root := placement.q * q_root
    const T w = row[3], i = row[4], j = row[5], k = row[6];
    row[3] = w * qw - j * qy;
    row[4] = i * qw + k * qy;
    row[5] = j * qw + w * qy;
    row[6] = k * qw - i * qy;
}

template <class T>
void Performance::motionAt(double t_s, std::vector<T>& row) const {
    const double period_s = motion_.duration_s() - seam_s_;
    const size_t repetition = std::min(static_cast<size_t>(t_s / period_s), repetitions_.size() - 1);
    const double within_s = t_s - static_cast<double>(repetition) * period_s;
    if (repetition == 0 || within_s >= seam_s_)
        return repetitionAt(repetition, within_s, row);
    std::vector<T> ending, beginning;
    repetitionAt(repetition - 1, within_s + period_s, ending);
    repetitionAt(repetition, within_s, beginning);
    coordinates_.blend(ending, beginning, fadeWeight<T>(within_s, seam_s_), row);
}

template <class T>
void Performance::posedAt(double t_s, std::vector<T>& row) const {
    row.assign(rest_row_.begin(), rest_row_.end());
    for (const Posing& posing : posings_) {
        if (t_s <= posing.begin_s)
            return;
        const std::vector<T> from = row, to(posing.row.begin(), posing.row.end());
        coordinates_.blend(from, to, fadeWeight<T>(t_s - posing.begin_s, kPosing_s), row);
    }
}

void Performance::takePose(const Pose& pose, double t_s) {
    require(motion_.columns() == 0, "a performer with a motion follows it");
    Pose standing = pose;
    standing.p_world_root = {rest_row_[0], 0, rest_row_[2]};
    std::vector<double> row = coordinates_.fromPose(standing);
    row[1] -= lowestPoint(coordinates_, row);
    coordinates_.continueFrom(posings_.empty() ? rest_row_ : posings_.back().row, row);
    posings_.push_back({t_s, std::move(row)});
}

void Performance::keepPose() {
    if (!posings_.empty())
        rest_row_ = posings_.back().row;
    posings_.clear();
}

void Performance::standAt(const StandingPlace& place) {
    place_ = {axisAngle(Vector3d::UnitY(), place.yaw_rad), Vector3d(place.x_m, 0, place.z_m)};
}

void Performance::lastFor(double duration_s) {
    duration_s_ = duration_s;
    if (motion_.columns() > 0)
        placeRepetitions();
    else
        rest_seconds_ = duration_s;
}

void Performance::comeBack(double duration_s) {
    once_s_ = duration_s_;
    duration_s_ = duration_s;
}

template <class T>
void Performance::at(double t_s, std::vector<T>& row) const {
    const PlayedTime played = once_s_ > 0 ? toAndFro(t_s, once_s_) : PlayedTime{t_s};
    performedAt(played.t_s, row);
    if constexpr (std::is_same_v<T, Jet>)
        for (Jet& coordinate : row)
            coordinate = inTimeOf(played, coordinate);
    if (place_)
        placeRoot(*place_, row);
}

template <class T>
void Performance::performedAt(double t_s, std::vector<T>& row) const {
    const double moving_s = t_s - rest_seconds_;
    if (motion_.columns() == 0) {
        posedAt(t_s, row);
    } else if (moving_s <= 0) {
        row.assign(rest_row_.begin(), rest_row_.end());
    } else if (moving_s >= transition_s_) {
        motionAt(moving_s, row);
    } else {
        const std::vector<T> rest(rest_row_.begin(), rest_row_.end());
        std::vector<T> motion;
        motionAt(moving_s, motion);
        coordinates_.blend(rest, motion, fadeWeight<T>(moving_s, transition_s_), row);
    }
}

template <class T>
void Performance::frames(double t_s, std::vector<Frame<T>>& frames) const {
    std::vector<T> row;
    at(t_s, row);
    coordinates_.frames(row, frames);
}

Pose Performance::pose(double t_s) const {
    std::vector<double> row;
    at(t_s, row);
    return coordinates_.toPose(row);
}

template void Performance::at<double>(double, std::vector<double>&) const;
template void Performance::at<Jet>(double, std::vector<Jet>&) const;
template void Performance::frames<double>(double, std::vector<Frame<double>>&) const;
template void Performance::frames<Jet>(double, std::vector<Frame<Jet>>&) const;

}  // namespace noctule::simulation
