// SPDX-License-Identifier: Apache-2.0
// session.json: made, read, written, damaged, newer, rebuilt.
#include "core/session/session.h"

#include <fstream>

#include "core/session/session_json.h"
#include "tests/core/session/session_folder.h"

namespace noctule::test {
namespace {

namespace fs = std::filesystem;

class SessionFile : public SessionFolder {
protected:
    void write(const std::string& content) {
        std::ofstream(folder() / "session.json", std::ios::trunc) << content;
    }
};

TEST_F(SessionFile, NewSessionHasItsFoldersAndOnePerformer) {
    const Session session = newSession();
    for (const char* part : {"calibration", "takes", "video", "exports"})
        EXPECT_TRUE(fs::is_directory(folder() / part)) << part;
    ASSERT_EQ(session.performers.size(), 1u);
    EXPECT_EQ(session.performers[0].suit.boards.size(), 18u);
    EXPECT_EQ(session.current_performer, session.performers[0].name);
    const Session again = opened();
    EXPECT_EQ(again.name, "Stage tests");
    EXPECT_EQ(again.created_utc, kCreated);
    EXPECT_EQ(toJson(again), toJson(session));
}

TEST_F(SessionFile, NewSessionTakesAnEmptyFolderAndRefusesAFullOne) {
    fs::create_directory(folder());
    newSession();
    const auto second = createSession(folder(), "Other", kCreated);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(opened().name, "Stage tests");
}

TEST_F(SessionFile, NewSessionThatCannotBeMadeLeavesNothing) {
    std::ofstream(folder().string()) << "a file";
    EXPECT_FALSE(createSession(folder() / "inside", "x", kCreated));
    EXPECT_TRUE(fs::is_regular_file(folder()));
    if (mayWriteAnywhere())
        GTEST_SKIP() << "refused writing cannot be tried as the superuser";
    fs::permissions(home_, fs::perms::owner_read | fs::perms::owner_exec);
    const auto refused = createSession(home_ / "other", "x", kCreated);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kDisk);
}

TEST_F(SessionFile, EverythingTheOperatorSaidComesBack) {
    Session session = newSession();
    makeTake(takes() / "walk_001.noctule");
    session = opened();
    SessionTake& take = session.takes.at(0);
    take.rating = 4;
    take.notes = "Second turn is the good one.\n\"Quoted\", ümlaut";
    take.performer = "Performer 1";
    take.in_s = 0.25;
    take.out_s = 1.5;
    session.notes = "Tuesday";
    Performer tall = session.performers[0];
    tall.name = "Tall";
    tall.measures = {1.93, 0.31, 0, 0, 0.4, 0, 0.45, 0, 0, 0.5};
    tall.suit.boards[9].p_segment_board_m.x() += 0.0123;
    session.performers.push_back(tall);
    session.current_performer = "Tall";
    session.suit_calibrations["NB-000087"] = "rest-pose-2026-03-01.json";
    ASSERT_TRUE(saveSession(session));
    const Session again = opened();
    EXPECT_EQ(toJson(again), toJson(session));
    EXPECT_EQ(again.suit_calibrations, session.suit_calibrations);
    const BodyMeasures& measures = again.findPerformer("Tall")->measures;
    EXPECT_EQ(measures.upper_arm_m, 0.31);
    EXPECT_EQ(measures.forearm_m, 0);
    EXPECT_EQ(measures.trunk_m, 0.5);
    EXPECT_EQ(again.performers[1].suit.boards[9].p_segment_board_m, tall.suit.boards[9].p_segment_board_m);
}

TEST_F(SessionFile, UnknownMembersAreKept) {
    newSession();
    makeTake(takes() / "walk_001.noctule");
    Session session = opened();
    ASSERT_TRUE(saveSession(session));
    nlohmann::json json = nlohmann::json::parse(text(folder() / "session.json"));
    json["x_stage"] = {{"width_m", 4}};
    json["version"] = 1.5;
    json["performers"][0]["shoe_size"] = 43;
    json["takes"][0]["scene"] = "7b";
    write(json.dump());
    session = opened();
    session.name = "Renamed";
    session.takes[0].rating = 3;
    ASSERT_TRUE(saveSession(session));
    const nlohmann::json after = nlohmann::json::parse(text(folder() / "session.json"));
    json["name"] = "Renamed";
    json["takes"][0]["rating"] = 3;
    EXPECT_EQ(after, json);
}

TEST_F(SessionFile, CalibrationsOfSuitsAreNamesOfFilesInTheirFolder) {
    newSession();
    nlohmann::json json = nlohmann::json::parse(text(folder() / "session.json"));
    for (const nlohmann::json& wrong : {nlohmann::json::array(), nlohmann::json{{"NB-1", 3}},
                                        nlohmann::json{{"NB-1", "../elsewhere.json"}}}) {
        json["suit_calibrations"] = wrong;
        write(json.dump());
        const auto session = openSession(folder(), {});
        ASSERT_FALSE(session) << wrong;
        EXPECT_NE(session.error().message.find("suit_calibrations"), std::string::npos);
    }
}

TEST_F(SessionFile, CopiedAndMovedSessionIsTheSame) {
    newSession();
    makeTake(takes() / "walk_001.noctule");
    Session session = opened();
    session.takes[0].rating = 5;
    ASSERT_TRUE(saveSession(session));
    fs::copy(folder(), home_ / "copy", fs::copy_options::recursive);
    fs::rename(folder(), home_ / "moved");
    for (const char* name : {"copy", "moved"}) {
        const auto there = openSession(home_ / name, {});
        ASSERT_TRUE(there) << there.error().text();
        EXPECT_EQ(toJson(*there), toJson(session));
        EXPECT_TRUE(there->takes[0].problem.empty());
        EXPECT_TRUE(isThere(there->pathOf(there->takes[0])));
    }
}

TEST_F(SessionFile, NewerVersionIsRefused) {
    newSession();
    nlohmann::json json = nlohmann::json::parse(text(folder() / "session.json"));
    json["version"] = 2;
    write(json.dump());
    const auto session = openSession(folder(), {});
    ASSERT_FALSE(session);
    EXPECT_EQ(session.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(session.error().message.find("newer"), std::string::npos);
    EXPECT_FALSE(canRebuildSession(folder()));
}

TEST_F(SessionFile, DamagedFileSaysWhatIsSafe) {
    newSession();
    makeTake(takes() / "walk_001.noctule");
    makeTake(takes() / "walk_002.noctule");
    const std::string whole = text(folder() / "session.json");
    const std::string damages[] = {"",
                                   "{",
                                   whole.substr(0, whole.size() / 2),
                                   "[]",
                                   "{\"format\":\"other\"}",
                                   R"({"format":"noctule-session","version":1,"performers":[{"name":7}]})",
                                   R"({"format":"noctule-session","version":1,"takes":[{"file":"../x"}]})",
                                   R"({"format":"noctule-session","version":1,"takes":5})"};
    for (const std::string& damage : damages) {
        write(damage);
        const auto session = openSession(folder(), {});
        ASSERT_FALSE(session) << damage;
        EXPECT_EQ(session.error().kind, ErrorKind::kUnreadable) << damage;
        EXPECT_NE(session.error().message.find("2 takes are safe"), std::string::npos)
            << session.error().text();
        EXPECT_TRUE(canRebuildSession(folder())) << damage;
        EXPECT_EQ(text(folder() / "session.json"), damage);
    }
}

TEST_F(SessionFile, EveryCutOfTheFileIsAnErrorAndNoCrash) {
    newSession();
    const std::string whole = text(folder() / "session.json");
    for (size_t length = 0; length + 2 < whole.size(); length += 97)
        EXPECT_FALSE(sessionFromText(whole.substr(0, length), "session.json")) << length;
}

TEST_F(SessionFile, RebuildingKeepsTheDamagedFileAndFindsTakesAndPerformers) {
    newSession();
    makeTake(takes() / "walk_001.noctule", "2026-03-01T11:00:00Z", "Ada");
    makeTake(takes() / "turn_001.noctule", "2026-03-01T10:30:00Z", "Ben");
    write("{ broken");
    const auto rebuilt = rebuildSession(folder(), kCreated, {});
    ASSERT_TRUE(rebuilt) << rebuilt.error().text();
    EXPECT_EQ(text(folder() / "session.json.damaged-1"), "{ broken");
    ASSERT_EQ(rebuilt->takes.size(), 2u);
    EXPECT_EQ(rebuilt->takes[0].name, "turn_001");
    ASSERT_NE(rebuilt->findPerformer("Ada"), nullptr);
    EXPECT_EQ(rebuilt->findPerformer("Ada")->measures.height_m, 1.9);
    EXPECT_NE(rebuilt->findPerformer("Ben"), nullptr);
    write("again");
    ASSERT_TRUE(rebuildSession(folder(), kCreated, {}));
    EXPECT_EQ(text(folder() / "session.json.damaged-1"), "{ broken");
    EXPECT_EQ(text(folder() / "session.json.damaged-2"), "again");
}

TEST_F(SessionFile, SoundSessionIsNotRebuilt) {
    newSession();
    makeTake(takes() / "walk_001.noctule");
    const std::string before = text(folder() / "session.json");
    EXPECT_FALSE(rebuildSession(folder(), kCreated, {}));
    EXPECT_EQ(text(folder() / "session.json"), before);
}

TEST_F(SessionFile, MissingFileWithTakesCanBeRebuilt) {
    makeTake(takes() / "walk_001.noctule");
    const auto session = openSession(folder(), {});
    ASSERT_FALSE(session);
    EXPECT_NE(session.error().message.find("Its take is safe"), std::string::npos);
    EXPECT_TRUE(rebuildSession(folder(), kCreated, {}));
}

TEST_F(SessionFile, FolderWithoutASessionIsNamed) {
    EXPECT_NE(openSession(home_ / "nowhere", {}).error().message.find("no such folder"), std::string::npos);
    EXPECT_NE(openSession(home_, {}).error().message.find("holds no session"), std::string::npos);
}

TEST_F(SessionFile, ReadOnlySessionOpensAndSaysSoWhenSaving) {
    Session session = newSession();
    makeTake(takes() / "walk_001.noctule");
    if (mayWriteAnywhere())
        GTEST_SKIP() << "refused writing cannot be tried as the superuser";
    const std::string before = text(folder() / "session.json");
    for (const Path& path : {folder(), takes()})
        fs::permissions(path, fs::perms::owner_read | fs::perms::owner_exec);
    session = opened();
    EXPECT_TRUE(session.takes.at(0).problem.empty());
    session.name = "Other";
    const Status saved = saveSession(session);
    const Status trashed = trashTake(session, "walk_001");
    for (const Path& path : {folder(), takes()})
        fs::permissions(path, fs::perms::owner_all);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().kind, ErrorKind::kDisk);
    EXPECT_FALSE(trashed);
    EXPECT_EQ(session.takes.size(), 1u);
    EXPECT_EQ(text(folder() / "session.json"), before);
}

TEST_F(SessionFile, SavingWhereTheFolderHasGoneIsAnError) {
    const Session session = newSession();
    fs::remove_all(folder());
    const Status saved = saveSession(session);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().kind, ErrorKind::kDisk);
}

}  // namespace
}  // namespace noctule::test
