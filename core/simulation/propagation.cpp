// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/propagation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/simulation/sound_scenario.h"

namespace noctule::simulation {
namespace {

using Eigen::Vector2d;

constexpr double kClearance_m = 0.01;
constexpr double kNearest_m = 0.01;

double distanceToSegment(const Vector3d& point, const Vector3d& a, const Vector3d& b) {
    const Vector3d ab = b - a;
    const double length2 = ab.squaredNorm();
    const double s = length2 > 0 ? std::clamp((point - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
    return (point - a - s * ab).norm();
}

/// Ericson, "Real-Time Collision Detection" (2005), section 5.1.9.
double segmentDistance(const Vector3d& p, const Vector3d& q, const Vector3d& a, const Vector3d& b) {
    const Vector3d pq = q - p, ab = b - a, offset = p - a;
    const double pq2 = pq.squaredNorm(), ab2 = ab.squaredNorm(), along = pq.dot(ab);
    const double c = pq.dot(offset), f = ab.dot(offset);
    if (pq2 <= 0)
        return distanceToSegment(p, a, b);
    if (ab2 <= 0)
        return distanceToSegment(a, p, q);
    const double determinant = pq2 * ab2 - along * along;
    double s =
        determinant > 1e-12 * pq2 * ab2 ? std::clamp((along * f - c * ab2) / determinant, 0.0, 1.0) : 0;
    double t = (along * s + f) / ab2;
    if (t < 0 || t > 1) {
        t = std::clamp(t, 0.0, 1.0);
        s = std::clamp((along * t - c) / pq2, 0.0, 1.0);
    }
    return (offset + s * pq - t * ab).norm();
}

/// Cheap test that leaves few capsules to look at closely: the line misses a sphere around the capsule,
/// without a root or a division.
bool farFrom(const WorldCapsule& capsule, const Vector3d& from, const Vector3d& to) {
    const double half2 = 0.25 * (capsule.b_m - capsule.a_m).squaredNorm();
    // (h + r)^2 <= 1.5 h^2 + 3 r^2, equal where h = 2 r.
    const double reach2 = 1.5 * half2 + 3 * capsule.radius_m * capsule.radius_m;
    const Vector3d way = to - from, center = 0.5 * (capsule.a_m + capsule.b_m) - from;
    const double along = way.dot(center), way2 = way.squaredNorm(), center2 = center.squaredNorm();
    if (along <= 0)
        return center2 > reach2;
    if (along >= way2)
        return (center - way).squaredNorm() > reach2;
    return center2 * way2 - along * along > reach2 * way2;
}

/// The radius that leaves both points outside; negative when one of them lies on the axis.
double yieldingRadius(const WorldCapsule& capsule, const Vector3d& from, const Vector3d& to) {
    const double nearest = std::min(distanceToSegment(from, capsule.a_m, capsule.b_m),
                                    distanceToSegment(to, capsule.a_m, capsule.b_m));
    return std::min(capsule.radius_m, nearest - kClearance_m);
}

/// Length of a taut string between points at distances p and q from the centre of a circle, laid around it
/// through that angle.
double stringAroundCircle(double p, double q, double angle_rad, double radius) {
    const double arc_rad =
        angle_rad - std::acos(std::min(1.0, radius / p)) - std::acos(std::min(1.0, radius / q));
    if (arc_rad <= 0)
        return std::sqrt(std::max(0.0, p * p + q * q - 2 * p * q * std::cos(angle_rad)));
    const double free2_p = std::max(0.0, p * p - radius * radius);
    const double free2_q = std::max(0.0, q * q - radius * radius);
    return std::sqrt(free2_p) + std::sqrt(free2_q) + radius * arc_rad;
}

double angleBetweenVectors(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The point lies before an end of the capsule, within its cylinder.
bool endOn(const WorldCapsule& capsule, double radius, const Vector3d& point) {
    const Vector3d axis = (capsule.b_m - capsule.a_m).normalized();
    return axis.cross(point - capsule.a_m).norm() < radius && axis.squaredNorm() > 0;
}

/// Around the infinite cylinder: a developable surface, so the string is the diagonal of its unrolling.
double lengthAroundCylinder(const WorldCapsule& capsule, double radius, const Vector3d& from,
                            const Vector3d& to) {
    const Vector3d axis = (capsule.b_m - capsule.a_m).normalized();
    const Vector3d p = from - capsule.a_m, q = to - capsule.a_m;
    const Vector3d p_across = p - axis * axis.dot(p), q_across = q - axis * axis.dot(q);
    if (endOn(capsule, radius, from) || endOn(capsule, radius, to))
        return std::numeric_limits<double>::infinity();
    const double across =
        stringAroundCircle(p_across.norm(), q_across.norm(), angleBetweenVectors(p_across, q_across), radius);
    return std::hypot(across, axis.dot(q - p));
}

/// The section of a capsule by a plane through the line of sight, as circles of points (its hull is meant),
/// in coordinates of that plane: the line runs from (0, 0) along x.
class Outline {
public:
    Outline(const WorldCapsule& capsule, double radius, const Vector3d& from, const Vector3d& along,
            const Vector3d& normal) {
        const Vector3d aside = normal.cross(along), axis = capsule.b_m - capsule.a_m;
        // A plane parallel to the axis cuts a stadium: two circles make it. Others are made of more.
        const bool stadium = std::abs(normal.dot(axis)) < 1e-9;
        for (int i = 0; i < kCircles; i += stadium ? kCircles - 1 : 1) {
            const Vector3d center = capsule.a_m + axis * i / (kCircles - 1.0) - from;
            const double height = normal.dot(center);
            if (std::abs(height) < radius)
                addCircle({along.dot(center), aside.dot(center)},
                          std::sqrt(radius * radius - height * height));
        }
    }
    const Vector2d* begin() const { return points_.data(); }
    const Vector2d* end() const { return points_.data() + count_; }
    size_t size() const { return count_; }

private:
    static constexpr int kCircles = 6, kPointsPerCircle = 24;

    void addCircle(const Vector2d& center, double radius) {
        for (int i = 0; i < kPointsPerCircle; ++i) {
            const double angle_rad = 2 * std::numbers::pi * i / kPointsPerCircle;
            points_[count_++] = center + radius * Vector2d{std::cos(angle_rad), std::sin(angle_rad)};
        }
    }

    std::array<Vector2d, kCircles * kPointsPerCircle> points_;
    size_t count_ = 0;
};

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// A taut string from (0, 0) to (length, 0) around a convex outline between them, on its left (side +1) or
/// right side (-1): gift wrapping, as both ends are corners of the hull.
double stringAroundOutline(const Outline& outline, double length, double side) {
    const Vector2d end{length, 0};
    Vector2d here = Vector2d::Zero();
    double total = 0;
    for (size_t corner = 0; corner <= outline.size(); ++corner) {
        Vector2d next = end;
        for (const Vector2d& point : outline) {
            if (point != here && side * cross(next - here, point - here) > 0)
                next = point;
        }
        total += (next - here).norm();
        here = next;
        if (here == end)
            break;
    }
    return total;
}

double blockingRadius(const WorldCapsule& capsule, const Vector3d& from, const Vector3d& to) {
    if (farFrom(capsule, from, to))
        return 0;
    const double distance = segmentDistance(from, to, capsule.a_m, capsule.b_m);
    if (distance >= capsule.radius_m)
        return 0;
    const double radius = yieldingRadius(capsule, from, to);
    return distance < radius ? radius : 0;
}

}  // namespace

Medium mediumOf(const SoundScenario& scenario, double speed_of_sound_m_per_s) {
    return {.speed_of_sound_m_per_s = speed_of_sound_m_per_s,
            .absorption_db_per_m = scenario.absorption_db_per_m,
            .directivity = scenario.directivity,
            .occlusion = scenario.occlusion,
            .late_path = scenario.late_path,
            .behind_source_db = scenario.behind_source_db,
            .late_path_db = scenario.late_path_db,
            .late_path_db_per_cm = scenario.late_path_db_per_cm};
}

double pistonDirectivity(double ka, double cos_angle, double behind_source_db) {
    if (cos_angle < 0)
        return gainFromDb(behind_source_db);
    // 2 J1(x)/x = sum of (-x^2/4)^k / (k! (k+1)!): for the ka of small transducers a dozen terms are exact.
    const double quarter = 0.25 * ka * ka * std::max(0.0, 1 - cos_angle * cos_angle);
    double term = 1, sum = 1;
    for (int k = 1; std::abs(term) > 1e-17 && k < 100; ++k) {
        term *= -quarter / (k * (k + 1.0));
        sum += term;
    }
    return sum;
}

double airGain(double length_m, double absorption_db_per_m) {
    const double length = std::max(length_m, kNearest_m);
    return gainFromDb(-absorption_db_per_m * length) / length;
}

bool blocks(const WorldCapsule& capsule, const Vector3d& from_m, const Vector3d& to_m) {
    return blockingRadius(capsule, from_m, to_m) > 0;
}

double detourAround(const WorldCapsule& capsule, const Vector3d& from_m, const Vector3d& to_m) {
    const double radius = blockingRadius(capsule, from_m, to_m);
    if (radius <= 0)
        return 0;
    const double straight = (to_m - from_m).norm();
    const Vector3d along = (to_m - from_m) / straight;
    Vector3d normal = along.cross(capsule.b_m - capsule.a_m);
    if (normal.norm() < 1e-9)
        normal = along.unitOrthogonal();
    normal.normalize();
    const auto inPlane = [&](const Vector3d& plane_normal) {
        const Outline outline(capsule, radius, from_m, along, plane_normal);
        return std::min(stringAroundOutline(outline, straight, 1),
                        stringAroundOutline(outline, straight, -1));
    };
    double shortest = std::min(lengthAroundCylinder(capsule, radius, from_m, to_m), inPlane(normal));
    if (endOn(capsule, radius, from_m) || endOn(capsule, radius, to_m))
        shortest = std::min(shortest, inPlane(normal.cross(along)));
    return std::max(0.0, shortest - straight);
}

DirectPath directPath(const PathEnds& ends, const std::vector<WorldCapsule>& capsules, double ka,
                      const Medium& medium) {
    DirectPath path;
    const Vector3d way = ends.microphone_m - ends.source_m;
    path.distance_m = way.norm();
    path.angle_rad = angleBetweenVectors(ends.normal, way);
    path.behind_source = ends.normal.dot(way) < 0;
    path.gain = airGain(path.distance_m, medium.absorption_db_per_m);
    if (medium.directivity)
        path.gain *= pistonDirectivity(ka, std::cos(path.angle_rad), medium.behind_source_db);
    if (!medium.occlusion)
        return path;
    for (const WorldCapsule& capsule : capsules) {
        if (!blocks(capsule, ends.source_m, ends.microphone_m))
            continue;
        path.occluded = true;
        path.detour_m = std::max(path.detour_m, detourAround(capsule, ends.source_m, ends.microphone_m));
    }
    const double late_path_db = medium.late_path_db + medium.late_path_db_per_cm * 100 * path.detour_m;
    if (path.occluded)
        path.gain *= medium.late_path ? gainFromDb(late_path_db) : 0;
    return path;
}

Flight directFlight(const World& world, int source, int board, double emission_s,
                    double speed_of_sound_m_per_s) {
    const Vector3d p_source = world.source(source, emission_s);
    Flight flight{emission_s, 0};
    // Each round shrinks the error by the microphone's Mach number, below 0.1 for anything on a body.
    for (int round = 0; round < 30; ++round) {
        flight.distance_m = (world.microphone(board, flight.arrival_s) - p_source).norm();
        const double arrival_s = emission_s + flight.distance_m / speed_of_sound_m_per_s;
        const bool settled = std::abs(arrival_s - flight.arrival_s) < 1e-12;
        flight.arrival_s = arrival_s;
        if (settled)
            break;
    }
    return flight;
}

}  // namespace noctule::simulation
