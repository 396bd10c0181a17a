// SPDX-License-Identifier: Apache-2.0
// Two boxes, one recording: `record` with a --device per suit, and what follows a recording.
#include <sqlite3.h>

#include <fstream>

#include "core/body/actor.h"
#include "core/recording/take.h"
#include "tests/app/virtual_suit/test_studio.h"

namespace noctule::test {
namespace {

Ran studio(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "--batch");
    return Started(std::move(arguments), NOCTULE_STUDIO).wait();
}

std::string deviceOf(const RunningSuit& box) {
    return "tcp://127.0.0.1:" + std::to_string(box.tcpPort());
}

/// Two performers as sound, simulated once, and what a laboratory knows of their suits.
class CastOnTape {
public:
    CastOnTape() {
        std::ofstream(folder_.file("cast.json")) << R"({"shared_clock":true,"subjects":[{"motion":")"
                                                 << kMotion << R"(","place":{"z_m":-0.8}},{"motion":")"
                                                 << kMotion << R"(","place":{"z_m":0.8,"yaw_deg":180}}]})";
        const Ran made = studio({"simulate", "--cast", folder_.file("cast.json"), "--out", tape(),
                                 "--duration", "1.5", "--rest-seconds", "1", "--seed", "3"});
        EXPECT_EQ(made.exit_code, 0) << made.err;
        const auto take = Take::open(tape());
        const auto calibrations = take->calibrations(), actors = take->actors();
        for (const DocumentRow& row : calibrations.value())
            std::ofstream(file("calibration_" + std::to_string(row.suit) + ".json"))
                << toJson(take->calibration(row.id).value()).dump();
        for (const DocumentRow& row : actors.value())
            std::ofstream(file("actor_" + std::to_string(row.suit) + ".json"))
                << toJson(take->actor(row.id).value()).dump();
    }
    std::string file(const std::string& name) const { return folder_.file(name); }
    std::string tape() const { return folder_.file("tape_001.noctule"); }
    /// The truth of the simulation into a take of the same sound.
    void lendReference(const std::string& take) const {
        sqlite3* database = nullptr;
        ASSERT_EQ(sqlite3_open(take.c_str(), &database), SQLITE_OK);
        const std::string sql = "ATTACH '" + tape() +
                                "' AS tape; CREATE TABLE reference AS SELECT * FROM tape.reference; "
                                "INSERT INTO meta SELECT * FROM tape.meta WHERE key LIKE 'reference_%'";
        EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(database);
        sqlite3_close(database);
    }

private:
    Folder folder_;
};

TEST(RecordSeveral, TwoBoxesBecomeOneTakeAndGoAllTheWay) {
    SKIP_WITHOUT_MOTION();
    const CastOnTape cast;
    RunningSuit first({"--take", cast.tape(), "--subject", "A"});
    RunningSuit second({"--take", cast.tape(), "--subject", "B"});
    const Ran recorded = studio({"record",
                                 "--device",
                                 deviceOf(first),
                                 "--device",
                                 deviceOf(second),
                                 "--out-dir",
                                 cast.file("takes"),
                                 "--name",
                                 "duo",
                                 "--seconds",
                                 "1.4",
                                 "--rest-seconds",
                                 "1",
                                 "--calibration",
                                 cast.file("calibration_1.json"),
                                 "--calibration",
                                 cast.file("calibration_2.json"),
                                 "--actor",
                                 cast.file("actor_1.json"),
                                 "--actor",
                                 cast.file("actor_2.json"),
                                 "--subject",
                                 "Ann",
                                 "--subject",
                                 "Bob",
                                 "--json"});
    ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
    const auto json = recorded.json();
    ASSERT_EQ(json["suits"].size(), 2U);
    for (const auto& suit : json["suits"]) {
        EXPECT_GE(suit["seconds"].get<double>(), 1.4) << suit.dump();
        EXPECT_GT(suit["live"]["poses"].get<int>(), 0) << suit.dump();
    }
    EXPECT_EQ(json["suits"][1]["subject"], "Bob");
    EXPECT_NE(json["suits"][0]["serial"], json["suits"][1]["serial"]);

    const std::string take = cast.file("takes/duo_001.noctule");
    // Boxes that find no core send less, which is told.
    int64_t lost_samples = 0;
    const auto opened = Take::open(take);
    ASSERT_TRUE(opened);
    for (const int suit : {1, 2}) {
        const auto gaps = opened->gaps(suit);
        ASSERT_TRUE(gaps);
        for (const GapRow& gap : *gaps)
            lost_samples += gap.sample_count;
    }
    EXPECT_EQ(json["lost_samples"], lost_samples);
    const Ran seen = studio({"inspect", take});
    EXPECT_EQ(seen.exit_code, 0) << seen.err;
    for (const std::string text : {"subject Ann", "subject Bob"})
        EXPECT_NE(seen.out.find(text), std::string::npos) << text << " is not in " << seen.out;
    cast.lendReference(take);
    // Clocks are joined with what the boxes' arrivals tell, which a busy machine delays: each alone here.
    const Ran processed = studio({"process", take, "--between", "off"});
    ASSERT_EQ(processed.exit_code, 0) << processed.err;
    const Ran judged = studio({"evaluate", take, "--json"});
    ASSERT_EQ(judged.exit_code, 0) << judged.err;
    const auto subjects = judged.json()["subjects"];
    ASSERT_EQ(subjects.size(), 2U) << judged.out;
    for (const auto& subject : subjects)
        EXPECT_LT(subject["mean_deg"].get<double>(), 5) << subject.dump();
}

/// Whenever the studio lets it begin, a box sounds and hears as the others of its cast expect.
TEST(RecordSeveral, ABoxOfACastKeepsTheTimeOfAll) {
    SKIP_WITHOUT_MOTION();
    const Folder folder;
    std::ofstream(folder.file("cast.json"))
        << R"({"shared_clock":true,"subjects":[{"motion":")" << kMotion << R"("},{"motion":")" << kMotion
        << R"(","place":{"z_m":1.6}}]})";
    const int64_t start_ms =
        std::chrono::system_clock::now().time_since_epoch() / std::chrono::milliseconds(1) + 1000;
    const double start_s = 1e-9 * static_cast<double>(nowNs()) + 1;
    char start[40];
    const time_t whole_s = start_ms / 1000;
    tm utc{};
    const size_t length = strftime(start, sizeof start, "%Y-%m-%dT%H:%M:%S", gmtime_r(&whole_s, &utc));
    snprintf(start + length, sizeof start - length, ".%03dZ", static_cast<int>(start_ms % 1000));
    RunningSuit box({"--cast", folder.file("cast.json"), "--subject", "B", "--start-at", start});
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const Ran recorded = studio({"record", "--device", deviceOf(box), "--out-dir", folder.file("takes"),
                                 "--name", "late", "--seconds", "2"});
    ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
    const std::string out = box.end(SIGTERM).err;
    const std::string said = "started at ";
    ASSERT_NE(out.find(said), std::string::npos) << out;
    const double began_s = std::stod(out.substr(out.find(said) + said.size()));

    const auto take = Take::open(folder.file("takes/late_001.noctule"));
    ASSERT_TRUE(take);
    const auto pulses = take->pulses();
    ASSERT_TRUE(pulses);
    ASSERT_GT(pulses->size(), 8U);
    // Eight sources take turns, from the beginning of the cast on.
    const auto rate_hz = static_cast<double>(take->header().sample_rate_hz);
    const double interval_s = static_cast<double>((*pulses)[1].sample - (*pulses)[0].sample) / rate_hz;
    for (const Pulse& pulse : *pulses) {
        const double since_s = began_s - start_s + static_cast<double>(pulse.sample) / rate_hz;
        EXPECT_NEAR(std::remainder(since_s - pulse.source * interval_s, 8 * interval_s), 0, 0.003);
    }
}

TEST(RecordSeveral, MistakesAreRefusedAndLeaveNothing) {
    const Folder folder;
    const auto refused = [&](int exit_code, std::vector<std::string> arguments,
                             const std::vector<std::string>& named) {
        arguments.insert(arguments.begin(),
                         {"record", "--out-dir", folder.file("takes"), "--seconds", "0.2"});
        const Ran ran = studio(arguments);
        EXPECT_EQ(ran.exit_code, exit_code) << ran.err;
        for (const std::string& word : named)
            EXPECT_NE(ran.err.find(word), std::string::npos) << "'" << word << "' is not in: " << ran.err;
        EXPECT_FALSE(std::filesystem::exists(folder.file("takes")));
    };
    const std::vector<std::string> two{"--device", "tcp://127.0.0.1:1", "--device", "tcp://127.0.0.1:2"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = two;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    refused(2, with({"--calibration", "c.json"}), {"--calibration is given 1 times for 2 devices", "none"});
    refused(2, with({"--subject", "Ann", "--subject", "Ann"}), {"Ann"});
    refused(2, with({"--keep-results"}), {"--keep-results", "process"});
    refused(2, with({"--trigger", "4000"}), {"--trigger"});
    refused(2, {"--device", "tcp://127.0.0.1:1", "--device", "tcp://127.0.0.1:1"}, {"given twice"});
    refused(2, {"--device", "tcp://127.0.0.1:1", "--actor", "a", "--actor", "b"}, {"--actor"});
    refused(5, two, {"tcp://127.0.0.1:1", "tcp://127.0.0.1:2"});

    // The same sound twice: two boxes on one carrier.
    const RunningSuit one({"--take", kTinyTake}), same({"--take", kTinyTake});
    refused(5, {"--device", deviceOf(one), "--device", deviceOf(same)}, {"same driver box"});
}

}  // namespace
}  // namespace noctule::test
