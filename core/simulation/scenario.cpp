// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/scenario.h"

#include <cmath>

namespace noctule::simulation {

Scenario Scenario::ideal() {
    Scenario s;
    s.sound.source_start_delay_s = {4e-6, 3e-5};
    s.sound.board_mic_delay_s = 1e-6;
    s.sound.ka = {2.8, 3.6};
    return s;
}

Scenario Scenario::nominal() {
    Scenario s = ideal();
    s.name = "nominal";
    s.gyro_noise_rad_per_s = 0.002;
    s.accel_noise_m_per_s2 = 0.02;
    s.codec = true;
    s.gyro_bias_rad_per_s = 0.005;
    s.accel_bias_m_per_s2 = 0.03;
    s.gyro_bias_walk_rad_per_s_per_sqrt_s = 0.0002;
    s.gyro_matrix_error = 0.0003;
    s.accel_matrix_error = 0.001;
    s.sound.acoustic_noise_counts = 8;
    s.sound.low_frequency_noise_counts = 30;
    s.sound.impulses_per_s = 0.2;
    s.sound.reflections = true;
    s.sound.late_path = true;
    s.sound.source_resonance_hz = {39600, 40600};
    s.sound.source_q = {15, 35};
    s.sound.source_gain_db = 1.5;
    s.sound.board_gain_db = 1.5;
    s.source_offset_error_s = 1.5e-6;
    s.temperature_c = {18, 29};
    s.temperature_error_c = 0.5;
    s.initial_pose_rad = 0.0087;
    s.cast.clock_rate_error = {-20e-6, 20e-6};
    s.cast.clock_wander_s_per_sqrt_s = 0.5e-6;
    s.cast.survey_m = 0.003;
    s.cast.housing_m = 0.0005;
    return s;
}

Scenario Scenario::realistic() {
    Scenario s = nominal();
    s.name = "realistic";
    s.mounting_rad = 0.052;
    s.mounting_m = 0.005;
    s.source_position_m = 0.0035;
    s.bone_scale = 0.02;
    s.soft_tissue = SoftTissue{};
    s.initial_pose_rad = 0.035;
    s.unreduced_motion = true;
    s.temperature_error_c = 2;
    s.gyro_bias_walk_rad_per_s_per_sqrt_s = 0.0005;
    s.sound.impulses_per_s = 1;
    s.sound.acoustic_noise_counts = 15;
    s.cast.clock_rate_wander_per_sqrt_s = 0.05e-6;
    s.cast.survey_m = 0.01;
    s.cast.housing_m = 0.001;
    return s;
}

PulseSchedule Scenario::schedule() const {
    return {static_cast<int>(std::lround(pulse_interval_s * sample_rate_hz)), pulse_cycles, drive_hz,
            enabled_sources};
}

Result<Scenario> Scenario::named(const std::string& name) {
    for (const Scenario& scenario : {ideal(), nominal(), realistic()})
        if (scenario.name == name)
            return scenario;
    return Error{ErrorKind::kUsage, "There is no scenario \"" + name + "\"",
                 "Choose ideal, nominal or realistic"};
}

}  // namespace noctule::simulation
