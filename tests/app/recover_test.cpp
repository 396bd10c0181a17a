// SPDX-License-Identifier: Apache-2.0
// A recording that broke off and the verb that saves it.
#include <thread>

#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

/// As a crash leaves it: two seconds of sound, never finished.
void makeBrokenTake(const std::string& path) {
    std::filesystem::copy_file(kTinyTake, path);
    runSql(path, "UPDATE meta SET value='recording' WHERE key='state'");
}

/// Another process that has the file open, until the object goes.
class OpenElsewhere {
public:
    explicit OpenElsewhere(const std::string& path) {
        int ready[2];
        EXPECT_EQ(pipe(ready), 0);
        child_ = fork();
        if (child_ == 0) {
            sqlite3* handle = nullptr;
            sqlite3_open(path.c_str(), &handle);
            sqlite3_exec(handle, "PRAGMA journal_mode=WAL; BEGIN IMMEDIATE", nullptr, nullptr, nullptr);
            (void)!write(ready[1], "x", 1);
            pause();
        }
        char byte = 0;
        EXPECT_EQ(read(ready[0], &byte, 1), 1);
        close(ready[0]);
        close(ready[1]);
    }
    ~OpenElsewhere() {
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
    }

private:
    pid_t child_ = 0;
};

TEST(Recover, OfADamagedTakeWhatCanBeReadIsSaved) {
    Folder folder;
    const std::string torn = folder.file("walk_001.noctule"), whole = readBytes(kTinyTake);
    writeBytes(torn, whole.substr(0, whole.size() / 2));
    expectRefusal({"inspect", torn}, 3, {"noctule --batch recover"});
    const Ran ran = batch({"recover", torn, "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto told = ran.json()["takes"][0];
    EXPECT_EQ(told["state"], "recovered");
    const auto lost = told["lost"];
    EXPECT_NEAR(lost["sound"]["whole_s"].get<double>(), 302500 / 150000.0, 1e-9);
    EXPECT_GT(lost["sound"]["saved_s"].get<double>(), 302500 / 150000.0 / 3);
    EXPECT_LT(lost["sound"]["saved_s"].get<double>(), 302500 / 150000.0);
    EXPECT_GT(lost["tables"]["adc_block"]["lost_rows"], 10);
    EXPECT_EQ(lost["tables"]["reference"]["saved_rows"], 0);
    EXPECT_EQ(lost["list_of_tables_damaged"], false);
    EXPECT_EQ(batch({"inspect", folder.file("walk_001_recovered.noctule")}).exit_code, 0);
}

TEST(Recover, DamageInsideOfAFinishedTakeIsFoundAndToldInWords) {
    Folder folder;
    const std::string torn = folder.file("walk_001.noctule");
    std::string bytes = readBytes(kTinyTake);
    bytes.replace(bytes.size() / 2, 40000, 40000, '\xff');
    writeBytes(torn, bytes);
    const Ran ran = batch({"recover", torn});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("was damaged. Saved of it: 1."), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find(" s of 2.02 s of the sound; everything else is complete.\n"), std::string::npos)
        << ran.out;
}

TEST(Recover, OfADamagedTakeWithALogBesideItWhatCanBeReadIsSaved) {
    Folder folder;
    const std::string torn = folder.file("walk_001.noctule"), whole = folder.file("whole.noctule");
    std::filesystem::copy_file(kTinyTake, whole);
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(whole.c_str(), &handle), SQLITE_OK);
    EXPECT_EQ(
        sqlite3_exec(handle, "PRAGMA journal_mode=WAL; INSERT INTO note(created_utc,text) VALUES('', 'x')",
                     nullptr, nullptr, nullptr),
        SQLITE_OK);
    const std::string bytes = readBytes(whole);
    writeBytes(torn, bytes.substr(0, bytes.size() / 2));
    std::filesystem::copy_file(whole + "-wal", torn + "-wal");
    sqlite3_close(handle);
    const Ran ran = batch({"recover", torn, "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(ran.json()["takes"][0].contains("lost"));
}

TEST(Recover, ABrokenTakeBecomesAFinishedOneAndStaysAsItIs) {
    Folder folder;
    const std::string broken = folder.file("walk_001.noctule");
    makeBrokenTake(broken);
    const std::string before = readBytes(broken);
    const Ran ran = batch({"recover", broken, "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto told = ran.json()["takes"][0];
    EXPECT_EQ(told["state"], "recovered");
    EXPECT_NEAR(told["duration_s"].get<double>(), 302500 / 150000.0, 1e-9);
    EXPECT_EQ(told["recovered"], folder.file("walk_001_recovered.noctule"));
    EXPECT_EQ(readBytes(broken), before);
    EXPECT_EQ(batch({"inspect", folder.file("walk_001_recovered.noctule")}).exit_code, 0);
    expectRefusal({"recover", broken}, 2, {"walk_001_recovered.noctule"});
    EXPECT_EQ(batch({"recover", kTinyTake, "--json"}).json()["takes"][0]["state"], "finished");
}

TEST(Recover, AFolderAndASession) {
    Folder folder;
    std::filesystem::create_directories(folder.file("takes"));
    makeBrokenTake(folder.file("takes/walk_001.noctule"));
    makeBrokenTake(folder.file("loose.noctule"));
    std::filesystem::copy_file(kTinyTake, folder.file("takes/fine.noctule"));
    const Ran first = batch({"recover", folder.path().string(), "--json"});
    ASSERT_EQ(first.exit_code, 0) << first.err;
    ASSERT_EQ(first.json()["takes"].size(), 2u);
    const Ran second = batch({"recover", folder.path().string(), "--json"});
    EXPECT_EQ(second.exit_code, 0) << second.err;
    for (const auto& take : second.json()["takes"])
        EXPECT_EQ(take["state"], "recovered before");
    Folder empty;
    EXPECT_EQ(batch({"recover", empty.path().string(), "--json"}).json()["takes"].size(), 0u);
}

TEST(Recover, OneThatIsBeingRecordedIsLeftAloneInAFolder) {
    Folder folder;
    const std::string open = folder.file("open.noctule");
    makeBrokenTake(open);
    makeBrokenTake(folder.file("walk_001.noctule"));
    const OpenElsewhere recording(open);
    const Ran ran = batch({"recover", folder.path().string(), "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto takes = ran.json()["takes"];
    ASSERT_EQ(takes.size(), 2u);
    EXPECT_EQ(takes[0], (nlohmann::json{{"take", open}, {"state", "being recorded"}}));
    EXPECT_EQ(takes[1]["state"], "recovered");
    EXPECT_FALSE(std::filesystem::exists(folder.file("open_recovered.noctule")));
    const Ran text = batch({"recover", folder.path().string()});
    EXPECT_NE(text.out.find("open.noctule: is being recorded right now"), std::string::npos) << text.out;
}

TEST(Recover, WhatCannotBeRecoveredIsNamed) {
    Folder folder;
    expectRefusal({"recover", folder.file("none.noctule")}, 3, {"none.noctule"});
    writeBytes(folder.file("text.noctule"), "no take at all");
    expectRefusal({"recover", folder.file("text.noctule")}, 3, {"text.noctule", "not a take"});
    const std::string open = folder.file("open.noctule");
    makeBrokenTake(open);
    const OpenElsewhere recording(open);
    expectRefusal({"recover", open}, 2, {"open.noctule", "being recorded"});
    EXPECT_EQ(folder.names().size(), 4u) << "two files, and what SQLite keeps beside the open one";
}

}  // namespace
}  // namespace noctule::test
