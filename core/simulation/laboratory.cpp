// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/laboratory.h"

#include "core/acoustics/inflection_detector.h"
#include "core/math/json.h"

namespace noctule::simulation {
namespace {

using Json = nlohmann::json;

Json axesJson(const ChipTruth& chip) {
    Json matrix = Json::array();
    for (int i = 0; i < 3; ++i)
        matrix.push_back(json::fromVector(chip.calibration.matrix.row(i)));
    return {{"zero_counts", json::fromVector(chip.calibration.zero_counts)},
            {"matrix", matrix},
            {"bias", json::fromVector(chip.bias)},
            {"noise", chip.noise},
            {"bias_walk_per_sqrt_s", chip.bias_walk_per_sqrt_s}};
}

Json shiftJson(const PoseShift& shift) {
    Json rows = Json::array();
    for (const auto& row : shift.slope.rowwise())
        rows.push_back(std::vector<double>(row.begin(), row.end()));
    return {{"bound", shift.bound}, {"slope", rows}};
}

Json tissueJson(const WornBoard& worn) {
    return {{"shift_m", shiftJson(worn.shift_m)},
            {"tilt_rad", shiftJson(worn.tilt_rad)},
            {"axial_twist_lag", worn.twist_lag},
            {"wobble_axis", json::fromVector(worn.wobble_axis)}};
}

std::vector<double> inflectionOffsets(const Scenario& scenario, const SoundTruth& sound) {
    const PulseSchedule schedule = scenario.schedule();
    const PulseTrain train{static_cast<double>(scenario.sample_rate_hz), schedule.interval_samples,
                           schedule.drive_hz, schedule.cycles};
    Result<std::unique_ptr<PulseDetector>> detector = makeDetector(Detector::kInflection, train);
    std::vector<double> offsets_s;
    for (const SourceTruth& source : sound.sources)
        offsets_s.push_back(
            source.start_delay_s +
            (detector ? detectorResponse(**detector, train, source.resonance_hz, source.q).delay_s : 0));
    return offsets_s;
}

}  // namespace

HiddenTruth drawHiddenTruth(const Suit& suit, const Scenario& scenario, uint64_t seed) {
    HiddenTruth truth;
    truth.seed = seed;
    truth.air = drawAir(scenario, seed);
    truth.sound = drawSoundTruth(scenario.sound, static_cast<int>(suit.sources.size()),
                                 static_cast<int>(suit.boards.size()), seed);
    truth.inflection_offset_s = inflectionOffsets(scenario, truth.sound);
    for (size_t b = 0; b < suit.boards.size(); ++b)
        truth.inertia.push_back(drawInertialTruth(suit.boards[b], scenario, seed, b));
    return truth;
}

Calibration laboratoryCalibration(const Suit& suit, const Scenario& scenario, const HiddenTruth& truth) {
    Calibration calibration;
    for (size_t s = 0; s < suit.sources.size(); ++s) {
        const double error_s =
            Random(truth.seed, "source offset error", s).gaussian(scenario.source_offset_error_s);
        const SourceTruth& source = truth.sound.sources[s];
        SourceCalibration found;
        found.id = suit.sources[s].id;
        found.offsets_s = {{"start", source.start_delay_s + error_s},
                           {"inflection", truth.inflection_offset_s[s] + error_s}};
        if (scenario.source_offset_error_s > 0)
            found.sigma_s = {{"start", scenario.source_offset_error_s},
                             {"inflection", scenario.source_offset_error_s}};
        found.resonance_hz = source.resonance_hz;
        found.q = source.q;
        calibration.sources.push_back(found);
    }
    for (size_t b = 0; b < suit.boards.size(); ++b) {
        const InertialTruth& board = truth.inertia[b];
        BoardCalibration found;
        found.id = suit.boards[b].id;
        found.gyro = asCalibrated(board.gyro.calibration, scenario.gyro_matrix_error,
                                  Random(truth.seed, "gyro calibration", b));
        found.accel = asCalibrated(board.accel.calibration, scenario.accel_matrix_error,
                                   Random(truth.seed, "accel calibration", b));
        found.mic_delay_s = truth.sound.boards[b].mic_delay_s;
        if (scenario.mounting_rad == 0)
            found.sigma_mounting_rad = Vector3d::Zero();  // boards hang exactly as the suit says
        calibration.boards.push_back(found);
    }
    return calibration;
}

nlohmann::json toJson(const HiddenTruth& truth, const Suit& suit, const Scenario& scenario) {
    Json boards = Json::array(), sources = Json::array();
    for (size_t b = 0; b < suit.boards.size(); ++b)
        boards.push_back({{"id", suit.boards[b].id},
                          {"gyro", axesJson(truth.inertia[b].gyro)},
                          {"accel", axesJson(truth.inertia[b].accel)},
                          {"phase_samples", truth.inertia[b].phase_samples},
                          {"board_gain_db", truth.sound.boards[b].gain_db},
                          {"mic_delay_s", truth.sound.boards[b].mic_delay_s}});
    for (size_t s = 0; s < suit.sources.size(); ++s) {
        const SourceTruth& source = truth.sound.sources[s];
        sources.push_back(
            {{"id", suit.sources[s].id},
             {"offsets_s", {{"start", source.start_delay_s}, {"inflection", truth.inflection_offset_s[s]}}},
             {"source_start_delay_s", source.start_delay_s},
             {"resonance_hz", source.resonance_hz},
             {"q", source.q},
             {"source_gain_db", source.gain_db},
             {"ka", source.ka}});
    }
    return {{"format", "noctule-truth"},
            {"version", 1},
            {"scenario", scenario.name},
            {"seed", truth.seed},
            {"temperature_c", truth.air.temperature_c},
            {"humidity_percent", truth.air.humidity_percent},
            {"temperature_error_c", truth.air.thermometer_error_c},
            {"speed_of_sound_m_per_s", truth.air.speedOfSound_m_per_s()},
            {"boards", boards},
            {"sources", sources}};
}

void addWorn(nlohmann::json& truth, const WornSuit& worn) {
    for (size_t b = 0; b < worn.boards.size(); ++b) {
        truth["boards"][b]["p_segment_board_m"] = json::fromVector(worn.boards[b].p_segment_board_m);
        truth["boards"][b]["q_segment_board"] = json::fromQuaternion(worn.boards[b].q_segment_board);
        if (worn.boards[b].tilt_rad.bound > 0)
            truth["boards"][b]["soft_tissue"] = tissueJson(worn.boards[b]);
    }
    for (size_t s = 0; s < worn.sources.size(); ++s)
        truth["sources"][s]["p_segment_source_m"] = json::fromVector(worn.sources[s].p_segment_source_m);
}

}  // namespace noctule::simulation
