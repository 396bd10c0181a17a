// SPDX-License-Identifier: Apache-2.0
// simulate, process, evaluate, export, attach, inspect: one after the other, and the numbers that come out.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

#include "core/formats/bvh.h"
#include "core/formats/opensim.h"
#include "core/formats/positions_csv.h"
#include "core/formats/scene_reader.h"
#include "core/job/atomic_file.h"
#include "core/media/picture_file.h"
#include "core/media/video_file.h"
#include "tests/support/glb_body.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

nlohmann::json jsonOf(std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const Ran ran = batch(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.json();
}

/// One take, made once, processed with the root given and free.
class RoundTrip : public testing::Test {
protected:
    static void SetUpTestSuite() {
        if (!std::filesystem::exists(kMotion))
            return;
        folder_ = new Folder;
        makeTake(take());
        for (const char* root : {"free", "given"})
            ASSERT_EQ(batch({"process", take(), "--root", root, "--run-name", root}).exit_code, 0);
    }
    static void TearDownTestSuite() {
        delete folder_;
        folder_ = nullptr;
    }
    void SetUp() override { SKIP_WITHOUT_MOTION(); }

    static std::string file(const std::string& name) { return folder_->file(name); }
    static std::string take() { return file("hops_001.noctule"); }
    static std::string copyOfTake(const std::string& name) {
        std::filesystem::copy_file(take(), file(name));
        return file(name);
    }

private:
    static inline Folder* folder_ = nullptr;
};

TEST_F(RoundTrip, EvaluateTellsSmallErrors) {
    const auto json = jsonOf({"evaluate", take(), "--run", "given"});
    EXPECT_EQ(json["take"], "hops_001");
    EXPECT_EQ(json["run"], "given");
    EXPECT_EQ(json["sensors"], "AGD");
    EXPECT_GT(json["mean_deg"], 0.001);
    EXPECT_LT(json["mean_deg"], 1.0);
    EXPECT_LT(json["end_effector_mm"], 20);
    EXPECT_LT(json["root"]["position_m"], 0.01);
    EXPECT_GT(json["nees"], 0);
    EXPECT_NEAR(json["duration_s"], 4, 0.1);
    ASSERT_GE(json["joints"].size(), 15u);
    double sum = 0;
    for (const auto& joint : json["joints"]) {
        EXPECT_NEAR(std::hypot(joint["mean_deg"].get<double>(), joint["std_deg"].get<double>()),
                    joint["rms_deg"], 1e-3);
        sum += joint["mean_deg"].get<double>();
    }
    EXPECT_NEAR(sum / static_cast<double>(json["joints"].size()), json["mean_deg"], 1e-9);
    EXPECT_GT(json["ranges"]["used"], 100);
    EXPECT_GT(json["ranges"]["occluded"], 100);
    EXPECT_EQ(json["boards"].size(), 18u);
    for (const auto& board : json["boards"])
        EXPECT_GE(board["readings_present"], 0.98 * board["readings_expected"].get<double>()) << board;
}

TEST_F(RoundTrip, EvaluateForPeopleAndAsAReport) {
    const Ran ran = batch({"evaluate", take(), "--report", file("r.html")});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    for (const char* word : {"joint", "mean deg", "RightArm", "\nmean ", "r.html"})
        EXPECT_NE(ran.out.find(word), std::string::npos) << word;
    const std::string html = readBytes(file("r.html"));
    EXPECT_EQ(html.substr(0, 15), "<!DOCTYPE html>");
    for (const char* word : {"free", "given", "Right shoulder"})
        EXPECT_NE(html.find(word), std::string::npos) << word;
    EXPECT_TRUE(batch({"evaluate", take(), "--quiet"}).out.empty());
}

TEST_F(RoundTrip, TheTableOfJointsSaysWhatTheJsonSays) {
    const auto json = jsonOf({"evaluate", take(), "--run", "given", "--csv", file("joints.csv")});
    EXPECT_EQ(json["csv"], file("joints.csv"));
    const auto cells = [](const std::string& line) {
        std::vector<std::string> all(1);
        for (const char c : line)
            c == ',' ? static_cast<void>(all.emplace_back()) : all.back().push_back(c);
        return all;
    };
    std::istringstream csv(readBytes(file("joints.csv")));
    std::string line;
    std::getline(csv, line);
    const std::vector<std::string> header = cells(line);
    std::map<std::string, int> rows_of_run;
    std::map<std::string, std::map<std::string, std::string>> given;  // by joint, then column
    while (std::getline(csv, line)) {
        const std::vector<std::string> row = cells(line);
        ASSERT_EQ(row.size(), header.size()) << line;
        std::map<std::string, std::string> named;
        for (size_t i = 0; i < row.size(); ++i)
            named[header[i]] = row[i];
        EXPECT_EQ(named["take"], "hops_001");
        ++rows_of_run[named["run"]];
        if (named["run"] == "given")
            given[named["joint"]] = named;
    }
    const auto joints = static_cast<int>(json["joints"].size());
    EXPECT_EQ(rows_of_run, (std::map<std::string, int>{{"free", joints}, {"given", joints}}));
    for (const auto& joint : json["joints"])
        for (const char* column : {"mean_deg", "median_deg", "std_deg", "rms_deg", "p95_deg", "max_deg",
                                   "drift_deg_per_min", "position_mm", "nees"}) {
            const std::string& cell = given[joint["name"]][column];
            EXPECT_EQ(cell, joint[column].is_null() ? "" : joint[column].dump()) << joint["name"] << column;
        }
    expectRefusal({"evaluate", take(), "--csv", file("joints.csv")}, 2, {"joints.csv", "--overwrite"});
}

/// The command as a shell takes it, with the name of another result put last.
TEST_F(RoundTrip, TheReportsCommandMakesTheSamePoses) {
    const std::string copy = copyOfTake("made_again.noctule");
    ASSERT_EQ(batch({"evaluate", copy, "--run", "given", "--report", file("command.html")}).exit_code, 0);
    const std::string html = readBytes(file("command.html")), label = "Made again by</dt><dd>";
    std::vector<std::string> commands;
    for (size_t at = html.find(label); at != std::string::npos; at = html.find(label, at + 1))
        commands.push_back(html.substr(at + label.size(), html.find("</dd>", at) - at - label.size()));
    const auto found = std::ranges::find_if(
        commands, [](const auto& one) { return one.find("--run-name given") != std::string::npos; });
    ASSERT_NE(found, commands.end()) << commands.size() << " commands";
    ASSERT_EQ(found->rfind("noctule --batch process made_again.noctule ", 0), 0U) << *found;
    EXPECT_EQ(found->find_first_of("'&\"\\"), std::string::npos) << "words need no shell: " << *found;
    std::istringstream text(found->substr(found->find("process")));
    std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
    words[1] = copy;  // the report names it without its folder
    words.back() = "again";
    ASSERT_EQ(batch(words).exit_code, 0) << *found;
    for (const std::string run : {"given", "again"})
        ASSERT_EQ(
            batch({"export", copy, "--run", run, "--csv", file(run + "_poses.csv"), "--angles"}).exit_code,
            0);
    const std::string given = readBytes(file("given_poses.csv"));
    EXPECT_GT(given.size(), 10'000U);
    EXPECT_EQ(given, readBytes(file("again_poses.csv")));
}

TEST_F(RoundTrip, AWrongRunIsNamedWithTheOnesThereAre) {
    expectRefusal({"evaluate", take(), "--run", "nothing"}, 4, {"nothing", "free", "given"});
}

TEST_F(RoundTrip, ABodyOfAnotherProgramMovesInFilesPicturesAndFilms) {
    jsonOf({"export", take(), "--glb", file("figure.glb"), "--from", "1", "--to", "1.1"});
    std::vector<std::string> words{"export", take(), "--mesh", file("figure.glb"), "--fbx", file("worn.fbx")};
    words.insert(words.end(), {"--png", file("worn.png"), "--video", file("worn.mkv")});
    for (const char* word : {"--from", "1", "--to", "2", "--fps", "10", "--size", "320x180", "--camera",
                             "turn", "--blending", "dual"})
        words.push_back(word);
    const nlohmann::json json = jsonOf(words).at("takes").at(0);
    EXPECT_EQ(json.at("bones").at("LeftForeArm"), "LeftForeArm");
    EXPECT_EQ(json.at("film").at("frames"), 11);
    EXPECT_EQ(json.at("files").size(), 3U);
    const auto film = readVideo(file("worn.mkv"));
    ASSERT_TRUE(film) << film.error().text();
    EXPECT_EQ(film->frames, 11U);
    EXPECT_EQ(film->size.width_px, 320);
    const auto picture = readPicture(file("worn.png"));
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->height_px, 180);
    writeBytes(file("bones.json"),
               R"({"format": "noctule-bone-map", "version": 1, "bones": {"Hips": "Hips"}})");
    expectRefusal({"export", take(), "--mesh", file("figure.glb"), "--bones", file("bones.json"), "--glb",
                   file("no.glb")},
                  4, {"figure.glb", "LeftArm", "map of bones"});
    writeBytes(file("box.obj"), "v 0 0 0\nv 1 0 0\nv 0 1.7 0\nf 1 2 3\n");
    expectRefusal({"export", take(), "--mesh", file("box.obj"), "--glb", file("no.glb")}, 4, {"box.obj"});
}

/// Files carry a texture as it is; only who draws it has to decode it.
TEST_F(RoundTrip, TexturesThatAreNotDrawnAreSaidWithPicturesAlone) {
    GlbBody body;
    const std::string torn = "\x89PNG\r\n\x1a\nand no more";
    body.json["images"] = {{{"bufferView", body.view(std::vector<uint8_t>(torn.begin(), torn.end()))},
                            {"mimeType", "image/png"}}};
    body.json["textures"] = {{{"source", 0}}};
    body.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    body.primitive()["material"] = 0;
    const size_t vertices =
        body.json["accessors"][body.primitive()["attributes"]["POSITION"].get<size_t>()]["count"];
    body.primitive()["attributes"]["TEXCOORD_0"] =
        body.accessor(std::vector<float>(2 * vertices, 0.5F), "VEC2");
    writeBytes(file("torn.glb"), body.glb());
    const auto exported = [&](const std::string& option, const std::string& to) {
        return batch(
            {"export", take(), "--mesh", file("torn.glb"), option, file(to), "--from", "1", "--to", "1.1"});
    };
    const Ran file_alone = exported("--glb", "as_it_is.glb"), picture = exported("--png", "drawn.png");
    EXPECT_EQ(file_alone.exit_code, 0) << file_alone.err;
    EXPECT_EQ(file_alone.err.find("drawn"), std::string::npos) << file_alone.err;
    EXPECT_NE(picture.err.find("1 texture of 1 cannot be decoded"), std::string::npos) << picture.err;
}

TEST_F(RoundTrip, ExportedFilesSayTheSame) {
    const auto json = jsonOf({"export", take(), "--run", "given", "--bvh", file("{name}.bvh"), "--csv",
                              file("{name}.csv"), "--angles", "--fps", "60", "--from", "1", "--to", "3"});
    EXPECT_EQ(json["takes"][0]["frames"], 121);
    const auto document = readBvh(file("hops_001.bvh"));
    ASSERT_TRUE(document) << document.error().text();
    EXPECT_EQ(document->frameCount(), 121u);
    EXPECT_NEAR(document->frame_time_s, 1 / 60.0, 1e-9);
    const auto clip = toClip(*document, BvhUnit::kCentimetre);
    ASSERT_TRUE(clip);
    const auto table = readPositionsCsv(file("hops_001.csv"));
    ASSERT_TRUE(table) << table.error().text();
    ASSERT_EQ(table->time_s.size(), 121u);
    ASSERT_EQ(table->joints.size(), 21u);
    for (size_t frame : {0u, 60u, 120u}) {
        const GlobalPose pose = globalPose(*clip, frame);
        for (size_t j = 0; j < table->joints.size(); ++j) {
            const int joint = clip->skeleton.find(table->joints[j]);
            ASSERT_GE(joint, 0);
            EXPECT_LT((table->at(frame, j) - pose.p_world_joint[static_cast<size_t>(joint)]).norm(), 1e-5);
        }
    }
    EXPECT_NE(readBytes(file("hops_001.csv")).find("LeftForeArm."), std::string::npos);
}

TEST_F(RoundTrip, PresetsAndRootMotion) {
    ASSERT_EQ(batch({"export", take(), "--bvh", file("m.bvh"), "--preset", "blender", "--root", "heading"})
                  .exit_code,
              0);
    const auto document = readBvh(file("m.bvh"));
    ASSERT_TRUE(document);
    EXPECT_EQ(chooseUnit(*document).unit, BvhUnit::kMetre);
    const auto clip = toClip(*document, BvhUnit::kMetre);
    ASSERT_TRUE(clip);
    for (const Pose& pose : clip->frames) {
        EXPECT_NEAR(pose.p_world_root.x(), clip->frames[0].p_world_root.x(), 1e-6);
        EXPECT_NEAR(pose.p_world_root.z(), clip->frames[0].p_world_root.z(), 1e-6);
        const Vector3d forward = pose.q_parent_joint[0] * Vector3d::UnitZ();
        EXPECT_NEAR(std::atan2(forward.x(), forward.z()), 0, 1e-4);
    }
}

/// Two takes at once, every format that holds a skeleton, the names of another program; all against the
/// table.
TEST_F(RoundTrip, SeveralTakesGoOutInEveryFormat) {
    copyOfTake("again_002.noctule");
    const auto json = jsonOf({"export",
                              take(),
                              file("again_002.noctule"),
                              "--run",
                              "given",
                              "--from",
                              "1",
                              "--to",
                              "2",
                              "--preset",
                              "unreal",
                              "--fbx",
                              file("{name}.fbx"),
                              "--glb",
                              file("{name}.glb"),
                              "--mot",
                              file("{name}.mot"),
                              "--sto",
                              file("{name}.sto"),
                              "--csv",
                              file("{name}_all.csv"),
                              "--mesh",
                              "none"});
    for (const auto& one : json["takes"]) {
        EXPECT_EQ(one["frames"], 61) << "the preset's rate";
        EXPECT_EQ(one["files"].size(), 5U);
    }
    for (const std::string name : {"hops_001", "again_002"}) {
        const auto table = readPositionsCsv(file(name + "_all.csv"));
        ASSERT_TRUE(table);
        std::vector<std::string> joints = table->joints;
        std::replace(joints.begin(), joints.end(), std::string("Chest"), std::string("Spine2"));
        for (const SceneFormat format : {SceneFormat::kFbx, SceneFormat::kGlb}) {
            const std::string path = file(name + (format == SceneFormat::kFbx ? ".fbx" : ".glb"));
            const auto opened = SceneFile::open(path, path, format);
            ASSERT_TRUE(opened) << opened.error().text();
            const auto scene = opened->read(joints);
            ASSERT_TRUE(scene) << scene.error().text();
            EXPECT_EQ(scene->clip.name, "hops_001") << "the take's own name, whatever its file is called";
            ASSERT_EQ(scene->clip.frames.size(), 61U);
            for (const size_t frame : {0U, 30U, 60U})
                for (size_t j = 0; j < joints.size(); ++j)
                    EXPECT_LT((globalPose(scene->clip, frame).p_world_joint[j] - table->at(frame, j)).norm(),
                              1e-5);
        }
        const auto angles = parseOpenSimTable(*readWholeFile(file(name + ".mot")), name);
        ASSERT_TRUE(angles);
        EXPECT_EQ(angles->rows(), 61U);
        EXPECT_NEAR(angles->values[1], table->at(0, 0).z(), 1e-5) << "pelvis_tx is forward";
    }
}

TEST_F(RoundTrip, SeveralTakesGoIntoOneFileAsStacks) {
    copyOfTake("other_003.noctule");
    const std::vector<std::string> part{"--run", "given", "--from", "1", "--to", "2", "--fps", "60"};
    std::vector<std::string> stacks{"export", take(),          file("other_003.noctule"),
                                    "--fbx",  file("all.fbx"), "--stacks"};
    stacks.insert(stacks.end(), part.begin(), part.end());
    const auto json = jsonOf(stacks);
    EXPECT_EQ(json["stacks"], 2);
    EXPECT_EQ(json["frames"], 122);
    std::vector<std::string> positions{"export", take(), "--csv", file("stacks.csv")};
    positions.insert(positions.end(), part.begin(), part.end());
    jsonOf(positions);
    const auto table = readPositionsCsv(file("stacks.csv"));
    const auto scene = SceneFile::open(file("all.fbx"), "all.fbx", SceneFormat::kFbx);
    ASSERT_TRUE(table && scene);
    for (const char* name : {"hops_001", "other_003"}) {
        const auto motion = scene->read(table->joints, name);
        ASSERT_TRUE(motion) << motion.error().text();
        ASSERT_EQ(motion->clip.frames.size(), 61U);
        for (const size_t frame : {0U, 30U, 60U})
            for (size_t j = 0; j < table->joints.size(); ++j)
                EXPECT_LT((globalPose(motion->clip, frame).p_world_joint[j] - table->at(frame, j)).norm(),
                          1e-5);
    }
}

TEST_F(RoundTrip, ProcessIntoAnotherFolderLeavesTheTakeAlone) {
    const std::string before = readBytes(take());
    std::filesystem::create_directory(file("results"));
    const auto json = jsonOf({"process", take(), "--out-dir", file("results"), "--sensors", "gA",
                              "--estimator", "paper", "--paper-sigma", "3", "--root", "given"});
    EXPECT_EQ(json["takes"][0]["run"], "AG paper");
    EXPECT_EQ(json["takes"][0]["take"], file("results") + "/hops_001.noctule");
    EXPECT_EQ(readBytes(take()), before);
    const auto evaluation = jsonOf({"evaluate", file("results/hops_001.noctule")});
    EXPECT_EQ(evaluation["sensors"], "AG");
    EXPECT_EQ(evaluation["estimator"], "paper");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file("results")), {}), 1);
}

TEST_F(RoundTrip, AttachedMotionIsFoundInTime) {
    ASSERT_EQ(
        batch({"export", take(), "--run", "given", "--bvh", file("optical.bvh"), "--from", "1.25"}).exit_code,
        0);
    const std::string copy = copyOfTake("attached.noctule");
    expectRefusal({"attach", copy, "--reference", file("optical.bvh")}, 2,
                  {"attached.noctule", "--overwrite"});
    const auto json = jsonOf({"attach", copy, "--reference", file("optical.bvh"), "--overwrite"});
    EXPECT_NEAR(json["shift_ms"], 1250, 2);
    EXPECT_GT(json["correlation"], 0.99);
    const auto evaluation = jsonOf({"evaluate", copy, "--run", "given"});
    EXPECT_EQ(evaluation["reference_kind"], "optical");
    EXPECT_LT(evaluation["mean_deg"], 0.1);
    const auto against_file =
        jsonOf({"evaluate", take(), "--run", "given", "--reference", file("optical.bvh")});
    EXPECT_NEAR(against_file["reference_offset_s"], 1.25, 0.002);
    EXPECT_LT(against_file["mean_deg"], 0.1);
}

TEST_F(RoundTrip, PositionsServeAsTheRoot) {
    ASSERT_EQ(batch({"export", take(), "--run", "given", "--csv", file("points.csv")}).exit_code, 0);
    const std::string copy = copyOfTake("points.noctule");
    expectRefusal({"attach", copy, "--reference", file("points.csv"), "--overwrite"}, 4,
                  {"points.csv", "external-root"});
    expectRefusal({"attach", copy, "--reference", file("points.csv"), "--as", "external-root", "--overwrite"},
                  2, {"points.csv", "--align"});
    jsonOf({"attach", copy, "--reference", file("points.csv"), "--as", "external-root", "--overwrite",
            "--align", "0"});
    jsonOf({"process", copy, "--root", "given", "--run-name", "points"});
    const auto json = jsonOf({"evaluate", copy, "--run", "points"});
    EXPECT_LT(json["mean_deg"], 1.0);
    EXPECT_LT(json["root"]["position_m"], 0.02);
}

TEST_F(RoundTrip, InspectShowsWhatIsThere) {
    const auto json = jsonOf({"inspect", take()})["takes"][0];
    EXPECT_EQ(json["name"], "hops_001");
    EXPECT_EQ(json["level"], "readings");
    EXPECT_EQ(json["boards"].size(), 18u);
    EXPECT_EQ(json["quality"]["pairs"].size(), 144u);
    EXPECT_EQ(json["quality"]["inertia"].size(), 18u);
    EXPECT_NEAR(json["duration_s"], 5, 0.01);
    EXPECT_TRUE(json["missing"].empty()) << json["missing"];
    EXPECT_TRUE(json["problems"].empty()) << json["problems"];
    EXPECT_EQ(json["runs"].size(), 4u);
}

TEST(Process, ACopyHoldsWhatTheWriteAheadLogHolds) {
    Folder folder;
    const std::string take = folder.file("t.noctule");
    writeBytes(take, readBytes(kTinyTake));
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(take.c_str(), &handle), SQLITE_OK);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    ASSERT_EQ(sqlite3_exec(
                  handle, "PRAGMA journal_mode = WAL; INSERT INTO note(created_utc, text) VALUES('', 'late')",
                  nullptr, nullptr, nullptr),
              SQLITE_OK);
    sqlite3_close(handle);
    const std::string before = readBytes(take), log_before = readBytes(take + "-wal");
    ASSERT_FALSE(log_before.empty());
    std::filesystem::create_directory(folder.file("o"));
    jsonOf({"process", take, "--out-dir", folder.file("o")});
    EXPECT_EQ(readBytes(take), before);
    EXPECT_EQ(readBytes(take + "-wal"), log_before);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.file("o")), {}), 1);
    const auto notes = jsonOf({"inspect", folder.file("o/t.noctule")})["takes"][0]["notes"];
    EXPECT_EQ(notes.back()["text"], "late");
}

TEST(Simulate, WritesWhatALaboratoryKnowsAndTheTruth) {
    Folder folder;
    const auto json = jsonOf({"simulate", "--rig", "rest", "--duration", "1.5", "--level", "readings",
                              "--seed", "7", "--out", folder.file("still.noctule"), "--calibration-out",
                              folder.file("c.json"), "--truth-out", folder.file("f.json")});
    EXPECT_EQ(json["seed"], 7);
    EXPECT_NEAR(json["duration_s"], 1.5, 1e-6);
    EXPECT_EQ(nlohmann::json::parse(readBytes(folder.file("c.json")))["format"], "noctule-calibration");
    EXPECT_FALSE(nlohmann::json::parse(readBytes(folder.file("f.json"))).empty());
    jsonOf({"process", folder.file("still.noctule"), "--calibration", folder.file("c.json")});
}

TEST(TinyTake, IsReadProcessedAndEvaluated) {
    Folder folder;
    const std::string take = folder.file("tiny.noctule");
    writeBytes(take, readBytes(kTinyTake));
    EXPECT_EQ(jsonOf({"inspect", take})["takes"][0]["boards"].size(), 2u);
    const auto processed = jsonOf({"process", take, "--root", "given"})["takes"][0];
    EXPECT_EQ(processed["frames"]["lost"], 0);
    EXPECT_GT(processed["ranges"]["heard"], 400);
    EXPECT_TRUE(jsonOf({"evaluate", take})["mean_deg"].is_number());
}

}  // namespace
}  // namespace noctule::test
