// SPDX-License-Identifier: Apache-2.0
#include "core/live/pose_predictor.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kKept_s = 2 * PosePredictor::kLongest_s;
constexpr double kSilence_s = 0.03;          // four frames: a board that lost more is not believed to turn on
constexpr double kFastestRoot_m_per_s = 12;  // beyond that the filter has mended its place

double seconds(const TimedPose& pose) {
    return static_cast<double>(pose.time_ns) * 1e-9;
}

}  // namespace

Result<std::unique_ptr<PosePredictor>> PosePredictor::create(const Suit& suit, const Calibration& calibration,
                                                             const Actor& actor, double sample_rate_hz) {
    const KinematicTree tree(actor.skeleton, BallCoordinates::kManifold);
    const auto mounted = mountSuit(suit, calibration, actor, tree);
    if (!mounted)
        return mounted.error();
    std::unique_ptr<PosePredictor> made(new PosePredictor(suit, calibration, actor, sample_rate_hz));
    for (size_t board = 0; board < suit.boards.size(); ++board) {
        Segment& segment = made->boards_[board];
        segment.R_segment_board = mounted->boards[board].R_link_board;
        const std::string& name = suit.boards[board].segment;
        const int joint = name.empty() ? -1 : actor.skeleton.find(name);
        const bool is_taken = std::ranges::any_of(
            made->boards_, [&](const Segment& other) { return &other != &segment && other.joint == joint; });
        if (!is_taken)
            segment.joint = joint;
    }
    return made;
}

PosePredictor::PosePredictor(const Suit& suit, const Calibration& calibration, const Actor& actor,
                             double sample_rate_hz)
    : skeleton_(actor.skeleton),
      calibrator_(suit, calibration, sample_rate_hz),
      boards_(suit.boards.size()) {}

void PosePredictor::add(const InertialReading& reading) {
    const InertialMeasurement measurement = calibrator_.convert(reading);
    Segment& segment = boards_[static_cast<size_t>(reading.board)];
    const auto omega = sensedVector(measurement.gyro);
    if (segment.joint < 0 || !omega)
        return;
    segment.rates.push_back({measurement.time_s, segment.R_segment_board * *omega});
    while (segment.rates.front().time_s < measurement.time_s - kKept_s)
        segment.rates.pop_front();
    newest_s_ = std::max(newest_s_, measurement.time_s);
}

void PosePredictor::add(const TimedPose& pose) {
    if (!pose.pose)
        return;
    if (base_) {
        const double passed_s = seconds(pose) - seconds(*base_);
        const Vector3d moved_m = pose.pose->p_world_root - base_->pose->p_world_root;
        const bool is_motion =
            passed_s > 0 && passed_s <= kLongest_s && moved_m.norm() <= kFastestRoot_m_per_s * passed_s;
        v_world_root_m_per_s_ = is_motion ? Vector3d(moved_m / passed_s) : Vector3d::Zero();
    }
    base_ = pose;
}

std::optional<Quaterniond> PosePredictor::turn(const Segment& segment, double from_s, double to_s) {
    if (segment.rates.empty() || segment.rates.back().time_s < to_s - kSilence_s)
        return std::nullopt;
    Quaterniond turned = Quaterniond::Identity();
    double at_s = from_s;
    const auto go = [&](double until_s, const Vector3d& omega_rad_per_s) {
        if (until_s <= at_s)
            return;
        turned = turned * expQuaternion(omega_rad_per_s * (until_s - at_s));
        at_s = until_s;
    };
    const Rate* before = nullptr;
    for (const Rate& rate : segment.rates) {
        const Vector3d mean =
            before ? Vector3d((before->omega_rad_per_s + rate.omega_rad_per_s) / 2) : rate.omega_rad_per_s;
        go(std::min(rate.time_s, to_s), mean);
        before = &rate;
    }
    go(to_s, before->omega_rad_per_s);
    return turned;
}

std::optional<TimedPose> PosePredictor::predict() const {
    if (!base_)
        return std::nullopt;
    const double from_s = seconds(*base_), to_s = std::min(newest_s_, from_s + kLongest_s);
    if (to_s <= from_s)
        return base_;
    TimedPose predicted = *base_;
    predicted.time_ns = std::llround(to_s * 1e9);
    Pose& pose = *predicted.pose;
    pose.p_world_root += v_world_root_m_per_s_ * (to_s - from_s);
    const GlobalPose before = globalPose(skeleton_, *base_->pose);
    std::vector<Quaterniond> after(before.q_world_joint.size());
    for (int joint = 0; joint < skeleton_.size(); ++joint) {
        const auto at = static_cast<size_t>(joint);
        const int parent = skeleton_.joint(joint).parent;
        const Quaterniond q_world_parent =
            parent < 0 ? Quaterniond::Identity() : after[static_cast<size_t>(parent)];
        const auto board = std::ranges::find(boards_, joint, &Segment::joint);
        const auto turned = board == boards_.end() ? std::nullopt : turn(*board, from_s, to_s);
        if (turned)
            pose.q_parent_joint[at] =
                (q_world_parent.conjugate() * before.q_world_joint[at] * *turned).normalized();
        after[at] = q_world_parent * pose.q_parent_joint[at];
    }
    return predicted;
}

}  // namespace noctule
