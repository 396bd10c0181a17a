// SPDX-License-Identifier: Apache-2.0
// Does a foot stand? The stance hypothesis optimal detector, a generalised likelihood-ratio test on a short
// window of gyroscope and accelerometer (Skog, Haendel, Nilsson and Rantakokko, "Zero-Velocity Detection - An
// Algorithm Evaluation", IEEE Transactions on Biomedical Engineering 57, 2010, equation 15): a foot that
// stands turns at no rate and feels nothing but gravity, from whatever side. Here the force is carried from
// the board to the point of contact, which rests longer than the board does: a foot that rolls over its ball
// turns about it. Without accelerometers it is the angular-rate energy detector of the same paper.
//
// Each reading counts with its own noise, which the delta-coded stream makes larger in motion, and with what
// a standing foot does (Params). Mean squares are then 1 or less in stance. Two limits give hysteresis.
#pragma once

#include <optional>
#include <vector>

#include "core/estimation/measurement.h"

namespace noctule {

struct StanceParameters {
    bool uses_accelerometers = true;
    double g_m_per_s2 = kStandardGravity_m_per_s2;
    double window_s = 0.04;
    /// What a standing foot does, per axis; larger: contacts begin earlier, end later, and soon are false.
    double rolling_rad_per_s = 0.7, shaking_m_per_s2 = 1.1;
    double touch = 1, leave = 2.5;   ///< of the statistic
    double least_contact_s = 0.06;   ///< shorter ones are turning points of a swing
    double longest_silence_s = 0.1;  ///< lost frames: what is not heard does not stand
};

class StanceDetector {
public:
    /// `p_board_contact_m`: the point of contact in the board's frame.
    StanceDetector(const StanceParameters& parameters, const Vector3d& p_board_contact_m)
        : parameters_(parameters), p_board_contact_m_(p_board_contact_m) {}

    /// What is known without readings: it has stood since then, and does until they say otherwise.
    void standsFrom(double since_s, double now_s);
    /// Readings of the foot's board in order of time; `gyro_bias` as far as it is known.
    void add(const InertialMeasurement& measurement, const Vector3d& gyro_bias);

    /// When the foot came to stand; nothing while it does not, or has not yet for least_contact_s.
    std::optional<double> standsSince_s(double now_s) const;

private:
    struct Sample {
        double time_s = 0;
        Vector3d omega_rad_per_s = Vector3d::Zero(), force_m_per_s2 = Vector3d::Zero();  ///< board's frame
        double omega_variance = 0, force_variance = 0;                                   ///< noise, per axis
    };
    Sample sampleOf(const InertialMeasurement& measurement, const Vector3d& rate,
                    const Vector3d& force) const;
    double statistic() const;
    void begin();

    StanceParameters parameters_;
    Vector3d p_board_contact_m_;
    std::vector<Sample> window_;
    double heard_s_ = -1e9;  ///< when something was last known
    std::optional<double> still_since_s_;
};

}  // namespace noctule
