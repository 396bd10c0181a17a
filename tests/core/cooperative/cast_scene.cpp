// SPDX-License-Identifier: Apache-2.0
#include "tests/core/cooperative/cast_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/formats/bvh.h"
#include "core/math/rotation_fit.h"
#include "tests/support/nees.h"

namespace noctule::cooperative {
namespace {

const std::string kPairs = NOCTULE_SOURCE_DIR "/../shared/data/bvh/cmu/";
using Track = std::vector<std::vector<Vector3d>>;  // per frame, per point

MotionClip readClip(const std::string& file, double scale) {
    auto document = readBvh(kPairs + file);
    EXPECT_TRUE(document) << (document ? "" : document.error().text());
    auto clip = toClip(*document, scale > 0 ? BvhUnit::kMetre : BvhUnit::kCmu);
    EXPECT_TRUE(clip);
    return *clip;
}

Track trackOf(const MotionClip& clip, const std::vector<std::string>& joints, double scale, size_t skip) {
    std::vector<size_t> indices;
    for (const std::string& name : joints) {
        const int found = clip.skeleton.find(name);
        EXPECT_GE(found, 0) << name;
        indices.push_back(static_cast<size_t>(std::max(found, 0)));
    }
    Track track;
    for (size_t frame = skip; frame < clip.frames.size(); ++frame) {
        const GlobalPose pose = globalPose(clip, frame);
        std::vector<Vector3d> places;
        for (const size_t joint : indices)
            places.push_back(scale * pose.p_world_joint[joint]);
        track.push_back(std::move(places));
    }
    return track;
}

/// At 100 Hz, by cubics through four frames.
Track resampled(const Track& track, double rate_hz, double dt_s) {
    Track result;
    const double last = static_cast<double>(track.size()) - 3;
    for (size_t k = 0; 1 + static_cast<double>(k) * dt_s * rate_hz <= last; ++k) {
        const double at = 1 + static_cast<double>(k) * dt_s * rate_hz;
        const auto i = static_cast<size_t>(at);
        const double u = at - static_cast<double>(i);
        std::vector<Vector3d> places(track[i].size());
        for (size_t p = 0; p < places.size(); ++p) {
            const Vector3d &a = track[i - 1][p], &b = track[i][p], &c = track[i + 1][p], &d = track[i + 2][p];
            places[p] = b + 0.5 * u * (c - a + u * (2 * a - 5 * b + 4 * c - d + u * (3 * (b - c) + d - a)));
        }
        result.push_back(std::move(places));
    }
    return result;
}

CastScene sceneOf(const std::vector<Track>& people, double q_m2_per_s3) {
    CastScene scene;
    scene.q_m2_per_s3 = q_m2_per_s3;
    scene.places_m = people.front();
    for (size_t person = 1; person < people.size(); ++person)
        for (size_t step = 0; step < scene.places_m.size(); ++step)
            scene.places_m[step].insert(scene.places_m[step].end(), people[person][step].begin(),
                                        people[person][step].end());
    const size_t each = people.front().front().size();
    for (size_t i = 0; i < each * people.size(); ++i)
        scene.user_of_point.push_back(static_cast<int>(i / each));
    scene.anchors_m = fourAnchors();
    return scene;
}

/// The middle of all points stands over the middle of the room.
void toMiddle(std::vector<Track>& people) {
    Vector3d sum = Vector3d::Zero();
    double count = 0;
    for (const Track& track : people)
        for (const auto& places : track)
            for (const Vector3d& place : places)
                sum += place, count += 1;
    const Vector3d shift(sum.x() / count, 0, sum.z() / count);
    for (Track& track : people)
        for (auto& places : track)
            for (Vector3d& place : places)
                place -= shift;
}

std::vector<Track> handshakeTracks() {
    const MotionClip clip = readClip("pair_handshake/18_01.bvh", 0);
    const Track track =
        resampled(trackOf(clip,
                          {"head", "lhumerus", "lradius", "lwrist", "rwrist", "rhumerus", "rradius", "lfemur",
                           "ltibia", "lfoot", "rfemur", "rtibia", "rfoot"},
                          1, 0),
                  30, 0.01);
    const size_t meet = 420;
    const Vector3d wrist = track[meet][4];
    Vector3d ahead = track[350][0] - track[0][0];  // the way the head goes
    ahead.y() = 0;
    ahead.normalize();
    const Vector3d centre = wrist + 0.1 * ahead;
    std::vector<Track> people(2, track);
    for (size_t step = 0; step < track.size(); ++step)
        for (size_t p = 0; p < track[step].size(); ++p) {
            const double u = std::min(1.0, static_cast<double>(step) * 0.01 / 3.5);
            const Vector3d place = track[step][p] - 0.5 * (1 - u * u * (3 - 2 * u)) * ahead;
            people[0][step][p] = place;
            const Vector3d arm = place - centre;
            people[1][step][p] = Vector3d(centre.x() - arm.x(), place.y(), centre.z() - arm.z());
        }
    return people;
}

/// The turn and what remains after the best rigid motion of the estimate onto the truth (Kabsch).
std::pair<double, double> turnAndShape(const std::vector<Vector3d>& truth, const FreePoints& points) {
    Vector3d mean_truth = Vector3d::Zero(), mean = Vector3d::Zero();
    for (size_t i = 0; i < truth.size(); ++i)
        mean_truth += truth[i], mean += points.place(static_cast<int>(i));
    mean_truth /= static_cast<double>(truth.size()), mean /= static_cast<double>(truth.size());
    Matrix3d C = Matrix3d::Zero();
    for (size_t i = 0; i < truth.size(); ++i)
        C += (truth[i] - mean_truth) * (points.place(static_cast<int>(i)) - mean).transpose();
    const Matrix3d R = nearestRotation(C);
    double sum = 0;
    for (size_t i = 0; i < truth.size(); ++i)
        sum += (truth[i] - mean_truth - R * (points.place(static_cast<int>(i)) - mean)).squaredNorm();
    return {degrees(Eigen::AngleAxisd(R).angle()), sum};
}

}  // namespace

std::vector<Vector3d> fourAnchors() {
    return {{2.5, 0.5, 2.5}, {2.5, 2.5, -2.5}, {-2.5, 0.5, -2.5}, {-2.5, 2.5, 2.5}};
}

CastScene handshake() {
    auto people = handshakeTracks();
    toMiddle(people);
    return sceneOf(people, 0.03);
}

CastScene salsa() {
    std::vector<Track> people;
    for (const char* file : {"pair_salsa/60_05_scaled.bvh", "pair_salsa/61_05_scaled.bvh"})
        people.push_back(
            resampled(trackOf(readClip(file, 1.4),
                              {"head", "lShldr", "lForeArm", "lHand", "rHand", "rShldr", "rForeArm", "lThigh",
                               "lShin", "lFoot", "rThigh", "rShin", "rFoot"},
                              1.4, 1),
                      60, 0.01));
    toMiddle(people);
    return sceneOf(people, 0.3);
}

CastScene ringOf(int people) {
    const auto pair = handshakeTracks();
    const int pairs = people / 2;
    std::vector<Track> all;
    for (int k = 0; k < pairs; ++k)
        for (const Track& person : pair) {
            all.push_back(person);
            const double angle = 2 * std::numbers::pi * k / pairs;
            const double radius = pairs > 1 ? 0.5 / std::sin(std::numbers::pi / pairs) : 0;
            const Eigen::AngleAxisd turn(angle, Vector3d::UnitY());
            const Vector3d shift = turn * Vector3d(radius, 0, 0);
            for (auto& places : all.back())
                for (Vector3d& place : places)
                    place = turn * place + shift;
        }
    toMiddle(all);
    return sceneOf(all, 0.03);
}

CastScene drawnScene(int users, int points_each, int steps, double q_m2_per_s3, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const double dt = 0.01, sd_v = std::sqrt(q_m2_per_s3 * dt), sd_p = std::sqrt(q_m2_per_s3 * dt / 12) * dt;
    CastScene scene;
    scene.q_m2_per_s3 = q_m2_per_s3;
    scene.anchors_m = fourAnchors();
    std::vector<Vector3d> p, v;
    for (int i = 0; i < users * points_each; ++i) {
        scene.user_of_point.push_back(i / points_each);
        p.push_back(Vector3d{normal(random), 1 + 0.5 * normal(random), normal(random)});
        v.push_back(0.3 * Vector3d{normal(random), normal(random), normal(random)});
    }
    for (int step = 0; step < steps; ++step) {
        scene.places_m.push_back(p);
        for (size_t i = 0; i < p.size(); ++i)
            for (int axis = 0; axis < 3; ++axis) {
                const double dv = sd_v * normal(random);
                p[i][axis] += dt * (v[i][axis] + dv / 2) + sd_p * normal(random);
                v[i][axis] += dv;
            }
    }
    return scene;
}

CastScore runCast(const CastScene& scene, const CastRun& run) {
    std::mt19937 random(run.seed);
    std::normal_distribution<double> normal;
    const auto& first = scene.places_m.front();
    std::vector<Vector3d> start = first;
    for (Vector3d& place : start)
        for (int axis = 0; axis < 3; ++axis)
            place[axis] += run.start_sigma_m * normal(random);
    FreePoints points = startPoints(start, run.start_sigma_m, run.start_sigma_m_per_s);
    PointFilter filter(run.settings, std::move(points), scene.user_of_point, scene.anchors_m);
    std::vector<std::vector<PointRange>> pairs;
    for (int user = 0; user < scene.users(); ++user)
        pairs.push_back(pairsOfTarget(scene.user_of_point, static_cast<int>(scene.anchors_m.size()), user));
    CastScore score;
    double sum = 0, sum_wrist = 0, sum_nees = 0, sum_shape = 0;
    for (size_t step = 1; step < scene.places_m.size(); ++step) {
        const auto& truth = scene.places_m[step];
        const int target = static_cast<int>(step) % scene.users();
        std::vector<PointRange> ranges = pairs[static_cast<size_t>(target)];
        for (PointRange& range : ranges) {
            const Vector3d& other = range.other < 0 ? scene.anchors_m[static_cast<size_t>(-1 - range.other)]
                                                    : truth[static_cast<size_t>(range.other)];
            range.distance_m =
                (truth[static_cast<size_t>(range.point)] - other).norm() + run.sigma_m * normal(random);
            range.variance_m2 = run.sigma_m * run.sigma_m;
        }
        filter.predict(scene.dt_s);
        filter.correct(ranges, target);
        if (run.watch)
            run.watch(filter, step);
        if (static_cast<int>(step) < run.warm_up_steps)
            continue;
        Eigen::VectorXd error(filter.points().p_m.size());
        for (size_t i = 0; i < truth.size(); ++i)
            error.segment<3>(static_cast<Eigen::Index>(3 * i)) =
                filter.points().place(static_cast<int>(i)) - truth[i];
        const double square = error.squaredNorm() / static_cast<double>(truth.size());
        sum += square;
        score.worst_mm = std::max(score.worst_mm, 1000 * std::sqrt(square));
        if (scene.users() > 1 && scene.wrists[1] < static_cast<int>(truth.size()))
            sum_wrist +=
                (error.segment<3>(3 * scene.wrists[0]) - error.segment<3>(3 * scene.wrists[1])).squaredNorm();
        if (score.steps % 10 == 0)
            sum_nees += test::nees(error, filter.points().cov_pp);
        const auto [turn, shape] = turnAndShape(truth, filter.points());
        score.turn_deg = std::max(score.turn_deg, turn);
        sum_shape += shape / static_cast<double>(truth.size());
        ++score.steps;
    }
    const auto n = static_cast<double>(score.steps);
    score.rms_mm = 1000 * std::sqrt(sum / n);
    score.wrist_to_wrist_mm = 1000 * std::sqrt(sum_wrist / n);
    score.nees = sum_nees / std::ceil(n / 10);
    score.shape_mm = 1000 * std::sqrt(sum_shape / n);
    return score;
}

}  // namespace noctule::cooperative
