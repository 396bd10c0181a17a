// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/source_offsets.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/source_offsets/jig_labels.h"
#include "core/calibration/source_offsets/jig_measurements.h"
#include "core/calibration/source_offsets/offset_findings.h"
#include "core/calibration/source_offsets/offset_fit.h"
#include "core/suit/calibration_entries.h"

namespace noctule {
namespace {

constexpr double kAnySoundScale = 0.1, kAnyMicDelay_s = 1e-4;  // priors of what is estimated: none

std::vector<OffsetSample> samplesOf(const JigData& jig) {
    std::vector<OffsetSample> samples;
    for (const JigMeasurement& m : jig.measurements) {
        const double travel_s = m.distance_m / m.c_m_per_s;
        samples.push_back({m.source, m.board, m.stretch, travel_s,
                           m.flight_s - travel_s - jig.mic_delay_s[static_cast<size_t>(m.board)],
                           std::hypot(m.flight_sigma_s, m.distance_sigma_m / m.c_m_per_s),
                           m.moved || m.mislabelled});
    }
    return samples;
}

OffsetFitSettings fitSettingsOf(const JigData& jig, const SourceOffsetSettings& settings,
                                bool estimate_sound) {
    return {static_cast<int>(jig.suit.sources.size()),
            static_cast<int>(jig.suit.boards.size()),
            jig.stretches,
            estimate_sound ? kAnySoundScale : settings.thermometer_sigma_k * kStretchPerKelvin,
            estimate_sound,
            settings.thermometer_noise_k * kStretchPerKelvin,
            settings.estimate_mic_delays ? kAnyMicDelay_s : settings.mic_delay_sigma_s,
            settings.estimate_mic_delays};
}

void takeSources(const OffsetFit& fit, int min_measurements, SourceOffsetReport& report) {
    for (size_t s = 0; s < report.sources.size(); ++s) {
        SourceOffset& source = report.sources[s];
        double sum2_m2 = 0;
        for (const JigMeasurement& m : report.measurements)
            if (m.source == static_cast<int>(s) && m.used) {
                sum2_m2 += m.residual_m * m.residual_m;
                ++source.measurements;
            }
        source.calibrated = source.measurements >= std::max(1, min_measurements);
        if (!source.calibrated)
            continue;
        source.offset_s = fit.offset_s[s];
        source.sigma_s = fit.offset_sigma_s[s];
        source.rms_m = std::sqrt(sum2_m2 / source.measurements);
    }
}

void takeMeasurements(const OffsetFit& fit, SourceOffsetReport& report) {
    const double slower = report.sound_estimated ? 1 + fit.stretch : 1;
    for (size_t i = 0; i < report.measurements.size(); ++i) {
        JigMeasurement& m = report.measurements[i];
        m.used = fit.weight[i] > 0;
        m.residual_m = fit.residual_s[i] * m.c_m_per_s / slower;
        m.left_out_m = fit.left_out_s[i] * m.c_m_per_s / slower;
    }
}

void takeMicDelays(const OffsetFit& fit, const JigData& jig, SourceOffsetReport& report) {
    for (size_t b = 0; b < jig.suit.boards.size(); ++b)
        if (std::ranges::any_of(report.measurements, [&](const JigMeasurement& m) {
                return m.used && m.board == static_cast<int>(b);
            }))
            report.mic_delays.push_back(
                {jig.suit.boards[b].id, jig.mic_delay_s[b] + fit.mic_s[b], fit.mic_sigma_s[b]});
}

/// Of calibrated sources.
DistanceErrors leaveOneOut(const SourceOffsetReport& report, bool with_outliers) {
    DistanceErrors errors;
    double sum_m = 0, sum2_m2 = 0;
    for (const JigMeasurement& m : report.measurements)
        if (report.sources[static_cast<size_t>(m.source)].calibrated &&
            (m.used || (with_outliers && !m.mislabelled))) {
            const double error_m = std::abs(m.left_out_m);
            sum_m += error_m;
            sum2_m2 += error_m * error_m;
            errors.worst_m = std::max(errors.worst_m, error_m);
            ++errors.count;
        }
    if (errors.count == 0)
        return errors;
    errors.mean_m = sum_m / errors.count;
    errors.deviation_m = std::sqrt(std::max(0.0, sum2_m2 / errors.count - errors.mean_m * errors.mean_m));
    return errors;
}

void solve(JigData& jig, const SourceOffsetSettings& settings, SourceOffsetReport& report) {
    report.swaps = markSwappedLabels(jig);
    for (const SwappedLabels& swap : report.swaps)
        report.findings.push_back(findingOf(swap, jig.suit));
    const OffsetFit fit = fitOffsets(samplesOf(jig), fitSettingsOf(jig, settings, report.sound_estimated));
    report.measurements = jig.measurements;
    report.sound_scale_sigma = report.sound.scale * fit.stretch_sigma;
    if (report.sound_estimated)
        report.sound.scale /= 1 + fit.stretch;
    takeMeasurements(fit, report);
    takeSources(fit, settings.min_measurements, report);
    if (settings.estimate_mic_delays)
        takeMicDelays(fit, jig, report);
    report.leave_one_out = leaveOneOut(report, false);
    report.all_left_out = leaveOneOut(report, true);
    judgeOffsets({jig, settings, fit}, report);
}

}  // namespace

SourceOffsetReport calibrateSourceOffsets(const std::vector<Observations>& takes, const KnownDistances& known,
                                          const SourceOffsetSettings& settings) {
    JigData jig = measureJig(takes, known, settings);
    SourceOffsetReport report;
    report.findings = known.findings;
    report.findings.insert(report.findings.end(), jig.findings.begin(), jig.findings.end());
    if (takes.empty())
        return report;
    report.suit = jig.suit;
    report.detector = takes.front().detector;
    report.sound = takes.front().calibration.sound;
    for (const Source& source : jig.suit.sources) {
        report.sources.push_back({.id = source.id});
        const SourceCalibration* in_force = takes.front().calibration.findSource(source.id);
        if (in_force && in_force->offsets_s.contains(report.detector))
            report.sources.back().before_s = in_force->offsets_s.at(report.detector);
    }
    if (const auto mistake = findUnitMistake(jig)) {
        report.measurements = jig.measurements;
        report.findings.push_back(findingOf(*mistake, known.where));
        return report;
    }
    report.sound_estimated = settings.speed_of_sound == SourceOffsetSettings::SpeedOfSound::kEstimate;
    solve(jig, settings, report);
    return report;
}

Calibration SourceOffsetReport::applied(const Calibration& base) const {
    Calibration calibration = base;
    for (const SourceOffset& source : sources)
        if (source.calibrated) {
            SourceCalibration& entry =
                entryOf(calibration, suit.sources[static_cast<size_t>(suit.findSource(source.id))]);
            entry.offsets_s[detector] = source.offset_s;
            entry.sigma_s[detector] = source.sigma_s;
        }
    if (sound_estimated && std::ranges::any_of(sources, &SourceOffset::calibrated))
        calibration.sound = sound;
    for (const MicDelay& mic : mic_delays)
        entryOf(calibration, suit.boards[static_cast<size_t>(suit.findBoard(mic.id))]).mic_delay_s =
            mic.delay_s;
    return calibration;
}

}  // namespace noctule
