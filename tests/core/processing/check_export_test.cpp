// SPDX-License-Identifier: Apache-2.0
#include "core/processing/check_export.h"

#include <gtest/gtest.h>

#include "core/job/atomic_file.h"
#include "core/processing/export_names.h"
#include "tests/core/processing/made_take.h"

namespace noctule {
namespace {

class CheckExport : public test::MadeTake {
protected:
    void SetUp() override {
        MadeTake::SetUp();
        addRuns("AGD manifold");
        request_.take_path = path();
        request_.frames_per_second = 60;
        request_.overwrite = true;
    }

    ExportCheck written(const ExportRequest& request) {
        const auto summary = exportTake(request, {});
        EXPECT_TRUE(summary) << summary.error().text();
        return checked(request);
    }
    ExportCheck checked(const ExportRequest& request) {
        const auto checks = checkExport(request, {});
        EXPECT_TRUE(checks) << checks.error().text();
        return checks->at(0);
    }
    ExportRequest bvh(RootMotion root = RootMotion::kMoving) {
        ExportRequest request = request_;
        request.bvh_path = file("out.bvh");
        request.root = root;
        return request;
    }
    ExportRequest csv(RootMotion root = RootMotion::kMoving) {
        ExportRequest request = request_;
        request.csv_path = file("out.csv");
        request.root = root;
        return request;
    }

    /// Replaces the last line by what `change` makes of it; empty: takes it away.
    void changeLastLine(const std::string& path, const std::function<std::string(std::string)>& change) {
        std::string text = *readWholeFile(path);
        const size_t begin = text.rfind('\n', text.size() - 2) + 1;
        const std::string changed = change(text.substr(begin, text.size() - begin - 1));
        text = text.substr(0, begin) + (changed.empty() ? "" : changed + "\n");
        ASSERT_TRUE(writeFileAtomically(path, text, true));
    }

    ExportRequest request_;
};

/// The n-th number of a line (from 0), increased.
std::string increased(std::string line, size_t index, char separator, double by) {
    size_t begin = 0;
    for (size_t i = 0; i < index; ++i)
        begin = line.find(separator, begin) + 1;
    const size_t end = std::min(line.find(separator, begin), line.size());
    return line.replace(begin, end - begin, std::to_string(std::stod(line.substr(begin, end - begin)) + by));
}

TEST_F(CheckExport, BvhHoldsTheTakeHoweverTheRootIsHeld) {
    for (const RootMotion root : {RootMotion::kMoving, RootMotion::kInPlace, RootMotion::kHeading}) {
        const ExportCheck check = written(bvh(root));
        EXPECT_TRUE(check.ok()) << check.faults.front();
        EXPECT_EQ(check.frames, 120U);
        EXPECT_EQ(check.expected_frames, 120U);
        EXPECT_NEAR(check.frames_per_second, 60, 1e-3);
        EXPECT_EQ(check.joints, 21);
        EXPECT_EQ(check.run, "AGD manifold");
        EXPECT_NEAR(check.facing_rad, 0, 1e-9);
        EXPECT_GT(check.height_m, 1.6);
        EXPECT_LT(check.height_m, 1.9);
        EXPECT_TRUE(check.has_angles);
        EXPECT_LT(check.largest_angle_rad, 1e-6);
        EXPECT_GT(check.bytes, 10000);
    }
}

TEST_F(CheckExport, FilesAtTheRateOfTelevisionAreRead) {
    ExportRequest request = bvh();
    request.fbx_path = file("out.fbx");
    request.glb_path = file("out.glb");
    request.csv_path = file("out.csv");
    for (const double ntsc : {30000.0 / 1001, 60000.0 / 1001}) {
        request.frames_per_second = ntsc;
        ASSERT_TRUE(exportTake(request, {}));
        const auto checks = checkExport(request, {});
        ASSERT_TRUE(checks) << checks.error().text();
        EXPECT_EQ(checks->size(), 4u);
        for (const ExportCheck& check : *checks) {
            EXPECT_TRUE(check.ok()) << check.path << ": " << check.faults.front();
            EXPECT_NEAR(check.frames_per_second, ntsc, 1e-3) << check.path;
        }
    }
}

TEST_F(CheckExport, CsvHoldsTheTakeHoweverTheRootIsHeld) {
    for (const RootMotion root : {RootMotion::kMoving, RootMotion::kInPlace, RootMotion::kHeading}) {
        const ExportCheck check = written(csv(root));
        EXPECT_TRUE(check.ok()) << check.faults.front();
        EXPECT_EQ(check.frames, 120U);
        EXPECT_FALSE(check.has_angles);
        EXPECT_LT(check.largest_position_m, 2e-6);
        EXPECT_GT(check.largest_position_m, 0) << "a table has six decimals";
    }
}

TEST_F(CheckExport, AnglesOfATableAreCompared) {
    ExportRequest request = csv();
    request.angles = true;
    EXPECT_TRUE(written(request).has_angles);
    EXPECT_TRUE(checked(request).ok());
    changeLastLine(request.csv_path, [](const std::string& line) {
        return increased(line, static_cast<size_t>(std::count(line.begin(), line.end(), ',')), ',', 1);
    });
    const ExportCheck check = checked(request);
    EXPECT_FALSE(check.ok());
    EXPECT_NEAR(degrees(check.largest_angle_rad), 1, 1e-4);
}

TEST_F(CheckExport, FindsATurnedJoint) {
    const ExportRequest request = bvh();
    ASSERT_TRUE(written(request).ok());
    changeLastLine(request.bvh_path,
                   [](const std::string& line) { return increased(line, 9, ' ', 0.5); });  // of one joint
    const ExportCheck check = checked(request);
    ASSERT_FALSE(check.ok());
    EXPECT_NEAR(degrees(check.largest_angle_rad), 0.5, 0.01);
    EXPECT_GT(check.largest_position_m, 1e-4) << "what hangs on it is elsewhere";
}

TEST_F(CheckExport, FindsAShiftedRoot) {
    const ExportRequest request = bvh(RootMotion::kInPlace);
    ASSERT_TRUE(written(request).ok());
    changeLastLine(request.bvh_path, [](const std::string& line) { return increased(line, 0, ' ', 1); });
    EXPECT_NEAR(checked(request).largest_position_m, 0.01, 1e-6) << "one centimetre";
    EXPECT_FALSE(checked(request).ok());
}

TEST_F(CheckExport, FindsAMissingFrame) {
    const ExportRequest request = csv();
    ASSERT_TRUE(written(request).ok());
    changeLastLine(request.csv_path, [](const std::string&) { return std::string(); });
    const ExportCheck check = checked(request);
    ASSERT_FALSE(check.ok());
    EXPECT_EQ(check.frames, 119U);
    EXPECT_EQ(check.faults.front(), "The file holds 119 frames, the take has 120 in this range.");
}

TEST_F(CheckExport, FindsAnotherUnitAndAnotherHeading) {
    ExportRequest request = bvh(RootMotion::kHeading);
    ASSERT_TRUE(written(request).ok());
    request.metres_per_unit = 1;
    EXPECT_FALSE(checked(request).ok()) << "a hundred times as tall";
    request = csv(RootMotion::kMoving);
    ASSERT_TRUE(written(request).ok());
    request.root = RootMotion::kHeading;
    EXPECT_FALSE(checked(request).ok()) << "the heading was not taken out";
}

TEST_F(CheckExport, SaysWhyAFileCannotBeRead) {
    const ExportRequest request = bvh();
    ASSERT_TRUE(writeFileAtomically(request.bvh_path, "nothing", true));
    const ExportCheck check = checked(request);
    ASSERT_FALSE(check.ok());
    EXPECT_NE(check.faults.front().find("out.bvh"), std::string::npos);
}

TEST_F(CheckExport, NamesBoardsThatWereSilentInTheRange) {
    auto take = Take::open(path(), Access::kReadWrite);
    ASSERT_TRUE(take);
    auto edit = TakeEdit::begin(*take);
    ASSERT_TRUE(edit);
    ASSERT_TRUE(edit->addGap({static_cast<int64_t>(0.4 * test::kRate_hz), test::kRate_hz / 5, 1, "board"}));
    ASSERT_TRUE(edit->addGap({static_cast<int64_t>(1.6 * test::kRate_hz), 1200, 0, "board"}));
    ASSERT_TRUE(edit->commit());
    ExportRequest request = bvh();
    request.from_s = 0.5;
    request.to_s = 1.5;
    const ExportCheck check = written(request);
    EXPECT_TRUE(check.ok());
    EXPECT_EQ(check.frames, 61U);
    ASSERT_EQ(check.silent.size(), 1U) << "the other one lies after the range";
    EXPECT_EQ(check.silent[0].segment, "LeftHand");
    EXPECT_NEAR(check.silent[0].from_s, 0.5, 1e-9) << "cut to the range";
    EXPECT_NEAR(check.silent[0].to_s, 0.6, 1e-9);
    EXPECT_EQ(check.silent[0].frames, 6U);
}

TEST(ExportNames, FillsInThePlaces) {
    const ExportNameFields fields{"turn_003", "Ada", "AGD manifold", "2026-11-21", 60};
    EXPECT_EQ(*exportFileName("{take}_{fps}", fields), "turn_003_60");
    EXPECT_EQ(*exportFileName("{date} {performer} {run}", fields), "2026-11-21 Ada AGD manifold");
    EXPECT_EQ(*exportFileName("a/b:{take}", fields), "a-b-turn_003") << "no folders, nothing refused";
    EXPECT_EQ(*exportFileName("{take", fields), "{take") << "not a place";
    EXPECT_EQ(exportFileName("{takes}", fields).error().kind, ErrorKind::kUsage);
    EXPECT_EQ(exportFileName(" . ", fields).error().kind, ErrorKind::kUsage);
}

TEST_F(CheckExport, NamesAreNeverTakenTwice) {
    std::set<std::string> taken;
    ASSERT_TRUE(writeFileAtomically(file("a.bvh"), "there", false));
    EXPECT_EQ(freeFilePath(folder_.path(), "a", "bvh", taken), file("a_2.bvh"));
    EXPECT_EQ(freeFilePath(folder_.path(), "a", "bvh", taken), file("a_3.bvh")) << "of the same export";
    EXPECT_EQ(freeFilePath(folder_.path(), "a", "csv", taken), file("a.csv"));
}

TEST_F(CheckExport, WhatHelpsBelowTheFloorDependsOnWhatHoldsTheFigure) {
    const auto held = [](const std::string& settings) {
        DerivedRun run;
        run.settings_json = settings;
        return heldBy(run);
    };
    EXPECT_EQ(held(R"({"estimator":"manifold","ground":"level"})"), HeldBy::kLevelFloor);
    EXPECT_EQ(held(R"({"estimator":"manifold","ground":"uneven"})"), HeldBy::kUnevenGround);
    EXPECT_EQ(held(R"({"estimator":"manifold","ground":"treadmill"})"), HeldBy::kTreadmill);
    EXPECT_EQ(held(R"({"estimator":"manifold","ground":"none"})"), HeldBy::kNothing);
    EXPECT_EQ(held(R"({"estimator":"manifold","ground":"level","room":true})"), HeldBy::kRoom);
    EXPECT_EQ(held(R"({"estimator":"manifold","ground":"level","root":"given"})"), HeldBy::kOtherSystem);
    EXPECT_EQ(held(R"({"estimator":"paper"})"), HeldBy::kNothing);
    EXPECT_EQ(held(R"({"estimator":"orientation","ground":"none"})"), HeldBy::kLevelFloor);
    EXPECT_EQ(held("{}"), HeldBy::kOtherSystem) << "an imported motion";

    ExportCheck check;
    check.has_figure = true;
    check.lowest_m = -0.05;
    EXPECT_EQ(check.floorRemedy(), FloorRemedy::kNone) << "for moments, of feet on a level floor";
    check.held_by = HeldBy::kNothing;
    EXPECT_EQ(check.floorRemedy(), FloorRemedy::kHoldFeet);
    check.lowest_m = -0.01;
    EXPECT_EQ(check.floorRemedy(), FloorRemedy::kNone) << "feet roll as deep";
    check.lowest_m = check.usual_lowest_m = -0.05;
    check.held_by = HeldBy::kTreadmill;
    EXPECT_EQ(check.floorRemedy(), FloorRemedy::kMoveUp);
}

TEST_F(CheckExport, HowDeepAFigureUsuallyStandsIsReadFromTheFile) {
    for (const ExportCheck& check : {written(bvh()), written(csv())}) {
        EXPECT_LT(check.lowest_m, check.usual_lowest_m);
        EXPECT_LT(check.usual_lowest_m, check.lowest_m + 0.5);
        EXPECT_EQ(check.held_by, HeldBy::kOtherSystem) << "as its settings say";
    }
}

}  // namespace
}  // namespace noctule
