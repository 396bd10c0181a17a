// SPDX-License-Identifier: Apache-2.0
#include "core/processing/calibrate_sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/recording/take.h"
#include "core/recording/take_writer.h"
#include "tests/support/files.h"

namespace noctule::test {
namespace {

const Vector3d kHardIron(12, -30, 8);
constexpr const char* kCreated = "2026-03-01T10:00:00Z";

/// One board turned slowly through all directions, or only about the vertical.
std::string turnedTake(const Folder& folder, bool all_directions) {
    const std::string path = folder.file(all_directions ? "all.noctule" : "flat.noctule");
    TakeHeader header;
    header.created_utc = kCreated;
    header.sample_rate_hz = 1'000'000;
    header.board_count = 1;
    Suit suit;
    Board board;
    board.id = "wrist";
    board.has_magnetometer = true;
    suit.boards = {board};
    Calibration calibration;
    BoardCalibration values;
    values.id = "wrist";
    values.gyro.zero_counts = values.accel.zero_counts = Vector3d::Zero();
    calibration.boards = {values};
    auto take = TakeWriter::create(path, header, {});
    EXPECT_TRUE(take);
    EXPECT_TRUE(take->addSuit(suit));
    EXPECT_TRUE(take->addCalibration(calibration));
    EXPECT_TRUE(take->setMeta("level", "readings"));
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0, 0.3);
    for (int i = 0; i < 4000; ++i) {
        const double a = 0.013 * i, b = all_directions ? 0.0021 * i : 0.3;
        const Quaterniond q = Quaterniond(Eigen::AngleAxisd(a, Vector3d::UnitX())) *
                              Quaterniond(Eigen::AngleAxisd(all_directions ? b * 3 : 0, Vector3d::UnitY())) *
                              Quaterniond(Eigen::AngleAxisd(b, Vector3d::UnitZ()));
        const Vector3d field = q.conjugate() * Vector3d(0, -40, 25) + kHardIron +
                               Vector3d(noise(random), noise(random), noise(random));
        const Vector3d up = q.conjugate() * Vector3d(0, kStandardGravity_m_per_s2, 0);
        InertialReading reading;
        reading.board = 0;
        reading.frame = i;
        reading.sample = i * 10'000.0;
        reading.corrected_bits = 0;
        for (size_t axis = 0; axis < 3; ++axis) {
            reading.counts[axis] = 0.1;
            reading.counts[3 + axis] = up[Eigen::Index(axis)];
            reading.magnetometer_counts[axis] = field[Eigen::Index(axis)];
        }
        EXPECT_TRUE(take->addInertial(kPrimaryRun, reading));
    }
    EXPECT_TRUE(take->finish());
    return path;
}

CalibrateRequest requestFor(const std::string& path) {
    CalibrateRequest request;
    request.take_paths = {path};
    request.created_utc = kCreated;
    return request;
}

TEST(CalibrateSensors, AMagnetometersIronIsFoundStoredAndReadBack) {
    const Folder folder;
    const std::string path = turnedTake(folder, true);
    const auto result = calibrateMagnetometers(requestFor(path), {}, {});
    ASSERT_TRUE(result) << result.error().text();
    ASSERT_NE(result->grade(), Grade::kNotUsable) << result->document.findings.front().what;
    ASSERT_TRUE(storeCalibration({path}, result->calibration));
    const auto take = Take::open(path);
    ASSERT_TRUE(take);
    const auto stored = take->calibrationInForce();
    ASSERT_TRUE(stored) << stored.error().text();
    const BoardCalibration* board = stored->value.findBoard("wrist");
    ASSERT_TRUE(board && board->mag);
    EXPECT_LT((board->mag->zero_counts - kHardIron).norm(), 0.5);
    EXPECT_NEAR(board->mag->apply(kHardIron + Vector3d(0, -40, 25)).norm(), std::hypot(40, 25), 0.5);
    EXPECT_EQ(board->made.count("magnetometers"), 1u);
}

TEST(CalibrateSensors, MissingDirectionsAreNamedAndTheValuesStay) {
    const Folder folder;
    const auto result = calibrateMagnetometers(requestFor(turnedTake(folder, false)), {}, {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->grade(), Grade::kNotUsable);
    EXPECT_NE(result->document.findings.front().remedy.find("x"), std::string::npos);
    EXPECT_FALSE(result->calibration.findBoard("wrist")->mag);
}

TEST(CalibrateSensors, ABoardThatNeverLayStillIsRefused) {
    const Folder folder;
    const auto result = calibrateInertial(requestFor(turnedTake(folder, true)), {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->grade(), Grade::kNotUsable);
}

}  // namespace
}  // namespace noctule::test
