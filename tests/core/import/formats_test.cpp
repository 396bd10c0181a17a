// SPDX-License-Identifier: Apache-2.0
// Recordings of other programs: bytes after their specifications, and real files beside the repository
// (../shared/data), without which those tests skip.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/import/import_format.h"
#include "core/import/import_take.h"
#include "core/import/segment_map.h"
#include "core/import/segment_names.h"
#include "core/recording/take.h"
#include "tests/core/import/example_files.h"
#include "tests/support/files.h"

namespace noctule::test {
namespace {

TEST(XsensText, EverySeparatorAndLineEndReadsAlike) {
    for (const char separator : {'\t', ',', ';', ' '})
        for (const char* end : {"\n", "\r\n"}) {
            const auto read =
                readAs({{"t/MT_1_00B42D4B.txt", xsensExample({7, 8, 9, 10}, separator, true, end)}});
            ASSERT_TRUE(read) << read.error().text();
            ASSERT_EQ(read->sensors.size(), 1u);
            const ImportedSensor& sensor = read->sensors[0];
            EXPECT_EQ(sensor.id, "00B42D4B");
            EXPECT_EQ(sensor.samples.rate_hz, 100);
            ASSERT_EQ(sensor.samples.size(), 4u);
            EXPECT_EQ(sensor.samples.gyro_rad_per_s[3], Vector3d(0.03, -0.5, 0.25));
            EXPECT_EQ(sensor.samples.accel_m_per_s2[0], Vector3d(0.1, 0.2, 9.81));
            EXPECT_EQ(sensor.samples.mag[1], Vector3d(0.5, 0, -0.9));
            // The file turns y to 0.28 north, 0.96 up.
            const Vector3d y = sensor.q_world_sensor[0] * Vector3d::UnitY();
            EXPECT_LT((y - Vector3d(0, 0.96, 0.28)).norm(), 1e-9);
        }
}

TEST(XsensText, DecimalCommasAreReadWhereTheSeparatorIsAnother) {
    std::string text = xsensExample({7, 8, 9, 10}, ';', true, "\n");
    const size_t rows = text.find('\n', text.find("PacketCounter"));
    std::replace(text.begin() + static_cast<std::ptrdiff_t>(rows), text.end(), '.', ',');
    const auto read = readAs({{"t/MT_1_00B42D4B.txt", text}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sensors[0].samples.gyro_rad_per_s[3], Vector3d(0.03, -0.5, 0.25));
}

TEST(XsensText, TheCounterWrapsAndLostPacketsBecomeEmptyRows) {
    const std::string early = xsensExample({65533, 65534, 65535, 0, 1, 4}, '\t', true, "\n", "0001"),
                      late = xsensExample({0, 1, 2, 3}, '\t', true, "\n", "0002");
    const auto read = readAs({{"a_0001.txt", early}, {"a_0002.txt", late}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sensors[0].samples.size(), 8u);
    EXPECT_FALSE(read->sensors[0].samples.gyro_rad_per_s[5].allFinite());
    EXPECT_TRUE(read->sensors[0].samples.gyro_rad_per_s[7].allFinite());
    EXPECT_DOUBLE_EQ(read->sensors[1].offset_s, 0.03) << "aligned by the counters across the wrap";
    EXPECT_TRUE(mentions(read->warnings, "2 of 8 rows are lost"));
}

/// Counters of both files run together across the wrap; in each a row has none.
TEST(XsensText, ARowWithoutACounterIsLostAndNoOtherIs) {
    std::string early = xsensExample({65533, 65534, 65535, 0, 1}, '\t', true, "\n", "0001"),
                late = xsensExample({0, 1, 2, 3}, '\t', true, "\n", "0002");
    early.replace(early.find("\n65535\t"), 6, "\n");
    late.replace(late.find("\n00002\t"), 6, "\n");
    const auto read = readAs({{"a_0002.txt", late}, {"a_0001.txt", early}});
    ASSERT_TRUE(read) << read.error().text();
    for (const ImportedSensor& sensor : read->sensors) {
        ASSERT_EQ(sensor.samples.size(), sensor.id == "0002" ? 4u : 5u);
        EXPECT_FALSE(sensor.samples.gyro_rad_per_s[2].allFinite());
        EXPECT_TRUE(sensor.samples.gyro_rad_per_s[3].allFinite());
    }
}

TEST(XsensText, WithoutARateTheFinesTicksTellItElseItIsAskedFor) {
    const auto ticked = readAs({{"a_1.txt", xsensExample({1, 2, 3, 4}, '\t', false)}});
    ASSERT_TRUE(ticked) << ticked.error().text();
    EXPECT_NEAR(ticked->sensors[0].samples.rate_hz, 100, 1e-9);
    std::string bare = "PacketCounter\tAcc_X\tAcc_Y\tAcc_Z\n1\t0\t0\t9.8\n2\t0\tNaN\t9.8\n3\t0\t0\t9.8\n";
    const auto refused = readAs({{"a_1.txt", bare}});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("--rate HZ"), std::string::npos) << refused.error().text();
    ImportChoice choice;
    choice.rate_hz = 60;
    const auto given = readAs({{"a_1.txt", bare}}, choice);
    ASSERT_TRUE(given) << given.error().text();
    EXPECT_EQ(given->sensors[0].samples.rate_hz, 60);
    EXPECT_FALSE(given->sensors[0].samples.accel_m_per_s2[1].allFinite());
}

TEST(XsensText, ACutFileLosesItsLastLineAndSaysSo) {
    const std::string whole = xsensExample({1, 2, 3, 4}, '\t', true);
    const auto read = readAs({{"a_1.txt", whole.substr(0, whole.size() - 9)}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sensors[0].samples.size(), 3u);
    EXPECT_TRUE(mentions(read->warnings, "no end"));
}

TEST(XsensText, TheExampleOfOpenSenseHasGravityUpward) {
    const std::string folder = NOCTULE_SOURCE_DIR "/../shared/data/imu/opensense/example/IMUData";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "needs ../shared/data/imu";
    const auto files = readImportFiles({folder}, nullptr);
    ASSERT_TRUE(files) << files.error().text();
    const auto read = readAs(*files);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->sensors.size(), 8u);
    for (const ImportedSensor& sensor : read->sensors) {
        Vector3d mean = Vector3d::Zero();
        size_t count = 0;
        for (size_t i = 0; i < sensor.samples.size(); ++i)
            if (const Vector3d f = sensor.q_world_sensor[i] * sensor.samples.accel_m_per_s2[i];
                f.allFinite()) {
                mean += f;
                ++count;
            }
        mean /= double(count);
        EXPECT_GT(mean.y(), 9.5) << sensor.id;
        EXPECT_LT(mean.y(), 10.2) << sensor.id;
        EXPECT_LT(std::hypot(mean.x(), mean.z()), 0.6) << sensor.id;
    }
}

TEST(XsensText, TheVariantsOfMtManager2022AreRead) {
    const std::string folder = NOCTULE_SOURCE_DIR "/../shared/data/imu/opensense/readers/Xsens";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "needs ../shared/data/imu";
    ImportChoice choice;
    choice.rate_hz = 100;
    int with_attitude = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto read = readAs({{entry.path().string(), readBytes(entry.path().string())}}, choice);
        ASSERT_TRUE(read) << read.error().text();
        ASSERT_EQ(read->sensors.size(), 1u);
        const ImportedSensor& sensor = read->sensors[0];
        EXPECT_GE(sensor.samples.size(), 4u) << entry.path();
        EXPECT_NEAR(sensor.samples.accel_m_per_s2[1].norm(), 9.94, 0.1) << entry.path();
        if (!sensor.q_world_sensor.empty()) {
            ++with_attitude;
            EXPECT_GT((sensor.q_world_sensor[1] * sensor.samples.accel_m_per_s2[1]).y(), 9.8) << entry.path();
        }
    }
    EXPECT_EQ(with_attitude, 5);
}

TEST(OpenSenseSto, AttitudesAndSegmentsAreRead) {
    const auto read = readAs({{"walk.sto", stoExample()}});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->sensors.size(), 2u);
    EXPECT_EQ(read->sensors[0].segment, "Hips");
    EXPECT_EQ(read->sensors[1].segment, "RightUpLeg");
    EXPECT_NEAR(read->sensors[0].samples.rate_hz, 100, 1e-6);
    EXPECT_EQ(read->sensors[0].q_world_sensor.size(), 50u);
    EXPECT_TRUE(mentions(read->warnings, "ENU was assumed"));
    const std::string real = NOCTULE_SOURCE_DIR
        "/../shared/data/imu/opensense/tests/MT_012005D6_009-quaternions_calibration_trial_Facing_X.sto";
    if (!std::filesystem::exists(real))
        return;
    const auto walked = readAs({{real, readBytes(real)}});
    ASSERT_TRUE(walked) << walked.error().text();
    ASSERT_EQ(walked->sensors.size(), 8u);
    EXPECT_EQ(walked->sensors[7].segment, "LeftFoot");
    EXPECT_NEAR(walked->sensors[0].q_world_sensor[0].norm(), 1, 1e-9);
}

/// OpenSim reads such files.
TEST(OpenSenseSto, BlanksAroundLinesAndEmptyLinesAtTheEndDoNoHarm) {
    std::string text = stoExample() + "\r\n\r\n";
    text.replace(text.find("endheader"), 9, " endheader \t");
    for (size_t at = text.find("time");
         (at = text.find('\n', at)) != std::string::npos && at + 3 < text.size(); at += 2)
        text.insert(at, "\t");
    const auto read = readAs({{"walk.sto", text}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sensors[1].q_world_sensor.size(), 50u);
}

TEST(OpenSenseSto, MissingAttitudesAreRowsThatAreLost) {
    std::string text = stoExample();
    const size_t row = text.find('\n', text.size() / 2) + 1, cell = text.find('\t', row) + 1;
    text.replace(cell, text.find('\t', cell) - cell, "NaN,nan,NaN,NaN");
    const auto read = readAs({{"walk.sto", text}});
    ASSERT_TRUE(read) << read.error().text();
    const auto lost = [](const ImportedSensor& sensor) {
        return std::ranges::count_if(sensor.q_world_sensor,
                                     [](const Quaterniond& q) { return !q.coeffs().allFinite(); });
    };
    EXPECT_EQ(lost(read->sensors[0]), 1);
    EXPECT_EQ(lost(read->sensors[1]), 0);
    text.replace(row, cell - 1 - row, "NaN");
    EXPECT_FALSE(readAs({{"walk.sto", text}}));
}

const char* kTable = "t;ax;ay;az;gx;gy;gz\n0;0;0;1000;90;0;0\n10;0;0;1000;90;0;0\n20;;0;1000;90;0;0\n";

nlohmann::json mapOfTable() {
    return nlohmann::json::parse(
        R"({"format":"noctule-import-map","version":1,"time":{"column":"t","unit":"ms"},
        "sensors":[{"id":"wrist","segment":"LeftForeArm","gyro":["gx","gy","gz"],"gyro_unit":"deg/s",
        "accel":["ax","ay","az"],"accel_unit":"mg","axes":["y","-x","z"]}]})");
}

TEST(ColumnMap, UnitsAndAxesAreThoseOfTheMap) {
    ImportChoice choice;
    choice.map = mapOfTable();
    const auto read = readAs({{"table.csv", kTable}}, choice);
    ASSERT_TRUE(read) << read.error().text();
    const ImportedSensor& sensor = read->sensors[0];
    EXPECT_EQ(sensor.segment, "LeftForeArm");
    EXPECT_NEAR(sensor.samples.rate_hz, 100, 1e-9);
    EXPECT_LT((sensor.samples.gyro_rad_per_s[0] - Vector3d(0, -radians(90), 0)).norm(), 1e-12);
    EXPECT_NEAR(sensor.samples.accel_m_per_s2[0].z(), kStandardGravity_m_per_s2, 1e-12);
    EXPECT_FALSE(sensor.samples.accel_m_per_s2[2].allFinite());
}

TEST(ColumnMap, MistakesAreNamed) {
    const auto refusal = [](const nlohmann::json& map) {
        ImportChoice choice;
        choice.map = map;
        const auto read = readAs({{"table.csv", kTable}}, choice);
        return read ? std::string() : read.error().text();
    };
    EXPECT_NE(refusal(nullptr).find("t, ax, ay"), std::string::npos) << refusal(nullptr);
    nlohmann::json map = mapOfTable();
    map["sensors"][0]["gyro"][1] = "wy";
    EXPECT_NE(refusal(map).find("\"wy\""), std::string::npos) << refusal(map);
    map = mapOfTable();
    map["sensors"][0].erase("gyro_unit");
    EXPECT_NE(refusal(map).find("gyro_unit is missing"), std::string::npos) << refusal(map);
    map = mapOfTable();
    map["sensors"][0]["axes"] = {"x", "y", "-z"};
    EXPECT_NE(refusal(map).find("no turn"), std::string::npos) << "a mirror is no turn";
    map = mapOfTable();
    map["sensors"][0]["segment"] = "LeftArmpit";
    EXPECT_NE(refusal(map).find("\"LeftArmpit\""), std::string::npos) << refusal(map);
    map = mapOfTable();
    map["time"] = 3;
    EXPECT_NE(refusal(map).find("time names no column"), std::string::npos) << refusal(map);
}

ImportedRecording twoNumberedSensors() {
    return readAs({{"a_0001.txt", xsensExample({1, 2, 3, 4}, '\t', true, "\n", "0001")},
                   {"a_0002.txt", xsensExample({1, 2, 3, 4}, '\t', true, "\n", "0002")}})
        .value();
}

TEST(XsensText, OneSensorGivenTwiceIsRefused) {
    const std::string text = xsensExample({1, 2, 3, 4}, '\t', true);
    const auto read = readAs({{"a_1.txt", text}, {"a_2.txt", text}});
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().text().find("two sensors are named 00B42D4B"), std::string::npos);
}

TEST(SegmentMap, PutsNumberedSensorsOnSegments) {
    ImportedRecording recording = twoNumberedSensors();
    EXPECT_EQ(sensorsWithoutSegment(recording), (std::vector<std::string>{"0001", "0002"}));
    nlohmann::json map = segmentMapTemplate(recording);
    ASSERT_TRUE(map["sensors"][1]["segment"].is_null()) << map.dump();
    map["sensors"][1]["segment"] = "LeftForeArm";
    ASSERT_FALSE(describesColumns(map));
    ASSERT_TRUE(applySegmentMap(map, recording));
    EXPECT_EQ(recording.sensors[0].segment, "");
    EXPECT_EQ(recording.sensors[1].segment, "LeftForeArm");
    EXPECT_EQ(sensorsWithoutSegment(recording), std::vector<std::string>{"0001"});
    EXPECT_EQ(segmentMapTemplate(recording)["sensors"][1]["segment"], "LeftForeArm");
}

TEST(SegmentMap, GoesBeforeWhatANameMeans) {
    ImportedRecording recording = twoNumberedSensors();
    recording.sensors[0].segment = "Hips";
    ASSERT_TRUE(applySegmentMap({{"sensors", {{{"id", "0002"}, {"segment", "Hips"}}}}}, recording));
    EXPECT_EQ(recording.sensors[0].segment, "");
    EXPECT_EQ(recording.sensors[1].segment, "Hips");
}

TEST(SegmentMap, MistakesAreNamed) {
    const auto refusal = [](const nlohmann::json& sensors) {
        ImportedRecording recording = twoNumberedSensors();
        const Status placed = applySegmentMap({{"sensors", sensors}}, recording);
        return placed ? std::string() : placed.error().text();
    };
    const auto at = [](const char* id, nlohmann::json segment) {
        return nlohmann::json{{"id", id}, {"segment", std::move(segment)}};
    };
    using Json = nlohmann::json;
    EXPECT_NE(refusal(Json::array({at("3", "Hips")})).find("Its sensors are: 0001, 0002"), std::string::npos);
    EXPECT_NE(refusal(Json::array({at("0001", "Hip")})).find("\"Hip\""), std::string::npos);
    EXPECT_NE(refusal(Json::array({at("0001", 7)})).find("which no body has"), std::string::npos);
    EXPECT_NE(refusal(Json::array({at("0001", "Hips"), at("0002", "Hips")})).find("both put on Hips"),
              std::string::npos);
    EXPECT_NE(refusal(Json::array({at("0001", "Hips"), at("0001", "Head")})).find("twice"),
              std::string::npos);
    EXPECT_NE(refusal(Json::array()).find("no list of 1 to 100 sensors"), std::string::npos);
    EXPECT_NE(refusal(Json::array({5})).find("has no id"), std::string::npos);
}

TEST(Clocks, GapsAndJumpsAreToldOf) {
    ImportChoice choice;
    choice.map = mapOfTable();
    const std::string rows =
        "t;ax;ay;az;gx;gy;gz\n0;0;0;1;0;0;0\n10;0;0;1;0;0;0\n20;0;0;1;0;0;0\n50;0;0;1;0;0;0\n"
        "45;0;0;1;0;0;0\n60;0;0;1;0;0;0\n";
    const auto read = readAs({{"table.csv", rows}}, choice);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sensors[0].samples.size(), 7u);
    EXPECT_TRUE(mentions(read->warnings, "2 of 7 rows are lost in 1 gaps"));
    EXPECT_TRUE(mentions(read->warnings, "jumps back at 1 rows"));
    const auto far = readAs({{"table.csv", rows + "90000000;0;0;1;0;0;0\n"}}, choice);
    ASSERT_FALSE(far);
    EXPECT_NE(far.error().message.find("clock jumps"), std::string::npos) << far.error().message;
}

TEST(Readings, ImpossibleOnesBecomeMissingAndAreSaid) {
    ImportChoice choice;
    choice.map = mapOfTable();
    const auto read = readAs({{"table.csv", std::string(kTable) + "30;0;0;1000;1e30;0;0\n"}}, choice);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_FALSE(read->sensors[0].samples.gyro_rad_per_s[3].allFinite());
    EXPECT_TRUE(mentions(read->warnings, "beyond any sensor's range"));
}

TEST(Readings, WhatSeveralSensorsShareIsSaidOnce) {
    std::vector<ImportFile> files;
    for (const char* id : {"0001", "0002", "0003", "0004", "0005", "0006", "0007"})
        files.push_back({std::string("a_") + id + ".txt", xsensExample({0, 1, 2, 3}, '\t', true, "\n", id)});
    const auto all = readAs(files);
    ASSERT_TRUE(all) << all.error().text();
    const std::string repeated = "more than half of 4 accelerations repeat the one before";
    EXPECT_TRUE(mentions(all->warnings, "Each of 7 sensors: " + repeated));
    EXPECT_FALSE(mentions(all->warnings, "0001: "));
    // One that moves is not among them.
    int row = 0;
    for (size_t at = 0; (at = files[6].bytes.find("9.81")) != std::string::npos; ++row)
        files[6].bytes.replace(at, 4, "9.7" + std::to_string(row));
    ASSERT_EQ(row, 4);
    const auto most = readAs(files);
    ASSERT_TRUE(most) << most.error().text();
    EXPECT_TRUE(mentions(most->warnings, "0001, 0002, 0003, 0004 and 2 more: " + repeated));
    EXPECT_FALSE(mentions(most->warnings, "0007: " + repeated));
    const auto two = readAs({files[0], files[1], files[6]});
    ASSERT_TRUE(two) << two.error().text();
    EXPECT_TRUE(mentions(two->warnings, "0001 and 0002: " + repeated));
}

TEST(ImportedTakes, HoldTheMakersAttitudesBesideTheReadings) {
    const Folder folder;
    auto read = readAs({{"walk.mvnx", mvnxExample()}});
    ASSERT_TRUE(read);
    const std::string path = folder.file("walk.noctule");
    const auto summary =
        writeImportedTake(*read, {path, "walk", "2026-01-01T00:00:00Z", "test", "u", false}, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(folder.names(), std::vector<std::string>{"walk.noctule"});
    const auto take = Take::open(path);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->suit()->boards[1].segment, "RightUpLeg");
    EXPECT_EQ(take->suit()->boards[1].rate_hz, 60);
    const auto runs = take->derivedRuns();
    ASSERT_TRUE(runs);
    ASSERT_EQ(runs->size(), 1u);
    const auto rows = take->orientations((*runs)[0].run, 1);
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 20u);
    EXPECT_LT((*rows)[10].q_world_board.angularDistance(read->sensors[1].q_world_sensor[10]), 1e-9);
    const auto reference = take->reference();
    ASSERT_TRUE(reference) << reference.error().text();
    EXPECT_EQ(reference->frames.size(), 20u);
    EXPECT_EQ(reference->skeleton.joint(2).name, "LeftUpLeg");
    EXPECT_FALSE(writeImportedTake(*read, {path, "walk", "2026-01-01T00:00:00Z", "test", "u", false}, {}));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"walk.noctule"});
}

TEST(SegmentNames, WordsOfSeveralMakersAreKnown) {
    for (const auto& [name, segment] :
         std::vector<std::pair<std::string, std::string>>{{"calcn_r_imu", "RightFoot"},
                                                          {"lower_back", "Spine"},
                                                          {"upper_arm_left", "LeftArm"},
                                                          {"RightUpperLeg", "RightUpLeg"},
                                                          {"pelvis 64F0EDBF (UDP)", "Hips"},
                                                          {"T8", "Chest"},
                                                          {"hip", "Hips"},
                                                          {"00B42D4B", ""},
                                                          {"foot", ""}})
        EXPECT_EQ(segmentByName(name).value_or(""), segment) << name;
}

}  // namespace
}  // namespace noctule::test
