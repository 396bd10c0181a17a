// SPDX-License-Identifier: Apache-2.0
// Tables of Movella DOT: names, units and first lines as its app writes them.
#include <gtest/gtest.h>

#include "tests/core/import/example_files.h"

namespace noctule::test {
namespace {

/// 60 rows a second; the clock wraps behind the third row.
std::string dotTable(const std::string& tag, const std::string& columns, const std::string& values) {
    std::string text = "sep=,\nDeviceTag:," + tag +
                       ",,,,,,,,\nFirmwareVersion:,3.0.0,,,,,,,,\nSyncStatus:,Synced,,,,,,,,\n"
                       "OutputRate:,60Hz,,,,,,,,\nStartTime: ,2025-07-11_20:06:00_086 WEST\n"
                       "\xC2\xA9 Movella Technologies B. V. 2005-2025\n\nPacketCounter,SampleTimeFine," +
                       columns + "\n";
    for (int i = 0; i < 6; ++i)
        text += std::to_string(i + 1) + "," +
                std::to_string((4294917295ULL + 16667ULL * uint64_t(i)) % 4294967296ULL) + "," + values +
                "\n";
    return text;
}

TEST(MovellaDot, RatesAreDegreesAndTheClockCountsMicroseconds) {
    const std::string columns = "Quat_W,Quat_X,Quat_Y,Quat_Z,Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z";
    const std::string values = "0.8,0.6,0,0,0,0,9.81,90,0,-45";
    const auto read = readAs({{"dot/DOT_1_20250711_200600.csv", dotTable("left shank", columns, values)}});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->sensors.size(), 1u);
    const ImportedSensor& sensor = read->sensors[0];
    EXPECT_EQ(read->format, "mt");
    EXPECT_EQ(sensor.id, "left shank");
    EXPECT_EQ(sensor.segment, "LeftLeg");
    EXPECT_EQ(sensor.samples.rate_hz, 60);
    ASSERT_EQ(sensor.samples.size(), 6u);
    EXPECT_LT((sensor.samples.gyro_rad_per_s[2] - Vector3d(radians(90), 0, radians(-45))).norm(), 1e-12);
    EXPECT_LT((sensor.q_world_sensor[0] * Vector3d::UnitY() - Vector3d(0, 0.96, 0.28)).norm(), 1e-9);
    EXPECT_FALSE(mentions(read->warnings, "SampleTimeFine shows")) << "16667 microseconds are 60 Hz";
    EXPECT_FALSE(mentions(read->warnings, "No coordinate system")) << "DOT's is ENU";
}

TEST(MovellaDot, EulerAnglesAreRollPitchYawAndTagsAsDeliveredNameNobody) {
    const std::string columns = "Euler_X,Euler_Y,Euler_Z,FreeAcc_X,FreeAcc_Y,FreeAcc_Z,Status";
    const std::string table = dotTable("Xsens DOT", columns, "90,0,0,0,0,0,0");
    const auto read = readAs({{"A_20250711_200600.csv", table}, {"B_20250711_200600.csv", table}});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->sensors.size(), 2u);
    EXPECT_EQ(read->sensors[1].id, "B_20250711_200600");
    EXPECT_LT((read->sensors[0].q_world_sensor[0] * Vector3d::UnitY() - Vector3d::UnitY()).norm(), 1e-9)
        << "a roll of 90 degrees turns y up";
}

TEST(MovellaDot, ATagThatEndsTheNameOfItsFileIsStillItsName) {
    const auto read = readAs({{"DOT_hip.csv", dotTable("hip", "Gyr_X,Gyr_Y,Gyr_Z", "90,0,0")}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sensors[0].id, "hip");
}

/// Without the app's first lines, as a program with DOT's library writes it.
TEST(MovellaDot, ItsColumnsTellItToo) {
    std::string text = dotTable("", "Quat_W,Quat_X,Quat_Y,Quat_Z,Gyr_X,Gyr_Y,Gyr_Z", "1,0,0,0,90,0,0");
    text.erase(0, text.find("PacketCounter"));
    const auto read = readAs({{"dot.csv", text}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_NEAR(read->sensors[0].samples.rate_hz, 60, 0.01) << "by the clock, across its wrap";
    EXPECT_NEAR(read->sensors[0].samples.gyro_rad_per_s[0].x(), radians(90), 1e-12);
}

/// MT Manager's rates are rad/s, with a spreadsheet's line before them too.
TEST(MovellaDot, ALineForSpreadsheetsAloneMakesNoDot) {
    const auto read = readAs({{"t/MT_1_00B42D4B.csv", "sep=,\n" + xsensExample({7, 8, 9, 10}, ',', true)}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sensors[0].samples.gyro_rad_per_s[3], Vector3d(0.03, -0.5, 0.25));
}

}  // namespace
}  // namespace noctule::test
