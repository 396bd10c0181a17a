// SPDX-License-Identifier: Apache-2.0
// What a suit is made of: boards (gyroscope, accelerometer, microphone) and ultrasonic sources, and where
// they sit on the body. Positions in metres in the frame of the segment (the world's when `segment` is empty:
// fixed in the room). JSON: core/recording/README.md, section 4.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/math/conventions.h"

namespace noctule {

/// Of the boards of our own boxes.
inline constexpr double kUsualBoardRate_hz = 140;
inline constexpr double kLeastBoardRate_hz = 10, kMostBoardRate_hz = 1000;

struct Board {
    std::string id;       ///< "l_forearm"
    std::string serial;   ///< empty: unknown
    std::string segment;  ///< canonical joint name; empty: fixed in the world
    Vector3d p_segment_board_m = Vector3d::Zero();
    Quaterniond q_segment_board = Quaterniond::Identity();
    Vector3d p_board_mic_m = Vector3d::Zero();
    bool has_magnetometer = false;  ///< stream imu9
    double gyro_full_scale_rad_per_s = 17.5;
    double accel_full_scale_m_per_s2 = 16 * kStandardGravity_m_per_s2;
    double rate_hz = kUsualBoardRate_hz;  ///< nominal, of its inertial readings
    /// White noise per reading; none: that of the usual chips.
    std::optional<double> gyro_noise_rad_per_s{}, accel_noise_m_per_s2{};
};

struct Source {
    std::string id;
    std::string serial;
    std::string segment;
    Vector3d p_segment_source_m = Vector3d::Zero();
    Vector3d normal_segment = Vector3d::UnitZ();  ///< unit vector of the source's axis
    double nominal_hz = 40000;
    std::string board = {};  ///< in the same housing; empty: none
};

struct Suit {
    std::string name;
    std::vector<Board> boards;    ///< at most kMaxPerSuit
    std::vector<Source> sources;  ///< at most kMaxPerSuit
    /// None: as the take says.
    std::optional<double> carrier_hz{}, pulse_cycles{};
    std::optional<int64_t> pulse_interval_samples{}, sample_rate_hz{};

    static constexpr size_t kMaxPerSuit = 32;

    /// Nobody wears it: anchors in the room.
    bool isFixed() const;
    int findBoard(const std::string& id) const;   ///< -1 when absent
    int findSource(const std::string& id) const;  ///< -1 when absent
    std::vector<int> housings() const;            ///< per source the board in its housing; -1: none
};

nlohmann::json toJson(const Suit& suit);
/// `where` names the file or take in errors.
Result<Suit> suitFromJson(const nlohmann::json& json, const std::string& where);

/// Fails (kUnusable) and names the board or source when a segment is not among the given joint names.
Status checkSegments(const Suit& suit, const std::vector<std::string>& joint_names, const std::string& where);

}  // namespace noctule
