// SPDX-License-Identifier: Apache-2.0
// The calibration in force: what turns counts into SI units and arrival times into distances. Values only;
// the solvers are elsewhere. JSON: core/recording/README.md, section 5.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/suit/board_flesh.h"
#include "core/suit/suit.h"

namespace noctule {

/// value (board frame, SI) = matrix * (counts - zero_counts)
struct AxisCalibration {
    Vector3d zero_counts = Vector3d::Constant(2048);
    Matrix3d matrix = Matrix3d::Identity();
    std::optional<Vector3d> sigma_zero_counts;

    Vector3d apply(const Vector3d& counts) const { return matrix * (counts - zero_counts); }
    /// Else of SI values, as other makers' recordings hold them: zero and matrix correct them, nothing clips.
    /// The zeros of 12-bit counts lie near 2048, those of rad/s and m/s^2 below 10.
    bool isOfCounts() const { return zero_counts.cwiseAbs().maxCoeff() > 100; }
    /// zero 2048, full scale / 2048 on the diagonal
    static AxisCalibration nominal(double full_scale);
};

/// When a procedure found values of a part, and how good they are by its own words.
struct CalibrationMade {
    std::string created_utc, verdict;

    bool operator==(const CalibrationMade&) const = default;
};
/// Keys are those of `noctule --batch calibrate`: sources, accelerometers, gyroscopes, magnetometers,
/// inertial, rest-pose, motion.
using CalibrationHistory = std::map<std::string, CalibrationMade>;

struct BoardCalibration {
    std::string id;
    AxisCalibration gyro;                  ///< rad/s
    AxisCalibration accel;                 ///< m/s^2
    std::optional<AxisCalibration> mag{};  ///< microtesla; none: readings are taken as they are
    double mic_delay_s = 0;
    std::optional<Vector3d> p_segment_board_m;  ///< corrected mounting, replaces the suit's
    std::optional<Quaterniond> q_segment_board;
    /// Of q_segment_board, about the board's axes; none: not stated.
    std::optional<Vector3d> sigma_mounting_rad = {};
    std::optional<BoardFlesh> flesh = {};
    std::string serial;  ///< whose values these are; empty: not stated
    CalibrationHistory made;
};

struct SourceCalibration {
    std::string id;
    std::map<std::string, double>
        offsets_s;  ///< detector name -> reported time at distance 0; "start" reserved
    std::map<std::string, double> sigma_s;
    std::optional<double> resonance_hz, q;
    std::optional<Vector3d> p_segment_source_m = {};  ///< corrected place, replaces the suit's
    std::string serial;
    CalibrationHistory made;
};

struct SoundModel {
    enum class Kind { kCramer, kLinear, kFixed } kind = Kind::kCramer;
    double c_m_per_s = 343.2;  ///< kFixed only
    double scale = 1;
};

struct Calibration {
    std::string created_utc;
    std::string box_serial;  ///< of the driver box it was made for; empty: not stated
    SoundModel sound;
    std::vector<SourceCalibration> sources;  ///< any order; look up by id
    std::vector<BoardCalibration> boards;

    const BoardCalibration* findBoard(const std::string& id) const;
    const SourceCalibration* findSource(const std::string& id) const;
};

/// Nominal values for every board of the suit; no source offsets.
Calibration nominalCalibration(const Suit& suit);

nlohmann::json toJson(const Calibration& calibration);
Result<Calibration> calibrationFromJson(const nlohmann::json& json, const std::string& where);

}  // namespace noctule
