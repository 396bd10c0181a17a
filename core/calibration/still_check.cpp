// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/still_check.h"

#include <algorithm>
#include <cmath>

#include "core/body/text.h"
#include "core/calibration/rest_evidence.h"
#include "core/calibration/rest_pose_findings.h"
#include "core/calibration/worn_part_names.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

// Of a suit that was calibrated: the same person stands in the same pose a little later.
constexpr double kSigmaPose_rad = radians(3), kSigmaTurn_rad = radians(1.5);
constexpr double kSigmaBoardShift_m = 0.005, kSigmaSourceShift_m = 0.005, kSigmaDistance_m = 0.005;
constexpr double kSlipped_rad = radians(5);
constexpr double kGyroMoved_rad_per_s = radians(1.5);  // what a chip's warming up explains is below
constexpr double kFarRange_m = 0.03, kLatest_m = 0.15;
constexpr int kRangesToJudge = 3;
constexpr int kMostCheckIterations = 40;

RestPriors calibratedPriors(const Observations& take) {
    RestPriors priors = priorsOf(take, true);
    priors.sigma_pose_rad = kSigmaPose_rad;
    for (BoardPrior& board : priors.boards) {
        board.sigma_turn_rad = kSigmaTurn_rad;
        board.sigma_shift_m = kSigmaBoardShift_m;
    }
    for (SourcePrior& source : priors.sources)
        source.sigma_shift_m = kSigmaSourceShift_m;
    return priors;
}

/// By how much a board leans otherwise than its prior and the pose say.
double tiltChange_rad(const BoardPrior& prior, const UpEvidence& up, const GlobalPose& global) {
    const Vector3d up_world =
        global.q_world_joint[static_cast<size_t>(prior.joint)] * (prior.q_segment_board * up.up_board);
    return std::acos(std::clamp(up_world.y(), -1.0, 1.0));
}

void compareRanges(const RestEvidence& evidence, const RestFit& fit, StillCheckReport& report) {
    std::vector<std::vector<double>> sizes(report.boards.size());
    for (size_t i = 0; i < evidence.distances.size(); ++i) {
        const DistanceEvidence& distance = evidence.distances[i];
        report.pairs.push_back({distance.source, distance.board, fit.distance_residual_m[i]});
        const bool direct = std::abs(fit.distance_residual_m[i]) < kLatest_m;  // else an echo
        if (direct && distance.sigma_m < 3 * kSigmaDistance_m)                 // and heard well
            sizes[static_cast<size_t>(distance.board)].push_back(std::abs(fit.distance_residual_m[i]));
    }
    for (size_t b = 0; b < sizes.size(); ++b)
        if (!sizes[b].empty()) {
            const auto middle = sizes[b].begin() + static_cast<std::ptrdiff_t>((sizes[b].size() - 1) / 2);
            std::ranges::nth_element(sizes[b], middle);
            report.boards[b].range_residual_m = *middle;
            report.boards[b].ranges = static_cast<int>(sizes[b].size());
        }
}

void addWhatMoved(const Observations& take, int index, StillCheckReport& report) {
    const BoardStillCheck& board = report.boards[static_cast<size_t>(index)];
    const std::string place = std::to_string(index + 1) + ", " + boardPlace(take.suit, index);
    const auto add = [&](const std::string& what, const char* remedy) {
        report.findings.push_back({Grade::kNotUsable, board.id, what, remedy});
    };
    if (board.slipped)
        add("The strap of board " + place + ", has slipped by about " +
                text::number(degrees(board.tilt_change_rad), 0) + "°",
            "Put it back, or calibrate the rest pose again");
    else if (board.ranges >= kRangesToJudge && board.range_residual_m > kFarRange_m)
        add("Board " + place + ", hears its sources about " + text::number(100 * board.range_residual_m, 0) +
                " cm from where the calibration puts it",
            "See whether it sits where it belongs, or calibrate the rest pose again");
    if (board.gyro_change_rad_per_s.norm() > kGyroMoved_rad_per_s)
        add("The gyroscope of board " + place + ", has drifted by about " +
                text::number(degrees(board.gyro_change_rad_per_s.norm()), 0) + "°/s",
            "Calibrate the rest pose again");
}

}  // namespace

StillCheckReport checkStill(const Observations& take) {
    StillCheckReport report;
    for (const Board& board : take.suit.boards) {
        report.boards.emplace_back();
        report.boards.back().id = board.id;
    }
    const StillStretch still = findStillStretch(take);
    report.stretch = still.stretch;
    if (!still.isUsable() || take.actor.skeleton.size() == 0) {
        addWhyNotStill(take, still, report.findings);
        return report;
    }
    const RestPoseFit fitter(take.actor);
    const RestEvidenceMaker maker(take, still, kSigmaDistance_m);
    const RestPriors priors = calibratedPriors(take);
    const RestEvidence evidence = maker.make(maker.asDescribed());
    const RestFit fit = fitter.fit(priors, evidence, kMostCheckIterations);
    const GlobalPose global = globalPose(take.actor.skeleton, fit.pose);
    for (const UpEvidence& up : evidence.ups) {
        BoardStillCheck& board = report.boards[static_cast<size_t>(up.board)];
        board.heard = true;
        board.tilt_change_rad = tiltChange_rad(priors.boards[static_cast<size_t>(up.board)], up, global);
        board.gyro_change_rad_per_s = maker.gyro_rad_per_s({up.board, up.board});
        board.slipped = board.tilt_change_rad > kSlipped_rad;
    }
    compareRanges(evidence, fit, report);
    addStandingFindings(take, still, report.findings);
    for (int b = 0; b < static_cast<int>(report.boards.size()); ++b)
        addWhatMoved(take, b, report);
    return report;
}

}  // namespace noctule
