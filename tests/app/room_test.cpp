// SPDX-License-Identifier: Apache-2.0
// A room that surveys itself from the command line: simulate, spoil its places, survey, attach, process.
#include <cmath>

#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

const std::string kCeiling = std::string(NOCTULE_SOURCE_DIR) + "/resources/casts/ceiling_4.json";
const std::string kTransceivers = std::string(NOCTULE_SOURCE_DIR) + "/resources/casts/transceivers_13.json";

nlohmann::json parsed(const std::string& path) {
    return nlohmann::json::parse(readBytes(path));
}

/// One performer on the installed motion, below four anchors.
class WalkBelowAnchors {
public:
    explicit WalkBelowAnchors(const std::string& seconds) {
        std::ofstream(file("cast.json"))
            << R"({"subjects":[{"motion":")" + kMotion + R"(","suit":")" + kTransceivers +
                   R"(","place":{"x_m":0,"z_m":0,"yaw_deg":0}}],"room":")" + kCeiling + "\"}";
        const Ran made =
            batch({"simulate", "--cast", file("cast.json"), "--out", take(), "--level", "readings",
                   "--scenario", "nominal", "--duration", seconds, "--truth-out", file("truth.json")});
        EXPECT_EQ(made.exit_code, 0) << made.err;
    }
    std::string file(const std::string& name) const { return folder_.file(name); }
    std::string take() const { return file("walk_001.noctule"); }
    /// The room's file with every anchor elsewhere.
    std::string roughRoom(double off_m) const {
        nlohmann::json room = parsed(kCeiling);
        double sign = 1;
        for (const char* list : {"boards", "sources"})
            for (auto& part : room[list]) {
                const char* key = list == std::string("boards") ? "p_segment_board_m" : "p_segment_source_m";
                const auto index = static_cast<double>(&part - &room[list][0]);
                part[key][0] = part[key][0].get<double>() + off_m * std::cos(2 * index);
                part[key][1] = part[key][1].get<double>() - off_m * std::abs(std::sin(index)) * sign;
                part[key][2] = part[key][2].get<double>() + off_m * std::sin(2 * index);
            }
        std::ofstream(file("rough.json")) << room.dump();
        return file("rough.json");
    }
    /// Root against the truth, made equal at the first frame, mm.
    double rootError_mm(const std::string& run) const {
        const Ran processed = batch({"process", take(), "--room", "on", "--run-name", run});
        EXPECT_EQ(processed.exit_code, 0) << processed.err;
        const Ran judged = batch({"evaluate", take(), "--run", run, "--json"});
        EXPECT_EQ(judged.exit_code, 0) << judged.err;
        return 1000 * judged.json()["root"]["position_m"].get<double>();
    }

private:
    Folder folder_;
};

TEST(RoomProgram, RoughPlacesAreReplacedByASurvey) {
    SKIP_WITHOUT_MOTION();
    const WalkBelowAnchors walk("26");
    const Ran spoiled = batch({"attach", walk.take(), "--room", walk.roughRoom(0.3)});
    ASSERT_EQ(spoiled.exit_code, 0) << spoiled.err;
    const double before_mm = walk.rootError_mm("rough");

    const std::string room = walk.file("room.json");
    const Ran surveyed = batch({"calibrate", "room", walk.take(), "--out", room, "--report",
                                walk.file("room.html"), "--force", "--json"});
    ASSERT_EQ(surveyed.exit_code, 0) << surveyed.err;
    const nlohmann::json found = surveyed.json();
    ASSERT_EQ(found["anchors"].size(), 4U);
    EXPECT_EQ(found["frame"]["of"], "performer");
    EXPECT_EQ(found["frame"]["fixed"], 6);
    EXPECT_NE(readBytes(walk.file("room.html")).find("ceiling_1"), std::string::npos);
    const nlohmann::json truth = parsed(walk.file("truth.json"))["suits"][1];
    for (size_t i = 0; i < 4; ++i) {
        double square = 0;
        for (size_t axis = 0; axis < 3; ++axis)
            square += std::pow(found["anchors"][i]["source_m"][axis].get<double>() -
                                   truth["sources"][i]["p_segment_source_m"][axis].get<double>(),
                               2);
        EXPECT_LT(std::sqrt(square), 0.10) << i;
    }

    const Ran attached = batch({"attach", walk.take(), "--room", room});
    ASSERT_EQ(attached.exit_code, 0) << attached.err;
    const double after_mm = walk.rootError_mm("surveyed");
    std::printf("root: %.0f mm by rough places, %.0f mm by surveyed ones\n", before_mm, after_mm);
    EXPECT_LT(after_mm, before_mm / 2);
}

TEST(RoomProgram, TheRoomsFileIsARoomsFile) {
    SKIP_WITHOUT_MOTION();
    const WalkBelowAnchors walk("8");
    const std::string room = walk.file("room.json");
    const Ran surveyed = batch(
        {"calibrate", "room", walk.take(), "--out", room, "--force", "--store", "--height", "ceiling_1=2.7"});
    ASSERT_EQ(surveyed.exit_code, 0) << surveyed.err;
    EXPECT_EQ(parsed(room)["format"], "noctule-suit");
    std::ofstream(walk.file("again.json"))
        << R"({"subjects":[{"motion":")" + kMotion + R"("}],"room":")" + room + "\"}";
    const Ran again =
        batch({"simulate", "--cast", walk.file("again.json"), "--out", walk.file("again.noctule"), "--level",
               "readings", "--duration", "1", "--rest-seconds", "1"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    expectRefusal({"calibrate", "room", walk.take(), "--out", room}, 2, {room, "--overwrite"});
    expectRefusal({"calibrate", "room", walk.take(), "--out", walk.file("r.json"), "--height", "ceiling_9=2"},
                  2, {"ceiling_9", "ceiling_1, ceiling_2"});
    expectRefusal({"calibrate", "room", walk.take(), "--out", walk.file("r.json"), "--height", "high"}, 2,
                  {"--height", "'high'"});
    expectRefusal({"calibrate", "room", walk.take(), "--out", walk.file("r.json"), "--subject", "Bob"}, 2,
                  {"Bob", "Its subjects are A"});
    const std::string three = walk.file("three.json");
    const Ran without =
        batch({"calibrate", "room", walk.take(), "--out", three, "--force", "--without", "2", "--json"});
    ASSERT_EQ(without.exit_code, 0) << without.err;
    EXPECT_EQ(without.json()["anchors"][1]["left_out"], true);
    ASSERT_EQ(parsed(three)["sources"].size(), 3U);
    for (const auto& source : parsed(three)["sources"])
        EXPECT_NE(source["id"], "ceiling_2");
    EXPECT_EQ(parsed(room)["sources"].size(), 4U);
    expectRefusal({"calibrate", "room", walk.take(), "--out", walk.file("r.json"), "--without", "9"}, 2,
                  {"--without", "'9'", "ceiling_1, ceiling_2"});
    expectRefusal({"calibrate", "room", walk.take(), "--out", walk.file("r.json"), "--without", "ceiling_1",
                   "--without", "ceiling_2"},
                  2, {"fewer than three"});
    expectRefusal({"attach", walk.take(), "--room", kTransceivers}, 2, {"none of its anchors"});
    expectRefusal({"attach", walk.take()}, 2, {"--reference", "--room"});
}

/// Ranges to anchors that are further away than sound comes in a pulse interval, and the anchors' own pulses
/// in their own microphones: both once named anchors that nobody had moved.
TEST(RoomProgram, ATakeOfSoundHoldsPlaceAndIsSurveyed) {
    SKIP_WITHOUT_MOTION();
    const Folder folder;
    const std::string take = folder.file("sound.noctule");
    std::ofstream(folder.file("cast.json"))
        << R"({"subjects":[{"motion":")" + kMotion + R"(","suit":")" + kTransceivers +
               R"(","place":{"x_m":0.3,"z_m":-0.4,"yaw_deg":20}}],"room":")" + kCeiling + "\"}";
    ASSERT_EQ(batch({"simulate", "--cast", folder.file("cast.json"), "--out", take, "--level", "signal",
                     "--scenario", "nominal", "--duration", "12"})
                  .exit_code,
              0);
    const Ran processed = batch({"process", take, "--room", "on", "--run-name", "room", "--json"});
    ASSERT_EQ(processed.exit_code, 0) << processed.err;
    EXPECT_EQ(processed.err.find("contradicts"), std::string::npos) << processed.err;
    const Ran judged = batch({"evaluate", take, "--run", "room", "--json"});
    ASSERT_EQ(judged.exit_code, 0) << judged.err;
    EXPECT_LT(judged.json()["root_in_world"]["position_m"].get<double>(), 0.015);
    EXPECT_LT(judged.json()["root_in_world"]["yaw_deg"].get<double>(), 0.6);
    const std::string found = folder.file("room.json");
    ASSERT_EQ(batch({"calibrate", "room", take, "--out", found, "--force"}).exit_code, 0);
    const auto sources = parsed(found)["sources"], hung = parsed(kCeiling)["sources"];
    ASSERT_EQ(sources.size(), hung.size());
    const auto apart_m = [](const nlohmann::json& a, const nlohmann::json& b) {
        double square = 0;
        for (size_t axis = 0; axis < 3; ++axis)
            square += std::pow(
                a["p_segment_source_m"][axis].get<double>() - b["p_segment_source_m"][axis].get<double>(), 2);
        return std::sqrt(square);
    };
    for (size_t i = 0; i < hung.size(); ++i)
        for (size_t k = 0; k < i; ++k)
            EXPECT_NEAR(apart_m(sources[i], sources[k]), apart_m(hung[i], hung[k]), 0.04) << i << ", " << k;
}

TEST(RoomProgram, ATakeWithoutARoomIsRefused) {
    SKIP_WITHOUT_MOTION();
    const Folder folder;
    const std::string take = folder.file("alone.noctule");
    makeTake(take, "2");
    expectRefusal({"calibrate", "room", take, "--out", folder.file("room.json")}, 2, {take, "has no room"});
    expectRefusal({"attach", take, "--room", kCeiling}, 2, {take, "has no room"});
    EXPECT_FALSE(std::filesystem::exists(folder.file("room.json")));
}

}  // namespace
}  // namespace noctule::test
