// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_processor.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/devices/live/fake_device.h"

namespace noctule {
namespace {

LivePlan planOfTinyTake() {
    const Take tiny = std::move(Take::open(test::kTinyTake).value());
    LivePlan plan{tiny.suit().value(), tiny.calibrationInForce()->value, tiny.actorInForce()->value, {}, 2};
    plan.pipeline.decoder.train.sample_rate_hz = test::kMadeRate_hz;
    return plan;
}

struct NoNote {
    operator NoteRow() const { throw std::runtime_error("no note"); }
};

/// What no device sends and no promise allows: it holds none of its alternatives.
LiveItem brokenItem() {
    LiveItem item = NoteRow{};
    EXPECT_THROW(item.emplace<NoteRow>(NoNote{}), std::runtime_error);
    EXPECT_TRUE(item.valueless_by_exception());
    return item;
}

TEST(LiveProcessor, AMistakeEndsTheProcessingAndIsTold) {
    const auto processor = LiveProcessor::start(planOfTinyTake(), std::nullopt);
    ASSERT_TRUE(processor) << processor.error().text();
    (*processor)->push(test::madeBlock(0, 600, 2));
    (*processor)->push(brokenItem());
    (*processor)->push(test::madeBlock(600, 600, 2));
    (*processor)->finish();
    const auto frame = (*processor)->latest();
    EXPECT_EQ(frame->sample, 600) << "what was known until then stays";
    ASSERT_TRUE(frame->trouble);
    EXPECT_EQ(frame->trouble->kind, ErrorKind::kInternal);
    EXPECT_NE(frame->trouble->message.find("variant"), std::string::npos) << frame->trouble->message;
    EXPECT_FALSE(frame->trouble->remedy.empty());
}

TEST(LiveProcessor, TellsNoTroubleWhenThereIsNone) {
    const auto processor = LiveProcessor::start(planOfTinyTake(), std::nullopt);
    (*processor)->push(test::madeBlock(0, 600, 2));
    (*processor)->finish();
    EXPECT_EQ((*processor)->latest()->sample, 600);
    EXPECT_FALSE((*processor)->latest()->trouble);
}

TEST(LiveProcessor, ALostEstimateIsTold) {
    const Pose rest = planOfTinyTake().actor.restPose();
    EXPECT_FALSE(LiveProcessor::lossIn({})) << "nothing came";
    EXPECT_FALSE(LiveProcessor::lossIn({{0, rest, {}}}));
    Pose broken = rest;
    broken.p_world_root.x() = std::numeric_limits<double>::quiet_NaN();
    for (const std::optional<Pose>& last : {std::optional<Pose>(broken), std::optional<Pose>()}) {
        const auto loss = LiveProcessor::lossIn({{0, rest, {}}, {1, last, {}}});
        ASSERT_TRUE(loss);
        EXPECT_EQ(loss->message, "the live estimate was lost: the data contradict each other");
        EXPECT_FALSE(loss->remedy.empty());
    }
}

}  // namespace
}  // namespace noctule
