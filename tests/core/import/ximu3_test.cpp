// SPDX-License-Identifier: Apache-2.0
// Recordings of x-IMU3 devices: folders of CSV tables, byte streams, and what the devices state of
// themselves.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/import/import_format.h"
#include "tests/core/import/example_files.h"

namespace noctule::test {
namespace {

TEST(Ximu3, CsvAndStreamAgree) {
    const auto csv = readAs({{"rec/pelvis 64F0EDBF (UDP)/Inertial.csv", ximu3Csv()}});
    ASSERT_TRUE(csv) << csv.error().text();
    EXPECT_EQ(csv->sensors[0].id, "pelvis 64F0EDBF (UDP)");
    EXPECT_EQ(csv->sensors[0].segment, "Hips");
    const auto stream = readAs({{"rec/pelvis.ximu3", ximu3Binary()}});
    ASSERT_TRUE(stream) << stream.error().text();
    const ImuSamples &a = csv->sensors[0].samples, &b = stream->sensors[0].samples;
    EXPECT_NEAR(a.rate_hz, 400, 1e-6);
    EXPECT_NEAR(b.rate_hz, 400, 1e-6);
    ASSERT_EQ(b.size(), 41u);
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT((a.gyro_rad_per_s[i] - b.gyro_rad_per_s[i]).norm(), 1e-9) << i;
        EXPECT_LT((a.accel_m_per_s2[i] - b.accel_m_per_s2[i]).norm(), 1e-9) << i;
    }
    EXPECT_NEAR(b.gyro_rad_per_s[0].x(), radians(90), 1e-12);
    EXPECT_NEAR(b.accel_m_per_s2[0].z(), kStandardGravity_m_per_s2, 1e-12);
    EXPECT_EQ(b.mag[4], Vector3d(1, 0, -2));
    EXPECT_FALSE(b.mag[5].allFinite()) << "the magnetometer is slower";
    EXPECT_TRUE(mentions(stream->notes, "deg/s"));
}

/// What a device answered to commands: its name tells the segment, its axes are those of its attitudes.
TEST(Ximu3, CommandsAreReadAndSaid) {
    const std::string commands =
        R"([{"ping":{"interface":"UDP","name":"Left Foot","sn":"64F0EBCE"}},{"time":"2023-09-16 02:06:25"},)"
        R"({"ahrs_axes_convention":1},{"calibration_date":"2023-01-02"},{"axes_alignment":3},)"
        R"({"inertial_message_rate_divisor":8},{"wi_fi_client_key":"secret"}])";
    const std::string quaternions =
        "Timestamp (us),W,X,Y,Z\n1000000,1,0,0,0\n1002500,1,0,0,0\n1005000,1,0,0,0\n";
    std::vector<ImportFile> files{{"rec/device 3/Command.json", commands},
                                  {"rec/device 3/Inertial.csv", ximu3Csv()},
                                  {"rec/device 3/Quaternion.csv", quaternions}};
    const auto read = readAs(files);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->sensors.size(), 1u);
    EXPECT_EQ(read->name, "Inertial") << "the tables name the recording";
    EXPECT_EQ(read->sensors[0].id, "device 3");
    EXPECT_EQ(read->sensors[0].segment, "LeftFoot") << "by the device's name";
    for (const std::string words : {"'Left Foot', serial number 64F0EBCE", "2023-09-16 02:06:25", "ENU",
                                    "2023-01-02", "axes alignment 3", "divisor of 8"})
        EXPECT_TRUE(mentions(read->notes, words)) << words;
    EXPECT_FALSE(mentions(read->notes, "secret"));
    EXPECT_FALSE(mentions(read->warnings, "Command.json"));
    EXPECT_FALSE(mentions(read->warnings, "NWU was taken"));
    EXPECT_NEAR(read->sensors[0].samples.rate_hz, 400, 1e-6) << "time stamps tell the rate";
    const Quaterniond stated = read->sensors[0].q_world_sensor[0];
    files.erase(files.begin());
    const auto unstated = readAs(files);
    EXPECT_TRUE(mentions(unstated->warnings, "NWU was taken"));
    EXPECT_NEAR(stated.angularDistance(unstated->sensors[0].q_world_sensor[0]), radians(90), 1e-9)
        << "ENU and NWU differ by a quarter turn";
    EXPECT_TRUE(unstated->sensors[0].segment.empty());
    files.push_back({"rec/device 3/Command.json", "[{\"ping\":"});
    EXPECT_TRUE(mentions(readAs(files)->warnings, "states of itself cannot be read"));
}

/// As x-IMU3's first firmware answered.
TEST(Ximu3, TheFirstNamesOfAPingAreKnown) {
    const auto read = readAs(
        {{"rec/a/Command.json",
          R"([{"ping":{"deviceName":"Left Foot","interface":"USB","serialNumber":"F7E4-5410-EC7B-D7E7"}}])"},
         {"rec/a/Inertial.csv", ximu3Csv()}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->sensors[0].segment, "LeftFoot");
    EXPECT_TRUE(mentions(read->notes, "serial number F7E4-5410-EC7B-D7E7"));
}

/// A device sends its attitude in one kind of messages: a quarter turn about z in each of them.
TEST(Ximu3, AttitudesAreReadFromEveryKindOfMessage) {
    constexpr float kHalf = 0.70710678f;
    const auto attitude = [](const std::vector<ImportFile>& files) {
        const auto read = readAs(files);
        EXPECT_TRUE(read) << read.error().text();
        return read && !read->sensors[0].q_world_sensor.empty() ? read->sensors[0].q_world_sensor[0]
                                                                : Quaterniond(0, 0, 0, 0);
    };
    const ImportFile inertial{"rec/a/Inertial.csv", ximu3Csv()};
    const Quaterniond quarter = attitude(
        {inertial, {"rec/a/Quaternion.csv", "Timestamp (us),W,X,Y,Z\n1000000,0.707107,0,0,0.707107\n"}});
    const auto expectSame = [&](const Quaterniond& q, const char* what) {
        EXPECT_LT(q.angularDistance(quarter), 1e-3) << what;
    };
    expectSame(attitude({inertial,
                         {"rec/a/EulerAngles.csv",
                          "Timestamp (us),Roll (deg),Pitch (deg),Yaw (deg)\n1000000,0.0,0.0,90.0\n"}}),
               "angles");
    expectSame(
        attitude({inertial,
                  {"rec/a/EarthAcceleration.csv",
                   "Timestamp (us),Quaternion W,Quaternion X,Quaternion Y,Quaternion Z,Acceleration X "
                   "(g),Acceleration Y (g),Acceleration Z (g)\n1000000,0.707107,0,0,0.707107,0,0,1\n"}}),
        "earth acceleration");
    std::string stream =
        ximu3Message('I', 1'000'000, {0, 0, 0, 0, 0, 1}) + ximu3Message('I', 1'002'500, {0, 0, 0, 0, 0, 1});
    expectSame(attitude({{"a.ximu3", ximu3Message('A', 1'000'000, {0, 0, 90}) + stream}}), "A");
    expectSame(attitude({{"a.ximu3", ximu3Message('L', 1'000'000, {kHalf, 0, 0, kHalf, 0, 0, 1}) + stream}}),
               "L");
    const auto bare = readAs({{"a.ximu3", ximu3Message('L', 1'000'000, {0, 0, 1}) + stream}});
    ASSERT_TRUE(bare) << bare.error().text();
    EXPECT_FALSE(mentions(bare->warnings, "damaged")) << "newer firmware sends no quaternion with it";
}

/// Files named one by one have no folder that joins them.
TEST(Ximu3, CommandsWithoutAFolderAreTheOnlyDevices) {
    const ImportFile commands{"Command.json", R"([{"ping":{"name":"Left Foot","sn":"64F0EBCE"}}])"};
    const auto one = readAs({{"Inertial.csv", ximu3Csv()}, commands});
    ASSERT_TRUE(one) << one.error().text();
    ASSERT_EQ(one->sensors.size(), 1u);
    EXPECT_EQ(one->sensors[0].segment, "LeftFoot");
    EXPECT_TRUE(mentions(one->notes, "64F0EBCE"));
    EXPECT_FALSE(mentions(one->warnings, "Command.json"));
    const auto two =
        readAs({{"rec/a/Inertial.csv", ximu3Csv()}, {"rec/b/Inertial.csv", ximu3Csv()}, commands});
    ASSERT_TRUE(two) << two.error().text();
    EXPECT_FALSE(mentions(two->notes, "64F0EBCE"));
    EXPECT_TRUE(mentions(two->warnings, "Command.json: belongs to no device"));
}

/// With hundreds of devices a line for each would hide all others.
TEST(Ximu3, UnstatedAxesAreSaidOnceForAllDevices) {
    const std::string quaternions =
        "Timestamp (us),W,X,Y,Z\n1000000,1,0,0,0\n1002500,1,0,0,0\n1005000,1,0,0,0\n";
    std::vector<ImportFile> files;
    for (const std::string device : {"a", "b", "c"}) {
        files.push_back({"rec/" + device + "/Inertial.csv", ximu3Csv()});
        files.push_back({"rec/" + device + "/Quaternion.csv", quaternions});
    }
    const auto read = readAs(files);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(std::ranges::count_if(
                  read->warnings,
                  [](const auto& warning) { return warning.find("NWU was taken") != std::string::npos; }),
              1);
    EXPECT_TRUE(mentions(read->warnings, "Each of 3 sensors: does not say which axes"));
}

TEST(Ximu3, DamagedMessagesAreCountedAndACutOneIsSaid) {
    std::string bytes = ximu3Binary();
    bytes.insert(bytes.find('\n') + 1, std::string("\xC9garbage\n", 9));
    const auto read = readAs({{"a.ximu3", bytes.substr(0, bytes.size() - 5)}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(mentions(read->warnings, "1 messages are damaged"));
    EXPECT_TRUE(mentions(read->warnings, "cut in the middle"));
    EXPECT_EQ(read->sensors[0].samples.size(), 40u);
}

}  // namespace
}  // namespace noctule::test
