// SPDX-License-Identifier: Apache-2.0
// Inputs that are damaged, foreign or do not fit: the documented exit code, a message that names the thing,
// and nothing written or changed.
#include "core/recording/take.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

/// Every verb that reads takes refuses this file and leaves it as it was.
void expectEveryVerbRefuses(const Folder& folder, const std::string& take, int exit_code,
                            const std::vector<std::string>& named) {
    const std::string before = readBytes(take);
    const auto names = folder.names();
    expectRefusal({"process", take}, exit_code, named);
    expectRefusal({"evaluate", take}, exit_code, named);
    expectRefusal({"export", take, "--bvh", folder.file("x.bvh")}, exit_code, named);
    expectRefusal({"inspect", take}, exit_code, named);
    EXPECT_EQ(readBytes(take), before);
    EXPECT_EQ(folder.names(), names);
}

TEST(BadInput, TakesThatAreNone) {
    Folder folder;
    expectRefusal({"inspect", folder.file("none.noctule")}, 3, {"none.noctule"});
    writeBytes(folder.file("text.noctule"),
               "this is no database, but long enough to hold a header, one thinks");
    expectEveryVerbRefuses(folder, folder.file("text.noctule"), 3, {"text.noctule"});
    writeBytes(folder.file("empty.noctule"), "");
    expectEveryVerbRefuses(folder, folder.file("empty.noctule"), 3, {"empty.noctule", "is empty"});
    std::filesystem::create_directory(folder.file("folder.noctule"));
    for (const char* verb : {"process", "evaluate", "inspect"})
        expectRefusal({verb, folder.file("folder.noctule")}, 3, {"folder.noctule", "is a folder"});
    expectRefusal({"process", tinyTake(folder), "--subjects", "Z"}, 2, {"'Z'", "one performer"});
    runSql(folder.file("other.noctule"), "CREATE TABLE t(x)");
    expectEveryVerbRefuses(folder, folder.file("other.noctule"), 3, {"other.noctule", "another kind"});
}

TEST(BadInput, TruncatedTake) {
    Folder folder;
    const std::string take = folder.file("cut.noctule");
    writeBytes(take, readBytes(kTinyTake).substr(0, 50000));
    expectEveryVerbRefuses(folder, take, 3, {"cut.noctule"});
}

/// Whatever an option reads: a motion, a body, a calibration, the take itself.
TEST(BadInput, NoInputIsOverwritten) {
    Folder folder;
    const std::string take = folder.file("t.noctule"), motion = folder.file("m.bvh"),
                      body = folder.file("b.glb"), other = folder.file("c.json");
    writeBytes(take, readBytes(kTinyTake));
    ASSERT_EQ(batch({"process", take, "--root", "given"}).exit_code, 0);
    for (const std::string& path : {motion, body})
        writeBytes(path, "mine");
    const std::string before = readBytes(take);
    const std::string calibration = toJson(Take::open(take)->calibrationInForce()->value).dump();
    writeBytes(other, calibration);
    const std::vector<std::vector<std::string>> losing = {
        {"evaluate", take, "--report", take},
        {"evaluate", take, "--csv", take},
        {"evaluate", take, "--reference", motion, "--csv", motion},
        {"simulate", "--motion", motion, "--out", motion},
        {"simulate", "--rig", "rest", "--suit", other, "--out", folder.file("x.noctule"), "--truth-out",
         other},
        {"export", take, "--mesh", body, "--glb", body},
        {"orient", take, "--calibration", other, "--csv", other},
        {"check", take, "--calibration", other, "--report", other},
        {"calibrate", "sources", take, "--digitizer", other, "--out", other}};
    for (std::vector<std::string> words : losing) {
        words.emplace_back("--overwrite");
        expectRefusal(words, 2, {"is read and would be written"});
    }
    for (const std::string& path : {motion, body})
        EXPECT_EQ(readBytes(path), "mine") << path;
    EXPECT_EQ(readBytes(other), calibration);
    EXPECT_EQ(readBytes(take), before);
}

TEST(BadInput, TakeOfAnotherVersion) {
    Folder folder;
    const std::string take = folder.file("later.noctule");
    writeBytes(take, readBytes(kTinyTake));
    runSql(take, "PRAGMA user_version = 2000");
    expectEveryVerbRefuses(folder, take, 3, {"later.noctule", "version 2", "newer Noctule"});
}

/// Tables keep their columns, whatever a take calls its boards.
TEST(BadInput, NamesOfThousandsOfLettersAreShownShort) {
    Folder folder;
    const std::string take = folder.file("long.noctule"), name(5000, 'n');
    writeBytes(take, readBytes(kTinyTake));
    for (const char* table : {"suit", "calibration"})
        runSql(take, std::string("UPDATE ") + table + " SET json=json_set(json,'$.boards[0].id','" + name +
                         "','$.sources[0].id','" + name + "')");
    runSql(take, "INSERT INTO marker(sample,kind,label) VALUES(1,'user','" + name + "')");
    ASSERT_EQ(batch({"process", take, "--root", "given"}).exit_code, 0);
    const Ran seen = batch({"inspect", take});
    EXPECT_EQ(seen.exit_code, 0) << seen.err;
    std::istringstream lines(seen.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LT(line.size(), 300U) << line;
    EXPECT_NE(seen.out.find("nnn…"), std::string::npos) << "what is cut shows it";
}

TEST(BadInput, TakeThatLacksParts) {
    Folder folder;
    const std::string take = folder.file("half.noctule");
    const auto withSql = [&](const std::string& sql) {
        writeBytes(take, readBytes(kTinyTake));
        runSql(take, sql);
    };
    withSql("DELETE FROM suit");
    expectRefusal({"process", take}, 4, {"half.noctule", "suit"});
    EXPECT_EQ(batch({"inspect", take}).exit_code, 0);

    withSql("DELETE FROM meta WHERE key = 'sample_rate_hz'");
    expectRefusal({"process", take}, 4, {"half.noctule", "sample_rate_hz"});

    withSql("UPDATE meta SET value = '7' WHERE key = 'board_count'");
    expectRefusal({"process", take}, 4, {"half.noctule", "7 boards", "2"});

    withSql("DELETE FROM adc_block");
    const std::string before = readBytes(take);
    expectRefusal({"process", take}, 4, {"half.noctule"});
    EXPECT_EQ(readBytes(take), before);
    EXPECT_NE(batch({"inspect", take}).out.find("adc_block"), std::string::npos);

    withSql("DELETE FROM external_root");
    expectRefusal({"process", take, "--root", "given"}, 4, {"external_root", "--root free"});
    expectRefusal({"evaluate", take}, 4, {"half.noctule", "process"});
}

/// What it needs, what this one is, and what gives a motion of it.
TEST(BadInput, OrientSaysWhichTakeItNeeds) {
    Folder folder;
    const std::string take = folder.file("box.noctule");
    writeBytes(take, readBytes(kTinyTake));
    expectRefusal({"orient", take}, 4,
                  {"holds the sound of a driver box", "needs a take of inertial sensors",
                   "noctule --batch process " + take});
}

TEST(BadInput, CalibrationOfAnotherSuit) {
    Folder folder;
    const std::string take = folder.file("t.noctule"), calibration = folder.file("c.json");
    writeBytes(take, readBytes(kTinyTake));
    writeBytes(calibration,
               R"({"format":"noctule-calibration","version":1,"created_utc":"2026-01-01T00:00:00Z",
                   "sound":{"model":"cramer"},"sources":[],
                   "boards":[{"id":"l_wing","gyro":{"zero_counts":[2048,2048,2048],
                              "matrix":[[1,0,0],[0,1,0],[0,0,1]]},
                              "accel":{"zero_counts":[2048,2048,2048],"matrix":[[1,0,0],[0,1,0],[0,0,1]]}}]})");
    const std::string before = readBytes(take);
    expectRefusal({"process", take, "--calibration", calibration}, 4,
                  {"t.noctule", "calibration", "knows none"});
    EXPECT_EQ(readBytes(take), before);
    writeBytes(calibration, "{");
    expectRefusal({"process", take, "--calibration", calibration}, 3, {"c.json"});
    expectRefusal({"process", take, "--actor", calibration}, 3, {"c.json"});
    expectRefusal({"process", take, "--calibration", folder.file("no.json")}, 3, {"no.json"});
    EXPECT_EQ(readBytes(take), before);
}

TEST(BadInput, MotionsThatAreNone) {
    Folder folder;
    const std::string motion = folder.file("m.bvh"), out = folder.file("t.noctule");
    expectRefusal({"simulate", "--motion", motion, "--out", out}, 3, {"m.bvh"});
    writeBytes(motion, "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0");
    expectRefusal({"simulate", "--motion", motion, "--out", out}, 3, {"m.bvh", "line"});
    SKIP_WITHOUT_MOTION();
    std::string text = readBytes(kMotion);
    const size_t row = text.find('\n', text.find("Frame Time")) + 1;
    text.replace(row, text.find(' ', row) - row, "nan");
    writeBytes(motion, text);
    expectRefusal({"simulate", "--motion", motion, "--out", out}, 3, {"m.bvh", "nan"});
    EXPECT_EQ(folder.names(), std::vector<std::string>{"m.bvh"});
}

TEST(BadInput, SuitWithAnUnknownSegment) {
    Folder folder;
    nlohmann::json suit =
        nlohmann::json::parse(readBytes(NOCTULE_SOURCE_DIR "/resources/suits/default.json"));
    suit["boards"][3]["segment"] = "Tail";
    writeBytes(folder.file("s.json"), suit.dump());
    expectRefusal({"simulate", "--rig", "rest", "--duration", "2", "--suit", folder.file("s.json"), "--out",
                   folder.file("t.noctule")},
                  4, {"s.json", "Tail", suit["boards"][3]["id"]});
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.json"});
}

TEST(BadInput, OutputsInTheWayStayAsTheyWere) {
    Folder folder;
    const std::string there = folder.file("there"), take = folder.file("t.noctule");
    writeBytes(there, "precious");
    writeBytes(take, readBytes(kTinyTake));
    ASSERT_EQ(batch({"process", take, "--quiet"}).exit_code, 0);
    expectRefusal({"simulate", "--rig", "rest", "--duration", "1", "--out", there}, 2,
                  {"there", "--overwrite"});
    expectRefusal({"evaluate", take, "--report", there}, 2, {"there", "--overwrite"});
    expectRefusal({"export", take, "--csv", there}, 2, {"there", "--overwrite"});
    expectRefusal({"process", take, "--out-dir", std::filesystem::path(take).parent_path()}, 2,
                  {"t.noctule"});
    EXPECT_EQ(readBytes(there), "precious");
    EXPECT_EQ(batch({"export", take, "--csv", there, "--overwrite"}).exit_code, 0);
    EXPECT_EQ(readBytes(there).substr(0, 7), "time_s,");
}

TEST(BadInput, FoldersThatCannotBeWritten) {
    Folder folder;
    const std::string take = folder.file("t.noctule");
    writeBytes(take, readBytes(kTinyTake));
    ASSERT_EQ(batch({"process", take, "--quiet"}).exit_code, 0);
    expectRefusal({"simulate", "--rig", "rest", "--out", folder.file("no/t.noctule")}, 6, {"no/t.noctule"});
    expectRefusal({"export", take, "--bvh", folder.file("no/t.bvh")}, 6, {"no/t.bvh"});
    expectRefusal({"evaluate", take, "--report", folder.file("no/t.html")}, 6, {"no/t.html"});
    expectRefusal({"process", take, "--out-dir", folder.file("no")}, 6, {"no/t.noctule"});
}

TEST(BadInput, OneBadTakeDoesNotStopTheOthers) {
    Folder folder;
    const std::string take = folder.file("t.noctule");
    writeBytes(take, readBytes(kTinyTake));
    const Ran ran = batch({"process", folder.file("none.noctule"), take, "--json", "--quiet"});
    EXPECT_EQ(ran.exit_code, 3);
    const auto takes = ran.json()["takes"];
    ASSERT_EQ(takes.size(), 2u);
    EXPECT_EQ(takes[0]["error"]["exit_code"], 3);
    EXPECT_EQ(takes[1]["run"], "AGD");
}

}  // namespace
}  // namespace noctule::test
