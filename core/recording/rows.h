// SPDX-License-Identifier: Apache-2.0
// Rows of a take's tables as values (README.md, sections 2 and 3). Samples count on the clock of the suit;
// pulses, readings, ranges and poses have their types in their own rooms.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

/// What stands in `meta` about the whole take. 0 or empty: missing there.
struct TakeHeader {
    std::string uuid;
    std::string name;
    std::string created_utc;  ///< ISO 8601, Z
    std::string software;
    int64_t sample_rate_hz = 0;
    int board_count = 0;
    int source_count = 0;
    int64_t pulse_interval_samples = 1200;
    double pulse_cycles = 10;
    double drive_hz = 40000;
    std::string take_kind = "motion";               ///< motion, jig, level, turntable
    double g_m_per_s2 = kStandardGravity_m_per_s2;  ///< where it was recorded
    double turntable_rpm = 0;                       ///< nominal; 0: not stated
};

/// What the primary data of a take is.
enum class TakeLevel {
    kSignal,    ///< sound: adc_block and pulse
    kReadings,  ///< inertial and range rows of run 0
};

/// take time = offset_ns + rate * suit time
struct SuitClock {
    double offset_ns = 0;
    double rate = 1;

    bool isTakeTime() const { return offset_ns == 0 && rate == 1; }
    double takeTime_s(double suit_s) const { return offset_ns * 1e-9 + rate * suit_s; }
    double suitTime_s(double take_s) const { return (take_s - offset_ns * 1e-9) / rate; }
};

/// The suit that a Take or an edit looks at; see Take::view().
inline constexpr int kSuitInView = 0;

/// Who wears which suits; the first one carries the actor. A room: anchors that do not move.
struct TakeSubject {
    std::string name;
    std::vector<int> suits;
    bool room = false;

    int suit() const { return suits.front(); }
};

/// `values` holds sample_count * board_count numbers, all boards of the first sample first.
struct AdcBlock {
    int64_t first_sample = 0;
    std::span<const int16_t> values;
};

struct StatusRow {
    int64_t sample = 0;
    std::optional<double> temperature_c, humidity_percent, battery_v, battery_percent;
};

struct GapRow {
    int64_t first_sample = 0;
    int64_t sample_count = 0;
    std::optional<int> board;  ///< absent: all boards
    std::string reason;        ///< link, box, studio, board or empty
};

struct MarkerRow {
    int64_t sample = 0;
    std::string kind;
    std::string label;
};

struct NoteRow {
    std::string created_utc;
    std::string text;
};

/// The root as another system measured it.
struct ExternalRootRow {
    int64_t time_ns = 0;
    Vector3d p_world_root = Vector3d::Zero();
    Quaterniond q_world_root = Quaterniond::Identity();
    double sigma_p_m = 0;
    double sigma_q_rad = 0;
};

/// The attitude of one sensor as an orientation run found it.
struct OrientationRow {
    int board = 0;
    int64_t time_ns = 0;
    Quaterniond q_world_board = Quaterniond::Identity();
    double heading_sigma_rad = 0;
};

/// A suit's clock as a clock run found it: at suit time `time_ns`, take time is time_ns + offset_ns.
struct ClockRow {
    int64_t time_ns = 0;
    double offset_ns = 0;
    double rate = 1;  ///< d take time / d suit time
    double sigma_ns = 0;
};

/// How well a pose run knows the vector from a joint of one suit's body to a joint of another's.
struct RelativeRow {
    int other_suit = 0;  ///< counts from 1
    std::string joint, other_joint;
    int64_t time_ns = 0;                 ///< take time
    Matrix3d cov_m2 = Matrix3d::Zero();  ///< of the vector in the frame of the first body's root
};

/// Both ends belong to it.
struct SampleInterval {
    int64_t first = 0;
    int64_t last = 0;
};

/// The box was lost while the rest pose was held, so that there is no motion. `rest_last`: last sample of it.
inline bool endsInRest(int64_t sample_count, int64_t rest_last) {
    return sample_count <= rest_last;
}

/// A calibration or an actor as stored: several of a suit stand side by side, the highest id is in force.
struct DocumentRow {
    int64_t id = 0;
    int suit = 0;  ///< counts from 1
    std::string created_utc;
};

struct DerivedRun {
    int64_t run = 0;
    std::string kind;  ///< inertial, range, pose
    std::string name;
    std::string created_utc;
    std::string software;
    std::string settings_json;
    std::optional<int64_t> calibration_id, actor_id;
};

/// Rows of one table that could not be used.
struct SkippedRows {
    std::string table;
    int64_t count = 0;
    std::string first;  ///< the first of them and why: "row 7: sample is negative"
};

/// Meta `contacts` (`contacts_2` of suit 2 and so on): whose word on the feet holds.
inline std::string contactsKey(int suit) {
    return suit == 1 ? "contacts" : "contacts_" + std::to_string(suit);
}
inline constexpr const char* kContactsEdited = "edited";
inline constexpr const char* kContactsDetected = "detected";

/// Meta, followed by the number of a pose run that was dropped: no later run is given that number, and those
/// that stay keep their place among all that were ever made.
inline constexpr const char* kDroppedResultKey = "x_dropped_result_";

/// Meta of a take that is made to be played again and again: from where on its second round begins, in
/// seconds. The performer is then as at its end, and the boards' streams go on there without a break.
inline constexpr const char* kLoopsFromKey = "x_loops_from_s";

/// Run number of primary inertial and range rows and of contacts that an operator has set; has no row in
/// `derived`.
inline constexpr int64_t kPrimaryRun = 0;
inline constexpr int64_t kHighestRun = INT32_MAX;  ///< higher ones are damage
/// Later samples (two years at 150 kHz) are damage.
inline constexpr int64_t kLastSample = 10'000'000'000'000;
inline constexpr int64_t kMaxBlockSamples = 65536;

}  // namespace noctule
