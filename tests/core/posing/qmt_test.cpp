// SPDX-License-Identifier: Apache-2.0
// The real recording of qmt: 16 sensors without magnetometers, 100 s. Needs ../shared/data and skips without.
// Events of its authors, on the recording's clock: standing 40 to 44 s, sitting 52 to 79, walking 95 to 115,
// a turn, walking 116 to 138.5, a turn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/import/import_format.h"
#include "core/math/rotation.h"
#include "core/motion/foot_contacts.h"
#include "core/posing/pose_body.h"
#include "core/posing/still_bias.h"
#include "tests/support/files.h"

namespace noctule::posing {
namespace {

constexpr double kStart_s = 40;

struct Qmt {
    SensorTracks tracks;
    BodyMotion motion;
};

const Qmt* qmt() {
    static const std::optional<Qmt> recording = []() -> std::optional<Qmt> {
        const std::string path =
            NOCTULE_SOURCE_DIR "/../shared/data/imu/qmt_fullbody/full_body_example_data.mat";
        if (!std::filesystem::exists(path))
            return std::nullopt;
        const auto read =
            readImport(*findImportFormat("mat"), {{path, noctule::test::readBytes(path)}}, {}, {});
        EXPECT_TRUE(read) << read.error().text();
        SensorTracks tracks;
        tracks.rate_hz = 50;
        for (ImportedSensor sensor : read->sensors) {
            const auto run = wornOrientation(sensor.samples, true, {});
            EXPECT_TRUE(run);
            SensorTrack track;
            track.id = sensor.id;
            track.segment = sensor.segment;
            for (size_t i = 0; i + 1 < sensor.samples.size(); i += 2) {
                track.q_world_sensor.push_back(run->q_world_sensor[i]);
                track.rate_rad_per_s.push_back(
                    (sensor.samples.gyro_rad_per_s[i] + sensor.samples.gyro_rad_per_s[i + 1]) / 2);
                track.accel_m_per_s2.push_back(
                    (sensor.samples.accel_m_per_s2[i] + sensor.samples.accel_m_per_s2[i + 1]) / 2);
                track.heading_sigma_rad.push_back(std::numbers::pi);
            }
            tracks.sensors.push_back(std::move(track));
        }
        auto made = poseBody(defaultActor(), tracks, std::nullopt, {}, {});
        EXPECT_TRUE(made) << made.error().text();
        return made ? std::optional(Qmt{std::move(tracks), std::move(*made)}) : std::nullopt;
    }();
    return recording ? &*recording : nullptr;
}

class QmtBody : public ::testing::Test {
protected:
    void SetUp() override {
        if (!qmt())
            GTEST_SKIP() << "needs ../shared/data/imu";
        motion_ = &qmt()->motion;
    }

    /// By how much gravity turns in the sensor of a segment from standing to sitting, whatever the method.
    double sittingByGravity_deg(const std::string& segment) const {
        const auto& sensors = qmt()->tracks.sensors;
        const auto track = std::ranges::find(sensors, segment, &SensorTrack::segment);
        const auto mean = [&](double from_s, double to_s) {
            Vector3d sum = Vector3d::Zero();
            for (size_t i = row(from_s); i < row(to_s); ++i)
                sum += track->accel_m_per_s2[i];
            return sum;
        };
        const Vector3d standing = mean(41, 43.5), sitting = mean(55, 77);
        return degrees(std::atan2(standing.cross(sitting).norm(), standing.dot(sitting)));
    }

    size_t row(double time_s) const { return size_t((time_s - kStart_s) * 50); }
    GlobalPose at(size_t i) const { return globalPose(actor_.skeleton, *motion_->poses[i].pose); }
    size_t joint(const std::string& name) const { return size_t(actor_.skeleton.find(name)); }
    /// Angle of a direction of a segment from the vertical.
    double fromVertical_deg(size_t i, const std::string& segment, const Vector3d& axis) const {
        const Vector3d v = at(i).q_world_joint[joint(segment)] * axis;
        return degrees(std::acos(std::clamp(v.y(), -1.0, 1.0)));
    }
    double flexion_deg(size_t i, const std::string& knee) const {
        const auto j = joint(knee);
        return degrees(
            projectOntoJoint(actor_.skeleton.joint(int(j)), motion_->poses[i].pose->q_parent_joint[j], false)
                .angles_rad[0]);
    }
    double heading_deg(size_t i) const {
        const Vector3d v = at(i).q_world_joint[0] * Vector3d::UnitZ();
        return degrees(std::atan2(v.x(), v.z()));
    }

    Actor actor_ = defaultActor();
    const BodyMotion* motion_ = nullptr;
};

TEST_F(QmtBody, Stands) {
    for (const std::string& warning : motion_->warnings)
        ADD_FAILURE() << warning;
    double most = 0;
    for (double t = 41; t < 43.5; t += 0.5) {
        for (const char* segment : {"Hips", "Chest", "LeftUpLeg", "LeftLeg", "RightUpLeg", "RightLeg"}) {
            const double off = fromVertical_deg(row(t), segment, Vector3d::UnitY());
            EXPECT_LT(off, 8) << segment << " at " << t;
            most = std::max(most, off);
        }
        EXPECT_NEAR(flexion_deg(row(t), "LeftLeg"), 0, 10);
    }
    std::printf("qmt: standing, hips, chest and legs at most %.1f deg from upright\n", most);
}

TEST_F(QmtBody, SitsWithThighsLevelAndKneesBent) {
    double flattest = 180, steepest = 0, least_bent = 180, most_bent = 0;
    for (double t = 55; t < 77; t += 2) {
        double thighs = 0;
        for (const std::string side : {"Left", "Right"}) {
            const double thigh = fromVertical_deg(row(t), side + "UpLeg", Vector3d::UnitY());
            thighs += thigh / 2;
            EXPECT_NEAR(thigh, sittingByGravity_deg(side + "UpLeg"), 3) << side << t;
            const double knee = flexion_deg(row(t), side + "Leg");
            EXPECT_NEAR(knee, 90, 10) << side << t;
            least_bent = std::min(least_bent, knee);
            most_bent = std::max(most_bent, knee);
        }
        EXPECT_NEAR(thighs, 90, 10) << t;
        flattest = std::min(flattest, thighs);
        steepest = std::max(steepest, thighs);
    }
    std::printf("qmt: sitting, thighs %.1f to %.1f deg from upright (mean of both), knees %.1f to %.1f deg\n",
                flattest, steepest, least_bent, most_bent);
}

TEST_F(QmtBody, WalksStraightAndTurnsAbout) {
    const double out = heading_deg(row(105)), back = heading_deg(row(127));
    EXPECT_NEAR(std::abs(std::remainder(back - out, 360)), 180, 20);
    const Vector3d way =
        motion_->poses[row(112)].pose->p_world_root - motion_->poses[row(98)].pose->p_world_root;
    const double direction = degrees(std::atan2(way.x(), way.z()));
    EXPECT_NEAR(std::remainder(direction - out, 360), 0, 20);
    EXPECT_GT(way.norm(), 5);
    std::printf("qmt: turned by %.0f deg, walked %.1f m in 14 s, %.0f deg beside where the body faces\n",
                std::abs(std::remainder(back - out, 360)), way.norm(),
                std::abs(std::remainder(direction - out, 360)));
}

TEST_F(QmtBody, FeetAlternateAndStandOnTheFloor) {
    const auto feet = findFootContacts({actor_.skeleton, motion_->poses});
    ASSERT_EQ(feet.size(), 2u);
    double highest = 0, longest_slide = 0;
    size_t all_steps = 0;
    for (const FootContacts& foot : feet) {
        const auto ankle = joint(foot.foot), toes = ankle + 1;
        ASSERT_EQ(actor_.skeleton.joint(int(toes)).parent, int(ankle));
        const double sole = actor_.skeleton.joint(int(toes)).offset_m.y();
        size_t steps = 0;
        for (const FootContact& contact : foot.contacts) {
            if (contact.from_s < 56 || contact.to_s > 98)
                continue;
            ++steps;
            const GlobalPose body = at(size_t((contact.from_s + contact.to_s) / 2 * 50));
            const Vector3d heel =
                body.p_world_joint[ankle] + body.q_world_joint[ankle] * Vector3d(0, sole, 0);
            const double height = std::min(heel.y(), body.p_world_joint[toes].y());
            EXPECT_LT(std::abs(height), 0.03) << foot.foot << contact.from_s;
            EXPECT_LT(contact.slide_m, 0.05) << foot.foot << contact.from_s;
            highest = std::max(highest, std::abs(height));
            longest_slide = std::max(longest_slide, contact.slide_m);
        }
        EXPECT_GT(steps, 30u);
        EXPECT_LT(steps, 60u);
        all_steps += steps;
    }
    std::printf("qmt: %zu stances, soles at most %.1f cm off the floor, sliding at most %.1f cm\n", all_steps,
                100 * highest, 100 * longest_slide);
}

TEST_F(QmtBody, KneesBendInTurn) {
    std::string order;
    for (const auto& [begin, end] : {std::pair{96.5, 114.0}, std::pair{118.0, 137.5}}) {
        bool left_bent = false, right_bent = false;
        const auto look = [&](size_t i, const char* knee, bool& bent, char letter) {
            const double flexion = flexion_deg(i, knee);
            if (!bent && flexion > 45)
                order += letter;
            bent = flexion > (bent ? 25 : 45);
        };
        for (size_t i = row(begin); i < row(end); ++i) {
            look(i, "LeftLeg", left_bent, 'L');
            look(i, "RightLeg", right_bent, 'R');
        }
        order += ' ';
    }
    EXPECT_EQ(order.find("LL"), std::string::npos) << order;
    EXPECT_EQ(order.find("RR"), std::string::npos) << order;
    EXPECT_GT(order.size(), 50u) << order;
    std::printf("qmt: knees bend in turn, %zu times\n",
                size_t(std::ranges::count_if(order, [](char c) { return c != ' '; })));
}

}  // namespace
}  // namespace noctule::posing
