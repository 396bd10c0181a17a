// SPDX-License-Identifier: Apache-2.0
// A suit from its rigs to the performer, by the command line alone: the values against the laboratory's, what
// is kept, what is refused.
#include <cmath>

#include "core/math/rotation.h"
#include "core/suit/calibration.h"
#include "tests/support/program_run.h"

namespace noctule {
namespace {

using namespace test;

class CalibrateByCommand : public testing::Test {
protected:
    std::string file(const std::string& name) const { return folder_.file(name); }
    /// The same seed is the same suit.
    void simulate(const std::string& rig, std::vector<std::string> more = {}) {
        std::vector<std::string> words{"simulate", "--rig", rig,     "--level",  "readings",
                                       "--seed",   "5",     "--out", takeOf(rig)};
        words.insert(words.end(), more.begin(), more.end());
        ASSERT_EQ(batch(words).exit_code, 0);
    }
    std::string takeOf(const std::string& rig) const { return file(rig + "_001.noctule"); }
    Calibration read(const std::string& path) const {
        const auto json = nlohmann::json::parse(readBytes(path), nullptr, false);
        return calibrationFromJson(json, path).value();
    }
    Ran calibrate(std::vector<std::string> words) const {
        words.insert(words.begin(), "calibrate");
        return batch(words);
    }

    Folder folder_;
};

TEST_F(CalibrateByCommand, RigsAndRestPoseMakeTheCalibrationOfAWornSuit) {
    simulate("jig", {"--digitizer-out", file("jig.csv"), "--calibration-out", file("lab.json")});
    simulate("level");
    simulate("turntable");
    simulate("rest", {"--duration", "6"});
    const Ran jig = calibrate({"sources", takeOf("jig"), "--digitizer", file("jig.csv"), "--out",
                               file("1.json"), "--report", file("jig.html"), "--json"});
    ASSERT_EQ(jig.exit_code, 0) << jig.err;
    EXPECT_EQ(jig.json().at("verdict"), "good");
    EXPECT_TRUE(jig.json().at("reasons").is_array());
    EXPECT_LT(jig.json().at("leave_one_out").at("mean_m").get<double>(), 0.00235);
    EXPECT_NE(readBytes(file("jig.html")).find("Source offsets"), std::string::npos);
    ASSERT_EQ(
        calibrate({"accelerometers", takeOf("level"), "--base", file("1.json"), "--out", file("2.json")})
            .exit_code,
        0);
    ASSERT_EQ(
        calibrate({"gyroscopes", takeOf("turntable"), "--base", file("2.json"), "--out", file("3.json")})
            .exit_code,
        0);
    ASSERT_EQ(
        calibrate({"rest-pose", takeOf("rest"), "--base", file("3.json"), "--out", file("4.json")}).exit_code,
        0);

    const Calibration found = read(file("4.json")), laboratory = read(file("lab.json"));
    for (const SourceCalibration& source : laboratory.sources) {
        const double error_s =
            found.findSource(source.id)->offsets_s.at("inflection") - source.offsets_s.at("inflection");
        EXPECT_LT(std::abs(error_s), 5e-6) << source.id << ": the laboratory errs by 1.5 µs itself";
        EXPECT_EQ(found.findSource(source.id)->made.at("sources").verdict, "good");
    }
    for (const BoardCalibration& board : laboratory.boards) {
        const BoardCalibration& ours = *found.findBoard(board.id);
        EXPECT_LT((ours.gyro.matrix - board.gyro.matrix).norm() / board.gyro.matrix.norm(), 0.003)
            << board.id;
        EXPECT_LT((ours.accel.matrix - board.accel.matrix).norm() / board.accel.matrix.norm(), 0.006)
            << board.id;
        EXPECT_TRUE(ours.q_segment_board) << board.id;
        for (const char* procedure : {"accelerometers", "gyroscopes", "rest-pose"})
            EXPECT_TRUE(ours.made.contains(procedure)) << board.id << " " << procedure;
    }
    const Ran check = batch({"check", takeOf("rest"), "--calibration", file("4.json"), "--json"});
    EXPECT_EQ(check.exit_code, 0) << check.err;
    EXPECT_EQ(check.json().at("verdict"), "good");
    EXPECT_EQ(batch({"process", takeOf("rest"), "--calibration", file("4.json")}).exit_code, 0);

    Calibration slipped = found;
    for (BoardCalibration& board : slipped.boards)
        if (board.id == "l_forearm")
            board.q_segment_board = axisAngle(Vector3d::UnitZ(), radians(15)) * *board.q_segment_board;
    writeBytes(file("slipped.json"), toJson(slipped).dump());
    const Ran moved = batch({"check", takeOf("rest"), "--calibration", file("slipped.json")});
    EXPECT_EQ(moved.exit_code, 4) << moved.out;
    EXPECT_NE(moved.err.find("left forearm, has slipped"), std::string::npos) << moved.err;
}

TEST_F(CalibrateByCommand, WhatCannotBeUsedIsRefusedWithItsReasonAndNothingIsWritten) {
    simulate("jig", {"--digitizer-out", file("jig.csv")});
    std::string millimetres = readBytes(file("jig.csv"));  // says metres, holds millimetres
    std::string scaled;
    for (size_t at = 0, line = 0; at < millimetres.size(); ++line) {
        const size_t end = millimetres.find('\n', at);
        std::string row = millimetres.substr(at, end - at);
        if (line > 0) {
            char kind[16], id[32];
            int placement = 0;
            double x = 0, y = 0, z = 0;
            ASSERT_EQ(
                std::sscanf(row.c_str(), "%d,%15[^,],%31[^,],%lf,%lf,%lf", &placement, kind, id, &x, &y, &z),
                6);
            char text[160];
            std::snprintf(text, sizeof text, "%d,%s,%s,%.3f,%.3f,%.3f", placement, kind, id, 1e3 * x, 1e3 * y,
                          1e3 * z);
            row = text;
        }
        scaled += row + "\n";
        at = end + 1;
    }
    writeBytes(file("mm.csv"), scaled);
    const std::vector<std::string> words{"sources",      takeOf("jig"), "--digitizer",
                                         file("mm.csv"), "--out",       file("c.json")};
    const Ran refused = calibrate(words);
    EXPECT_EQ(refused.exit_code, 4);
    EXPECT_NE(refused.err.find("millimetres"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(file("c.json")));
    std::vector<std::string> forced = words;
    forced.push_back("--force");
    EXPECT_EQ(calibrate(forced).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(file("c.json")));
    EXPECT_EQ(calibrate(forced).exit_code, 2) << "it is there already";
    const Ran no_sides = calibrate({"accelerometers", takeOf("jig"), "--out", file("a.json")});
    EXPECT_EQ(no_sides.exit_code, 4) << no_sides.err;
    EXPECT_FALSE(std::filesystem::exists(file("a.json")));
}

}  // namespace
}  // namespace noctule
