// SPDX-License-Identifier: Apache-2.0
// A take of two people as Review sees it: one of them at a time, and what lies between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/processing/evaluate_take.h"
#include "core/report/take_verdict.h"
#include "core/report/verdict.h"
#include "core/review/between_curve.h"
#include "core/review/take_review.h"
#include "tests/core/simulation/swaying_pair.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

const std::string& processedPair() {
    static const test::Folder folder;
    static const std::string path = [] {
        const std::string made = folder.file("pair.noctule");
        const Status written = test::writeProcessedPair(made);
        EXPECT_TRUE(written) << written.error().text();
        return made;
    }();
    return path;
}

TakeOverview overviewOf(int suit) {
    auto overview = overviewTake({processedPair(), suit}, {});
    EXPECT_TRUE(overview) << overview.error().text();
    return std::move(*overview);
}

TEST(SeveralPeople, TheFirstIsInViewUnlessAnotherIsWanted) {
    const TakeOverview first = overviewOf(kSuitInView);
    ASSERT_EQ(first.subjects.size(), 2u) << "the room is nobody";
    EXPECT_EQ(first.subjects[0].name, "Ada");
    EXPECT_EQ(first.subjects[1].name, "Bea");
    EXPECT_EQ(first.suit_in_view, first.subjects[0].suit());
    const int bea = first.subjects[1].suit();
    const TakeOverview second = overviewOf(bea);
    EXPECT_EQ(second.suit_in_view, bea);
    EXPECT_EQ(second.runs.size(), first.runs.size());
    ASSERT_TRUE(first.rest_s && second.rest_s);
    EXPECT_NEAR(second.rest_s->second, first.rest_s->second, 0.05) << "on the take's clock, not on her box's";
    EXPECT_NEAR(second.duration_s, first.duration_s, 0.1);
}

TEST(SeveralPeople, PosesAndReferencesAreOfWhomTheViewLooksAt) {
    const TakeOverview overview = overviewOf(kSuitInView);
    const int64_t run = overview.runs.back().run.run;
    for (const TakeSubject& subject : overview.subjects) {
        const auto motion = loadPoses({processedPair(), subject.suit()}, run, {}),
                   reference = loadPoses({processedPair(), subject.suit()}, std::nullopt, {});
        ASSERT_TRUE(motion && reference);
        const double side_m = subject.name == "Ada" ? -0.6 : 0.7;
        EXPECT_NEAR(reference->frames.front().pose->p_world_root.z(), side_m, 0.15);
        EXPECT_NEAR(motion->frames.back().pose->p_world_root.z(),
                    reference->frames.back().pose->p_world_root.z(), 0.05);
    }
}

/// Lowest and highest value that is one.
std::pair<float, float> extremes(const SeriesPyramid& curve) {
    std::pair<float, float> found{1e9F, -1e9F};
    for (const float value : curve.series().value)
        if (std::isfinite(value))
            found = {std::min(found.first, value), std::max(found.second, value)};
    return found;
}

TEST(SeveralPeople, DistancesAreRightAndSaySoHowFar) {
    const TakeOverview overview = overviewOf(kSuitInView);
    const TakeView ada{processedPair(), overview.subjects[0].suit()};
    const int bea = overview.subjects[1].suit();
    const auto found = loadBetween(ada, overview.runs.back().run.run, bea, {}),
               truth = loadBetween(ada, std::nullopt, bea, {});
    ASSERT_TRUE(found) << found.error().text();
    ASSERT_TRUE(truth) << truth.error().text();
    ASSERT_EQ(found->size(), 5u);
    ASSERT_EQ(truth->size(), 5u);
    EXPECT_EQ(found->front().joint, "Hips");
    for (size_t i = 0; i < found->size(); ++i) {
        SCOPED_TRACE((*found)[i].joint + " to " + (*found)[i].other_joint);
        const MotionCurve& curve = (*found)[i].distance;
        EXPECT_EQ(curve.unit, CurveUnit::kMetres);
        EXPECT_NEAR((*found)[i].least_m, (*truth)[i].least_m, 0.05);
        ASSERT_FALSE(curve.low.empty());
        EXPECT_TRUE((*truth)[i].distance.low.empty()) << "a reference states no error of its own";
        const std::vector<float>&value = curve.value.series().value, &low = curve.low.series().value;
        ASSERT_EQ(low.size(), value.size());
        const std::vector<double>& t_s = curve.value.series().t_s;
        for (size_t f = 0; f < low.size(); ++f)
            if (t_s[f] > overview.rest_s->second + 0.3 && t_s[f] < t_s.back() - 0.3) {
                ASSERT_TRUE(std::isfinite(low[f])) << "stated ten times a second, at " << t_s[f] << " s";
                EXPECT_LT(low[f], value[f]);
                EXPECT_GT(low[f], value[f] - 0.3F) << "two sigma of a pair that hears each other";
            }
        const float farthest = extremes(curve.value).second;
        EXPECT_LT(farthest, 2.5F);
    }
    const auto [nearest, farthest] = extremes(found->front().distance.value);
    EXPECT_NEAR(nearest, 1.3, 0.35);
    EXPECT_NEAR(farthest, 1.3, 0.35);
}

/// Number and mean of the distances of a table.
std::pair<size_t, double> heard(const RangeTable& table) {
    size_t count = 0;
    double sum_m = 0;
    for (const PairTrack& track : table.pairs)
        for (const float distance_m : track.distance_m)
            ++count, sum_m += distance_m;
    return {count, sum_m / static_cast<double>(std::max<size_t>(count, 1))};
}

size_t usedOf(const RangeTable& table) {
    size_t used = 0;
    for (const PairTrack& track : table.pairs)
        used += static_cast<size_t>(std::ranges::count(track.fate, RangeFate::kUsed));
    return used;
}

TEST(SeveralPeople, PairsMayHaveAnothersSources) {
    const TakeOverview overview = overviewOf(kSuitInView);
    ASSERT_EQ(overview.parties.size(), 3u);
    EXPECT_EQ(overview.parties[1].subject.name, "Bea");
    EXPECT_TRUE(overview.parties[2].subject.room);
    EXPECT_EQ(overview.parties[2].suit.sources.size(), 4u);
    const int ada = overview.subjects[0].suit();
    const int64_t run = *overview.runs.back().settings.range_run;
    const auto take = Take::open(processedPair());
    ASSERT_TRUE(take);
    std::map<int, size_t> rows;
    ASSERT_TRUE(take->forEachCrossRange(run, ada, [&](const Take::CrossRange& cross) {
        ++rows[cross.from_suit];
        return true;
    }));
    const auto own = loadRanges({processedPair(), ada}, run, {});
    ASSERT_TRUE(own);
    for (const size_t party : {size_t{1}, size_t{2}}) {
        const TakeParty& from = overview.parties[party];
        const auto table = loadRanges({processedPair(), ada, from.subject.suit()}, run, {});
        ASSERT_TRUE(table) << table.error().text();
        EXPECT_EQ(table->source_count, static_cast<int>(from.suit.sources.size()));
        EXPECT_EQ(table->board_count, 5);
        const auto [count, mean_m] = heard(*table);
        EXPECT_GT(count, 100u);
        EXPECT_EQ(count, rows[from.subject.suit()]);
        EXPECT_NEAR(mean_m, party == 1 ? 1.25 : 2.6, 0.5) << "as far as she or the corners stand";
        EXPECT_GT(mean_m, heard(*own).second + 0.3);
        EXPECT_GT(usedOf(*table), count / 4) << "the result tells what became of each";
        const auto half =
            loadRanges({processedPair(), ada, from.subject.suit()}, run, {}, {.index = 1, .count = 2});
        ASSERT_TRUE(half);
        EXPECT_LT(heard(*half).first, count);
        for (const PairTrack& track : table->pairs)
            EXPECT_TRUE(std::is_sorted(track.t_s.begin(), track.t_s.end()));
    }
}

TEST(SeveralPeople, WhoseBoxWasLostInTheRestPoseHasNoMotionAndTheVerdictSaysSo) {
    const test::Folder folder;
    const std::string path = folder.file("lost.noctule");
    const Status written = test::writePairLostInRest(path);
    ASSERT_TRUE(written) << written.error().text();
    const auto overview = overviewTake(path, {});
    ASSERT_TRUE(overview) << overview.error().text();
    const int ada = overview->subjects[0].suit(), bea = overview->subjects[1].suit();
    EXPECT_FALSE(overview->partyOf(ada)->lost_in_rest_s);
    ASSERT_TRUE(overview->partyOf(bea)->lost_in_rest_s);
    EXPECT_NEAR(*overview->partyOf(bea)->lost_in_rest_s, 0.5, 0.1);
    EXPECT_EQ(overview->partyOf(77), nullptr);
    EvaluateRequest request;
    request.take_path = path;
    request.suit = bea;
    const auto report = evaluateTake(request, {});
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(judgeTake(*report).grade, Grade::kNotUsable);
    EXPECT_EQ(judgeTake(*report).reasons, std::vector{VerdictReason::kEndsInRest});
    EXPECT_EQ(judge(*report).headline,
              "Not usable. The recording ends before the rest pose does. There is no motion.");
}

}  // namespace
}  // namespace noctule
