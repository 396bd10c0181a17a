// SPDX-License-Identifier: Apache-2.0
// A cast from the command line: simulate, inspect, process, evaluate, and what may be wrong with the file.
#include "core/formats/positions_csv.h"
#include "core/formats/scene_reader.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

/// A cast of two on the installed motion, in a folder of its own.
class CastOfTwo {
public:
    explicit CastOfTwo(const std::string& more = "") {
        write(R"({"subjects":[{"motion":")" + kMotion +
              R"(","place":{"z_m":-0.8}},{"name":"Bea","motion":")" + kMotion +
              R"(","place":{"z_m":0.8,"yaw_deg":180}}])" + more + "}");
    }
    void write(const std::string& text) const { std::ofstream(cast()) << text; }
    std::string cast() const { return folder_.file("cast.json"); }
    std::string file(const std::string& name) const { return folder_.file(name); }

private:
    Folder folder_;
};

const std::string kAnchors = std::string(NOCTULE_SOURCE_DIR) + "/resources/casts/ceiling_4.json";

/// The file holds A and Bea where each alone is, by each_A.csv and each_Bea.csv.
void expectBoth(const CastOfTwo& two, const std::string& file, SceneFormat format) {
    const auto scene = SceneFile::open(two.file(file), file, format);
    ASSERT_TRUE(scene) << scene.error().text();
    std::vector<Vector3d> hips_m;
    for (const std::string name : {"A", "Bea"}) {
        const auto table = readPositionsCsv(two.file("each_" + name + ".csv"));
        ASSERT_TRUE(table) << table.error().text();
        std::vector<std::string> joints;
        for (const std::string& joint : table->joints)
            joints.push_back(name + ":" + joint);
        const auto motion = scene->read(joints, {});
        ASSERT_TRUE(motion) << motion.error().text();
        ASSERT_EQ(motion->clip.frames.size(), 61U);
        for (const size_t frame : {0U, 30U, 60U})
            for (size_t j = 0; j < joints.size(); ++j)
                EXPECT_LT((globalPose(motion->clip, frame).p_world_joint[j] - table->at(frame, j)).norm(),
                          1e-5)
                    << joints[j];
        hips_m.push_back(motion->clip.frames[0].p_world_root);
    }
    EXPECT_GT((hips_m[0] - hips_m[1]).norm(), 0.5) << "they stand apart";
}

/// Every second frame of Bea's boards is lost, A's are whole.
void expectTheWorstVerdict(const std::string& take) {
    runSql(take,
           "UPDATE inertial SET gx=NULL,gy=NULL,gz=NULL,ax=NULL,ay=NULL,az=NULL,corrected=NULL "
           "WHERE suit=2 AND frame%2=0");
    const Ran judged = batch({"evaluate", take, "--json"});
    ASSERT_EQ(judged.exit_code, 0) << judged.err;
    const auto json = judged.json();
    EXPECT_EQ(json["subjects"][1]["verdict"], "Not usable");
    EXPECT_NE(json["subjects"][0]["verdict"], "Not usable") << json["subjects"][0]["reasons"];
    EXPECT_EQ(json["verdict"], "Not usable") << "the worst, not the first";
    EXPECT_EQ(json["reasons"].back().get<std::string>().find("Bea: "), 0U) << json["reasons"];
    const std::string text = batch({"evaluate", take}).out;
    EXPECT_EQ(text.find("all subjects: Not usable (Bea)"), 0U) << text;
    EXPECT_NE(text.find("Not usable. Mean joint error"), std::string::npos) << text;
}

TEST(CastProgram, ATakeOfTwoGoesAllTheWay) {
    SKIP_WITHOUT_MOTION();
    const CastOfTwo two(R"(,"room":")" + kAnchors + "\"");
    const std::string take = two.file("two_001.noctule");
    const Ran made = batch({"simulate", "--cast", two.cast(), "--out", take, "--level", "readings", "--json",
                            "--duration", "3", "--rest-seconds", "1", "--truth-out", two.file("truth.json")});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const auto suits = made.json()["suits"];
    ASSERT_EQ(suits.size(), 3U);
    EXPECT_EQ(suits[0]["name"], "A");
    EXPECT_EQ(suits[1]["carrier_hz"], 48000);
    EXPECT_EQ(suits[2]["pulse_interval_samples"], 1260);
    const auto truth = nlohmann::json::parse(readBytes(two.file("truth.json")));
    EXPECT_GT(std::abs(truth["suits"][1]["clock"]["offset_ns"].get<double>()), 1000);

    const Ran seen = batch({"inspect", take});
    EXPECT_EQ(seen.exit_code, 0) << seen.err;
    for (const std::string text : {"subject A", "subject Bea", "the room", "ceiling_1"})
        EXPECT_NE(seen.out.find(text), std::string::npos) << text << " is not in " << seen.out;
    const Ran processed = batch({"process", take});
    EXPECT_EQ(processed.exit_code, 0) << processed.err;
    const Ran judged = batch({"evaluate", take});
    EXPECT_EQ(judged.exit_code, 0) << judged.err;
    EXPECT_NE(judged.out.find("Bea"), std::string::npos) << judged.out;

    // Both in one file are where each alone is, at the same instants.
    const std::vector<std::string> part{"--from", "1.5", "--to", "2.5", "--fps", "60", "--json"};
    const auto exported = [&](std::vector<std::string> what) {
        what.insert(what.begin(), {"export", take});
        what.insert(what.end(), part.begin(), part.end());
        return batch(what);
    };
    ASSERT_EQ(exported({"--csv", two.file("each.csv")}).exit_code, 0);
    for (const SceneFormat format : {SceneFormat::kFbx, SceneFormat::kGlb}) {
        const std::string ending = format == SceneFormat::kFbx ? "fbx" : "glb", file = "both." + ending;
        const Ran together = exported({"--" + ending, two.file(file), "--together", "--mesh", "none"});
        ASSERT_EQ(together.exit_code, 0) << together.err;
        EXPECT_EQ(together.json()["performers"], 2);
        EXPECT_EQ(together.json()["frames"], 61);
        expectBoth(two, file, format);
    }
    expectRefusal({"export", take, "--fbx", two.file("no.fbx"), "--stacks"}, 4,
                  {"several performers", "--together"});
    expectRefusal({"export", take, "--bvh", two.file("no.bvh"), "--together"}, 2, {"--together", "--fbx"});
    expectTheWorstVerdict(take);
}

/// Sound alone: who is heard is told by the carrier, and the boxes' clocks are found from what they heard.
TEST(CastProgram, TheSoundOfTwoJoinsThem) {
    SKIP_WITHOUT_MOTION();
    const CastOfTwo two;
    const std::string take = two.file("sound_001.noctule");
    const Ran made = batch({"simulate", "--cast", two.cast(), "--out", take, "--level", "signal",
                            "--duration", "1.5", "--rest-seconds", "1", "--seed", "3"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Ran processed = batch({"process", take, "--between", "on", "--run-name", "joined"});
    ASSERT_EQ(processed.exit_code, 0) << processed.err;
    const Ran judged = batch({"evaluate", take, "--run", "joined", "--json"});
    ASSERT_EQ(judged.exit_code, 0) << judged.err;
    const auto between = judged.json()["between"];
    ASSERT_FALSE(between.empty());
    for (const auto& pair : between) {
        EXPECT_LT(pair["rms_mm"].get<double>(), 25) << pair.dump();
        EXPECT_LT(pair["heading_deg"].get<double>(), 1.5) << pair.dump();
    }
}

TEST(CastProgram, PointsComeFromTheSoundOfTwo) {
    SKIP_WITHOUT_MOTION();
    const CastOfTwo two(R"(,"room":")" + kAnchors + "\"");
    const std::string take = two.file("sound_002.noctule"), table = two.file("points.csv");
    const Ran made = batch({"simulate", "--cast", two.cast(), "--out", take, "--level", "signal",
                            "--duration", "2", "--rest-seconds", "1", "--seed", "4"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Ran tracked = batch({"process", take, "--estimator", "comocap", "--points", table, "--json"});
    ASSERT_EQ(tracked.exit_code, 0) << tracked.err;
    const auto ranges = tracked.json()["ranges"];
    for (const std::string kind : {"room", "own", "between"})
        EXPECT_GT(ranges[kind], 1000) << ranges;
    const Ran compared = batch({"evaluate", take, "--points", table, "--json"});
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    const auto found = compared.json()["tables"][0];
    EXPECT_LT(found["rms_mm"], 15);
    EXPECT_LT(found["between_rms_mm"], 20);
}

TEST(CastProgram, AMistakeLeavesNoTake) {
    SKIP_WITHOUT_MOTION();
    const CastOfTwo two;
    const std::string take = two.file("t.noctule");
    const auto refused = [&](int exit_code, const std::vector<std::string>& named,
                             const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"simulate", "--cast", two.cast(), "--out", take};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectRefusal(arguments, exit_code, named);
        EXPECT_FALSE(std::filesystem::exists(take));
    };
    refused(2, {"--suit", "--cast"}, {"--suit", kAnchors});
    two.write(R"({"subjects":[{"motion":"nowhere.bvh"}]})");
    refused(3, {"subject A", "nowhere.bvh"});
    two.write(R"({"subjects":[{"motion":")" + kMotion + R"(","carrier_hz":40000},{"motion":")" + kMotion +
              R"(","carrier_hz":40000}]})");
    refused(2, {"subject A", "subject B", "40 kHz", "carrier_hz"});
    two.write(R"({"subjects":[{"motion":")" + kMotion + R"(","motion_scale":1e9}]})");
    refused(3, {"subject A", "motion_scale"});
    two.write(R"({"subjects":[{"motion":")" + kMotion + R"(","motion_skip":100000}]})");
    refused(4, {"subject A", "motion_skip"});
    two.write(R"({"subjects":[{"motion":")" + kMotion + R"("}],"room":"nowhere.json"})");
    refused(3, {"room", "nowhere.json"});
    two.write("{");
    refused(3, {"cast.json", "JSON"});
    two.write(std::string(100000, '['));
    refused(3, {"cast.json", "JSON"});
}

}  // namespace
}  // namespace noctule::test
