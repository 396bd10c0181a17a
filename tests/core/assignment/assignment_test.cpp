// SPDX-License-Identifier: Apache-2.0
// Sensors on segments by movement: simulated from a recorded motion, and on the real recording of qmt. Both
// need the files beside the repository (../shared/data) and skip without them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <random>

#include "core/assignment/assign_segments.h"
#include "core/assignment/joint_evidence.h"
#include "core/formats/bvh.h"
#include "core/import/import_format.h"
#include "core/math/rotation.h"
#include "tests/support/files.h"

namespace noctule::assignment {
namespace {

struct NamedSensors {
    std::vector<std::string> segments;
    std::vector<ImuSamples> sensors;
};

/// In another order and mounted in any way.
NamedSensors disguised(const NamedSensors& given, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<size_t> order(given.sensors.size());
    for (size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    NamedSensors out;
    for (const size_t i : order) {
        const Quaterniond mount =
            Quaterniond{normal(random), normal(random), normal(random), normal(random)}.normalized();
        ImuSamples samples = given.sensors[i];
        for (auto* list : {&samples.gyro_rad_per_s, &samples.accel_m_per_s2})
            for (Vector3d& reading : *list)
                reading = mount * reading;
        out.segments.push_back(given.segments[i]);
        out.sensors.push_back(std::move(samples));
    }
    return out;
}

size_t rightOnes(const NamedSensors& truth, const Assignment& found) {
    size_t right = 0;
    for (size_t s = 0; s < truth.segments.size(); ++s) {
        right += found.sensors[s].segment == truth.segments[s];
        if (found.sensors[s].segment != truth.segments[s])
            std::printf("%s was taken for %s (confidence %.2f)\n", truth.segments[s].c_str(),
                        found.sensors[s].segment.c_str(), found.sensors[s].confidence);
    }
    return right;
}

NamedSensors qmtBody() {
    NamedSensors body;
    const std::string path = NOCTULE_SOURCE_DIR "/../shared/data/imu/qmt_fullbody/full_body_example_data.mat";
    if (!std::filesystem::exists(path))
        return body;
    const auto read = readImport(*findImportFormat("mat"), {{path, test::readBytes(path)}}, {}, {});
    EXPECT_TRUE(read) << read.error().text();
    for (const ImportedSensor& sensor : read->sensors) {
        body.segments.push_back(sensor.segment);
        body.sensors.push_back(sensor.samples);
    }
    return body;
}

TEST(AssignSegments, AllSixteenOfQmtsBodyAreRight) {
    const NamedSensors body = qmtBody();
    if (body.sensors.empty())
        GTEST_SKIP() << "needs ../shared/data/imu";
    for (unsigned seed = 1; seed <= 2; ++seed) {
        const NamedSensors given = disguised(body, seed);
        const auto found = assignSegments(given.sensors, {});
        ASSERT_TRUE(found) << found.error().text();
        EXPECT_EQ(rightOnes(given, *found), 16u);
        EXPECT_TRUE(found->warnings.empty());
        EXPECT_GT(std::abs(found->legs_side), 0.3);
        EXPECT_GT(std::abs(found->arms_side), 0.8);
    }
}

TEST(AssignSegments, TheLegsAloneAreRightToo) {
    const NamedSensors body = qmtBody();
    if (body.sensors.empty())
        GTEST_SKIP() << "needs ../shared/data/imu";
    NamedSensors legs;
    for (size_t s = 0; s < body.segments.size(); ++s)
        if (body.segments[s] == "Hips" || body.segments[s].ends_with("Leg") ||
            body.segments[s].ends_with("Foot")) {
            legs.segments.push_back(body.segments[s]);
            legs.sensors.push_back(body.sensors[s]);
        }
    ASSERT_EQ(legs.sensors.size(), 7u);
    const NamedSensors given = disguised(legs, 5);
    const auto found = assignSegments(given.sensors, {});
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(rightOnes(given, *found), 7u);
}

/// Sensors rigid on the segments of a recorded motion.
NamedSensors simulatedBody(const std::string& path) {
    static const std::map<std::string, std::string> names = {
        {"Hips", "Hips"},           {"LowerBack", "Spine"},       {"Spine1", "Chest"},
        {"Head", "Head"},           {"LeftUpLeg", "LeftUpLeg"},   {"LeftLeg", "LeftLeg"},
        {"LeftFoot", "LeftFoot"},   {"RightUpLeg", "RightUpLeg"}, {"RightLeg", "RightLeg"},
        {"RightFoot", "RightFoot"}, {"LeftArm", "LeftArm"},       {"LeftForeArm", "LeftForeArm"},
        {"LeftHand", "LeftHand"},   {"RightArm", "RightArm"},     {"RightForeArm", "RightForeArm"},
        {"RightHand", "RightHand"}};
    NamedSensors body;
    const auto document = readBvh(path);
    EXPECT_TRUE(document) << document.error().text();
    const auto read = toClip(*document);
    EXPECT_TRUE(read) << read.error().text();
    const MotionClip& clip = *read;
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    const double rate_hz = 1 / clip.frame_time_s;
    for (int j = 0; j < clip.skeleton.size(); ++j) {
        const auto name = names.find(clip.skeleton.joint(j).name);
        if (name == names.end())
            continue;
        Vector3d offset_m = Vector3d{normal(random), normal(random), normal(random)} * 0.02;
        for (const Joint& child : clip.skeleton.joints())
            if (child.parent == j) {
                offset_m += child.offset_m / 2;
                break;
            }
        std::vector<Vector3d> place;
        std::vector<Quaterniond> q;
        for (size_t f = 2; f < clip.frames.size(); ++f) {
            const GlobalPose pose = globalPose(clip, f);
            q.push_back(pose.q_world_joint[size_t(j)]);
            place.push_back(pose.p_world_joint[size_t(j)] + q.back() * offset_m);
        }
        place = lowPassed(place, rate_hz, 15);
        ImuSamples samples;
        samples.rate_hz = rate_hz;
        for (size_t f = 1; f + 1 < place.size(); ++f) {
            const Vector3d accel = (place[f + 1] - 2 * place[f] + place[f - 1]) * rate_hz * rate_hz +
                                   Vector3d(0, kStandardGravity_m_per_s2, 0);
            samples.accel_m_per_s2.push_back(q[f].conjugate() * accel);
            samples.gyro_rad_per_s.push_back(logQuaternion(q[f - 1].conjugate() * q[f + 1]) * rate_hz / 2);
        }
        body.segments.push_back(name->second);
        body.sensors.push_back(std::move(samples));
    }
    return body;
}

TEST(AssignSegments, SensorsOfARecordedMotionAreRight) {
    const std::string path = NOCTULE_SOURCE_DIR "/../shared/data/bvh/cmu/01_01_hop_turn.bvh";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "needs ../shared/data/bvh";
    const NamedSensors given = disguised(simulatedBody(path), 2);
    ASSERT_EQ(given.sensors.size(), 16u);
    const auto found = assignSegments(given.sensors, {});
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(rightOnes(given, *found), 16u);
}

TEST(AssignSegments, WhatCannotBeToldIsRefused) {
    ImuSamples still;
    still.rate_hz = 100;
    still.gyro_rad_per_s.assign(1000, Vector3d::Zero());
    still.accel_m_per_s2.assign(1000, Vector3d(0, 9.81, 0));
    const auto odd = assignSegments(std::vector<ImuSamples>(5, still), {});
    ASSERT_FALSE(odd);
    EXPECT_NE(odd.error().message.find("5 sensors"), std::string::npos);
    EXPECT_FALSE(assignSegments(std::vector<ImuSamples>(7, still), {})) << "nothing moves";
    std::vector<ImuSamples> uneven(7, still);
    uneven[3].gyro_rad_per_s.pop_back();
    uneven[3].accel_m_per_s2.pop_back();
    EXPECT_FALSE(assignSegments(uneven, {}));
}

}  // namespace
}  // namespace noctule::assignment
