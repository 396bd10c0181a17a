// SPDX-License-Identifier: Apache-2.0
#include "core/import/table_columns.h"

#include <gtest/gtest.h>

#include "core/import/import_format.h"
#include "tests/support/files.h"

namespace noctule {
namespace {

class TableColumnsTest : public testing::Test {
protected:
    std::string written(const std::string& text) {
        const std::string path = folder_.file("table.csv");
        test::writeBytes(path, text);
        return path;
    }
    TableColumns guessed(const std::string& text) {
        auto table = guessColumns(written(text));
        EXPECT_TRUE(table) << table.error().text();
        return table ? std::move(*table) : TableColumns{};
    }
    /// The recording as the guess reads it.
    ImportedRecording readAsGuessed(const std::string& text) {
        const auto map = mapOfColumns(guessed(text), 0);
        EXPECT_TRUE(map) << map.error().text();
        ImportChoice choice;
        choice.map = map ? *map : nlohmann::json();
        auto recording = readImport(*findImportFormat("csv"), {{"table.csv", text}}, choice, {});
        EXPECT_TRUE(recording) << recording.error().text();
        return recording ? std::move(*recording) : ImportedRecording{};
    }

    const test::Folder folder_;
};

/// "gyro 1 wrist" of a column.
std::string wordsOf(const TableColumn& column) {
    const char* names[] = {"nothing", "time", "gyro", "accel", "mag", "quaternion"};
    return std::string(names[static_cast<size_t>(column.quantity)]) + " " + std::to_string(column.axis) +
           " " + column.sensor;
}

TEST_F(TableColumnsTest, NamesTellQuantityAxisAndSensor) {
    const std::pair<const char*, const char*> names[] = {{"time_s", "time 0 "},
                                                         {"Timestamp", "time 0 "},
                                                         {"t", "time 0 "},
                                                         {"ax", "accel 0 sensor"},
                                                         {"gy", "gyro 1 sensor"},
                                                         {"wz", "gyro 2 sensor"},
                                                         {"mx", "mag 0 sensor"},
                                                         {"qw", "quaternion 0 sensor"},
                                                         {"q3", "quaternion 3 sensor"},
                                                         {"AccX", "accel 0 sensor"},
                                                         {"Acc_Z", "accel 2 sensor"},
                                                         {"Gyroscope Y (deg/s)", "gyro 1 sensor"},
                                                         {"angular_velocity.x", "gyro 0 sensor"},
                                                         {"linear_acceleration.z", "accel 2 sensor"},
                                                         {"orientation.w", "quaternion 0 sensor"},
                                                         {"pelvis_acc_y", "accel 1 pelvis"},
                                                         {"LeftShank Gyro Z", "gyro 2 left_shank"},
                                                         {"imu2_mag_x", "mag 0 imu_2"},
                                                         {"temperature", "nothing 0 "},
                                                         {"battery", "nothing 0 "},
                                                         {"acceleration", "nothing 0 "},
                                                         {"x", "nothing 0 "}};
    for (const auto& [name, expected] : names) {
        const TableColumns table = guessed(std::string(name) + ",other,more\n1,2,3\n3,4,5\n");
        ASSERT_EQ(table.columns.size(), 3u) << name;
        EXPECT_EQ(wordsOf(table.columns[0]), expected) << name;
    }
}

TEST_F(TableColumnsTest, TheSecondTimeIsNothing) {
    const TableColumns table = guessed("time,timestamp\n0,1000\n0.01,1010\n");
    EXPECT_EQ(table.columns[0].quantity, TableQuantity::kTime);
    EXPECT_EQ(table.columns[1].quantity, TableQuantity::kNothing);
    EXPECT_EQ(table.columns[1].cells, (std::vector<std::string>{"1000", "1010"}));
}

TEST_F(TableColumnsTest, ValuesTellTheUnitAndNamesKnowItBetter) {
    const TableColumns metric =
        guessed("t,ax,ay,az,gx,gy,gz\n0,0,0,9.7,0,1,0\n10,0,1,9.8,2,0,0\n20,0,0,9.8,0,0,0\n");
    EXPECT_EQ(metric.time_unit, "ms");
    EXPECT_EQ(metric.accel_unit, "m/s^2");
    EXPECT_EQ(metric.gyro_unit, "rad/s");
    const TableColumns other = guessed(
        "t,ax,ay,az,gx,gy,gz,mx,my,mz\n0,0,0,1,90,1,0,200,0,-400\n0.01,0,0,0.98,0,0,0,200,10,-410\n0.02,0,0,"
        "1,0,0,0,0,0,0\n");
    EXPECT_EQ(other.time_unit, "s");
    EXPECT_EQ(other.accel_unit, "g");
    EXPECT_EQ(other.gyro_unit, "deg/s");
    EXPECT_EQ(other.mag_unit, "mG");
    const TableColumns named =
        guessed("time [us],GyrX (dps),GyrY (dps),GyrZ (dps),MagX (µT)\n0,0,0,0,1\n5,0,0,1,1\n10,0,0,0,1\n");
    EXPECT_EQ(named.time_unit, "us");
    EXPECT_EQ(named.gyro_unit, "deg/s");
    EXPECT_EQ(named.mag_unit, "uT");
}

TEST_F(TableColumnsTest, AGuessReadsTheTable) {
    std::string text = "t;wrist ax;wrist ay;wrist az;hip gx;hip gy;hip gz\n";
    for (int i = 0; i < 50; ++i)
        text += std::to_string(20 * i) + ";0;0;1,0;57,29577951;0;" + std::to_string(i) + "\n";
    const ImportedRecording recording = readAsGuessed(text);
    ASSERT_EQ(recording.sensors.size(), 2u);
    EXPECT_EQ(recording.sensors[0].id, "hip");
    EXPECT_EQ(recording.sensors[1].id, "wrist");
    EXPECT_NEAR(recording.sensors[0].samples.rate_hz, 50, 1e-6);
    EXPECT_NEAR(recording.sensors[0].samples.gyro_rad_per_s[3].x(), 1, 1e-6) << "57.3 degrees a second";
    EXPECT_NEAR(recording.sensors[1].samples.accel_m_per_s2[3].z(), 9.80665, 1e-9);
}

TEST_F(TableColumnsTest, ATableWithoutHeaderIsLeftToTheOperator) {
    const TableColumns table = guessed("0,1,2\n1,2,3\n");
    ASSERT_EQ(table.columns.size(), 3u);
    EXPECT_FALSE(table.has_header);
    EXPECT_EQ(table.columns[1].name, "column 2");
    for (const TableColumn& column : table.columns)
        EXPECT_EQ(column.quantity, TableQuantity::kNothing);
    EXPECT_FALSE(guessColumns(written("no table at all")));
    EXPECT_FALSE(guessColumns(folder_.file("nowhere.csv")));
}

TEST_F(TableColumnsTest, WhatIsMissingOrDoubledIsNamed) {
    const TableColumns whole = guessed("t,ax,ay,az\n0,0,0,1\n1,0,0,1\n");
    ASSERT_TRUE(mapOfColumns(whole, 0));
    TableColumns table = whole;
    table.columns[3].quantity = TableQuantity::kNothing;
    const auto lacking = mapOfColumns(table, 0);
    ASSERT_FALSE(lacking);
    EXPECT_NE(lacking.error().message.find("lacks Z"), std::string::npos) << lacking.error().text();
    table = whole;
    table.columns[3].axis = 0;
    const auto doubled = mapOfColumns(table, 0);
    ASSERT_FALSE(doubled);
    EXPECT_NE(doubled.error().message.find("az"), std::string::npos) << doubled.error().text();
    table = whole;
    table.columns[0].quantity = TableQuantity::kNothing;
    EXPECT_FALSE(mapOfColumns(table, 0));
    EXPECT_TRUE(mapOfColumns(table, 100)) << "a rate stands for the time";
    table = whole;
    table.columns[2].sensor = "other";
    EXPECT_FALSE(mapOfColumns(table, 0));
    table.columns[2].sensor.clear();
    EXPECT_FALSE(mapOfColumns(table, 0));
}

}  // namespace
}  // namespace noctule
