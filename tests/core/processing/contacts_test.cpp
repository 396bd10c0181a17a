// SPDX-License-Identifier: Apache-2.0
// Feet on the ground from file to file: which contacts are found, whether they are true, what they do for a
// free root, and that an operator's take their place.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/formats/bvh.h"
#include "core/motion/comparison.h"
#include "core/motion/foot_contacts.h"
#include "core/processing/pose_runs.h"
#include "core/processing/process_take.h"
#include "core/recording/take_edit.h"
#include "tests/support/files.h"
#include "tests/support/simulated_take.h"

namespace noctule {
namespace {

constexpr const char* kSteps = NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh";
constexpr const char* kHops = "/usr/share/assimp/models/BVH/01_01.bvh";

class Contacts : public ::testing::Test {
protected:
    std::string simulate(const char* motion, double duration_s = 0) {
        const std::string path = folder_.file("feet.noctule");
        const Status written = test::writeSimulatedTake(
            path, {.clip = toClip(readBvh(motion).value()).value(), .duration_s = duration_s});
        EXPECT_TRUE(written) << written.error().text();
        return path;
    }
    static ProcessSummary process(const std::string& path, Ground ground, const SensorSelection& sensors = {},
                                  Smoother smoother = Smoother::kNone) {
        ProcessRequest request;
        request.take_path = path;
        request.tracker.sensors = sensors;
        request.tracker.ground = ground;
        request.tracker.smoother = smoother;
        request.software = "test";
        request.created_utc = "2026-01-01T00:00:00Z";
        const auto summary = processTake(request, {});
        EXPECT_TRUE(summary) << summary.error().text();
        return *summary;
    }
    static double rootError_m(const std::string& path, int64_t run) {
        const Take take = Take::open(path).value();
        ComparisonOptions options;
        options.from_ns = take.restInterval().value()->last * 1'000'000'000 / take.header().sample_rate_hz;
        return compareMotions(take.poses(run).value(), take.reference().value(), options)
            .value()
            .root.position_m;
    }
    test::Folder folder_;
};

/// Of all the time a foot was said to stand: how much of it its toes really moved, and how much of it both
/// its toes and its ankle, which a foot that rolls does not; and of the time in which it really stood flat
/// and still, or rolled slowly, how much was found.
struct Truth {
    double false_share = 0, carried_share = 0, found_share = 0, rolling_found_share = 0;
};

Truth judge(const TimedMotion& reference, const std::vector<FootContacts>& feet) {
    constexpr double kMoves_m_per_s = 0.5, kStill_m_per_s = 0.05;
    constexpr double kCarried_m_per_s = 0.25, kRolls_m_per_s = 0.15;
    double said = 0, wrong = 0, carried = 0, still = 0, found = 0, rolling = 0, rolling_found = 0;
    for (const FootContacts& foot : feet) {
        const int toes = reference.skeleton.find(foot.foot.substr(0, foot.foot.size() - 4) + "ToeBase");
        const int ankle = reference.skeleton.find(foot.foot);
        const auto way = [&](size_t i, int joint) {
            const auto place = [&](size_t frame) {
                return globalPose(reference.skeleton, *reference.frames[frame].pose)
                    .p_world_joint[static_cast<size_t>(joint)];
            };
            return (place(i + 1) - place(i - 1)).norm();
        };
        for (size_t i = 1; i + 1 < reference.frames.size(); ++i) {
            const double t_s = static_cast<double>(reference.frames[i].time_ns) * 1e-9;
            const double step_s =
                static_cast<double>(reference.frames[i + 1].time_ns - reference.frames[i - 1].time_ns) * 1e-9;
            const double speed = way(i, toes) / step_s, slowest = std::min(speed, way(i, ankle) / step_s);
            const bool stands = std::ranges::any_of(foot.contacts, [&](const FootContact& contact) {
                return contact.from_s <= t_s && t_s <= contact.to_s;
            });
            said += stands;
            wrong += stands && speed > kMoves_m_per_s;
            carried += stands && slowest > kCarried_m_per_s;
            const bool rolls = t_s > 4 && speed >= kStill_m_per_s && speed < kRolls_m_per_s;
            rolling += rolls;
            rolling_found += rolls && stands;
            still += t_s > 4 && speed < kStill_m_per_s;
            found += t_s > 4 && speed < kStill_m_per_s && stands;
        }
    }
    return {wrong / said, carried / said, found / still, rolling_found / rolling};
}

TEST_F(Contacts, OfStepsAreTrueAndHoldAFreeRoot) {
    const std::string path = simulate(kSteps);
    const ProcessSummary none = process(path, Ground::kNone);
    const ProcessSummary level = process(path, Ground::kLevel);
    const ProcessSummary treadmill = process(path, Ground::kTreadmill);
    EXPECT_EQ(none.contacts, 0);
    EXPECT_GE(level.contacts, 4);
    EXPECT_GE(treadmill.contacts, 4);

    const Take take = Take::open(path).value();
    const auto feet = take.contacts(level.pose_run).value();
    ASSERT_EQ(feet.size(), 2u);
    EXPECT_EQ(feet[0].foot, "LeftFoot");
    EXPECT_EQ(feet[1].foot, "RightFoot");
    EXPECT_TRUE(take.contacts(none.pose_run).value().empty());
    const auto rest = take.restInterval().value();
    const double rate_hz = static_cast<double>(take.header().sample_rate_hz);
    for (const FootContacts& foot : feet) {
        EXPECT_NEAR(foot.contacts[0].from_s, static_cast<double>(rest->first) / rate_hz, 1e-6);
        EXPECT_GT(foot.contacts[0].to_s, static_cast<double>(rest->last) / rate_hz)
            << "the rest pose is standing";
    }
    const Truth truth = judge(take.reference().value(), feet);
    EXPECT_LT(truth.false_share, 0.01);
    EXPECT_LT(truth.carried_share, 0.01);
    EXPECT_GT(truth.rolling_found_share, 0.65);
    EXPECT_GT(truth.found_share, 0.9);

    const double held_m = rootError_m(path, level.pose_run);
    EXPECT_LT(held_m, 0.05);
    EXPECT_LT(held_m, 0.1 * rootError_m(path, none.pose_run));
    EXPECT_LT(held_m, 0.3 * rootError_m(path, treadmill.pose_run)) << "a treadmill holds nothing";
}

TEST_F(Contacts, AreNotFoundInTheFlightOfAHop) {
    if (!std::filesystem::exists(kHops))
        GTEST_SKIP() << "no " << kHops << " (package assimp-testmodels)";
    const std::string path = simulate(kHops, 20);
    const ProcessSummary level = process(path, Ground::kLevel);
    const Take take = Take::open(path).value();
    const Truth truth = judge(take.reference().value(), take.contacts(level.pose_run).value());
    EXPECT_LT(truth.false_share, 0.02);
    EXPECT_LT(truth.carried_share, 0.03);
    EXPECT_GT(truth.rolling_found_share, 0.75);
    EXPECT_GT(truth.found_share, 0.7);
}

TEST_F(Contacts, SmoothedRunsHoldTheSame) {
    const std::string path = simulate(kSteps, 8);
    const int64_t plain = process(path, Ground::kLevel).pose_run;
    for (const Smoother smoother : {Smoother::kLag, Smoother::kFull}) {
        const int64_t smoothed = process(path, Ground::kLevel, {}, smoother).pose_run;
        const Take take = Take::open(path).value();
        const auto expected = take.contacts(plain).value(), feet = take.contacts(smoothed).value();
        ASSERT_EQ(feet.size(), expected.size());
        for (size_t f = 0; f < feet.size(); ++f) {
            ASSERT_EQ(feet[f].contacts.size(), expected[f].contacts.size());
            for (size_t i = 0; i < feet[f].contacts.size(); ++i) {
                EXPECT_EQ(feet[f].contacts[i].from_s, expected[f].contacts[i].from_s);
                EXPECT_EQ(feet[f].contacts[i].to_s, expected[f].contacts[i].to_s);
            }
        }
        EXPECT_LT(rootError_m(path, smoothed), rootError_m(path, plain) + 0.005);
    }
}

TEST_F(Contacts, OfAnOperatorTakeThePlaceOfThoseFound) {
    const std::string path = simulate(kSteps, 8);
    const std::vector<FootContacts> edited = {{"LeftFoot", {{3.5, 5, 0}}}};
    const auto set = [&](const std::optional<std::vector<FootContacts>>& contacts) {
        Take take = Take::open(path, Access::kReadWrite).value();
        auto edit = TakeEdit::begin(take).value();
        ASSERT_TRUE(edit.setContacts(contacts));
        ASSERT_TRUE(edit.commit());
    };
    set(edited);
    const ProcessSummary by_hand = process(path, Ground::kLevel);
    EXPECT_TRUE(by_hand.contacts_edited);
    EXPECT_EQ(by_hand.contacts, 1);
    {
        const Take take = Take::open(path).value();
        const auto used = take.contacts(by_hand.pose_run).value();
        ASSERT_EQ(used.size(), 1u);
        ASSERT_EQ(used[0].contacts.size(), 1u);
        EXPECT_NEAR(used[0].contacts[0].from_s, 3.5, 1e-9);
        EXPECT_NEAR(used[0].contacts[0].to_s, 5, 0.01);
        const auto run = poseRun(take, by_hand.pose_run).value();
        EXPECT_EQ(nlohmann::json::parse(run.settings_json)["contacts"], "edited");
    }
    set(std::vector<FootContacts>{});  // none at all is also a word
    EXPECT_EQ(process(path, Ground::kLevel).contacts, 0);
    set(std::nullopt);
    const ProcessSummary found = process(path, Ground::kLevel);
    EXPECT_FALSE(found.contacts_edited);
    EXPECT_GE(found.contacts, 2);
}

}  // namespace
}  // namespace noctule
