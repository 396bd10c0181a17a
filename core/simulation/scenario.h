// SPDX-License-Identifier: Apache-2.0
// How good or bad the world is that a simulated suit meets: every number of the three scenarios, each effect
// a member of its own that a test may switch. Sigmas are Gaussian, pairs are the bounds of a uniform draw
// made once per take. The defaults are what all scenarios share with every disturbance switched off: `ideal`.
// A test compares all of it with the published table (tests/data/simulation/scenarios.json).
#pragma once

#include <optional>
#include <string>

#include "core/job/result.h"
#include "core/simulation/cast_scenario.h"
#include "core/simulation/sound_scenario.h"

namespace noctule::simulation {

/// Down to the sampled sound, or inertial and range rows straight from error models.
enum class Level { kSignal, kReadings };

/// A board on flesh: a damped oscillator driven by the segment's acceleration, and slow shifts with the pose.
struct SoftTissue {
    double natural_hz = 12, damping = 0.3;
    double displacement_m_at_30_m_per_s2 = 0.005;
    double rotation_rad_at_30_m_per_s2 = 0.052;
    double pose_rotation_rad_max = 0.07;
    double pose_displacement_m_max = 0.015;
    double axial_twist_lag = 0.1;  ///< share of the axial twist that a board on forearm or thigh misses
};

/// The rigs of calibration.
struct RigScenario {
    int jig_placements = 6;
    Bounds jig_range_m{0.3, 0.9};  ///< of the distances between sources and boards
    double digitizer_sigma_m = 5e-5;
    double turntable_rpm = 45, turntable_speed_error = 0.0008;      ///< relative, constant in a take
    double turntable_tilt_deg = 0.3, level_plate_error_deg = 0.05;  ///< about each horizontal axis
};

struct Scenario {
    std::string name = "ideal";

    // Clock, pulses, motion
    int sample_rate_hz = 150000;
    double pulse_interval_s = 0.008;
    int pulse_cycles = 10;
    double drive_hz = 40000;
    std::optional<std::vector<int>> enabled_sources;  ///< none: all of them, in turn
    PulseSchedule schedule() const;
    double motion_low_pass_hz = 7;
    double rest_seconds = 3;

    // Inertia, as the board's chips see it
    double gyro_noise_rad_per_s = 0, accel_noise_m_per_s2 = 0;  ///< white, per reading
    bool codec = false;  ///< readings level only; at signal level the stream is always coded
    double gyro_zero_counts = 40, accel_zero_counts = 60;  ///< spread of the zeros around 2048
    double gyro_scale_spread = 0.02, accel_scale_spread = 0.015;
    double axis_misalignment_deg = 0.6;
    double gyro_bias_rad_per_s = 0, accel_bias_m_per_s2 = 0;  ///< constant, unknown to the calibration
    double gyro_bias_walk_rad_per_s_per_sqrt_s = 0;
    double gyro_matrix_error = 0, accel_matrix_error = 0;  ///< of the calibration, per relative element
    double stream_amplitude_counts = 300;

    // Sound
    SoundScenario sound;
    double source_offset_error_s = 0;  ///< of the calibration

    // Air
    Bounds temperature_c{22, 22};
    Bounds humidity_percent{30, 65};
    double temperature_error_c = 0;  ///< of the thermometer, constant in a take
    double temperature_noise_c = 0.05, humidity_noise_percent = 1;  ///< of each status row

    // The suit on the body
    double mounting_rad = 0, mounting_m = 0;  ///< of boards, per axis
    double source_position_m = 0;             ///< of sources, per axis
    double bone_scale = 0;                    ///< moving bones against those of the actor in the take
    std::optional<SoftTissue> soft_tissue;
    double initial_pose_rad = 0;    ///< per freedom, of the rest pose as held
    bool unreduced_motion = false;  ///< all joints move with three freedoms, as in the source

    // Root as another system measures it
    double external_root_rate_hz = 120;
    double external_root_sigma_position_m = 0.0005, external_root_sigma_rotation_rad = 0.0017;

    RigScenario rigs;
    CastScenario cast;

    static Scenario ideal();
    static Scenario nominal();
    static Scenario realistic();
    /// By name; kUsage for any other.
    static Result<Scenario> named(const std::string& name);
};

}  // namespace noctule::simulation
