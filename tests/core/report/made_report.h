// SPDX-License-Identifier: Apache-2.0
// A whole report made of nothing but arithmetic: seven runs, 18 boards, 8 sources.
#pragma once

#include <cmath>
#include <random>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/report/report_data.h"

namespace noctule::test {

inline TimedMotion bodyMotion(double seconds, double noise_deg, double drift_deg_per_min) {
    TimedMotion motion{defaultActor().skeleton, {}};
    const Pose rest = defaultActor().restPose();
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    std::vector<double> error(rest.q_parent_joint.size(), 0);
    for (int i = 0; i < seconds * 60; ++i) {
        const double t_s = i / 60.0;
        TimedPose frame{std::llround(t_s * 1e9), rest, std::vector<double>(3 * error.size(), 0)};
        frame.pose->q_parent_joint[0] = axisAngle(Vector3d::UnitY(), radians(noise_deg * t_s / 30));
        for (size_t j = 1; j < error.size(); ++j) {
            const size_t freedoms = motion.skeleton.joints()[j].dof.size();
            if (freedoms == 0)
                continue;
            error[j] = 0.95 * error[j] + 0.3 * noise_deg * normal(random);
            const double n = static_cast<double>(j);
            const double angle = 0.5 * std::sin((0.7 + 0.11 * n) * t_s + n) * std::sin(0.17 * t_s);
            const double wrong = radians(error[j] + noise_deg * 0.5 + drift_deg_per_min * t_s / 60);
            frame.pose->q_parent_joint[j] = frame.pose->q_parent_joint[j] *
                                            axisAngle(Vector3d(1, 0.4, 0.2).normalized(), angle) *
                                            axisAngle(Vector3d(0.3, 1, 0.1).normalized(), wrong);
            for (size_t k = 0; k < freedoms; ++k)
                frame.sigma_rad[3 * j + k] = radians(noise_deg);
        }
        motion.frames.push_back(frame);
    }
    return motion;
}

inline ReportRun madeRun(const std::string& sensors, const TimedMotion& reference, double seconds,
                         double noise_deg, double drift_deg_per_min) {
    ReportRun run;
    run.name = sensors + "-manifold";
    run.sensors = sensors;
    run.estimator = "manifold";
    run.root_given = true;
    run.created_utc = "2026-11-21T10:00:00Z";
    run.software = "noctule 0.1.0";
    run.calibration = "2 (2026-11-18)";
    run.settings = {{"Gate", "4.5 sigma"}, {"Detector", "matched"}};
    ComparisonOptions options;
    options.from_ns = 3'000'000'000;
    options.curves = sensors == "AGD";  // of the shown run alone, as evaluateTake does
    run.comparison =
        compareMotions(bodyMotion(seconds, noise_deg, drift_deg_per_min), reference, options).value();
    return run;
}

inline ReportPair madePair(int source, int board, double seconds) {
    ReportPair pair{source, board, {}};
    std::mt19937 random(static_cast<unsigned>(100 * source + board));
    std::uniform_real_distribution<float> uniform(0, 1);
    const float quality = 0.15f + 0.85f * static_cast<float>((source * 5 + board * 7) % 11) / 10;
    for (double t_s = 0.008 * source; t_s < seconds; t_s += 0.064) {
        PulseAtBoard pulse;
        pulse.time_s = static_cast<float>(t_s);
        const auto wave = static_cast<float>(0.5 + 0.5 * std::sin(0.3 * t_s + board));
        if (uniform(random) < quality * (0.4f + 0.6f * wave)) {
            pulse.confidence = std::min(1.0f, quality * (0.6f + 0.4f * wave) + 0.1f * uniform(random));
            const float roll = uniform(random);
            pulse.fate = roll < 0.9f    ? PulseFate::kUsed
                         : roll < 0.95f ? PulseFate::kRejected
                                        : PulseFate::kUnused;
            pulse.residual_m = 0.002f * (uniform(random) - 0.5f);
            pulse.distance_m = 0.6f + 0.2f * wave + (pulse.fate == PulseFate::kRejected ? 0.1f : 0.0f);
        } else {
            pulse.fate = uniform(random) < 0.9f ? PulseFate::kOccluded : PulseFate::kMissing;
        }
        pair.pulses.push_back(pulse);
    }
    return pair;
}

inline std::vector<ReportBoard> madeBoards(double seconds) {
    std::vector<ReportBoard> boards;
    for (const char* segment : {"Hips", "Spine", "Chest", "Head", "LeftShoulder", "LeftArm", "LeftForeArm",
                                "LeftHand", "RightShoulder", "RightArm", "RightForeArm", "RightHand",
                                "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot"}) {
        ReportBoard board;
        board.id = segment;
        board.segment = segment;
        board.frames_expected = std::llround(140 * seconds);
        board.readings_expected = 6 * board.frames_expected;
        board.readings_present = board.readings_expected;
        boards.push_back(board);
    }
    boards[14].frames_lost = 60;
    boards[14].readings_present -= 60 * 6 + 400;
    boards[14].clipped_accel = 12;
    return boards;
}

inline ReportData madeReport(double seconds) {
    ReportData data;
    data.take = {.name = "boxer_001",
                 .file = "/tmp/boxer_001.noctule",
                 .uuid = "8a1c",
                 .created_utc = "2026-11-21T09:58:00Z",
                 .performer = "Performer 1",
                 .actor_name = "default",
                 .software = "noctule 0.1.0",
                 .duration_s = seconds,
                 .rest_s = 3,
                 .sample_rate_hz = 150000,
                 .reference_kind = "simulated",
                 .reference_name = "",
                 .notes = {"Second round is the good one."}};
    const TimedMotion reference = bodyMotion(seconds, 0, 0);
    const struct {
        const char* sensors;
        double noise_deg, drift;
    } kinds[] = {{"A", 40, 0},   {"AD", 30, 0},  {"D", 20, 0},   {"G", 2, 6},
                 {"GD", 1.5, 0}, {"AG", 1, 0.2}, {"AGD", 0.6, 0}};
    for (const auto& kind : kinds)
        data.runs.push_back(madeRun(kind.sensors, reference, seconds, kind.noise_deg, kind.drift));
    data.runs.back().is_shown = true;
    data.boards = madeBoards(seconds);
    for (int s = 0; s < 8; ++s)
        data.sources.push_back({"s" + std::to_string(s + 1), s == 0 ? "belly" : s == 7 ? "hat" : ""});
    for (int s = 0; s < 8; ++s)
        for (int b = 0; b < 18; ++b)
            if (s != 3 || b != 5)
                data.pairs.push_back(madePair(s, b, seconds));
    for (const JointComparison& joint : data.runs.back().comparison->joints)
        data.support.push_back({joint.name, joint.name.starts_with("Right") ? 0.83 : 0.97, 0.02, {}, 0});
    data.provenance = {
        {"Calibration", {{"Source offsets", "2026-11-18, 0.9 mm"}, {"Speed of sound", "345.5 m/s"}}}};
    return data;
}

inline const ReportData& shortReport() {
    static const ReportData data = madeReport(20);
    return data;
}

inline bool has(const std::string& page, const std::string& part) {
    return page.find(part) != std::string::npos;
}

}  // namespace noctule::test
