// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/mannequin/implicit_body.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kFar_m = 1e3;
constexpr double kFine_m = 5e-4;
constexpr double kCleft_m = 0.016;       ///< fillet between a part and its mirror image
constexpr double kNearMiddle_m = 0.05;   ///< beyond, the mirror image of a part is too far to matter
constexpr double kSoleFillet_m = 0.006;  ///< where the soles are cut flat

/// Smooth minimum with second derivatives without jumps (I. Quilez, "Smooth minimum", cubic polynomial).
double smoothMin(double a, double b, double width) {
    if (width <= 0)
        return std::min(a, b);
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - h * h * h * width / 6;
}

double smoothMax(double a, double b, double width) {
    return -smoothMin(-a, -b, width);
}

Matrix3d rowsOf(PartAxes axes) {
    Matrix3d rows;  // across, front, along
    if (axes == PartAxes::kUpward)
        rows << 1, 0, 0, 0, 0, 1, 0, 1, 0;
    else if (axes == PartAxes::kOutward)
        rows << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    else
        rows << 1, 0, 0, 0, 1, 0, 0, 0, 1;
    return rows;
}

/// Slope of the profile at every section: the weighted mean of those to its neighbours, 0 at the ends.
template <class Profile>
std::vector<Profile> slopesOf(const std::vector<Section>& sections, const std::vector<Profile>& profiles) {
    std::vector<Profile> slopes(profiles.size(), Profile::Zero());
    for (size_t i = 1; i + 1 < profiles.size(); ++i) {
        const double before = sections[i].along_m - sections[i - 1].along_m;
        const double after = sections[i + 1].along_m - sections[i].along_m;
        slopes[i] = ((profiles[i] - profiles[i - 1]) / before * after +
                     (profiles[i + 1] - profiles[i]) / after * before) /
                    (before + after);
    }
    return slopes;
}

}  // namespace

ImplicitBody::ImplicitBody(const std::vector<Part>& parts, const Skeleton& skeleton, double root_height_m) {
    Pose pose = skeleton.zeroPose();
    pose.p_world_root.y() = root_height_m;
    const GlobalPose global = globalPose(skeleton, pose);
    for (const Part& part : parts) {
        const int joint = skeleton.find(part.joint);
        require(joint >= 0, "a part of the mannequin lies on no joint");
        lofts_.push_back(placed(part, global.p_world_joint[static_cast<size_t>(joint)]));
    }
}

ImplicitBody::Loft ImplicitBody::placed(const Part& part, const Vector3d& joint_m) {
    const Quaterniond turn = expQuaternion(part.turn_deg * std::numbers::pi / 180);
    Loft loft{rowsOf(part.axes) * turn.toRotationMatrix().transpose(),
              joint_m + part.origin_m,
              part,
              {},
              {},
              {},
              0};
    const double first_m = part.sections.front().along_m - part.first_cap_m;
    const double last_m = part.sections.back().along_m + part.last_cap_m;
    double reach_m = 0;
    for (const Section& s : part.sections) {
        loft.profiles.emplace_back(s.across_m, s.front_m, s.half_width_m, s.to_front_m, s.to_back_m);
        reach_m = std::max(reach_m, std::hypot(std::abs(s.across_m) + s.half_width_m,
                                               std::abs(s.front_m) + std::max(s.to_front_m, s.to_back_m)));
    }
    loft.slopes = slopesOf(part.sections, loft.profiles);
    loft.centre_m = loft.origin_m + loft.R_part_mesh.row(2).transpose() * (first_m + last_m) / 2;
    loft.radius_m = std::hypot((last_m - first_m) / 2, reach_m);
    return loft;
}

/// The cross-section at a place along the axis, held constant beyond the ends; cubic between.
ImplicitBody::Profile ImplicitBody::profileAt(const Loft& loft, double along_m) {
    const auto& sections = loft.shape.sections;
    if (along_m <= sections.front().along_m)
        return loft.profiles.front();
    if (along_m >= sections.back().along_m)
        return loft.profiles.back();
    size_t i = 0;
    while (along_m > sections[i + 1].along_m)
        ++i;
    const double step = sections[i + 1].along_m - sections[i].along_m;
    const double t = (along_m - sections[i].along_m) / step, u = 1 - t;
    return u * u * (1 + 2 * t) * loft.profiles[i] + t * u * u * step * loft.slopes[i] +
           t * t * (1 + 2 * u) * loft.profiles[i + 1] - t * t * u * step * loft.slopes[i + 1];
}

/// First-order distance (F - 1) / |grad F| to F = 1, where F is the norm of the place in its cross-section,
/// measured in half axes; domes beyond the ends are half ellipsoids.
double ImplicitBody::loftDistance_m(const Loft& loft, const Vector3d& p_m) {
    const Vector3d q = loft.R_part_mesh * (p_m - loft.origin_m);
    const auto& sections = loft.shape.sections;
    const Profile s = profileAt(loft, q.z());
    const double first_m = sections.front().along_m, last_m = sections.back().along_m;
    const double beyond_m = std::max(q.z() - last_m, 0.0) + std::min(q.z() - first_m, 0.0);
    const double cap_m = beyond_m > 0 ? loft.shape.last_cap_m : loft.shape.first_cap_m;
    const double depth = q.y() - s[1];
    const Vector3d axes(s[2], depth > 0 ? s[3] : s[4], cap_m);
    const Vector3d place(std::abs(q.x() - s[0]), std::abs(depth), std::abs(beyond_m));
    const double n = loft.shape.corner;
    const Vector3d scaled = place.cwiseQuotient(axes);
    const double norm = n == 2 ? scaled.norm() : std::pow(scaled.array().pow(n).sum(), 1 / n);
    if (norm < 1e-6)
        return -axes.head<2>().minCoeff();
    const Vector3d slope = scaled / norm;
    const Vector3d gradient = (n == 2 ? slope : Vector3d(slope.array().pow(n - 1))).cwiseQuotient(axes);
    return (norm - 1) / gradient.norm();
}

double ImplicitBody::partDistance_m(const Loft& loft, const Vector3d& p_m, double nothing_beyond_m) {
    const double at_least_m = (p_m - loft.centre_m).norm() - loft.radius_m;
    return at_least_m > nothing_beyond_m ? kFar_m : loftDistance_m(loft, p_m);
}

double ImplicitBody::distance_m(const Vector3d& p_m) const {
    const Vector3d left(std::abs(p_m.x()), p_m.y(), p_m.z()), right(-left.x(), p_m.y(), p_m.z());
    double d = kFar_m;
    for (const Loft& loft : lofts_) {
        const double blend_m = loft.shape.blend_m;
        const bool carve = loft.shape.use == PartUse::kCarve;
        const double beyond_m = carve ? blend_m - d : d + blend_m;
        double part = partDistance_m(loft, left, beyond_m);
        if (loft.shape.both_sides && left.x() < kNearMiddle_m)
            part = smoothMin(part, partDistance_m(loft, right, beyond_m), kCleft_m);
        d = carve ? smoothMax(d, -part, blend_m) : smoothMin(d, part, blend_m);
    }
    return smoothMax(d, -p_m.y(), kSoleFillet_m);
}

Vector3d ImplicitBody::normal(const Vector3d& p_m, double step_m) const {
    Vector3d gradient = Vector3d::Zero();  // from the corners of a tetrahedron: four places instead of six
    for (const Vector3d& corner : {Vector3d(1, 1, 1), {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
        gradient += distance_m(p_m + step_m * corner) * corner;
    return gradient.normalized();
}

Vector3d ImplicitBody::onSurface(Vector3d p_m) const {
    for (int round = 0; round < 2; ++round)
        p_m -= distance_m(p_m) * normal(p_m, kFine_m);
    return p_m;
}

}  // namespace noctule
