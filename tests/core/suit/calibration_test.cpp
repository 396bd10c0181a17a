// SPDX-License-Identifier: Apache-2.0
#include "core/suit/calibration.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/suit/default_suit.h"
#include "tests/core/suit/damage.h"

namespace noctule {
namespace {

using namespace test;
using Json = nlohmann::json;

Json smallCalibration() {
    return Json::parse(
        R"({"format": "noctule-calibration", "version": 1, "created_utc": "2026-11-12T11:17:00Z",
        "box_serial": "NB-000007", "sound": {"model": "fixed", "c_m_per_s": 345.5, "scale": 1.001}, "x_lab": true,
        "sources": [{"id": "hat", "offsets_s": {"start": 1.5e-5, "inflection": 1.3e-4},
                     "sigma_s": {"inflection": 2e-6}, "resonance_hz": 40450, "q": 31},
                    {"id": "navel"}],
        "boards": [{"id": "hips", "serial": "NB-17", "mic_delay_s": 1e-6,
                    "made": {"gyroscopes": {"created_utc": "2026-11-11T09:00:00Z", "verdict": "good"}},
                    "gyro": {"zero_counts": [2047, 2050, 2040], "sigma_zero_counts": [1, 2, 3],
                             "matrix": [[0.008, 0, 0], [0, 0.009, 0.0001], [0, 0, 0.01]]},
                    "accel": {"zero_counts": [2048, 2048, 2048], "matrix": [[0.07, 0, 0], [0, 0.07, 0], [0, 0, 0.07]]},
                    "p_segment_board_m": [0, 0.1, 0.2], "q_segment_board": [0.5, 0.5, 0.5, 0.5],
                    "sigma_mounting_rad": [0.01, 0.02, 0.03],
                    "flesh": {"joints": [null, "Spine"],
                              "tilt_rad": [[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0.01, 0.02, 0.03], [0, 0, 0]],
                              "shift_m": [[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0.002, 0]]}}]})");
}

TEST(Calibration, ReadsEveryMember) {
    const Result<Calibration> read = calibrationFromJson(smallCalibration(), "c.json");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->created_utc, "2026-11-12T11:17:00Z");
    EXPECT_EQ(read->box_serial, "NB-000007");
    EXPECT_EQ(read->sound.kind, SoundModel::Kind::kFixed);
    EXPECT_EQ(read->sound.c_m_per_s, 345.5);
    EXPECT_EQ(read->sound.scale, 1.001);
    const SourceCalibration* hat = read->findSource("hat");
    ASSERT_NE(hat, nullptr);
    EXPECT_EQ(hat->offsets_s.at("inflection"), 1.3e-4);
    EXPECT_EQ(hat->offsets_s.at("start"), 1.5e-5);
    EXPECT_EQ(hat->sigma_s.at("inflection"), 2e-6);
    EXPECT_EQ(hat->resonance_hz, 40450);
    EXPECT_EQ(hat->q, 31);
    EXPECT_TRUE(read->findSource("navel")->offsets_s.empty());
    EXPECT_EQ(read->findSource("nobody"), nullptr);
    const BoardCalibration* hips = read->findBoard("hips");
    ASSERT_NE(hips, nullptr);
    EXPECT_EQ(hips->serial, "NB-17");
    EXPECT_EQ(hips->made.at("gyroscopes"), (CalibrationMade{"2026-11-11T09:00:00Z", "good"}));
    EXPECT_TRUE(hat->serial.empty() && hat->made.empty());
    EXPECT_EQ(hips->mic_delay_s, 1e-6);
    EXPECT_EQ(hips->gyro.matrix(1, 2), 0.0001);
    EXPECT_EQ(hips->gyro.sigma_zero_counts, Vector3d(1, 2, 3));
    EXPECT_FALSE(hips->accel.sigma_zero_counts);
    EXPECT_EQ(hips->gyro.apply({2048, 2051, 2050}), Vector3d(0.008, 0.009 + 0.001, 0.1));
    EXPECT_EQ(hips->p_segment_board_m, Vector3d(0, 0.1, 0.2));
    EXPECT_EQ(hips->q_segment_board->z(), 0.5);
    EXPECT_EQ(hips->sigma_mounting_rad, Vector3d(0.01, 0.02, 0.03));
    ASSERT_TRUE(hips->flesh);
    EXPECT_EQ(hips->flesh->joints, (std::array<std::string, 2>{"", "Spine"}));
    EXPECT_EQ(hips->flesh->tilt_rad.col(4), Vector3d(0.01, 0.02, 0.03));
    EXPECT_EQ(hips->flesh->shift_m.col(5), Vector3d(0, 0.002, 0));
}

TEST(Calibration, WriteReadEqual) {
    for (const Calibration& original :
         {*calibrationFromJson(smallCalibration(), "c"), nominalCalibration(defaultSuit())}) {
        const Result<Calibration> again = calibrationFromJson(Json::parse(toJson(original).dump()), "again");
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(toJson(*again), toJson(original));
    }
}

TEST(Calibration, NominalTurnsFullScaleIntoFullScale) {
    const Calibration nominal = nominalCalibration(defaultSuit());
    ASSERT_EQ(nominal.boards.size(), 18u);
    EXPECT_TRUE(nominal.sources.empty());
    const BoardCalibration* foot = nominal.findBoard("r_foot");
    ASSERT_NE(foot, nullptr);
    EXPECT_DOUBLE_EQ(foot->gyro.apply(Vector3d::Constant(4096)).y(), 17.5);
    EXPECT_DOUBLE_EQ(foot->accel.apply(Vector3d::Constant(0)).z(), -156.9064);
    EXPECT_EQ(foot->accel.apply(Vector3d::Constant(2048)), Vector3d(0, 0, 0));
}

class DamagedCalibration : public testing::TestWithParam<Damage> {};

TEST_P(DamagedCalibration, IsRefusedByName) {
    Json calibration = smallCalibration();
    calibration[Json::json_pointer(GetParam().pointer)] = GetParam().value;
    const Result<Calibration> result = calibrationFromJson(calibration, "c.json");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, GetParam().kind) << result.error().text();
    EXPECT_NE(result.error().message.find(GetParam().named), std::string::npos) << result.error().text();
    EXPECT_FALSE(result.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedCalibration,
    testing::Values(
        Damage{"", Json(3), ErrorKind::kUnreadable, "c.json"},
        Damage{"/format", "noctule-suit", ErrorKind::kUnreadable, "is not a calibration"},
        Damage{"/version", 2, ErrorKind::kUnreadable, "version"},
        Damage{"/sound/model", "guess", ErrorKind::kUnusable, "model"},
        Damage{"/sound/c_m_per_s", nullptr, ErrorKind::kUnreadable, "c_m_per_s"},
        Damage{"/sound/scale", 0, ErrorKind::kUnusable, "scale"},
        Damage{"/sources/0/offsets_s/inflection", kNan, ErrorKind::kUnreadable,
               "source 1 'hat': 'offsets_s'"},
        Damage{"/sources/0/offsets_s", Json::array({1}), ErrorKind::kUnreadable, "offsets_s"},
        Damage{"/sources/0/q", -1, ErrorKind::kUnusable, "'q'"},
        Damage{"/sources/1/id", "hat", ErrorKind::kUnusable, "twice"},
        Damage{"/boards/0/made/gyroscopes", 3, ErrorKind::kUnreadable, "made: gyroscopes"},
        Damage{"/box_serial", 7, ErrorKind::kUnreadable, "box_serial"},
        Damage{"/sources/0/serial", 7, ErrorKind::kUnreadable, "serial"},
        Damage{"/boards/0/gyro", nullptr, ErrorKind::kUnreadable, "board 1 'hips': gyro"},
        Damage{"/boards/0/gyro/matrix/1/1", kNan, ErrorKind::kUnreadable, "matrix"},
        Damage{"/boards/0/accel/matrix/2", Json::array({0, 0, 0}), ErrorKind::kUnusable, "accel: 'matrix'"},
        Damage{"/boards/0/accel/matrix", Json::array({1, 2, 3}), ErrorKind::kUnreadable, "matrix"},
        Damage{"/boards/0/accel/zero_counts", Json::array({1, 2}), ErrorKind::kUnreadable, "zero_counts"},
        Damage{"/boards/0/q_segment_board", Json::array({0, 0, 0, 0}), ErrorKind::kUnreadable,
               "q_segment_board"},
        Damage{"/boards/0/sigma_mounting_rad", 0.01, ErrorKind::kUnreadable, "sigma_mounting_rad"},
        Damage{"/boards/0/flesh", 2, ErrorKind::kUnreadable, "flesh"},
        Damage{"/boards/0/flesh/joints/1", 7, ErrorKind::kUnreadable, "flesh: 'joints'"},
        Damage{"/boards/0/flesh/tilt_rad/5", nullptr, ErrorKind::kUnreadable, "flesh: 'tilt_rad'"},
        Damage{"/boards/0/flesh/shift_m", Json::array({1}), ErrorKind::kUnreadable, "flesh: 'shift_m'"},
        Damage{"/boards/0/mic_delay_s", "late", ErrorKind::kUnreadable, "mic_delay_s"},
        Damage{"/boards", 5, ErrorKind::kUnreadable, "boards"}));

}  // namespace
}  // namespace noctule
