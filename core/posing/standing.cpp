// SPDX-License-Identifier: Apache-2.0
#include "core/posing/standing.h"

#include <algorithm>
#include <cmath>

#include "core/assignment/joint_evidence.h"
#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"

namespace noctule::posing {

namespace {

constexpr double kStill_s = 1;
constexpr double kStill_rad_per_s = 0.15;  ///< root mean square of all sensors
constexpr double kWalking_rad_per_s = 1;   ///< root mean square of a leg within a second
constexpr double kLeastWalking_s = 4;
constexpr double kHanging_rad = 1.45;    ///< upper arms below the T pose
constexpr double kSwing_rad_per_s = 1;   ///< slower turns say little of an axis
constexpr double kClearBend_rad = 0.35;  ///< of a knee, to tell its axis
constexpr double kFewestBends_s = 1;
constexpr double kMostTurnedOut_rad = 0.44;
constexpr double kClearVote_rad = 0.05;
constexpr double kMostTilted_rad = 1;  ///< beyond it a stated mounting is of no use

bool isLeg(const std::string& segment) {
    return segment.ends_with("UpLeg") || segment.ends_with("Leg");
}
bool isTrunk(const std::string& segment) {
    return segment == "Hips" || segment == "Spine" || segment == "Chest";
}

Vector3d upOf(const SensorTrack& track, size_t i) {
    return track.q_world_sensor[i].conjugate() * Vector3d::UnitY();
}

/// Mean square rate of one sensor within each second, NaN where too little was read.
std::vector<double> activity(const SensorTrack& track, size_t window) {
    std::vector<double> out;
    for (size_t begin = 0; begin + window <= track.rate_rad_per_s.size(); begin += window / 2) {
        double sum = 0, count = 0;
        for (size_t i = begin; i < begin + window; ++i)
            if (track.has(i) && track.rate_rad_per_s[i].allFinite()) {
                sum += track.rate_rad_per_s[i].squaredNorm();
                count += 1;
            }
        out.push_back(count > 0.8 * double(window) ? sum / count : std::nan(""));
    }
    return out;
}

class StandingSearch {
public:
    explicit StandingSearch(const SensorTracks& tracks)
        : tracks_(tracks), window_(std::max<size_t>(2, size_t(kStill_s * tracks.rate_hz))) {
        for (const SensorTrack& track : tracks.sensors)
            activity_.push_back(activity(track, window_));
    }

    Standing find() const {
        const size_t seconds = activity_.front().size();
        const auto walking = walkingSeconds();
        std::vector<Vector3d> usual_up(tracks_.sensors.size(), Vector3d::Zero());
        for (const size_t w : walking)
            for (size_t s = 0; s < usual_up.size(); ++s)
                usual_up[s] += meanUp(s, w);
        const bool walks = double(walking.size()) * kStill_s / 2 >= kLeastWalking_s;
        size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (size_t w = 0; w < seconds; ++w) {
            const double unrest = std::sqrt(meanActivity(w)) / kStill_rad_per_s;
            if (!std::isfinite(unrest))
                continue;
            // A still second counts by the posture, or by how early it is; none is still: the stillest.
            const double cost = (walks ? 5 * strangeness(w, usual_up) + 0.2 * double(w) / double(seconds)
                                       : double(w) / double(seconds)) +
                                (unrest > 1 ? 10 * unrest : 0.2 * unrest) + 30 * missing(w);
            if (cost < least) {
                least = cost;
                best = w;
            }
        }
        const size_t first = best * (window_ / 2);
        return {first, std::min(first + window_, tracks_.size()) - 1, false, walks};
    }

private:
    double meanActivity(size_t w) const {
        double sum = 0, count = 0;
        for (const auto& one : activity_)
            if (std::isfinite(one[w])) {
                sum += one[w];
                count += 1;
            }
        return count > 0 ? sum / count : std::nan("");
    }

    /// Share of the sensors that do not read within that second: their mounting would stay unknown.
    double missing(size_t w) const {
        return double(std::ranges::count_if(activity_,
                                            [w](const auto& one) { return !std::isfinite(one[w]); })) /
               double(activity_.size());
    }

    /// Both legs turn, as far as they have sensors.
    std::vector<size_t> walkingSeconds() const {
        std::vector<size_t> out;
        for (size_t w = 0; w < activity_.front().size(); ++w) {
            bool any = false, all = true;
            for (size_t s = 0; s < activity_.size(); ++s)
                if (isLeg(tracks_.sensors[s].segment) && std::isfinite(activity_[s][w])) {
                    any = true;
                    all &= activity_[s][w] > std::pow(0.5 * kWalking_rad_per_s, 2);
                }
            if (any && all)
                out.push_back(w);
        }
        return out;
    }

    Vector3d meanUp(size_t sensor, size_t w) const {
        Vector3d sum = Vector3d::Zero();
        for (size_t i = w * (window_ / 2); i < w * (window_ / 2) + window_; ++i)
            if (tracks_.sensors[sensor].has(i))
                sum += upOf(tracks_.sensors[sensor], i);
        return sum.normalized();
    }

    /// Mean angle of legs and trunk from their usual inclination.
    double strangeness(size_t w, const std::vector<Vector3d>& usual_up) const {
        double sum = 0, count = 1e-9;
        for (size_t s = 0; s < usual_up.size(); ++s) {
            const std::string& segment = tracks_.sensors[s].segment;
            if (!(isLeg(segment) || isTrunk(segment)) || usual_up[s].norm() < 0.1 ||
                !std::isfinite(activity_[s][w]))
                continue;
            sum += std::acos(std::clamp(meanUp(s, w).dot(usual_up[s].normalized()), -1.0, 1.0));
            count += 1;
        }
        return sum / count;
    }

    const SensorTracks& tracks_;
    size_t window_;
    std::vector<std::vector<double>> activity_;
};

/// Mean of `attitude(i)`; the standing second is still, so that a sum of quaternions serves.
template <class Attitude>
Quaterniond meanAttitude(const SensorTrack& track, const Standing& standing, Attitude attitude) {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (size_t i = standing.first; i <= standing.last; ++i) {
        if (!track.has(i))
            continue;
        const Eigen::Vector4d q = attitude(i).coeffs();
        sum += sum.dot(q) < 0 ? Eigen::Vector4d(-q) : q;
    }
    return sum.norm() > 0 ? Quaterniond(Eigen::Vector4d(sum.normalized())) : Quaterniond::Identity();
}

/// Which way the body faces while it stands: the axis about which legs swing, and its sign by how bodies
/// bend.
class Facing {
public:
    Facing(const SensorTracks& tracks, const Headings& headings, const std::vector<SensorPair>& pairs,
           const std::vector<Quaterniond>& q_standing)
        : tracks_(tracks), headings_(headings), pairs_(pairs), q_standing_(q_standing) {}

    double find(std::vector<std::string>& warnings) const {
        Eigen::Matrix2d scatter = scatterOf([](const std::string& segment) { return isLeg(segment); });
        if (scatter.trace() <= 0)
            scatter = scatterOf([](const std::string&) { return true; });
        const Eigensystem axes = eigensystemOf(scatter);
        Vector3d left(axes.vectors(0, 1), 0, axes.vectors(1, 1));
        if (scatter.trace() <= 0)
            left = Vector3d::UnitX();
        const double bend = bendAbout(left);
        if (std::abs(bend) < kClearVote_rad || axes.values[1] < 1.5 * axes.values[0])
            warnings.push_back(
                "Which way the body faces is hardly known: record ten seconds of walking, or bend the knees");
        if (bend < 0)
            left = -left;
        return std::atan2(-left.z(), left.x());
    }

private:
    template <class Counts>
    Eigen::Matrix2d scatterOf(Counts counts) const {
        Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
        for (size_t s = 0; s < tracks_.sensors.size(); ++s) {
            const SensorTrack& track = tracks_.sensors[s];
            if (!counts(track.segment))
                continue;
            for (size_t i = 0; i < tracks_.size(); ++i) {
                if (!track.has(i) || !(track.rate_rad_per_s[i].norm() > kSwing_rad_per_s))
                    continue;
                const Vector3d rate = q_standing_[s] * track.rate_rad_per_s[i];
                const Eigen::Vector2d level(rate.x(), rate.z());
                scatter += level * level.transpose();
            }
        }
        return scatter;
    }

public:
    /// How far a knee's axis, as it bends, points out of the body's left: legs are turned out or in. 0 when
    /// it hardly bends.
    double turnOut(size_t thigh, size_t shank, double facing_rad) const {
        Vector3d sum = Vector3d::Zero();
        double bends = 0;
        for (size_t i = 0; i < tracks_.size(); ++i) {
            if (!tracks_.sensors[thigh].has(i) || !tracks_.sensors[shank].has(i))
                continue;
            const Vector3d bend = logQuaternion(undone(thigh, i) * undone(shank, i).conjugate());
            if (bend.norm() < kClearBend_rad)
                continue;
            sum += bend;
            bends += 1;
        }
        if (bends < kFewestBends_s * tracks_.rate_hz ||
            Vector3d(sum.x(), 0, sum.z()).norm() < 0.5 * sum.norm())
            return 0;
        const double out = std::remainder(std::atan2(-sum.z(), sum.x()) - facing_rad, 2 * std::numbers::pi);
        return std::clamp(out, -kMostTurnedOut_rad, kMostTurnedOut_rad);
    }

private:
    /// Knees bend forward about `left`, elbows the other way, the trunk forward, thighs rise: positive when
    /// they do.
    double bendAbout(const Vector3d& left) const {
        double vote = 0;
        for (const SensorPair& pair : pairs_) {
            const std::string& below = tracks_.sensors[pair.below].segment;
            const bool knee = below.ends_with("Leg") && !below.ends_with("UpLeg");
            if (knee || below.ends_with("ForeArm"))
                vote += (knee ? 2 : -1) * meanBend(pair.above, pair.below, left);
        }
        for (size_t s = 0; s < tracks_.sensors.size(); ++s) {
            const std::string& segment = tracks_.sensors[s].segment;
            if (segment.ends_with("UpLeg") || isTrunk(segment))
                vote += (isTrunk(segment) ? 0.3 : -0.5) * meanTilt(s, left);
        }
        return vote;
    }

    /// Takes vectors of the world to the world as the segment saw it while it stood: the inverse of its turn.
    Quaterniond undone(size_t s, size_t i) const {
        return q_standing_[s] * headings_.turned(tracks_, s, i).conjugate();
    }

    double meanBend(size_t above, size_t below, const Vector3d& left) const {
        double sum = 0, count = 1e-9;
        for (size_t i = 0; i < tracks_.size(); ++i)
            if (tracks_.sensors[above].has(i) && tracks_.sensors[below].has(i)) {
                sum += logQuaternion(undone(above, i) * undone(below, i).conjugate()).dot(left);
                count += 1;
            }
        return sum / count;
    }

    double meanTilt(size_t s, const Vector3d& left) const {
        const Vector3d forward = left.cross(Vector3d::UnitY());
        double sum = 0, count = 1e-9;
        for (size_t i = 0; i < tracks_.size(); ++i)
            if (tracks_.sensors[s].has(i)) {
                const Vector3d up = undone(s, i) * Vector3d::UnitY();
                sum += std::atan2(-up.dot(forward), up.y());
                count += 1;
            }
        return sum / count;
    }

    const SensorTracks& tracks_;
    const Headings& headings_;
    const std::vector<SensorPair>& pairs_;
    const std::vector<Quaterniond>& q_standing_;
};

bool standsWith(const SensorTrack& track, const Standing& standing) {
    for (size_t i = standing.first; i <= standing.last; ++i)
        if (track.has(i))
            return true;
    return false;
}

/// Per sensor: a leg's sensors share what its knee tells.
std::vector<double> legsTurnedOut(const SensorTracks& tracks, const std::vector<SensorPair>& pairs,
                                  const Facing& body, double facing_rad) {
    std::vector<double> out(tracks.sensors.size(), 0.0);
    for (const std::string side : {"Left", "Right"})
        for (const SensorPair& pair : pairs)
            if (tracks.sensors[pair.above].segment == side + "UpLeg" &&
                tracks.sensors[pair.below].segment == side + "Leg") {
                const double turn = body.turnOut(pair.above, pair.below, facing_rad);
                for (size_t s = 0; s < out.size(); ++s)
                    if (tracks.sensors[s].segment.starts_with(side) &&
                        (isLeg(tracks.sensors[s].segment) || tracks.sensors[s].segment.ends_with("Foot")))
                        out[s] = turn;
            }
    return out;
}

}  // namespace

Standing findStanding(const SensorTracks& tracks) {
    return StandingSearch(tracks).find();
}

Pose standingPose(const Actor& actor, bool rest) {
    Pose pose = actor.restPose();
    if (rest)
        return pose;
    const Skeleton& skeleton = actor.skeleton;
    for (Quaterniond& q : pose.q_parent_joint)
        q = Quaterniond::Identity();
    for (const auto& [name, sign] : {std::pair{"LeftArm", -1.0}, std::pair{"RightArm", 1.0}})
        if (const int arm = skeleton.find(name); arm >= 0)
            pose.q_parent_joint[size_t(arm)] = axisAngle(Vector3d::UnitZ(), sign * kHanging_rad);
    return pose;
}

StandingHeadings standingHeadings(const Actor& actor, const SensorTracks& tracks, const Standing& standing) {
    StandingHeadings out{standing.middle(), {}};
    out.of_sensor.resize(tracks.sensors.size());
    if (!standing.marked)
        return out;
    const GlobalPose pose = globalPose(actor.skeleton, standingPose(actor, true));
    for (size_t s = 0; s < tracks.sensors.size(); ++s) {
        const SensorTrack& track = tracks.sensors[s];
        if (!track.mounting || !standsWith(track, standing))
            continue;
        const auto joint = size_t(actor.skeleton.find(track.segment));
        const Quaterniond turn =
            pose.q_world_joint[joint] * track.mounting->q_segment_sensor *
            meanAttitude(track, standing, [&](size_t i) { return track.q_world_sensor[i]; }).conjugate();
        const double tilt_rad = std::acos(std::clamp((turn * Vector3d::UnitY()).y(), -1.0, 1.0));
        if (tilt_rad < kMostTilted_rad)
            out.of_sensor[s] = {2 * std::atan2(turn.y(), turn.w()),
                                std::hypot(track.mounting->sigma_rad, tilt_rad)};
    }
    return out;
}

Mountings findMountings(const Actor& actor, const SensorTracks& tracks, const Headings& headings,
                        const std::vector<SensorPair>& pairs, const Standing& standing) {
    Mountings out;
    std::vector<Quaterniond> q_standing;
    for (size_t s = 0; s < tracks.sensors.size(); ++s)
        q_standing.push_back(meanAttitude(tracks.sensors[s], standing,
                                          [&](size_t i) { return headings.turned(tracks, s, i); }));
    const Facing body(tracks, headings, pairs, q_standing);
    out.facing_rad = headings.facing_rad ? *headings.facing_rad : body.find(out.warnings);
    const auto turned_out = legsTurnedOut(tracks, pairs, body, out.facing_rad);
    const GlobalPose pose = globalPose(actor.skeleton, standingPose(actor, standing.marked));
    for (size_t s = 0; s < tracks.sensors.size(); ++s) {
        const int joint = actor.skeleton.find(tracks.sensors[s].segment);
        const Quaterniond facing = axisAngle(Vector3d::UnitY(), out.facing_rad + turned_out[s]);
        const bool stood = standsWith(tracks.sensors[s], standing);
        if (!stood)
            out.warnings.push_back("Sensor " + tracks.sensors[s].id +
                                   " does not read while the performer stands and is left out.");
        out.known.push_back(stood);
        out.q_segment_sensor.push_back(
            ((facing * pose.q_world_joint[size_t(joint)]).conjugate() * q_standing[s]).normalized());
    }
    return out;
}

}  // namespace noctule::posing
