// SPDX-License-Identifier: Apache-2.0
// A suit from its rigs to the performer, by the command line alone: the values against the laboratory's, what
// is kept, what is refused.
#include <cmath>

#include "core/formats/bvh.h"
#include "core/math/rotation.h"
#include "core/suit/calibration.h"
#include "core/suit/default_suit.h"
#include "core/vision/marker_plan.h"
#include "tests/support/guided_motion.h"
#include "tests/support/photographed_jig.h"
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

TEST_F(CalibrateByCommand, ByHandNeedsNeitherPlateNorTurntable) {
    simulate("level");
    const auto reasons = [&](const std::string& kind, std::vector<std::string> more) {
        more.insert(more.begin(), {kind, takeOf("level"), "--out", file("c.json"), "--json"});
        const Ran ran = calibrate(more);
        EXPECT_EQ(ran.exit_code, 4) << "six sides are too few by hand";
        return ran.json().at("reasons");
    };
    const auto inertial = reasons("inertial", {});
    EXPECT_EQ(reasons("accelerometers", {"--by-hand"}), inertial);
    EXPECT_EQ(reasons("gyroscopes", {"--by-hand"}), inertial);
}

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

TEST_F(CalibrateByCommand, MovementTellsMountingAndBonesAndStandingStillDoesNot) {
    ASSERT_TRUE(writeBvh(file("guided.bvh"), GuidedMotion::clip({16.0 / 6}), {}, true));
    ASSERT_EQ(batch({"simulate", "--motion", file("guided.bvh"), "--level", "readings", "--out",
                     takeOf("guided"), "--seed", "5"})
                  .exit_code,
              0);
    const Ran moved = calibrate({"motion", takeOf("guided"), "--out", file("moved.json"), "--actor-out",
                                 file("performer.json"), "--report", file("moved.html"), "--json"});
    ASSERT_EQ(moved.exit_code, 0) << moved.err;
    EXPECT_EQ(moved.json().at("verdict"), "good") << moved.json().at("reasons");
    EXPECT_EQ(moved.json().at("boards").size(), 18u);
    EXPECT_TRUE(moved.json().at("boards")[0].contains("sigma_turn_deg"));
    EXPECT_NE(readBytes(file("moved.html")).find("Bones"), std::string::npos);
    const Calibration found = read(file("moved.json"));
    for (const BoardCalibration& board : found.boards)
        EXPECT_EQ(board.made.at("motion").verdict, "good") << board.id;
    EXPECT_TRUE(found.sources[0].p_segment_source_m);
    EXPECT_EQ(batch({"process", takeOf("guided"), "--calibration", file("moved.json"), "--actor",
                     file("performer.json")})
                  .exit_code,
              0);

    simulate("rest", {"--duration", "20"});
    const std::vector<std::string> still{"motion",           takeOf("rest"), "--out",
                                         file("still.json"), "--actor-out",  file("still_actor.json")};
    const Ran refused = calibrate(still);
    EXPECT_EQ(refused.exit_code, 4);
    EXPECT_NE(refused.err.find("movement"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(file("still.json")) ||
                 std::filesystem::exists(file("still_actor.json")));
    std::vector<std::string> forced = still;
    forced.push_back("--force");
    EXPECT_EQ(calibrate(forced).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(file("still.json")));
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
    EXPECT_NE(refused.out.find("no distance could be judged"), std::string::npos) << refused.out;
    EXPECT_EQ(refused.out.find("0.00"), std::string::npos) << "nothing was measured: " << refused.out;
    EXPECT_FALSE(std::filesystem::exists(file("c.json")));
    std::vector<std::string> forced = words;
    forced.push_back("--force");
    EXPECT_EQ(calibrate(forced).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(file("c.json")));
    EXPECT_EQ(calibrate(forced).exit_code, 2) << "it is there already";
    const Ran no_sides = calibrate({"accelerometers", takeOf("jig"), "--out", file("a.json")});
    EXPECT_EQ(no_sides.exit_code, 4) << no_sides.err;
    EXPECT_NE(no_sides.err.find("; and 15 more"), std::string::npos)
        << "every board for the same reason: " << no_sides.err;
    EXPECT_FALSE(std::filesystem::exists(file("a.json")));
}

/// Where the digitizer touched sources and boards, placement by placement.
std::map<std::string, std::vector<StuckMarker>> markersAtDigitizerPoints(const std::string& csv,
                                                                         double side_m) {
    const Suit suit = defaultSuit();
    std::map<std::string, std::vector<StuckMarker>> stuck;
    for (size_t at = csv.find('\n') + 1; at < csv.size(); at = csv.find('\n', at) + 1) {
        char placement[16], kind[16], id[32];
        Vector3d p;
        if (std::sscanf(csv.c_str() + at, "%15[^,],%15[^,],%31[^,],%lf,%lf,%lf", placement, kind, id, &p.x(),
                        &p.y(), &p.z()) != 6)
            ADD_FAILURE() << csv.substr(at, 80);
        const bool is_source = std::string(kind) == "source";
        StuckMarker marker;
        marker.number =
            is_source ? kFirstSourceMarker + suit.findSource(id) : kFirstBoardMarker + suit.findBoard(id);
        marker.p_m = p;
        marker.side_m = side_m;
        // Sources and boards face each other; their markers look half to the side where the camera is.
        const Vector3d normal = Vector3d(0.8, 0.3, is_source ? -0.5 : 0.5).normalized(),
                       right = Vector3d::UnitY().cross(normal).normalized();
        marker.R << right, normal.cross(right), normal;
        stuck[placement].push_back(marker);
    }
    return stuck;
}

TEST_F(CalibrateByCommand, PhotographsGiveTheOffsetsThatTheDigitizerGives) {
    simulate("jig", {"--digitizer-out", file("jig.csv")});
    const auto stuck = markersAtDigitizerPoints(readBytes(file("jig.csv")), 0.02);
    ASSERT_EQ(stuck.size(), 6U);
    std::vector<std::string> words{"sources", takeOf("jig"),       "--marker-mm", "20",
                                   "--out",   file("photos.json"), "--json",      "--photos"};
    TestCamera camera{2000, 1500, 1500, {1003, 746}, -0.05, 0.02};
    uint32_t seed = 0;
    for (const auto& [placement, markers] : stuck) {
        Eigen::AlignedBox3d box;
        for (const StuckMarker& marker : markers)
            box.extend(marker.p_m);
        const Vector3d middle = box.center();
        for (const Vector3d& from :
             {Vector3d(0.65, 0.3, -0.2), Vector3d(0.7, 0.1, 0.2), Vector3d(0.6, 0.5, 0.05)}) {
            camera.look(middle + 1.2 * from, middle, 0.1 * double(seed));
            words.push_back(file(placement + "_" + std::to_string(seed) + ".jpg"));
            writeBytes(words.back(), takePhotograph(camera, markers, {.samples = 2}, ++seed));
        }
    }
    const Ran photographed = calibrate(words);
    ASSERT_EQ(photographed.exit_code, 0) << photographed.err;
    ASSERT_EQ(calibrate({"sources", takeOf("jig"), "--digitizer", file("jig.csv"), "--out", file("d.json")})
                  .exit_code,
              0);
    const Calibration ours = read(file("photos.json")), digitized = read(file("d.json"));
    double worst_s = 0;
    for (const SourceCalibration& source : digitized.sources) {
        const double error_s =
            ours.findSource(source.id)->offsets_s.at("inflection") - source.offsets_s.at("inflection");
        worst_s = std::max(worst_s, std::abs(error_s));
        EXPECT_LT(std::abs(error_s), 2e-6) << source.id;
    }
    EXPECT_EQ(photographed.json().at("reasons").dump().find("twice"), std::string::npos);
    const auto photographs = photographed.json().at("photographs");
    EXPECT_EQ(photographs.at("files").size(), 18U);
    EXPECT_NEAR(photographs.at("lenses").at(0).at("focal_px").get<double>(), camera.focal_px, 5);
    std::printf("offsets from photographs and from the digitizer differ by at most %.2f us; %s\n",
                1e6 * worst_s, photographed.json().at("reasons").dump().c_str());

    // What can go wrong on the way, by name.
    const auto refused = [&](const std::string& path, int exit_code, const std::vector<std::string>& named) {
        std::vector<std::string> changed{"calibrate", "sources",       takeOf("jig"),
                                         "--out",     file("no.json"), "--photos"};
        changed.insert(changed.end(), {path, words.back()});
        expectRefusal(changed, exit_code, named);
    };
    writeBytes(file("1_cut.jpg"), readBytes(words.back()).substr(0, 30000));
    refused(file("1_cut.jpg"), 3, {"1_cut.jpg", "cut off", "again"});
    writeBytes(file("1_noise.jpg"), std::string(3000, 'x'));
    refused(file("1_noise.jpg"), 3, {"1_noise.jpg", "not a photograph"});
    refused(file("1_missing.jpg"), 3, {"1_missing.jpg"});
    refused(file("IMG_1.jpg"), 2, {"IMG_1.jpg", "1, 2, 3, 4, 5, 6", "PLACEMENT_"});
    std::filesystem::copy_file(words.back(), file("1_a.jpg"));
    refused(file("1_a.jpg"), 4, {"only one photograph", "two photographs"});
    EXPECT_FALSE(std::filesystem::exists(file("no.json")));
}

TEST_F(CalibrateByCommand, MarkersArePrintedWithoutATake) {
    const Ran ran = calibrate({"sources", "--print-markers", file("sheet.svg"), "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.json().at("sheets").size(), 3U);
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"sheet.svg", "sheet_2.svg", "sheet_3.svg"}));
    EXPECT_NE(readBytes(file("sheet.svg")).find("0: source 1, "), std::string::npos);
    expectRefusal({"calibrate", "sources", "--print-markers", file("sheet.svg")}, 2, {"sheet.svg"});

    Suit suit = defaultSuit();
    suit.boards.resize(3);
    suit.sources.resize(2);
    writeBytes(file("small.json"), toJson(suit).dump());
    EXPECT_EQ(calibrate({"sources", "--print-markers", file("small.svg"), "--suit", file("small.json"),
                         "--marker-mm", "60"})
                  .exit_code,
              0);
    EXPECT_EQ(readBytes(file("small.svg")).find("board 4"), std::string::npos);
    while (suit.sources.size() < 12)
        suit.sources.push_back(suit.sources.front());
    for (size_t s = 0; s < suit.sources.size(); ++s)
        suit.sources[s].id = "s" + std::to_string(s);
    writeBytes(file("large.json"), toJson(suit).dump());
    expectRefusal({"calibrate", "sources", "--print-markers", file("l.svg"), "--suit", file("large.json")}, 4,
                  {"12 sources"});
}

TEST_F(CalibrateByCommand, OptionsOfPhotographsAreChecked) {
    const std::string sheet = file("s.svg");
    expectRefusal({"calibrate", "sources", "t", "--print-markers", sheet}, 2, {"'t'"});
    expectRefusal({"calibrate", "sources", "--print-markers", sheet, "--photos", "1_a.jpg"}, 2,
                  {"--print-markers", "--photos"});
    expectRefusal({"calibrate", "sources", "--print-markers", sheet, "--marker-mm", "5"}, 2,
                  {"--marker-mm", "10"});
    expectRefusal({"calibrate", "sources", "t", "--out", "c", "--digitizer", "d", "--marker-mm", "30"}, 2,
                  {"--marker-mm", "--photos"});
    expectRefusal({"calibrate", "sources", "t", "--out", "c", "--photos", "1_a.jpg", "--suit", "s"}, 2,
                  {"--suit"});
    expectRefusal({"calibrate", "sources", "t", "--out", "c", "--photos", "1_a.jpg", "--digitizer", "d"}, 2,
                  {"one of --digitizer, --distances and --photos"});
    expectRefusal({"calibrate", "sources", "t", "--photos", "--out", "c"}, 2, {"--photos has no value"});
    EXPECT_FALSE(std::filesystem::exists(sheet));
}

/// The suit says where boards sit, the calibration how exactly: laboratories state 0 of exact mountings.
TEST_F(CalibrateByCommand, OrientationsTrustMountingsAsFarAsIsStated) {
    const std::string take = takeOf("exact");
    ASSERT_EQ(batch({"simulate", "--motion", NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh", "--level",
                     "readings", "--duration", "14", "--out", take, "--calibration-out", file("stated.json")})
                  .exit_code,
              0);
    Calibration silent = read(file("stated.json"));
    for (BoardCalibration& board : silent.boards) {
        EXPECT_EQ(board.sigma_mounting_rad, Vector3d::Zero()) << board.id;
        board.sigma_mounting_rad.reset();
    }
    writeBytes(file("silent.json"), toJson(silent).dump());
    const auto mean_deg = [&](const std::string& name) {
        EXPECT_EQ(batch({"process", take, "--estimator", "orientation", "--calibration", file(name + ".json"),
                         "--run-name", name})
                      .exit_code,
                  0);
        return batch({"evaluate", take, "--run", name, "--json"}).json().at("mean_deg").get<double>();
    };
    EXPECT_LT(mean_deg("stated"), mean_deg("silent") - 0.1);
}

}  // namespace
}  // namespace noctule
