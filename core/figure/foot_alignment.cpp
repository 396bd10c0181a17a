// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/figure/aligner.h"
#include "core/figure/facing.h"
#include "core/math/rotation.h"

namespace noctule::figure {
namespace {

/// Below the horizontal, radians.
double slopeOf(const Vector3d& direction, const Vector3d& up) {
    return std::asin(std::clamp(-direction.normalized().dot(up), -1.0, 1.0));
}

}  // namespace

/// Slope of the line from ankle to toe while the foot stands, and its spread (half of the middle half's
/// width); nothing when it hardly ever stands. Standing: as low as it ever comes, and slow.
std::optional<std::pair<double, double>> Aligner::stanceSlope(int foot, int toe) const {
    constexpr double kSlow_m_per_s = 0.3, kLow = 0.06;
    struct Instant {
        double low, speed, slope;
    };
    std::vector<Instant> instants;
    std::vector<double> lows;
    for (size_t n = 0; n < seen_.poses().size(); ++n) {
        const size_t f = seen_.frames()[n];
        const GlobalPose& pose = seen_.poses()[n];
        const Vector3d ankle = pose.p_world_joint[static_cast<size_t>(foot)],
                       ball = pose.p_world_joint[static_cast<size_t>(toe)];
        if (f + 1 >= clip_.frames.size())
            break;
        const Vector3d next = globalPose(clip_, f + 1).p_world_joint[static_cast<size_t>(toe)];
        lows.push_back(ball.y());
        instants.push_back(
            {ball.y(), (next - ball).norm() / clip_.frame_time_s, slopeOf(ball - ankle, Vector3d::UnitY())});
    }
    if (lows.empty())
        return std::nullopt;
    std::sort(lows.begin(), lows.end());
    const double leg_m = seen_.distance(at("LeftUpLeg"), at("LeftLeg"));
    const double floor = lows[lows.size() / 20] + 2 * kLow * leg_m;
    std::vector<double> slopes;
    for (const Instant& instant : instants)
        if (instant.low < floor && instant.speed < kSlow_m_per_s)
            slopes.push_back(instant.slope);
    if (slopes.size() < 5 || slopes.size() * 20 < instants.size())
        return std::nullopt;
    std::sort(slopes.begin(), slopes.end());
    const double spread = (slopes[slopes.size() * 3 / 4] - slopes[slopes.size() / 4]) / 2;
    return std::pair{slopes[slopes.size() / 2], spread};
}

/// Whether the foot is flat in the zero pose: under straight legs, pointing forward, sole and toes level, and
/// not plainly otherwise than when it stands in the motion.
bool Aligner::zeroFootStands(const std::string& side, double stance_rad, double spread_rad) const {
    constexpr double kDown = radians(30), kSteepest = radians(50), kAgrees = radians(12),
                     kLevelToes = radians(10);
    if (!trunk_stands_)
        return false;
    const Vector3d up = q_zero_body_ * Vector3d::UnitY(), forward = q_zero_body_ * Vector3d::UnitZ();
    const Vector3d thigh = zero(side + "Leg") - zero(side + "UpLeg"),
                   shin = zero(side + "Foot") - zero(side + "Leg");
    if (angleOf(thigh, -up) > kDown || angleOf(shin, -up) > kDown)
        return false;
    if (!has(side + "ToeBase"))
        return true;
    const Vector3d bone = zero(side + "ToeBase") - zero(side + "Foot");
    if (bone.norm() < 1e-3)
        return true;
    const double slope = slopeOf(bone, up);
    const auto& tip = clip_.skeleton.joint(at(side + "ToeBase")).end_m;
    if (tip && tip->norm() > 1e-3 && std::abs(slopeOf(*tip, up)) > kLevelToes)
        return false;
    return bone.normalized().dot(forward) > 0.5 && slope > 0 && slope < kSteepest &&
           std::abs(slope - stance_rad) <= std::max(kAgrees, spread_rad);
}

/// Angle between the sole and the line from ankle to toe: shown by the toes' tip, else between how feet
/// usually are and how this one stands, whichever is surer.
double Aligner::slopeBelowAnkle(const std::string& side, const Vector3d& left, const Vector3d& ahead,
                                const std::optional<std::pair<double, double>>& stance) const {
    constexpr double kUsual = radians(8), kStanding = radians(4);
    const std::string toe = side + "ToeBase";
    const auto tip = has(toe) ? clip_.skeleton.joint(at(toe)).end_m : std::nullopt;
    if (tip && tip->norm() > 1e-3) {
        const Vector3d level = (*tip - left * left.dot(*tip)).normalized();
        const double slope = std::asin(std::clamp(level.cross(ahead).dot(left), -1.0, 1.0));
        if (slope > radians(3) && slope < radians(55))
            return slope;
    }
    const Vector3d usual_bone = boneOf(target_, side + "Foot", side + "ToeBase");
    const double usual = std::atan2(-usual_bone.y(), usual_bone.z());
    if (!stance || stance->first < radians(-5) || stance->first > radians(60))
        return usual;
    const double usual_weight = 1 / (kUsual * kUsual);
    const double stance_weight = 1 / (kStanding * kStanding + 4 * stance->second * stance->second);
    return (usual_weight * usual + stance_weight * stance->first) / (usual_weight + stance_weight);
}

/// From the zero pose where the foot is flat in it; else the sideways axis of the shin, and forward along the
/// foot.
void Aligner::alignFoot(const std::string& side) {
    const std::string foot = side + "Foot", toe = side + "ToeBase", shin = side + "Leg";
    if (!has(foot))
        return;
    const bool has_toe = has(toe) && seen_.distance(at(foot), at(toe)) > 1e-3;
    const auto stance = has_toe ? stanceSlope(at(foot), at(toe)) : std::nullopt;
    const double zero_slope = has_toe ? slopeOf(zero(toe) - zero(foot), q_zero_body_ * Vector3d::UnitY()) : 0;
    if (zeroFootStands(side, stance ? stance->first : zero_slope, stance ? stance->second : 0)) {
        q_[foot] = q_zero_body_;
    } else {
        q_[foot] = q_.at(shin);
        const Vector3d seen_left = meanIn(foot, [&](const GlobalPose& pose) {
            return Vector3d(canonical(pose, shin) * Vector3d::UnitX());
        });
        constexpr double kFar = radians(25);
        Vector3d left = q_[foot] * Vector3d::UnitX();
        if (angleOf(left, seen_left) > kFar)
            left = seen_left;
        const auto& tip = clip_.skeleton.joint(at(foot)).end_m;
        if (has_toe || (tip && tip->norm() > 1e-3)) {
            const Vector3d ahead = (has_toe ? bone(foot, toe) : *tip).normalized();
            left = (left - ahead * ahead.dot(left)).normalized();
            const Vector3d forward = axisAngle(left, -slopeBelowAnkle(side, left, ahead, stance)) * ahead;
            setAxes(foot, left, forward.cross(left));
        }
    }
    if (has(toe))
        q_[toe] = q_[foot];
}

}  // namespace noctule::figure
