// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>

#include "core/import/import_format.h"
#include "core/import/import_take.h"
#include "core/import/mat_recording.h"
#include "core/import/unit_check.h"
#include "core/job/atomic_file.h"
#include "core/recording/take.h"
#include "tests/support/fuzzing.h"

namespace noctule {
namespace {

// A writer of MATLAB's level 5 of its own: what is read here was not written by what is tested.
template <class T>
std::string bytesOf(T value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string element(uint32_t type, const std::string& data) {
    return bytesOf(type) + bytesOf(uint32_t(data.size())) + data +
           std::string((8 - data.size() % 8) % 8, '\0');
}

template <class T>
std::string array(const std::string& name, int rows, int columns, uint32_t type,
                  const std::vector<T>& values) {
    std::string data;
    for (const T value : values)
        data += bytesOf(value);
    return element(14, element(6, bytesOf(uint32_t{6}) + bytesOf(uint32_t{0})) +
                           element(5, bytesOf(int32_t{rows}) + bytesOf(int32_t{columns})) + element(1, name) +
                           element(type, data));
}

std::string structOf(const std::string& name,
                     const std::vector<std::pair<std::string, std::string>>& members) {
    std::string names, values;
    for (const auto& [member, value] : members) {
        names += member + std::string(32 - member.size(), '\0');
        values += value;
    }
    return element(14, element(6, bytesOf(uint32_t{2}) + bytesOf(uint32_t{0})) +
                           element(5, bytesOf(int32_t{1}) + bytesOf(int32_t{1})) + element(1, name) +
                           bytesOf(uint32_t{4u << 16 | 5u}) + bytesOf(int32_t{32}) + element(1, names) +
                           values);
}

std::string packed(const std::string& plain) {
    std::string out(compressBound(plain.size()), '\0');
    uLongf size = out.size();
    compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
             plain.size());
    out.resize(size);
    return bytesOf(uint32_t{15}) + bytesOf(uint32_t(size)) + out;
}

std::string file(const std::string& body) {
    std::string header = "MATLAB 5.0 MAT-file";
    header.resize(124, ' ');
    return header + bytesOf(uint16_t{0x0100}) + "IM" + body;
}

TEST(MatFile, ReadsNumbersInTheirSmallestTypes) {
    const auto arrays = parseMat(
        file(array<double>("a", 2, 2, 9, {1.5, 2, 3, -4}) + array<uint8_t>("b", 1, 3, 2, {7, 8, 255}) +
             packed(array<float>("c", 3, 1, 7, {0.5f, 1, 2}))),
        "x.mat");
    ASSERT_TRUE(arrays) << arrays.error().text();
    EXPECT_EQ(arrays->at("a"), (Eigen::Matrix2d() << 1.5, 3, 2, -4).finished()) << "column by column";
    EXPECT_EQ(arrays->at("b")(0, 2), 255);
    EXPECT_EQ(arrays->at("c")(0), 0.5);
}

TEST(MatFile, StructsHaveDottedNames) {
    const auto arrays = parseMat(file(structOf("hip", {{"gyr", array<double>("", 1, 3, 9, {1, 2, 3})},
                                                       {"acc", array<double>("", 1, 3, 9, {0, 0, 9.8})}})),
                                 "x.mat");
    ASSERT_TRUE(arrays) << arrays.error().text();
    EXPECT_EQ(arrays->count("hip.gyr"), 1u);
    EXPECT_EQ(arrays->at("hip.acc")(2), 9.8);
}

TEST(MatFile, OtherFilesAreRefusedInWords) {
    for (const auto& [bytes, word] : std::vector<std::pair<std::string, std::string>>{
             {"\x89HDF\r\n", "7.3"}, {"", "too short"}, {std::string(200, 'x'), "byte order"}}) {
        const auto arrays = parseMat(bytes, "x.mat");
        ASSERT_FALSE(arrays);
        EXPECT_EQ(arrays.error().kind, ErrorKind::kUnreadable);
        EXPECT_NE(arrays.error().message.find(word), std::string::npos) << arrays.error().message;
        EXPECT_FALSE(arrays.error().remedy.empty());
    }
}

TEST(MatFile, DamagedFilesNeverCrash) {
    const std::string good =
        file(structOf("s", {{"gyr", array<double>("", 2, 3, 9, {1, 2, 3, 4, 5, 6})}}) +
             packed(array<double>("t", 4, 1, 9, {0, 1, 2, 3})) + array<int16_t>("n", 1, 2, 3, {1, 2}));
    for (size_t cut = 0; cut < good.size(); ++cut)
        (void)parseMat(std::string_view(good).substr(0, cut), "cut.mat");
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string bytes = good;
        for (int flips = 0; flips < 3; ++flips)
            bytes[random() % bytes.size()] ^= char(1 << random() % 8);
        refused += !parseMat(bytes, "flipped.mat", {1 << 20, 8});
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 20'000) << "flips within values only change them";
}

TEST(FuzzImport, Mat) {
    const std::vector<std::string> examples = {
        file(structOf("s", {{"gyr", array<double>("", 2, 3, 9, {1, 2, 3, 4, 5, 6})},
                            {"acc", array<double>("", 2, 3, 9, {1, 2, 3, 4, 5, 6})}}) +
             packed(array<double>("t", 2, 1, 9, {0, 0.01})))};
    test::feedDamaged(examples, 1500, 64 * 1024, [](const std::string& bytes, int64_t) {
        const auto read = readImport(*findImportFormat("mat"), {{"a.mat", bytes}}, {}, {});
        EXPECT_TRUE(read || !read.error().remedy.empty());
    });
}

MatArrays turningSensor(double gyro_unit, double accel_unit) {
    // Rolls about x by 40 degrees and back, four times in 20 s.
    constexpr int kRows = 2000;
    Eigen::MatrixXd gyr = Eigen::MatrixXd::Zero(kRows, 3), acc = gyr, mag = gyr;
    for (int i = 0; i < kRows; ++i) {
        const double t = i / 100.0, w = 2 * std::numbers::pi / 5;
        const double angle = 0.7 * std::sin(w * t);
        gyr(i, 0) = 0.7 * w * std::cos(w * t) / gyro_unit;
        acc(i, 1) = kStandardGravity_m_per_s2 * std::cos(angle) / accel_unit;
        acc(i, 2) = -kStandardGravity_m_per_s2 * std::sin(angle) / accel_unit;
        mag(i, 2) = 20;
    }
    return {{"imu_gyr", gyr},
            {"imu_acc", acc},
            {"imu_mag", mag},
            {"sampling_rate", Eigen::MatrixXd::Constant(1, 1, 100)}};
}

TEST(UnitCheck, DegreesAndGAreConvertedAndSaid) {
    auto right = recordingFromMat(turningSensor(1, 1), "right");
    ASSERT_TRUE(right);
    convertToSi(*right);
    EXPECT_TRUE(right->warnings.empty()) << right->warnings.front();
    EXPECT_EQ(rateReading(right->sensors[0].samples), RateReading::kRadians);

    auto other = recordingFromMat(turningSensor(std::numbers::pi / 180, kStandardGravity_m_per_s2), "other");
    ASSERT_TRUE(other);
    convertToSi(*other);
    ASSERT_EQ(other->warnings.size(), 2u);
    EXPECT_NE(other->warnings[1].find("deg/s"), std::string::npos);
    for (size_t i = 0; i < right->sensors[0].samples.size(); i += 50) {
        EXPECT_LT((other->sensors[0].samples.gyro_rad_per_s[i] - right->sensors[0].samples.gyro_rad_per_s[i])
                      .norm(),
                  1e-9);
        EXPECT_LT((other->sensors[0].samples.accel_m_per_s2[i] - right->sensors[0].samples.accel_m_per_s2[i])
                      .norm(),
                  1e-9);
    }
}

TEST(UnitCheck, FieldsInTeslaAreConvertedAndSaid) {
    for (const double unit : {1.0, 1e-6, 1e3, 0.02}) {
        MatArrays arrays = turningSensor(1, 1);
        arrays["imu_mag"] *= unit;
        auto recording = recordingFromMat(arrays, "field");
        ASSERT_TRUE(recording);
        convertToSi(*recording);
        const bool is_plain = unit == 1 || unit == 0.02;  // 0.4 may be gauss
        EXPECT_EQ(recording->warnings.size(), is_plain ? 0u : 1u) << unit;
        EXPECT_NEAR(recording->sensors[0].samples.mag[0].z(), is_plain ? 20 * unit : 20, 1e-9) << unit;
    }
}

TEST(UnitCheck, RadiansStatedAsDegreesAreTakenBackAndSaid) {
    auto right = recordingFromMat(turningSensor(1, 1), "right");
    auto twice = recordingFromMat(turningSensor(180 / std::numbers::pi, 1), "twice");
    ASSERT_TRUE(right && twice);
    EXPECT_EQ(rateReading(twice->sensors[0].samples), RateReading::kConvertedTwice);
    convertToSi(*twice);
    ASSERT_EQ(twice->warnings.size(), 1u);
    EXPECT_NE(twice->warnings[0].find("stated as deg/s"), std::string::npos);
    EXPECT_LT((twice->sensors[0].samples.gyro_rad_per_s[700] - right->sensors[0].samples.gyro_rad_per_s[700])
                  .norm(),
              1e-9);
}

TEST(UnitCheck, RatesThatNoGyroscopeShowsAreQuestionedWhereGravityDoesNotTurn) {
    for (const auto& [rate, questioned] : {std::pair{200.0, true}, std::pair{30.0, false}}) {
        ImportedRecording recording;
        ImportedSensor sensor;
        sensor.id = "wrist";
        sensor.samples.rate_hz = 100;
        sensor.samples.gyro_rad_per_s.assign(500, Vector3d(0, 0, rate));
        sensor.samples.accel_m_per_s2.assign(500, Vector3d(0, 0, 9.81));
        recording.sensors.push_back(sensor);
        convertToSi(recording);
        EXPECT_EQ(recording.warnings.size(), questioned ? 1u : 0u);
        if (questioned) {
            EXPECT_NE(recording.warnings[0].find("look like deg/s"), std::string::npos);
        }
        EXPECT_EQ(recording.sensors[0].samples.gyro_rad_per_s[0].z(), rate);
    }
}

TEST(UnitCheck, AGyroscopeOfAnotherHandednessIsToldOf) {
    auto recording = recordingFromMat(turningSensor(-1, 1), "mirrored");
    ASSERT_TRUE(recording);
    convertToSi(*recording);
    ASSERT_EQ(recording->warnings.size(), 1u);
    EXPECT_NE(recording->warnings[0].find("check the gyroscope"), std::string::npos);
}

TEST(MatRecording, MissingPartsAreNamed) {
    MatArrays arrays = turningSensor(1, 1);
    arrays.erase("sampling_rate");
    const auto no_rate = recordingFromMat(arrays, "x");
    ASSERT_FALSE(no_rate);
    EXPECT_NE(no_rate.error().text().find("--rate"), std::string::npos);
    EXPECT_TRUE(recordingFromMat(arrays, "x", 100));
    MatArrays in_struct = arrays;
    in_struct["data.sampling_rate"] = Eigen::MatrixXd::Constant(1, 1, 250);
    const auto member = recordingFromMat(in_struct, "x");
    ASSERT_TRUE(member) << member.error().text();
    EXPECT_EQ(member->sensors[0].samples.rate_hz, 250);
    arrays["imu_acc"].conservativeResize(1999, 3);
    const auto uneven = recordingFromMat(arrays, "x", 100);
    ASSERT_FALSE(uneven);
    EXPECT_NE(uneven.error().message.find("1999"), std::string::npos);
    arrays.erase("imu_gyr");
    EXPECT_NE(recordingFromMat(arrays, "x", 100).error().message.find("imu_acc"), std::string::npos);
}

TEST(ImportTake, KeepsReadingsAndReference) {
    auto recording = recordingFromMat(turningSensor(1, 1), "turning");
    ASSERT_TRUE(recording);
    recording->sensors[0].samples.gyro_rad_per_s[5].setConstant(std::nan(""));
    const size_t rows = recording->sensors[0].samples.size();
    recording->q_world_sensor.assign(rows, Quaterniond::Identity());
    recording->p_world_sensor_m.assign(rows, Vector3d(1, 2, 3));
    recording->moves.assign(rows, 0);
    std::fill_n(recording->moves.begin() + 100, 200, char(1));
    const std::string path =
        (std::filesystem::temp_directory_path() / "noctule_import_test.noctule").string();
    const auto summary =
        writeImportedTake(*recording, {path, "turning", "2026-01-01T00:00:00Z", "test", "u", true}, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->missing, 1u);
    const auto take = Take::open(path);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->level(), TakeLevel::kReadings);
    auto cursor = take->readings(kPrimaryRun);
    ASSERT_TRUE(cursor);
    const auto first = cursor->next();
    ASSERT_TRUE(first && *first);
    EXPECT_NEAR(*(*first)->counts[0], recording->sensors[0].samples.gyro_rad_per_s[0].x(), 1e-12);
    EXPECT_NEAR(*(*first)->magnetometer_counts[2], 20, 1e-12);
    const auto reference = take->reference();
    ASSERT_TRUE(reference) << reference.error().text();
    EXPECT_EQ(reference->frames.size(), rows);
    EXPECT_EQ(take->markers()->size(), 2u);
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace noctule
