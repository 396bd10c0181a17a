// SPDX-License-Identifier: Apache-2.0
// Takes of two performers and anchors in which something went wrong: the box of a partner is lost, an anchor
// was moved, nothing joins the clocks, two suits share a carrier, a choice does not go with joining.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/processing/evaluate_between.h"
#include "core/processing/evaluate_take.h"
#include "core/processing/pose_runs.h"
#include "core/processing/process_take.h"
#include "core/processing/root_in_world.h"
#include "core/simulation/cast.h"
#include "tests/core/simulation/swaying_pair.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

using test::Folder;
using test::runSql;

/// The take that each test takes a copy of.
const std::string& soundTake() {
    static const Folder folder;
    static const std::string path = [] {
        const std::string made = folder.file("sound.noctule");
        const Status written = test::writeSwayingPair(made);
        EXPECT_TRUE(written) << written.error().text();
        return made;
    }();
    return path;
}

struct ErrorsOfSuit {
    double angles_deg = 0, root_m = 0;
};

/// Of the last run.
ErrorsOfSuit errorsIn(const std::string& path, int suit) {
    EvaluateRequest evaluation;
    evaluation.take_path = path;
    evaluation.suit = suit;
    const auto data = evaluateTake(evaluation, {});
    EXPECT_TRUE(data) << data.error().text();
    const auto& comparison = data->shownRun()->comparison;
    EXPECT_TRUE(comparison);
    std::printf("suit %d: %.2f deg, root %.1f mm\n", suit, comparison->mean_deg,
                1000 * comparison->root.position_m);
    return {comparison->mean_deg, comparison->root.position_m};
}

/// Of the sound take: 11.9 and 12.5 degrees, for few limbs carry a board, and 6.4 and 3.7 mm.
constexpr double kUsual_deg = 13.5, kUsual_m = 0.0125;

class CastGoneWrong : public testing::Test {
protected:
    void SetUp() override {
        path_ = folder_.file("cast.noctule");
        std::filesystem::copy_file(soundTake(), path_);
    }
    ProcessRequest request() const {
        ProcessRequest request;
        request.take_path = path_;
        request.software = "test";
        return request;
    }
    ProcessSummary processed(const ProcessRequest& request) const {
        const auto summary = processTake(request, {});
        EXPECT_TRUE(summary) << summary.error().text();
        for (const std::string& warning : summary->warnings)
            std::printf("warning: %s\n", warning.c_str());
        return *summary;
    }
    static bool says(const ProcessSummary& summary, const std::vector<std::string>& words) {
        return std::ranges::any_of(summary.warnings, [&](const std::string& warning) {
            return std::ranges::all_of(
                words, [&](const std::string& word) { return warning.find(word) != std::string::npos; });
        });
    }
    ErrorsOfSuit errorsOf(int suit) const { return errorsIn(path_, suit); }
    Folder folder_;
    std::string path_;
};

/// Everything that comes from or goes to suit 2 from one of its seconds to another.
std::string without(double from_s, double to_s) {
    const std::string from = std::to_string(std::lround(from_s * 150000)),
                      to = std::to_string(std::lround(to_s * 150000));
    return "DELETE FROM range WHERE suit=2 AND arrival_sample BETWEEN " + from + " AND " + to +
           ";DELETE FROM range WHERE pulse IN (SELECT id FROM pulse WHERE suit=2 AND sample BETWEEN " + from +
           " AND " + to + ");DELETE FROM pulse WHERE suit=2 AND sample BETWEEN " + from + " AND " + to +
           ";DELETE FROM inertial WHERE suit=2 AND sample BETWEEN " + from + " AND " + to + ";";
}

/// Of suit 1 and the room, after that second of its clock.
int64_t usedWithTheRoom(const std::string& path, int64_t range_run, double after_s) {
    const Take take = Take::open(path).value();
    int64_t used = 0;
    EXPECT_TRUE(take.forEachCrossRange(range_run, 1, [&](const Take::CrossRange& cross) {
        used += cross.from_suit == 3 && cross.range.arrival_sample > after_s * 150000 &&
                cross.range.fate == RangeFate::kUsed;
        return true;
    }));
    return used;
}

TEST_F(CastGoneWrong, ALostBoxIsSaidAndThePartnerGoesOn) {
    runSql(path_, without(3, 100));
    const ProcessSummary summary = processed(request());
    ASSERT_TRUE(summary.together);
    EXPECT_TRUE(says(summary, {"Bea sent no readings from 3.0 s", "the box was lost"}));
    const ErrorsOfSuit ada = errorsOf(1);
    EXPECT_LT(ada.angles_deg, kUsual_deg);
    EXPECT_LT(ada.root_m, kUsual_m);
    const int64_t used = usedWithTheRoom(path_, summary.range_run, 3.2);
    EXPECT_GT(used, 50);
    // The same where nothing says that her box was expected for longer: her recording ends there.
    runSql(path_, "DELETE FROM meta WHERE key='sample_count'");
    const ProcessSummary ended = processed(request());
    EXPECT_NEAR(double(ended.subjects[0].poses), double(summary.subjects[0].poses), 2);
    EXPECT_NEAR(double(usedWithTheRoom(path_, ended.range_run, 3.2)), double(used), 0.1 * double(used));
}

TEST_F(CastGoneWrong, ABoxThatIsLostWhileTheRestPoseIsHeldIsLeftOut) {
    runSql(path_, without(0.5, 100) + "DELETE FROM meta WHERE key='sample_count';");
    const ProcessSummary summary = processed(request());
    EXPECT_TRUE(says(summary, {"Bea: the recording ends before the rest pose does"}));
    ASSERT_EQ(summary.subjects.size(), 1U);
    EXPECT_EQ(summary.subjects[0].name, "Ada");
    EXPECT_GT(summary.subjects[0].poses, 100);
    EXPECT_LT(errorsOf(1).angles_deg, kUsual_deg);
}

TEST_F(CastGoneWrong, WhereNobodyHeldTheRestPoseToItsEndThatIsSaid) {
    runSql(
        path_,
        "DELETE FROM meta WHERE key='sample_count'; DELETE FROM range; DELETE FROM pulse WHERE sample>75000;"
        "DELETE FROM inertial WHERE sample>75000;");
    const auto summary = processTake(request(), {});
    ASSERT_FALSE(summary);
    EXPECT_NE(summary.error().message.find("no pose came out"), std::string::npos) << summary.error().message;
}

TEST_F(CastGoneWrong, AfterAGapBothAreKnownAgain) {
    runSql(path_, without(2, 3));  // then a second is left
    const ProcessSummary summary = processed(request());
    EXPECT_TRUE(says(summary, {"Bea sent no readings from 2.0 s to 3.0 s"}));
    EXPECT_FALSE(says(summary, {"Anchor"}));
    const ErrorsOfSuit ada = errorsOf(1), bea = errorsOf(2);
    EXPECT_LT(ada.angles_deg, kUsual_deg);
    EXPECT_LT(ada.root_m, kUsual_m);
    EXPECT_LT(bea.root_m, 0.15) << "a second in which nobody knows";
}

TEST_F(CastGoneWrong, AnAnchorThatWasMovedBeforeIsNamed) {
    for (const char* table : {"suit", "calibration"})
        runSql(path_, std::string("UPDATE ") + table +
                          " SET json=json_set(json,'$.boards[1].p_segment_board_m',json('[2.2,0.8,1.4]'),"
                          "'$.sources[1].p_segment_source_m',json('[2.2,0.8,1.4]')) WHERE " +
                          (std::string(table) == "suit" ? "id" : "suit") + "=3");
    const ProcessSummary summary = processed(request());
    EXPECT_TRUE(says(summary, {"Anchor east", "moved"}));
    const std::array moved{errorsOf(1), errorsOf(2)};
    // As good as if it did not hang there.
    runSql(path_,
           "DELETE FROM range WHERE (suit=3 AND board=1) OR pulse IN (SELECT id FROM pulse WHERE suit=3 AND "
           "source=1)");
    EXPECT_FALSE(says(processed(request()), {"Anchor"}));
    for (int suit = 1; suit <= 2; ++suit) {
        const ErrorsOfSuit without = errorsOf(suit), with = moved[static_cast<size_t>(suit - 1)];
        EXPECT_LT(with.angles_deg, without.angles_deg + 0.3);
        EXPECT_LT(with.root_m, 1.2 * without.root_m + 0.001);
    }
}

/// Two of four that fit by chance do not tell which ones were moved.
TEST_F(CastGoneWrong, WhereThreeOfFourAnchorsWereMovedTheRoomIsNotTrusted) {
    const std::pair<const char*, const char*> astray[] = {
        {"1", "[2.4,0.9,1.4]"}, {"2", "[-2.1,2.2,2.35]"}, {"3", "[-1.65,1.4,-1.2]"}};
    for (const auto& [index, place] : astray)
        for (const std::string table : {"suit", "calibration"})
            runSql(path_, "UPDATE " + table + " SET json=json_set(json,'$.boards[" + index +
                              "].p_segment_board_m',json('" + place + "'),'$.sources[" + index +
                              "].p_segment_source_m',json('" + place + "')) WHERE " +
                              (table == "suit" ? "id" : "suit") + "=3");
    EXPECT_TRUE(says(processed(request()), {"Fewer than three anchors agree", "cannot be trusted"}));
}

TEST_F(CastGoneWrong, AnAnchorThatIsMovedMeanwhileIsNamed) {
    // 0.2 m farther from both from 2 s on; 87.2 samples of sound.
    runSql(path_,
           "UPDATE range SET distance_m=distance_m+0.2, arrival_sample=arrival_sample+87.2 WHERE suit=3 AND "
           "board=1 AND arrival_sample>300000;"
           "UPDATE range SET distance_m=distance_m+0.2, arrival_sample=arrival_sample+87.2 WHERE suit<>3 AND "
           "pulse IN (SELECT id FROM pulse WHERE suit=3 AND source=1 AND sample>300000)");
    const ProcessSummary summary = processed(request());
    EXPECT_TRUE(says(summary, {"Anchor east", "moved"}));
    for (int suit = 1; suit <= 2; ++suit) {
        const ErrorsOfSuit errors = errorsOf(suit);
        EXPECT_LT(errors.angles_deg, kUsual_deg);
        EXPECT_LT(errors.root_m, kUsual_m);
    }
}

TEST_F(CastGoneWrong, AnAnchorThatIsHeardByWayOfAWallAtFirstIsUsedLater) {
    // 0.2 m late while the rest pose is held, and a little longer; the last second is judged.
    runSql(path_,
           "UPDATE range SET distance_m=distance_m+0.2, arrival_sample=arrival_sample+87.2 WHERE suit=3 AND "
           "board=1 AND arrival_sample<180000;"
           "UPDATE range SET distance_m=distance_m+0.2, arrival_sample=arrival_sample+87.2 WHERE suit<>3 AND "
           "pulse IN (SELECT id FROM pulse WHERE suit=3 AND source=1 AND sample<180000);"
           "DELETE FROM reference WHERE time_ns<3000000000");
    EXPECT_FALSE(says(processed(request()), {"Anchor"}));
    EXPECT_LT(errorsOf(1).root_m, kUsual_m);
    EXPECT_LT(errorsOf(2).root_m, kUsual_m);
}

TEST_F(CastGoneWrong, WhatIsInOrderIsNotCalledMoved) {
    EXPECT_FALSE(says(processed(request()), {"Anchor"}));
    EXPECT_LT(errorsOf(1).root_m, kUsual_m);
    EXPECT_LT(errorsOf(2).root_m, kUsual_m);
}

TEST_F(CastGoneWrong, RootsStandWhereTheRoomSays) {
    processed(request());
    const auto subjects = Take::open(path_)->subjects();
    ASSERT_TRUE(subjects);
    for (size_t s = 0; s < 2; ++s) {
        const auto found = rootInWorld(path_, "", (*subjects)[s], {});
        ASSERT_TRUE(found && *found);
        std::printf("in the room: %.1f mm, %.2f deg\n", 1000 * (*found)->position_m, (*found)->yaw_deg);
        EXPECT_LT((*found)->position_m, kUsual_m);
        EXPECT_LT((*found)->yaw_deg, 1);
    }
    // A reference that stands 0.1 m elsewhere: its own start would hide that.
    runSql(path_, "UPDATE reference SET px=px+0.1");
    EXPECT_GT((*rootInWorld(path_, "", (*subjects)[0], {}))->position_m, 0.08);
}

/// A receiver that knows nothing of the other boxes' clocks stores arrivals alone.
TEST_F(CastGoneWrong, ArrivalsWithoutDistancesJoinAsWell) {
    const ProcessSummary stated = processed(request());
    runSql(path_,
           "UPDATE range SET distance_m=NULL WHERE run=0 AND suit<>(SELECT suit FROM pulse WHERE "
           "pulse.id=range.pulse)");
    const ProcessSummary summary = processed(request());
    ASSERT_TRUE(summary.together);
    EXPECT_FALSE(says(summary, {"could not be used"}));
    EXPECT_FALSE(says(summary, {"cannot be joined"}));
    const auto used = static_cast<double>(usedWithTheRoom(path_, summary.range_run, 0));
    EXPECT_NEAR(used, static_cast<double>(usedWithTheRoom(path_, stated.range_run, 0)), 0.05 * used);
    EXPECT_GT(used, 100);
    for (const int suit : {1, 2}) {
        EXPECT_LT(errorsOf(suit).angles_deg, kUsual_deg);
        EXPECT_LT(errorsOf(suit).root_m, kUsual_m);
    }
}

TEST_F(CastGoneWrong, WithoutRangesBetweenEachIsAlone) {
    runSql(path_, "DELETE FROM range WHERE suit<>(SELECT suit FROM pulse WHERE pulse.id=range.pulse)");
    ProcessRequest wanted = request();
    wanted.between = Wanted::kOn;
    const auto refused = processTake(wanted, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().message.find("no distances between its suits"), std::string::npos);
    EXPECT_NE(refused.error().remedy.find("heard each other"), std::string::npos);
}

TEST_F(CastGoneWrong, WhatWasAskedForAndIsNotThereIsAnErrorElseItIsSaid) {
    runSql(path_, "DELETE FROM range WHERE suit=3 OR (SELECT suit FROM pulse WHERE pulse.id=range.pulse)=3");
    ProcessRequest wanted = request();
    wanted.room = Wanted::kOn;
    const auto refused = processTake(wanted, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("no distances to its room"), std::string::npos);
    const ProcessSummary summary = processed(request());
    EXPECT_TRUE(says(summary, {"Nobody hears the anchors"}));
    EXPECT_TRUE(summary.together && summary.together->between && !summary.together->room);
    EvaluateRequest evaluated;
    evaluated.take_path = path_;
    const auto report = evaluateTake(evaluated, {});
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->together, (std::vector<std::string>{"Ada", "Bea"}));
    EXPECT_TRUE(report->alone.empty());
}

TEST_F(CastGoneWrong, PeopleWhoDoNotHearEachOtherStandWhereTheRoomSays) {
    runSql(path_,
           "DELETE FROM range WHERE (suit=1 AND (SELECT suit FROM pulse WHERE pulse.id=range.pulse)=2) OR "
           "(suit=2 AND (SELECT suit FROM pulse WHERE pulse.id=range.pulse)=1)");
    const ProcessSummary summary = processed(request());
    EXPECT_TRUE(says(summary, {"do not hear each other"}));
    EXPECT_TRUE(summary.together && !summary.together->between && summary.together->room);
    ProcessRequest wanted = request();
    wanted.between = Wanted::kOn;
    EXPECT_FALSE(processTake(wanted, {}));
}

TEST_F(CastGoneWrong, WhomNobodyHearsIsNamed) {
    runSql(path_,
           "DELETE FROM range WHERE (suit=2)<>((SELECT suit FROM pulse WHERE pulse.id=range.pulse)=2)");
    const ProcessSummary summary = processed(request());
    EXPECT_TRUE(summary.together);
    EXPECT_TRUE(says(summary, {"Bea cannot be joined"}));
    EXPECT_EQ(summary.together->unjoined, std::vector{2});
    EvaluateRequest evaluated;
    evaluated.take_path = path_;
    const auto between =
        evaluateBetween(evaluated, subjectsOf(choosePoseRun(Take::open(path_).value(), "").value()), {});
    ASSERT_TRUE(between) << between.error().text();
    ASSERT_EQ(between->size(), 1u);
    for (const BetweenEvaluation& pair : *between) {
        EXPECT_FALSE(pair.observed);
        EXPECT_FALSE(pair.nees || pair.sigma_mm);
    }
    EXPECT_TRUE(Take::open(path_)->relatives(summary.pose_run, 1)->empty()) << "no band in plots either";
    const auto report = evaluateTake(evaluated, {});
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(report->people_apart);
    EXPECT_EQ(report->unjoined, std::vector<std::string>{"Bea"});
    EXPECT_TRUE(report->together.empty());
    EXPECT_EQ(report->alone, (std::vector<std::string>{"Ada", "Bea"}));
    // As good as if there were no Bea: the room alone holds the other.
    const ErrorsOfSuit beside = errorsOf(1);
    ProcessRequest alone = request();
    alone.subjects = {"Ada"};
    processed(alone);
    const ErrorsOfSuit without_bea = errorsOf(1);
    EXPECT_LT(beside.root_m, kUsual_m);
    EXPECT_NEAR(beside.root_m, without_bea.root_m, 0.001);
    EXPECT_NEAR(beside.angles_deg, without_bea.angles_deg, 0.1);
}

TEST_F(CastGoneWrong, OneCarrierOfTwoSuitsIsSaidWithARemedy) {
    runSql(path_, "UPDATE suit SET json=json_set(json,'$.carrier_hz',40000) WHERE id=2");
    const ProcessSummary summary = processed(request());
    EXPECT_FALSE(summary.together);
    EXPECT_TRUE(says(summary, {"Ada (suit 1) and Bea (suit 2)", "one carrier", "Record again"}));
}

TEST_F(CastGoneWrong, SmoothersDoNotGoWithJoining) {
    ProcessRequest smoothed = request();
    smoothed.tracker.smoother = Smoother::kLag;
    smoothed.between = Wanted::kOn;
    const auto refused = processTake(smoothed, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().message.find("--smooth lag"), std::string::npos) << refused.error().message;
    EXPECT_TRUE(Take::open(path_)->derivedRuns()->empty()) << "refused, yet something was written";
}

}  // namespace
}  // namespace noctule
