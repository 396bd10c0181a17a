// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/scenario.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace noctule::simulation {
namespace {

using Json = nlohmann::json;

Json published() {
    std::ifstream file(NOCTULE_TEST_DATA "/simulation/scenarios.json");
    return Json::parse(file);
}

/// All of a scenario's members under the names of the published table.
std::map<std::string, Json> members(const Scenario& s) {
    return {{"sample_rate_hz", s.sample_rate_hz},
            {"pulse_interval_s", s.pulse_interval_s},
            {"pulse_cycles", s.pulse_cycles},
            {"drive_hz", s.drive_hz},
            {"motion_low_pass_hz", s.motion_low_pass_hz},
            {"rest_seconds", s.rest_seconds},
            {"absorption_db_per_m", s.sound.absorption_db_per_m},
            {"amplitude_counts_at_1m", s.sound.amplitude_counts_at_1m},
            {"stream_amplitude_counts", s.stream_amplitude_counts},
            {"humidity_percent", s.humidity_percent},
            {"source_start_delay_s", s.sound.source_start_delay_s},
            {"board_mic_delay_s", s.sound.board_mic_delay_s},
            {"gyro_zero_counts", s.gyro_zero_counts},
            {"accel_zero_counts", s.accel_zero_counts},
            {"gyro_scale_spread", s.gyro_scale_spread},
            {"accel_scale_spread", s.accel_scale_spread},
            {"axis_misalignment_deg", s.axis_misalignment_deg},
            {"gyro_noise_rad_per_s", s.gyro_noise_rad_per_s},
            {"accel_noise_m_per_s2", s.accel_noise_m_per_s2},
            {"codec", s.codec},
            {"acoustic_noise_counts", s.sound.acoustic_noise_counts},
            {"low_frequency_noise_counts", s.sound.low_frequency_noise_counts},
            {"reflections", s.sound.reflections},
            {"impulses_per_s", s.sound.impulses_per_s},
            {"occlusion", s.sound.occlusion},
            {"source_resonance_hz", s.sound.source_resonance_hz},
            {"source_q", s.sound.source_q},
            {"source_gain_db", s.sound.source_gain_db},
            {"board_gain_db", s.sound.board_gain_db},
            {"gyro_bias_rad_per_s", s.gyro_bias_rad_per_s},
            {"gyro_bias_walk_rad_per_s_per_sqrt_s", s.gyro_bias_walk_rad_per_s_per_sqrt_s},
            {"accel_bias_m_per_s2", s.accel_bias_m_per_s2},
            {"gyro_matrix_error", s.gyro_matrix_error},
            {"accel_matrix_error", s.accel_matrix_error},
            {"source_offset_error_s", s.source_offset_error_s},
            {"mounting_rad", s.mounting_rad},
            {"mounting_m", s.mounting_m},
            {"source_position_m", s.source_position_m},
            {"bone_scale", s.bone_scale},
            {"initial_pose_rad", s.initial_pose_rad},
            {"temperature_c", s.temperature_c},
            {"temperature_error_c", s.temperature_error_c}};
}

void expectListed(const Json& table, const Scenario& scenario) {
    // Texts, and numbers that belong to the suit, to rigs or are compared by name below.
    const std::vector<std::string> elsewhere = {"motion_filter",
                                                "boards",
                                                "sources",
                                                "gyro_full_scale_rad_per_s",
                                                "accel_full_scale_m_per_s2",
                                                "external_root",
                                                "amplitude_meaning",
                                                "status_noise",
                                                "directivity",
                                                "reflectors",
                                                "occlusion_late_path",
                                                "jig",
                                                "turntable",
                                                "level_plate_error_deg",
                                                "about",
                                                "soft_tissue",
                                                "diffraction",
                                                "acoustic_noise_counts_meaning",
                                                "temperature_error_meaning"};
    const std::map<std::string, Json> ours = members(scenario);
    for (const auto& [name, value] : table.items()) {
        if (std::find(elsewhere.begin(), elsewhere.end(), name) != elsewhere.end())
            continue;
        const auto found = ours.find(name);
        ASSERT_NE(found, ours.end()) << name << " is no member of Scenario";
        EXPECT_EQ(found->second, value) << scenario.name << ": " << name;
    }
}

TEST(Scenario, EqualsThePublishedTable) {
    const Json table = published();
    for (const Scenario& scenario : {Scenario::ideal(), Scenario::nominal(), Scenario::realistic()})
        expectListed(table["common"], scenario);
    expectListed(table["ideal"], Scenario::ideal());
    expectListed(table["nominal"], Scenario::nominal());
    Json realistic = table["nominal"];
    realistic.update(table["realistic"]);
    expectListed(realistic, Scenario::realistic());
}

TEST(Scenario, NestedNumbersEqualThePublishedTable) {
    const Json common = published()["common"];
    const Scenario s = Scenario::nominal();
    EXPECT_EQ(common["external_root"]["rate_hz"], s.external_root_rate_hz);
    EXPECT_EQ(common["external_root"]["sigma_position_m"], s.external_root_sigma_position_m);
    EXPECT_EQ(common["external_root"]["sigma_rotation_rad"], s.external_root_sigma_rotation_rad);
    EXPECT_EQ(common["status_noise"]["temperature_c"], s.temperature_noise_c);
    EXPECT_EQ(common["status_noise"]["humidity_percent"], s.humidity_noise_percent);
    EXPECT_EQ(s.sound.ka, (Bounds{2.8, 3.6}));
    EXPECT_EQ(s.sound.behind_source_db, -20);
    EXPECT_EQ(s.sound.late_path_db, -20);
    EXPECT_EQ(s.sound.late_path_db_per_cm, -4);
    EXPECT_TRUE(s.sound.late_path);
    EXPECT_FALSE(Scenario::ideal().sound.late_path);
}

TEST(Scenario, RigsEqualThePublishedTable) {
    const Json common = published()["common"];
    for (const Scenario& scenario : {Scenario::ideal(), Scenario::nominal(), Scenario::realistic()}) {
        const RigScenario& rigs = scenario.rigs;
        EXPECT_EQ(common["jig"]["placements"], rigs.jig_placements);
        EXPECT_EQ(common["jig"]["range_m"], rigs.jig_range_m);
        EXPECT_EQ(common["jig"]["digitizer_sigma_m"], rigs.digitizer_sigma_m);
        EXPECT_EQ(common["turntable"]["rpm"], rigs.turntable_rpm);
        EXPECT_EQ(common["turntable"]["speed_error"], rigs.turntable_speed_error);
        EXPECT_EQ(common["turntable"]["tilt_deg"], rigs.turntable_tilt_deg);
        EXPECT_EQ(common["level_plate_error_deg"], rigs.level_plate_error_deg);
    }
}

TEST(Scenario, SoftTissueEqualsThePublishedTable) {
    const Json soft = published()["realistic"]["soft_tissue"];
    const SoftTissue s = Scenario::realistic().soft_tissue.value();
    EXPECT_EQ(soft["wobble"]["natural_hz"], s.natural_hz);
    EXPECT_EQ(soft["wobble"]["damping"], s.damping);
    EXPECT_EQ(soft["wobble"]["displacement_m_at_30_m_per_s2"], s.displacement_m_at_30_m_per_s2);
    EXPECT_EQ(soft["wobble"]["rotation_rad_at_30_m_per_s2"], s.rotation_rad_at_30_m_per_s2);
    EXPECT_EQ(soft["pose_dependent"]["rotation_rad_max"], s.pose_rotation_rad_max);
    EXPECT_EQ(soft["pose_dependent"]["displacement_m_max"], s.pose_displacement_m_max);
    EXPECT_EQ(soft["pose_dependent"]["axial_twist_lag_forearm_thigh"], s.axial_twist_lag);
    EXPECT_FALSE(Scenario::nominal().soft_tissue);
}

TEST(Scenario, UnknownNameIsAUsageErrorThatNamesIt) {
    const Result<Scenario> scenario = Scenario::named("hard");
    ASSERT_FALSE(scenario);
    EXPECT_EQ(scenario.error().kind, ErrorKind::kUsage);
    EXPECT_NE(scenario.error().message.find("hard"), std::string::npos);
    EXPECT_EQ(Scenario::named("realistic").value().bone_scale, 0.02);
}

}  // namespace
}  // namespace noctule::simulation
