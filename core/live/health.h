// SPDX-License-Identifier: Apache-2.0
// How a suit fares while it is worn: per board, per pair of source and board, and as a whole. Rates are over
// the last second of the suit's clock. Push what comes, ask for a report at any time; no threads, no clocks.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/acoustics/range.h"
#include "core/inertial/reading.h"
#include "core/live/sliding_maximum.h"
#include "core/live/sliding_sum.h"
#include "core/suit/suit.h"

namespace noctule {

struct BoardHealth {
    double frames_per_s = 0;  ///< trusted ones; 140 is perfect
    int64_t frames_lost = 0;  ///< in the last second
    int64_t bits_corrected = 0;
    int64_t frames_lost_in_all = 0, bits_corrected_in_all = 0;
    double signal_counts = 0;     ///< root mean square of the wire, sound and digital stream together
    double peak_counts = 0;       ///< largest magnitude of the wire in the last second
    int64_t clipped_samples = 0;  ///< of the wire, in the last second
    int64_t clipped_readings = 0;
    bool silent = true;  ///< nothing but zeros for a second: unplugged
    double ranges_per_s = 0;
    bool still = false;  ///< a whole second of readings without motion, or of an even turn
    /// Of the last second: means, and the deviation of the worst axis. Absent with too few readings.
    struct Means {
        Vector3d gyro_counts = Vector3d::Zero(), accel_counts = Vector3d::Zero();
        double gyro_deviation_rad_per_s = 0, accel_deviation_m_per_s2 = 0;
    };
    std::optional<Means> means = {};
    /// The last whole reading of the magnetometer; absent: none has come.
    struct Field {
        double sample = 0;
        Vector3d counts = Vector3d::Zero();
    };
    std::optional<Field> field = {};
};

struct PairHealth {
    std::optional<double> age_s;  ///< of the last range; absent: never heard
    double confidence = 0;        ///< of that one
    double heard = 0;             ///< of its sound alone, without what the pose made of it
    double distance_m = 0;
};

/// What the box says; absent: not measured.
struct SuitStatus {
    int64_t sample = 0;
    std::optional<double> temperature_c, humidity_percent, battery_v, battery_percent;
};

struct HealthReport {
    int64_t sample = 0;  ///< as of
    std::vector<BoardHealth> boards;
    std::vector<PairHealth> pairs;  ///< source * boards + board
    SuitStatus suit;

    const PairHealth& pair(int source, int board) const {
        return pairs[static_cast<size_t>(source) * boards.size() + static_cast<size_t>(board)];
    }
};

struct HealthSettings {
    /// Deviations over a second below which a board counts as lying still. A standing person sways with 0.02
    /// rad/s; a count is 0.0085 rad/s and 0.077 m/s^2.
    double still_gyro_rad_per_s = 0.03;
    double still_accel_m_per_s2 = 0.2;
};

class HealthMonitor {
public:
    HealthMonitor(const Suit& suit, int sample_rate_hz, const HealthSettings& settings = {});

    void add(const InertialReading& reading);
    void add(const RangeMeasurement& range);
    void add(const SuitStatus& status) { report_.suit = status; }
    /// Sample-interleaved values of all boards.
    void addBlock(int64_t first_sample, std::span<const int16_t> interleaved);

    HealthReport report();

private:
    struct BoardWindow {
        explicit BoardWindow(int64_t window);
        SlidingSum trusted, lost, corrected, clipped_readings, ranges;
        SlidingSum wire_power, wire_samples, wire_clipped, wire_alive;
        SlidingMaximum wire_peak;
        std::vector<SlidingSum> axes;  ///< gyro xyz, accelerometer xyz, counts
    };
    void addWire(int board, int64_t first_sample, std::span<const int16_t> interleaved);
    void advance(BoardWindow& window) const;
    BoardHealth healthOf(size_t board);
    std::optional<BoardHealth::Means> meansOf(size_t board) const;

    Suit suit_;
    int sample_rate_hz_;
    HealthSettings settings_;
    std::vector<BoardWindow> windows_;
    std::vector<double> heard_at_;  ///< pulse's sample per pair, -1: never
    HealthReport report_;
};

}  // namespace noctule
