// SPDX-License-Identifier: Apache-2.0
#include "core/processing/calibrate_sensors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/processing/field_take.h"
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
                               Vector3d{noise(random), noise(random), noise(random)};
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

Vector3d magnetOf(int board) {
    return 0.5 * (board + 1) * kHardIron;
}

/// Two of our own boards, in counts: 7 readings a second and nothing else.
FieldRecord turnedRecord(int boards_turned, double strength_ut = 48) {
    FieldRecord record;
    record.readings.resize(2);
    record.spot = SpotField{48.2, 0.4, 65.4, 1.9, 40, 12.5};
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    for (int board = 0; board < boards_turned; ++board)
        for (int i = 0; i < 1500; ++i) {
            const Vector3d direction = Vector3d{normal(random), normal(random), normal(random)}.normalized();
            const Vector3d field_ut =
                strength_ut * direction + magnetOf(board) + 0.2 * Vector3d{normal(random), normal(random), 0};
            const Vector3d counts = field_ut.array() * 2048 / 100 + 2048;
            record.readings[size_t(board)].push_back({1000.0 + i * 150000 / 7.0, counts.array().round()});
        }
    return record;
}

Suit twoBoards() {
    Suit suit;
    for (const char* id : {"l_hand", "r_hand"}) {
        Board board;
        board.id = id;
        board.segment = id[0] == 'l' ? "LeftHand" : "RightHand";
        board.has_magnetometer = true;
        suit.boards.push_back(board);
    }
    return suit;
}

FieldTakePlan planOf(const Folder& folder) {
    return {folder.file("magnetometers_001.noctule"), "magnetometers_001", kCreated, "test", 150000, {}};
}

TEST(FieldTake, KeepsReadingsAndTheSpot) {
    const Folder folder;
    FieldRecord record = turnedRecord(2);
    // The box was switched off and counts from zero again.
    for (size_t i = 800; i < 1500; ++i)
        record.readings[0][i].sample -= record.readings[0][800].sample - 5;
    for (int again = 0; again < 2; ++again)
        ASSERT_TRUE(writeFieldTake(planOf(folder), twoBoards(), record)) << "it replaces what stands there";
    Suit other = twoBoards();
    std::swap(other.boards[0], other.boards[1]);
    other.boards.push_back(Board{});
    other.boards.back().id = "new";
    const auto read = readFieldTake(planOf(folder).path, other);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->readings.size(), 3u);
    EXPECT_TRUE(read->readings[2].empty());
    ASSERT_EQ(read->readings[1].size(), 1500u);
    for (size_t i = 0; i < 1500; ++i) {
        EXPECT_EQ(read->readings[1][i].counts, record.readings[0][i].counts);
        if (i > 0) {
            EXPECT_GT(read->readings[1][i].sample, read->readings[1][i - 1].sample);
        }
    }
    ASSERT_TRUE(read->spot);
    EXPECT_EQ(read->spot->strength_ut, 48.2);
    EXPECT_EQ(read->spot->dip_deg, 65.4);
    EXPECT_EQ(read->spot->floor_percent, 12.5);
    EXPECT_FALSE(readFieldTake(folder.file("nothing.noctule"), other));
}

TEST(CalibrateSensors, CountsOfOurBoardsAreMicrotesla) {
    const Folder folder;
    ASSERT_TRUE(writeFieldTake(planOf(folder), twoBoards(), turnedRecord(2)));
    const auto result = calibrateMagnetometers(requestFor(planOf(folder).path), {}, {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->grade(), Grade::kGood);
    for (int board = 0; board < 2; ++board) {
        const BoardCalibration& values = result->calibration.boards[size_t(board)];
        ASSERT_TRUE(values.mag);
        const Vector3d magnet = magnetOf(board);
        EXPECT_LT((values.mag->zero_counts - Vector3d(magnet.array() * 2048 / 100 + 2048)).norm(), 6)
            << "0.3 microtesla";
        EXPECT_NEAR(values.mag->apply((magnet + Vector3d(0, 0, 48)).array() * 2048 / 100 + 2048).norm(), 48,
                    0.5);
    }
    const CalibrationDocument& document = result->document;
    EXPECT_NE(document.summary.find("2 of 2 magnetometers"), std::string::npos) << document.summary;
    EXPECT_EQ(document.numbers.size(), 4u);
    ASSERT_TRUE(document.errors);
    ASSERT_EQ(document.errors->rows.size(), 2u);
    for (const CalibrationErrors::Row& row : document.errors->rows) {
        EXPECT_GT(row.before.size(), 90u);
        EXPECT_EQ(row.before.size(), row.after.size());
        EXPECT_GT(*std::ranges::max_element(row.before), 20) << "as they were read";
        EXPECT_LT(*std::ranges::max_element(row.after), 4);
    }
    EXPECT_EQ(result->json["sphere"].size(), size_t(FieldSphere::kCells));
}

TEST(CalibrateSensors, ABoardThatWasNotTurnedKeepsWhatItHas) {
    const Folder folder;
    FieldTakePlan plan = planOf(folder);
    plan.calibration = nominalCalibration(twoBoards());
    plan.calibration->sound.scale = 1.01;
    plan.calibration->boards[1].mag = AxisCalibration::nominal(90);
    ASSERT_TRUE(writeFieldTake(plan, twoBoards(), turnedRecord(1)));
    const auto result = calibrateMagnetometers(requestFor(plan.path), {}, {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->grade(), Grade::kGood);
    EXPECT_TRUE(result->calibration.boards[0].made.contains("magnetometers"));
    EXPECT_FALSE(result->calibration.boards[1].made.contains("magnetometers"));
    EXPECT_EQ(result->calibration.boards[1].mag->matrix, AxisCalibration::nominal(90).matrix);
    EXPECT_EQ(result->calibration.sound.scale, 1.01) << "what is not calibrated stays";
    ASSERT_TRUE(writeFieldTake(plan, twoBoards(), turnedRecord(0)));
    EXPECT_FALSE(calibrateMagnetometers(requestFor(plan.path), {}, {})) << "nothing was turned";
}

TEST(CalibrateSensors, TooFewDirectionsAreUsableAndSaid) {
    const Folder folder;
    FieldRecord record = turnedRecord(2);
    for (auto& readings : record.readings)
        std::erase_if(readings, [&](const FieldReading& reading) {
            return (reading.field_ut() - magnetOf(&readings == &record.readings[0] ? 0 : 1))
                       .normalized()
                       .dot(Vector3d(0.6, 0, 0.8)) > 0.55;
        });
    ASSERT_TRUE(writeFieldTake(planOf(folder), twoBoards(), record));
    const auto result = calibrateMagnetometers(requestFor(planOf(folder).path), {}, {});
    ASSERT_TRUE(result) << result.error().text();
    ASSERT_EQ(result->grade(), Grade::kUsable);
    EXPECT_EQ(result->document.findings.front().what.find("Board 1, left hand: "), 0u)
        << result->document.findings.front().what;
    EXPECT_NE(result->document.findings.front().what.find(" of 100 directions were seen"), std::string::npos);
    EXPECT_EQ(result->calibration.boards[0].made.at("magnetometers").verdict, "usable");
}

TEST(CalibrateSensors, AFieldThatIsNotTheEarthsIsInTheVerdictAsInTheNumbers) {
    const Folder folder;
    ASSERT_TRUE(writeFieldTake(planOf(folder), twoBoards(), turnedRecord(2, 72)));
    const auto result = calibrateMagnetometers(requestFor(planOf(folder).path), {}, {});
    ASSERT_TRUE(result) << result.error().text();
    const CalibrationDocument& document = result->document;
    EXPECT_EQ(std::ranges::count(document.numbers, Grade::kUsable, &CalibrationNumber::grade), 1);
    EXPECT_EQ(result->grade(), Grade::kUsable);
    EXPECT_NE(document.findings.front().what.find("72.0 µT there, which the Earth's has nowhere"),
              std::string::npos)
        << document.findings.front().what;
    EXPECT_EQ(result->calibration.boards[0].made.at("magnetometers").verdict, "usable");
}

TEST(CalibrateSensors, BeforeAndNowAreOneMeasure) {
    const Folder folder;
    ASSERT_TRUE(writeFieldTake(planOf(folder), twoBoards(), turnedRecord(2)));
    CalibrateRequest request = requestFor(planOf(folder).path);
    const auto first = calibrateMagnetometers(request, {}, {});
    ASSERT_TRUE(first) << first.error().text();
    request.base = first->calibration;
    const auto again = calibrateMagnetometers(request, {}, {});
    ASSERT_TRUE(again) << again.error().text();
    for (int board = 0; board < 2; ++board) {
        const nlohmann::json &then = first->json["boards"][size_t(board)],
                             &now = again->json["boards"][size_t(board)];
        EXPECT_GT(then["spread_before_percent"], 5) << "as it was read";
        EXPECT_NEAR(now["spread_before_percent"], then["spread_after_percent"], 1e-6);
        EXPECT_NEAR(now["spread_after_percent"], then["spread_after_percent"], 1e-6);
    }
    // The sentence, the card and the table tell one number.
    const std::string told = again->document.numbers.front().value;
    EXPECT_NE(again->document.summary.find("even to " + told), std::string::npos) << again->document.summary;
    const auto& rows = again->document.tables.front().rows;
    EXPECT_TRUE(std::ranges::any_of(rows, [&](const auto& row) { return row[3] + " %" == told; }));
}

/// Readings of another maker that are not told apart from ours by a wizard.
TEST(CalibrateSensors, VerdictAndNumbersAgreeForEveryMaker) {
    const Folder folder;
    const auto result = calibrateMagnetometers(requestFor(turnedTake(folder, true)), {}, {});
    ASSERT_TRUE(result) << result.error().text();
    const bool any_doubt = std::ranges::any_of(result->document.numbers, [](const CalibrationNumber& number) {
        return number.grade != Grade::kGood;
    });
    EXPECT_EQ(any_doubt, result->grade() != Grade::kGood);
}

TEST(CalibrateSensors, ABoardThatNeverLayStillIsRefused) {
    const Folder folder;
    const auto result = calibrateInertial(requestFor(turnedTake(folder, true)), {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->grade(), Grade::kNotUsable);
}

}  // namespace
}  // namespace noctule::test
