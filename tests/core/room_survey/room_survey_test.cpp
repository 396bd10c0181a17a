// SPDX-License-Identifier: Apache-2.0
#include "core/room_survey/room_survey.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/math/linear_solvers.h"
#include "tests/core/room_survey/walked_room.h"

namespace noctule::room_survey {
namespace {

Result<RoomSurvey> surveyed(const Evidence& evidence) {
    return surveyRoom(evidence, {}, {});
}

std::vector<Vector3d> placesOf(const RoomSurvey& survey) {
    std::vector<Vector3d> places_m;
    for (const SurveyedAnchor& anchor : survey.anchors)
        places_m.push_back(anchor.place_m);
    return places_m;
}

/// Per freedom of the constellation; 1 is honest.
double neesOf(const Eigen::VectorXd& error_m, const Eigen::MatrixXd& cov_m2) {
    const Eigensystem eigen = eigensystemOf(cov_m2);
    double sum = 0;
    const Eigen::Index first = 6;  // the motions of all together
    for (Eigen::Index k = first; k < error_m.size(); ++k)
        sum += std::pow(eigen.vectors.col(k).dot(error_m), 2) / eigen.values[k];
    return sum / static_cast<double>(error_m.size() - first);
}

double largest(const Eigen::VectorXd& error_m) {
    return error_m.reshaped(3, error_m.size() / 3).colwise().norm().maxCoeff();
}

struct Figures {
    double mean_m = 0, worst_m = 0, nees = 0;
};

Figures figuresOf(const WalkedRoom& room, unsigned seeds) {
    Figures figures;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const auto survey = surveyed(evidenceOf(room, seed));
        EXPECT_TRUE(survey.ok()) << "seed " << seed << (survey ? "" : survey.error().message);
        if (!survey)
            continue;
        const Eigen::VectorXd error_m = constellationError(room.anchors_m, placesOf(*survey));
        figures.mean_m += largest(error_m) / seeds;
        figures.worst_m = std::max(figures.worst_m, largest(error_m));
        figures.nees += neesOf(error_m, survey->cov_m2) / seeds;
    }
    std::printf("worst anchor: mean %.2f mm, at most %.2f mm, NEES %.2f\n", 1000 * figures.mean_m,
                1000 * figures.worst_m, figures.nees);
    return figures;
}

TEST(RoomSurvey, AWalkPlacesAnchorsThatDoNotHearEachOther) {
    const Figures figures = figuresOf({}, 20);
    EXPECT_LT(figures.mean_m, 0.005);
    EXPECT_LT(figures.worst_m, 0.010);
    EXPECT_GT(figures.nees, 0.7);
    EXPECT_LT(figures.nees, 1.5);
}

TEST(RoomSurvey, LooseFleshStaysHonest) {
    WalkedRoom room;
    room.flesh_m = 0.012, room.device_m = 0.010, room.noise_m = 0.006, room.scale = 1.2e-3;
    const Figures figures = figuresOf(room, 20);
    EXPECT_LT(figures.mean_m, 0.010);
    EXPECT_GT(figures.nees, 0.7);
    EXPECT_LT(figures.nees, 1.5);
}

TEST(RoomSurvey, RoughPlacesAreNoPrior) {
    Evidence evidence = evidenceOf({}, 1);
    const auto near = surveyed(evidence);
    ASSERT_TRUE(near.ok());
    for (size_t i = 0; i < evidence.anchors.size(); ++i)
        evidence.anchors[i].rough_m = {3.0 * static_cast<double>(i), -7, 40};
    const auto far = surveyed(evidence);
    ASSERT_TRUE(far.ok());
    for (size_t i = 0; i < near->anchors.size(); ++i)
        EXPECT_EQ(near->anchors[i].place_m, far->anchors[i].place_m) << near->anchors[i].id;
}

TEST(RoomSurvey, TheRestPoseIsTheWorld) {
    const WalkedRoom room;
    const auto survey = surveyed(evidenceOf(room, 2));
    ASSERT_TRUE(survey.ok());
    EXPECT_TRUE(survey->frame.of_performer);
    EXPECT_EQ(survey->frame.fixed, 6);
    for (size_t i = 0; i < room.anchors_m.size(); ++i)
        EXPECT_LT((survey->anchors[i].place_m - room.anchors_m[i]).norm(), 0.05);
}

TEST(RoomSurvey, AClockThatNobodyKnowsIsFound) {
    WalkedRoom room;
    room.clock_known = false, room.clock_m = 1.2;
    const auto survey = surveyed(evidenceOf(room, 3));
    ASSERT_TRUE(survey.ok());
    EXPECT_LT(largest(constellationError(room.anchors_m, placesOf(*survey))), 0.015);
    EXPECT_TRUE(std::ranges::any_of(survey->findings, [](const Finding& finding) {
        return finding.what.find("clocks") != std::string::npos;
    }));
}

TEST(RoomSurvey, AnAnchorThatOnlyAnchorsHearIsPlacedByThem) {
    WalkedRoom room;
    room.deaf = {3}, room.anchors_hear = true, room.hidden = {{0, 1}};
    const auto survey = surveyed(evidenceOf(room, 4));
    ASSERT_TRUE(survey.ok());
    const SurveyedAnchor& hidden = survey->anchors[3];
    EXPECT_TRUE(hidden.placed);
    EXPECT_EQ(hidden.ranges, 0);
    EXPECT_EQ(hidden.hears, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(survey->anchors[0].hears_not, std::vector<int>{1});
    // Three anchors place a fourth, or its image beyond their plane.
    EXPECT_TRUE(hidden.mirrored);
    EXPECT_EQ(gradeOf(survey->findings), Grade::kNotUsable);
}

TEST(RoomSurvey, AnAnchorThatNobodyHeardIsNamed) {
    WalkedRoom room;
    room.deaf = {2};
    const auto survey = surveyed(evidenceOf(room, 5));
    ASSERT_TRUE(survey.ok());
    EXPECT_FALSE(survey->anchors[2].placed);
    ASSERT_EQ(gradeOf(survey->findings), Grade::kNotUsable);
    EXPECT_EQ(survey->findings.front().what, "Anchor anchor_3 was never heard");
}

TEST(RoomSurvey, AnAnchorThatIsLeftOutBlocksNothingAndThreeMustStay) {
    WalkedRoom room;
    room.deaf = {2};
    auto survey = surveyed(evidenceOf(room, 5));
    ASSERT_TRUE(survey.ok());
    ASSERT_EQ(gradeOf(survey->findings), Grade::kNotUsable);
    EXPECT_TRUE(canLeaveOut(*survey, 2)) << "the other three have places";
    EXPECT_FALSE(canLeaveOut(*survey, 0));
    const Status too_few = leaveOut(*survey, {0});
    ASSERT_FALSE(too_few);
    EXPECT_NE(too_few.error().message.find("anchor_1"), std::string::npos);
    EXPECT_FALSE(survey->anchors[0].left_out);

    ASSERT_TRUE(leaveOut(*survey, {2}));
    EXPECT_TRUE(survey->anchors[2].left_out);
    EXPECT_EQ(std::ranges::count(survey->findings, std::string("anchor_3"), &Finding::part), 0);
    EXPECT_NE(gradeOf(survey->findings), Grade::kNotUsable);
}

TEST(RoomSurvey, WhatIsLeftOutCountsNowhere) {
    auto survey = surveyed(evidenceOf({}, 5));
    ASSERT_TRUE(survey.ok());
    survey->anchors[3].sigma_m = 0.2;
    ASSERT_TRUE(leaveOut(*survey, {3}));
    EXPECT_LT(survey->worstSigma_m(), 0.05);
    EXPECT_TRUE(survey->anchors[3].placed) << "it can be shown, and taken back in";
    EXPECT_EQ(survey->distances.size(), 3U);
}

TEST(RoomSurvey, AMovedAnchorIsNamedAndDoesNotSpoilTheOthers) {
    for (const int moved : {0, 3})
        for (const Vector3d& by_m : {Vector3d(0.3, 0, 0), Vector3d(0, -0.15, 0.1)}) {
            WalkedRoom room;
            room.moved = {moved, by_m};
            const auto survey = surveyed(evidenceOf(room, 6));
            ASSERT_TRUE(survey.ok());
            std::vector<Vector3d> truth_m, found_m;
            for (size_t i = 0; i < survey->anchors.size(); ++i) {
                EXPECT_EQ(survey->anchors[i].moved.has_value(), static_cast<int>(i) == moved) << i;
                if (static_cast<int>(i) != moved)
                    truth_m.push_back(room.anchors_m[i]), found_m.push_back(survey->anchors[i].place_m);
            }
            EXPECT_LT(largest(constellationError(truth_m, found_m)), 0.012);
            EXPECT_EQ(gradeOf(survey->findings), Grade::kNotUsable);
        }
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const auto still = surveyed(evidenceOf({}, seed));
        ASSERT_TRUE(still.ok());
        for (const SurveyedAnchor& anchor : still->anchors)
            EXPECT_FALSE(anchor.moved) << anchor.id << ", seed " << seed;
    }
}

/// Six anchors at three heights, that hear each other.
WalkedRoom aloneRoom() {
    WalkedRoom room;
    room.anchors_m = {{2.3, 2.7, 2.3},  {-2.3, 0.5, 2.3}, {-2.3, 2.65, -2.3},
                      {2.3, 1.2, -2.3}, {0, 2.5, 2.4},    {0.2, 0.3, -2.4}};
    room.walks = false, room.anchors_hear = true;
    room.scale = 1e-3;
    return room;
}

TEST(RoomSurvey, AnchorsAloneKeepThePlaceOfTheFileAndSayIt) {
    const WalkedRoom room = aloneRoom();
    const Figures figures = figuresOf(room, 20);
    EXPECT_LT(figures.mean_m, 0.010);
    EXPECT_GT(figures.nees, 0.7);
    EXPECT_LT(figures.nees, 1.5);
    const auto survey = surveyed(evidenceOf(room, 1));
    ASSERT_TRUE(survey.ok());
    EXPECT_FALSE(survey->frame.of_performer);
    EXPECT_EQ(survey->frame.fixed, 0);
    EXPECT_EQ(gradeOf(survey->findings), Grade::kUsable);
    EXPECT_NE(survey->findings.back().what.find("mirror images"), std::string::npos);
}

TEST(RoomSurvey, ThreeHeightsMakeAnchorsLevel) {
    const WalkedRoom room = aloneRoom();
    Evidence evidence = evidenceOf(room, 2);
    for (const int anchor : {0, 1, 3})
        evidence.heights.push_back({anchor, room.anchors_m[static_cast<size_t>(anchor)].y()});
    const auto survey = surveyed(evidence);
    ASSERT_TRUE(survey.ok());
    EXPECT_EQ(survey->frame.fixed, 3);
    for (size_t i = 0; i < room.anchors_m.size(); ++i)
        EXPECT_NEAR(survey->anchors[i].place_m.y(), room.anchors_m[i].y(), 0.02) << i;
}

TEST(RoomSurvey, AMirrorImageThatNothingTellsApartIsSaid) {
    const WalkedRoom room = aloneRoom();
    Evidence evidence = evidenceOf(room, 3);
    // A file that fits both images alike: every anchor in the plane of the mirror.
    for (size_t i = 0; i < evidence.anchors.size(); ++i)
        evidence.anchors[i].rough_m = {room.anchors_m[i].x(), room.anchors_m[i].y(), 0};
    const auto survey = surveyed(evidence);
    ASSERT_TRUE(survey.ok());
    for (const SurveyedAnchor& anchor : survey->anchors)
        EXPECT_TRUE(anchor.mirrored);
    EXPECT_EQ(gradeOf(survey->findings), Grade::kNotUsable);
}

TEST(RoomSurvey, AnchorsAtOneHeightAloneDoNotHoldTheirHeights) {
    WalkedRoom room = aloneRoom();
    room.anchors_m = {{2.3, 2.7, 2.3}, {-2.3, 2.7, 2.3}, {-2.3, 2.7, -2.3}, {2.3, 2.7, -2.3}};
    const auto survey = surveyed(evidenceOf(room, 4));
    ASSERT_TRUE(survey.ok());
    EXPECT_GT(survey->worstSigma_m(), 0.010);
    EXPECT_NE(gradeOf(survey->findings), Grade::kGood);
}

TEST(RoomSurvey, SaysWhatIsMissing) {
    WalkedRoom two;
    two.anchors_m.resize(2);
    const auto few = surveyed(evidenceOf(two, 1));
    ASSERT_FALSE(few.ok());
    EXPECT_EQ(few.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(few.error().message.find("2 anchors"), std::string::npos);

    WalkedRoom silent;
    silent.walks = false;
    Evidence evidence = evidenceOf(silent, 1);
    const auto unheard = surveyed(evidence);
    ASSERT_FALSE(unheard.ok());
    EXPECT_NE(unheard.error().message.find("hardly hear each other"), std::string::npos);
    for (Anchor& anchor : evidence.anchors)
        anchor.sounds = false;
    const auto mute = surveyed(evidence);
    ASSERT_FALSE(mute.ok());
    EXPECT_NE(mute.error().message.find("no sources"), std::string::npos);

    WalkedRoom deaf;
    deaf.deaf = {1, 2};
    const auto hidden = surveyed(evidenceOf(deaf, 1));
    ASSERT_FALSE(hidden.ok());
    EXPECT_NE(hidden.error().message.find("anchor_2, anchor_3"), std::string::npos);

    Evidence nowhere = evidenceOf(aloneRoom(), 1);
    for (Anchor& anchor : nowhere.anchors)
        anchor.rough_m.setZero();
    const auto unplaced = surveyed(nowhere);
    ASSERT_FALSE(unplaced.ok());
    EXPECT_NE(unplaced.error().message.find("cannot be known"), std::string::npos);
}

}  // namespace
}  // namespace noctule::room_survey
