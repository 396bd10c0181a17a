// SPDX-License-Identifier: Apache-2.0
#include "core/processing/outside_files.h"

#include <gtest/gtest.h>

#include "core/job/atomic_file.h"
#include "core/processing/export_take.h"
#include "tests/core/processing/made_take.h"

namespace noctule {
namespace {

class OutsideFiles : public test::MadeTake {
protected:
    /// The take's own motion as another system might have recorded it, 0.25 s late.
    std::string motionFile() {
        addRuns("AGD manifold");
        ExportRequest request;
        request.take_path = path();
        request.bvh_path = file("optical.bvh");
        request.csv_path = file("optical.csv");
        request.overwrite = true;
        const auto written = exportTake(request, {});
        EXPECT_TRUE(written) << written.error().text();
        return request.bvh_path;
    }
};

TEST_F(OutsideFiles, AnAttachedMotionIsRememberedWithNameAndShift) {
    std::vector<std::string> warnings;
    auto request = readAttachment(motionFile(), warnings, {});
    ASSERT_TRUE(request) << request.error().text();
    EXPECT_TRUE(request->motion && !request->positions);
    EXPECT_TRUE(warnings.empty());
    request->take_path = path();
    request->shift_s = 0.25;
    ASSERT_TRUE(attachReference(*request, {}));
    const auto facts = referenceFacts(path());
    ASSERT_TRUE(facts) << facts.error().text();
    EXPECT_EQ(facts->kind, "optical");
    EXPECT_EQ(facts->name, "optical.bvh");
    ASSERT_TRUE(facts->shift_s);
    EXPECT_NEAR(*facts->shift_s, 0.25, 1e-6);
    EXPECT_GT(facts->matched, 10);
    EXPECT_LE(facts->matched, facts->joints);
}

TEST_F(OutsideFiles, TablesArePositions) {
    motionFile();
    std::vector<std::string> warnings;
    const auto request = readAttachment(file("optical.csv"), warnings, {});
    ASSERT_TRUE(request) << request.error().text();
    EXPECT_TRUE(request->positions && !request->motion);
    EXPECT_TRUE(isPositionsFile("a.CSV"));
    EXPECT_FALSE(isPositionsFile("csv.bvh"));
    EXPECT_TRUE(holdsPlacesOnly("a.csv") && holdsPlacesOnly("a.trc") && holdsPlacesOnly("a.C3D"));
    ASSERT_TRUE(writeFileAtomically(file("walk.trc"),
                                    "PathFileType\t4\t(X/Y/Z)\twalk.trc\n"
                                    "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n"
                                    "100\t100\t2\t1\tmm\n"
                                    "Frame#\tTime\tHips\t\t\n"
                                    "\t\tX1\tY1\tZ1\n\n"
                                    "1\t0\t0\t1000\t0\n"
                                    "2\t0.01\t10\t1000\t0\n",
                                    false));
    const auto marked = readAttachment(file("walk.trc"), warnings, {});
    ASSERT_TRUE(marked) << marked.error().text();
    ASSERT_TRUE(marked->positions);
    EXPECT_EQ(marked->positions->joints, std::vector<std::string>{"Hips"});
    EXPECT_NEAR(marked->positions->at(0, 0).y(), 1, 1e-9);
    EXPECT_NE(warnings.back().find("Y was taken"), std::string::npos) << warnings.back();
}

TEST_F(OutsideFiles, WhatCannotBeReadIsNamed) {
    std::vector<std::string> warnings;
    EXPECT_EQ(readAttachment(file("none.bvh"), warnings, {}).error().kind, ErrorKind::kUnreadable);
    EXPECT_EQ(referenceFacts(path()).error().kind, ErrorKind::kUnusable) << "the take has none";
    ASSERT_TRUE(writeFileAtomically(file("c.json"), "{", false));
    const auto calibration = readCalibrationFile(file("c.json"));
    ASSERT_FALSE(calibration);
    EXPECT_NE(calibration.error().message.find("c.json"), std::string::npos);
}

TEST_F(OutsideFiles, ACalibrationComesBack) {
    Suit suit{"one", {}, {}};
    Board board;
    board.id = "b";
    board.segment = "Hips";
    suit.boards.push_back(board);
    ASSERT_TRUE(writeFileAtomically(file("c.json"), toJson(nominalCalibration(suit)).dump(), false));
    const auto calibration = readCalibrationFile(file("c.json"));
    ASSERT_TRUE(calibration) << calibration.error().text();
    EXPECT_TRUE(calibration->findBoard("b"));
}

}  // namespace
}  // namespace noctule
