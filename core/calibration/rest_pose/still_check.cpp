// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/still_check.h"

#include <algorithm>
#include <cmath>

#include "core/body/text.h"
#include "core/calibration/rest_pose/rest_evidence.h"
#include "core/calibration/rest_pose/rest_pose_calibration.h"
#include "core/calibration/rest_pose/rest_pose_findings.h"
#include "core/calibration/worn_part_names.h"
#include "core/math/rotation.h"
#include "core/suit/calibration_lack.h"

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

/// What has no calibrated values cannot have moved away from them.
std::string whyUnchecked(const Observations& take) {
    CalibrationLack lack = lackOf(take.suit, take.calibration);
    lack.sources.clear();  // tilts are compared without distances
    const auto forget_few = [&lack](std::vector<int>& boards) {
        if (2 * static_cast<int>(boards.size()) <= lack.board_count)
            boards.clear();
    };
    for (std::vector<int>* boards : {&lack.accelerometers, &lack.gyroscopes, &lack.rest_pose})
        forget_few(*boards);
    if (lack.isNone())
        return "";
    const bool one = lack.accelerometers.empty() && lack.gyroscopes.empty();
    return lackInWords(lack) + (one ? " is" : " are") + " not calibrated";
}

struct Moved {
    std::vector<bool> place, gyroscope;  ///< per board
};

Moved whatMoved(const StillCheckReport& report) {
    Moved moved;
    for (const BoardStillCheck& board : report.boards) {
        moved.place.push_back(board.slipped ||
                              (board.ranges >= kRangesToJudge && board.range_residual_m > kFarRange_m));
        moved.gyroscope.push_back(board.gyro_change_rad_per_s.norm() > kGyroMoved_rad_per_s);
    }
    return moved;
}

/// One cause, one finding: what befell most boards alike is no matter of single straps.
bool isOfMost(const std::vector<bool>& boards) {
    return 2 * std::ranges::count(boards, true) > std::ssize(boards) && std::ranges::count(boards, true) > 2;
}

/// Two boards that seem to have moved may have been exchanged: the fit of the rest pose tells.
void addExchanged(const Observations& take, Moved& moved, StillCheckReport& report) {
    int suspects = 0;
    for (size_t b = 0; b < moved.place.size(); ++b)
        suspects += moved.place[b] || moved.gyroscope[b];
    if (suspects < 2)
        return;
    const auto rest = calibrateRestPose(take, {}, {});
    if (!rest)
        return;
    for (const SwappedBoards& pair : rest->swapped) {
        report.findings.push_back(
            {Grade::kNotUsable, report.boards[static_cast<size_t>(pair.first)].id,
             "Boards " + boardInList(take.suit, pair.first) + " and " + boardInList(take.suit, pair.second) +
                 " seem to be exchanged",
             pair.plugs ? "Exchange their plugs at the driver box, or drag the one onto the other on Connect"
                        : "Exchange them on the body, or drag the one onto the other on Connect"});
        for (const int board : {pair.first, pair.second})
            moved.place[static_cast<size_t>(board)] = moved.gyroscope[static_cast<size_t>(board)] = false;
    }
}

void addPlaces(const Observations& take, const std::vector<bool>& moved, StillCheckReport& report) {
    if (isOfMost(moved)) {
        report.findings.push_back(
            {Grade::kNotUsable, "",
             std::to_string(std::ranges::count(moved, true)) +
                 " boards sit otherwise than the calibration says",
             "See that it was made by this performer in this suit, or calibrate the rest pose again"});
        return;
    }
    for (size_t b = 0; b < moved.size(); ++b) {
        if (!moved[b])
            continue;
        const BoardStillCheck& board = report.boards[b];
        const std::string place = std::to_string(b + 1) + ", " + boardPlace(take.suit, static_cast<int>(b));
        if (board.slipped)
            report.findings.push_back({Grade::kNotUsable, board.id,
                                       "The strap of board " + place + ", has slipped by about " +
                                           text::number(degrees(board.tilt_change_rad), 0) + "°",
                                       "Put it back, or calibrate the rest pose again"});
        else
            report.findings.push_back(
                {Grade::kNotUsable, board.id,
                 "Board " + place + ", hears its sources about " +
                     text::number(100 * board.range_residual_m, 0) + " cm from where the calibration puts it",
                 "See whether it sits where it belongs, or calibrate the rest pose again"});
    }
}

void addGyroscopes(const Observations& take, const std::vector<bool>& moved, StillCheckReport& report) {
    const auto rate = [&report](size_t b) { return report.boards[b].gyro_change_rad_per_s.norm(); };
    double fastest_rad_per_s = 0;
    for (size_t b = 0; b < moved.size(); ++b)
        fastest_rad_per_s = std::max(fastest_rad_per_s, rate(b));
    if (isOfMost(moved)) {
        report.findings.push_back({Grade::kNotUsable, "",
                                   "The gyroscopes of " + std::to_string(std::ranges::count(moved, true)) +
                                       " boards have drifted, by up to " +
                                       text::number(degrees(fastest_rad_per_s), 0) + "°/s",
                                   "Calibrate the rest pose again"});
        return;
    }
    for (size_t b = 0; b < moved.size(); ++b)
        if (moved[b])
            report.findings.push_back({Grade::kNotUsable, report.boards[b].id,
                                       "The gyroscope of board " + std::to_string(b + 1) + ", " +
                                           boardPlace(take.suit, static_cast<int>(b)) +
                                           ", has drifted by about " + text::number(degrees(rate(b)), 0) +
                                           "°/s",
                                       "Calibrate the rest pose again"});
}

}  // namespace

StillCheckReport checkStill(const Observations& take) {
    StillCheckReport report;
    for (const Board& board : take.suit.boards) {
        report.boards.emplace_back();
        report.boards.back().id = board.id;
    }
    report.unchecked = whyUnchecked(take);
    if (!report.unchecked.empty()) {
        report.findings.push_back({Grade::kUnknown, "", text::capitalised(report.unchecked),
                                   "Calibrate them in step Calibrate, then check the suit"});
        return report;
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
    Moved moved = whatMoved(report);
    addExchanged(take, moved, report);
    addPlaces(take, moved.place, report);
    addGyroscopes(take, moved.gyroscope, report);
    return report;
}

}  // namespace noctule
