// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/random.h"

namespace noctule::simulation {
namespace {

/// Clothed skin gives back about a tenth of the energy.
constexpr double kFleshReflection = 0.3;

double reach(const World& world, const Vector3d& direction) {
    constexpr int kInstants = 200;
    double farthest = direction.dot(middleOfSuit(world, 0));
    for (int i = 1; i <= kInstants; ++i)
        farthest = std::max(farthest, direction.dot(middleOfSuit(world, world.duration_s() * i / kInstants)));
    return farthest;
}

Vector3d horizontal(double azimuth_rad) {
    return {std::sin(azimuth_rad), 0, std::cos(azimuth_rad)};
}

/// The point of a capsule where a ray from one end meets the other, nearly: on the axis where the unfolded
/// way is straight, then outward along the bisector.
Vector3d specularPoint(const WorldCapsule& capsule, const Vector3d& p, const Vector3d& q) {
    const Vector3d ab = capsule.b_m - capsule.a_m;
    const double length = ab.norm();
    const Vector3d axis = length > 0 ? Vector3d(ab / length) : Vector3d::UnitY();
    const double along_p = axis.dot(p - capsule.a_m), along_q = axis.dot(q - capsule.a_m);
    const double across_p = (p - capsule.a_m - along_p * axis).norm();
    const double across_q = (q - capsule.a_m - along_q * axis).norm();
    const double across = std::max(across_p + across_q, 1e-9);
    const double along = std::clamp((along_p * across_q + along_q * across_p) / across, 0.0, length);
    const Vector3d on_axis = capsule.a_m + along * axis;
    const Vector3d bisector = (p - on_axis).normalized() + (q - on_axis).normalized();
    return bisector.norm() < 1e-6 ? on_axis : Vector3d(on_axis + capsule.radius_m * bisector.normalized());
}

/// A convex cylinder spreads the sound in one plane: geometrical acoustics, with the flesh's own loss. It
/// fades by itself towards grazing incidence, where way and direct path are one.
double capsuleGain(double radius, double r1, double r2, double cos_incidence) {
    const double spread = radius * cos_incidence;
    return kFleshReflection * std::sqrt(spread / (spread + 2 * r1 * r2 / (r1 + r2)));
}

/// The ways of one pulse to one board.
class EchoSearch {
public:
    EchoSearch(const Room::Query& query, const std::vector<WorldCapsule>& capsules, const Medium& medium,
               std::vector<EchoPath>& echoes)
        : query_(query), capsules_(capsules), medium_(medium), echoes_(echoes) {}

    void addPlane(const Room::Plane& plane) {
        const double source_height = plane.normal.dot(source_) - plane.offset_m;
        const double microphone_height = plane.normal.dot(microphone_) - plane.offset_m;
        if (source_height <= 0 || microphone_height <= 0)
            return;
        const auto mirrored = [&](const Vector3d& p) {
            return Vector3d(p - 2 * (plane.normal.dot(p) - plane.offset_m) * plane.normal);
        };
        const Vector3d image = mirrored(source_);
        const Vector3d point =
            image + (microphone_ - image) * (source_height / (source_height + microphone_height));
        const double gain = plane.gain * airGain((microphone_ - image).norm(), medium_.absorption_db_per_m);
        add({{image, 0}, {mirrored(query_.source_later_m), 0}, gain}, point);
    }

    void addSphere(const Room::Sphere& sphere) {
        // A rigid sphere many wavelengths wide returns as if a source of strength radius / 2 stood in it.
        const double gain = sphere.radius_m / 2 *
                            airGain((sphere.center_m - source_).norm(), medium_.absorption_db_per_m) *
                            airGain((sphere.center_m - microphone_).norm(), medium_.absorption_db_per_m);
        add(viaPoint(sphere.center_m, gain), sphere.center_m);
    }

    void addCapsule(const WorldCapsule& capsule) {
        const int segment = capsule.segment;
        if (segment >= 0 && (segment == query_.source_segment || segment == query_.board_segment))
            return;
        const Vector3d point = specularPoint(capsule, source_, microphone_);
        const double r1 = (point - source_).norm(), r2 = (point - microphone_).norm();
        const double apart = (microphone_ - source_).norm();
        const double cos_between =
            std::clamp((r1 * r1 + r2 * r2 - apart * apart) / (2 * r1 * r2 + 1e-12), -1.0, 1.0);
        const double gain = capsuleGain(capsule.radius_m, r1, r2, std::sqrt((1 + cos_between) / 2)) *
                            airGain(r1 + r2, medium_.absorption_db_per_m);
        if (gain >= query_.least_gain && !blocks(capsule, source_, microphone_))
            add(viaPoint(point, gain), point, &capsule);
    }

private:
    EchoPath viaPoint(const Vector3d& point, double gain) const {
        return {{point, (point - source_).norm()}, {point, (point - query_.source_later_m).norm()}, gain};
    }

    /// Applies the source's directivity and keeps the way when it is loud and free enough.
    void add(EchoPath echo, const Vector3d& point, const WorldCapsule* reflecting = nullptr) {
        if (medium_.directivity)
            echo.gain *= pistonDirectivity(query_.ka, query_.ends.normal.dot((point - source_).normalized()),
                                           medium_.behind_source_db);
        if (echo.gain >= query_.least_gain && isFree(source_, point, reflecting) &&
            isFree(point, microphone_, reflecting))
            echoes_.push_back(echo);
    }

    bool isFree(const Vector3d& from, const Vector3d& to, const WorldCapsule* except) const {
        return !medium_.occlusion ||
               std::none_of(capsules_.begin(), capsules_.end(), [&](const WorldCapsule& capsule) {
                   return &capsule != except && blocks(capsule, from, to);
               });
    }

    const Room::Query& query_;
    const std::vector<WorldCapsule>& capsules_;
    const Medium& medium_;
    std::vector<EchoPath>& echoes_;
    const Vector3d& source_ = query_.ends.source_m;
    const Vector3d& microphone_ = query_.ends.microphone_m;
};

}  // namespace

Vector3d middleOfSuit(const World& world, double t_s) {
    Vector3d sum = Vector3d::Zero();
    for (int b = 0; b < world.boardCount(); ++b)
        sum += world.microphone(b, t_s);
    return world.boardCount() > 0 ? Vector3d(sum / world.boardCount()) : sum;
}

Room::Room(const World& world, const SoundScenario& scenario, uint64_t seed) {
    if (!scenario.reflections)
        return;
    Random random(seed, "room");
    const auto planeGain = [&] {
        return gainFromDb(random.uniform(scenario.wall_gain_db[0], scenario.wall_gain_db[1]));
    };
    planes_.push_back({Vector3d::UnitY(), 0, planeGain()});
    double azimuth_rad = random.uniform(0, 2 * std::numbers::pi);
    for (int i = 0; i < scenario.walls; ++i) {
        const Vector3d outward = horizontal(azimuth_rad);
        const double distance_m = random.uniform(scenario.wall_distance_m[0], scenario.wall_distance_m[1]);
        planes_.push_back({-outward, -(reach(world, outward) + distance_m), planeGain()});
        azimuth_rad += random.uniform(std::numbers::pi / 3, std::numbers::pi);
    }
    scatter(middleOfSuit(world, 0), scenario.scattering_points, random);
}

Room Room::chamber(const ChamberScenario& chamber, const SoundScenario& scenario, uint64_t seed) {
    Room room;
    if (!scenario.reflections)
        return room;
    Random random(seed, "room");
    room.planes_ = {{Vector3d::UnitY(), 0, gainFromDb(chamber.floor_gain_db)},
                    {-Vector3d::UnitY(), -chamber.height_m, gainFromDb(chamber.ceiling_gain_db)}};
    for (const Vector3d& outward :
         {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 0, 1), Vector3d(0, 0, -1)}) {
        const double distance_m = (outward.x() != 0 ? chamber.width_m : chamber.depth_m) / 2;
        const double gain_db = random.uniform(scenario.wall_gain_db[0], scenario.wall_gain_db[1]);
        room.planes_.push_back({-outward, -distance_m, gainFromDb(gain_db)});
    }
    room.scatter(Vector3d::Zero(), scenario.scattering_points, random);
    return room;
}

void Room::scatter(const Vector3d& middle, int count, Random& random) {
    for (int i = 0; i < count; ++i) {
        const double point_azimuth_rad = random.uniform(0, 2 * std::numbers::pi);
        Vector3d center = middle + random.uniform(0.6, 2.5) * horizontal(point_azimuth_rad);
        center.y() = random.uniform(0.2, 2.2);
        spheres_.push_back({center, random.uniform(0.05, 0.15)});
    }
}

void Room::echoes(const Query& query, const std::vector<WorldCapsule>& capsules, const Medium& medium,
                  std::vector<EchoPath>& echoes) const {
    echoes.clear();
    EchoSearch search(query, capsules, medium, echoes);
    for (const Plane& plane : planes_)
        search.addPlane(plane);
    for (const Sphere& sphere : spheres_)
        search.addSphere(sphere);
    for (const WorldCapsule& capsule : capsules)
        search.addCapsule(capsule);
}

}  // namespace noctule::simulation
