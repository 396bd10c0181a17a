// SPDX-License-Identifier: Apache-2.0
// Where tables of other programs begin, as they write them: lines before, units below, dates as time.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/import/column_text.h"
#include "core/import/import_format.h"
#include "core/import/table_columns.h"
#include "tests/support/files.h"

namespace noctule::test {
namespace {

/// The recording as the guess reads it.
ImportedRecording readAsGuessed(const std::string& text) {
    const Folder folder;
    const std::string path = folder.file("table.csv");
    writeBytes(path, text);
    const auto table = guessColumns(path);
    EXPECT_TRUE(table) << table.error().text();
    const auto map = table ? mapOfColumns(*table, 0) : Result<nlohmann::json>(table.error());
    EXPECT_TRUE(map) << map.error().text();
    ImportChoice choice;
    choice.map = map ? *map : nlohmann::json();
    auto recording = readImport(*findImportFormat("csv"), {{"table.csv", text}}, choice, {});
    EXPECT_TRUE(recording) << recording.error().text();
    return recording ? std::move(*recording) : ImportedRecording{};
}

/// Consensys: a line for spreadsheets, names, units, and a separator behind each line.
TEST(TableHead, ShimmersSecondLineOfUnitsIsRead) {
    std::string text =
        "\"sep=\t\"\nS_1A_Timestamp_FormattedUnix_CAL\tS_1A_Accel_LN_X_CAL\tS_1A_Accel_LN_Y_CAL\t"
        "S_1A_Accel_LN_Z_CAL\tS_1A_Accel_WR_X_CAL\tS_1A_Accel_WR_Y_CAL\tS_1A_Accel_WR_Z_CAL\tS_1A_Gyro_X_"
        "CAL\t"
        "S_1A_Gyro_Y_CAL\tS_1A_Gyro_Z_CAL\tS_1A_Mag_X_CAL\tS_1A_Mag_Y_CAL\tS_1A_Mag_Z_CAL\t\n"
        "yyyy/mm/dd hh:mm:ss.000\tm/(s^2)\tm/(s^2)\tm/(s^2)\tm/(s^2)\tm/(s^2)\tm/(s^2)\tdeg/s\tdeg/s\tdeg/s\t"
        "local_flux\tlocal_flux\tlocal_flux\t\n";
    for (int i = 0; i < 25; ++i)
        text += "2020/07/28 23:59:59." + std::to_string(500 + 20 * i) + "\t0\t0\t9.8\t1\t1\t9\t10\t0\t" +
                std::to_string(i % 7) + "\t0.5\t0\t-0.8\t\n";
    const ImportedRecording read = readAsGuessed(text);
    ASSERT_EQ(read.sensors.size(), 1u);
    const ImuSamples& samples = read.sensors[0].samples;
    EXPECT_NEAR(samples.rate_hz, 50, 1e-3);
    EXPECT_NEAR(samples.gyro_rad_per_s[0].x(), radians(10), 1e-9) << "slow, but stated as deg/s";
    EXPECT_EQ(samples.accel_m_per_s2[0], Vector3d(0, 0, 9.8)) << "the first of two accelerometers";
    EXPECT_NE(
        std::ranges::find(read.notes,
                          "Read from S_1A_Accel_LN_X_CAL, S_1A_Accel_LN_Y_CAL, S_1A_Accel_LN_Z_CAL; left out "
                          "is the same quantity in S_1A_Accel_WR_X_CAL, S_1A_Accel_WR_Y_CAL, "
                          "S_1A_Accel_WR_Z_CAL, which a map can name instead"),
        read.notes.end());
    EXPECT_EQ(samples.mag[0], Vector3d(0.5, 0, -0.8));
}

/// Noraxon: lines about the recording, semicolons, decimal commas, milli-g, two ways to name a sensor.
TEST(TableHead, LinesAboutTheRecordingArePassedOver) {
    std::string text =
        "Name;Walking\nFrequency;200,0\nDate;01.02.2024\n"
        "time;Shank Accel Sensor X LT (mG);Shank Accel Sensor Y LT (mG);Shank Accel Sensor Z LT (mG);"
        "Noraxon MyoMotion-Segments-Shank LT-Gyroscope-x (deg/s);Noraxon MyoMotion-Segments-Shank "
        "LT-Gyroscope-y (deg/s);Noraxon MyoMotion-Segments-Shank LT-Gyroscope-z (deg/s)\n";
    for (int i = 0; i < 40; ++i)
        text += "0," + std::to_string(1000 + 5 * i).substr(1) + ";0,0;0,0;980,0;1,5;0,0;" +
                std::to_string(i % 5) + ",0\n";
    const ImportedRecording read = readAsGuessed(text);
    ASSERT_EQ(read.sensors.size(), 1u) << "one sensor has both";
    EXPECT_NEAR(read.sensors[0].samples.rate_hz, 200, 1e-6);
    EXPECT_NEAR(read.sensors[0].samples.accel_m_per_s2[0].z(), 0.98 * 9.80665, 1e-9);
    EXPECT_NEAR(read.sensors[0].samples.gyro_rad_per_s[0].x(), radians(1.5), 1e-9);
}

/// phyphox in German: quotes, exponents, decimal commas.
TEST(TableHead, PhyphoxTablesAreRead) {
    std::string text =
        "\"Time (s)\";\"Gyroscope x (rad/s)\";\"Gyroscope y (rad/s)\";\"Gyroscope z (rad/s)\";\"Absolute "
        "(rad/s)\"\n";
    for (int i = 0; i < 20; ++i)
        text += std::to_string(i) + ",000000000E-2;-1,250000000E-1;0,000000000E0;0,000000000E0;1,25E-1\n";
    const ImportedRecording read = readAsGuessed(text);
    ASSERT_EQ(read.sensors.size(), 1u);
    EXPECT_NEAR(read.sensors[0].samples.rate_hz, 100, 1e-6);
    EXPECT_EQ(read.sensors[0].samples.gyro_rad_per_s[3], Vector3d(-0.125, 0, 0));
}

/// A recording by the clock of the wall does not end at midnight.
TEST(TableHead, TimesOfDayGoOnBehindMidnight) {
    std::string text = "time,Gyr_X (rad/s),Gyr_Y (rad/s),Gyr_Z (rad/s)\n";
    for (const char* second : {"23:59:59.", "00:00:00."})
        for (int ms = 0; ms < 1000; ms += 20)
            text += second + std::to_string(1000 + ms).substr(1) + ",0.1,0,0\n";
    const ImportedRecording read = readAsGuessed(text);
    ASSERT_EQ(read.sensors.size(), 1u);
    EXPECT_EQ(read.sensors[0].samples.size(), 100u);
}

/// The day of a time of day is a guess where hours lie between two rows.
TEST(TableHead, AHoleBetweenTimesOfDayIsSaidToBeAGuess) {
    const auto warningsOf = [](const char* second_hour) {
        std::string text = "time,Gyr_X (rad/s),Gyr_Y (rad/s),Gyr_Z (rad/s)\n";
        for (const std::string& hour : {std::string("10"), std::string(second_hour)})
            for (int i = 0; i < 30; ++i)
                text += hour + ":00:" + std::to_string(10 + i) + ",0.1,0,0\n";
        std::string all;
        for (const std::string& warning : readAsGuessed(text).warnings)
            all += warning + "\n";
        return all;
    };
    EXPECT_NE(warningsOf("11").find("a hole of 0.99 h is a guess"), std::string::npos) << warningsOf("11");
    EXPECT_NE(warningsOf("08").find("jump back by 2.01 h"), std::string::npos) << warningsOf("08");
}

TEST(TableHead, ARowThatLacksOneAxisIsSaid) {
    std::string text = "time,Gyr_X (rad/s),Gyr_Y (rad/s),Gyr_Z (rad/s)\n";
    for (int i = 0; i < 500; ++i)
        text +=
            std::to_string(0.01 * i) + (i == 7 ? ",0.1,,0.5\n" : ",0.1,0," + std::to_string(i % 9) + "\n");
    const ImportedRecording read = readAsGuessed(text);
    ASSERT_EQ(read.sensors.size(), 1u);
    EXPECT_TRUE(read.sensors[0].samples.gyro_rad_per_s[7].array().isNaN().all());
    EXPECT_TRUE(std::ranges::any_of(read.warnings, [](const std::string& warning) {
        return warning.find("1 of 500") != std::string::npos &&
               warning.find("lack an axis") != std::string::npos;
    }));
}

TEST(TableHead, InstantsAreSecondsWhateverTheHeaderSays) {
    std::string text = "Time (ms),Gyr_X (rad/s),Gyr_Y (rad/s),Gyr_Z (rad/s)\n";
    for (int i = 0; i < 20; ++i)
        text += "10:00:" + std::to_string(10 + i / 2) + (i % 2 == 0 ? ".000" : ".500") + ",0.1,0,0\n";
    EXPECT_NEAR(readAsGuessed(text).sensors.at(0).samples.rate_hz, 2, 1e-6);
}

/// Spreadsheets fill all lines up to the table's width.
TEST(TableHead, EmptyCellsAboveTheNamesAreNoRow) {
    const auto head = tableHead("Recorded by,Ada\n,,,\n,,,\nt,ax,ay,az\n0,1,2,3\n1,2,3,4\n", "x.csv");
    ASSERT_TRUE(head);
    EXPECT_EQ(head->names, (std::vector<std::string>{"t", "ax", "ay", "az"}));
    EXPECT_EQ(head->first_line, 5u);
}

TEST(TableHead, ADamagedRowIsNoHeader) {
    const auto head = tableHead("t,ax,ay\n0,1,2\n1,2\n", "x.csv");
    ASSERT_TRUE(head);
    EXPECT_EQ(head->names.size(), 3u);
    EXPECT_TRUE(head->units.empty());
    EXPECT_EQ(head->first_line, 2u);
    const auto narrow = tableHead("t,ax\n0,1,2\n1,2,3\n", "x.csv");
    ASSERT_TRUE(narrow);
    EXPECT_TRUE(narrow->has_names) << "names that no row fits stay names, and the rows are refused";
}

TEST(TableHead, InstantsAreSeconds) {
    const double day = 86400 * 19844;  // 2024-05-01
    const std::pair<const char*, double> instants[] = {{"2024-05-01T00:00:01.25Z", day + 1.25},
                                                       {"2024/05/01 00:00:01,250", day + 1.25},
                                                       {"2024-05-01T02:00:01+02:00", day + 1},
                                                       {"2024-04-30 23:00:00-0100", day},
                                                       {"10:00:00.5", 36000.5}};
    for (const auto& [text, seconds] : instants) {
        const auto read = readInstant(text);
        ASSERT_TRUE(read) << text;
        EXPECT_NEAR(*read, seconds, 1e-6) << text;
    }
    for (const char* text : {"", "2024", "2024-13-01 00:00:00", "2024-05-01", "10:00", "10:00:00 and more",
                             "2024-05-01T25:00:00", "10:61:00", "ab:cd:ef"})
        EXPECT_FALSE(readInstant(text)) << text;
    EXPECT_EQ(readDateAndTime("2024-05-01T00:00:01Z"), day + 1);
    EXPECT_FALSE(readDateAndTime("10:00:00")) << "of which day?";
    EXPECT_FALSE(readDateAndTime(""));
}

}  // namespace
}  // namespace noctule::test
