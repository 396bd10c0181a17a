// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/rest_pose_calibration.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/rest_pose/rest_pose_findings.h"
#include "core/calibration/rest_pose/rest_swap_search.h"
#include "core/math/rotation.h"
#include "core/suit/calibration_entries.h"

namespace noctule {
namespace {

bool takesPart(const RestExplanation& explained, int board) {
    const StreamPlace& placed = explained.arrangement[static_cast<size_t>(board)];
    return placed.stream == board && placed.calibration == board;
}

/// Zeros that make the mean as long as g. The error along the vertical is a zero's far more than a scale's:
/// 60 counts of 2048 against 1.5 % of g.
Vector3d zerosForGravity(const AxisCalibration& accel, const Vector3d& mean_m_per_s2,
                         double above_g_m_per_s2) {
    const Vector3d zero_counts =
        accel.zero_counts + accel.matrix.inverse() * mean_m_per_s2.normalized() * above_g_m_per_s2;
    return zero_counts.allFinite() ? zero_counts : accel.zero_counts;
}

BoardAtRest boardAtRest(const RestPoseFit& fitter, const RestEvidenceMaker& maker,
                        const RestExplanation& explained, const UpEvidence& up, const Observations& take,
                        const StillBoard& still) {
    const auto b = static_cast<size_t>(up.board);
    const BoardPrior& prior = explained.priors.boards[b];
    const GlobalPose global = globalPose(take.actor.skeleton, explained.fit.pose);
    BoardAtRest board;
    board.measured = true;
    board.q_segment_board =
        RestPoseFit::boardOrientation(prior, up, global.q_world_joint[static_cast<size_t>(prior.joint)]);
    board.tilt_from_suit_rad = angleBetween(prior.q_segment_board, board.q_segment_board);
    const Matrix3d cov_segment = fitter.segmentCovariance(explained.fit, prior.joint);
    const AxisCalibration& accel = maker.calibration(up.board).accel;
    const double noise_rad = (accel.matrix * still.sigma_accel_counts).norm() / take.g_m_per_s2;
    board.sigma_tilt_rad = std::hypot(up.sigma_rad, noise_rad);
    board.sigma_mounting_tilt_rad =
        std::sqrt((cov_segment(0, 0) + cov_segment(2, 2)) / 2 + board.sigma_tilt_rad * board.sigma_tilt_rad);
    board.sigma_turn_rad = prior.sigma_turn_rad;
    board.gyro_zero_counts = still.gyro_counts;
    board.sigma_gyro_zero_counts = still.sigma_gyro_counts;
    const Vector3d mean_m_per_s2 = maker.accel({up.board, up.board});
    board.accel_above_g_m_per_s2 = mean_m_per_s2.norm() - take.g_m_per_s2;
    board.accel_zero_counts = zerosForGravity(accel, mean_m_per_s2, board.accel_above_g_m_per_s2);
    board.shift_m = explained.fit.board_shift_m[b];
    return board;
}

std::vector<JointAtRest> jointsAtRest(const RestPoseFit& fitter, const Actor& actor, const RestFit& fit) {
    std::vector<JointAtRest> joints;
    const Pose rest = actor.restPose();
    for (int j = 0; j < actor.skeleton.size(); ++j) {
        const auto at = static_cast<size_t>(j);
        JointAtRest joint;
        joint.joint = actor.skeleton.joint(j).name;
        joint.deviation_rad =
            logQuaternion(rest.q_parent_joint[at].conjugate() * fit.pose.q_parent_joint[at]);
        bool turns = false;
        for (const Link& link : fitter.tree().links())
            for (int i = link.type == LinkType::kFree ? 3 : 0; i < link.count && link.joint == j; ++i) {
                turns = true;
                joint.sigma_rad =
                    std::max(joint.sigma_rad, std::sqrt(fit.cov_pose(link.first + i, link.first + i)));
            }
        if (turns)
            joints.push_back(joint);
    }
    return joints;
}

/// Weighted as the fit weighs them, without those that it leaves out as echoes.
double distanceRms(const RestExplanation& explained) {
    double square = 0, weights = 0;
    for (size_t i = 0; i < explained.evidence.distances.size(); ++i) {
        const double sigma_m = explained.evidence.distances[i].sigma_m;
        const double residual = explained.fit.distance_residual_m[i] / sigma_m;
        if (std::abs(residual) < 3) {
            square += residual * residual;
            weights += 1 / (sigma_m * sigma_m);
        }
    }
    return weights > 0 ? std::sqrt(square / weights) : 0;
}

void fillReport(const RestPoseFit& fitter, const RestEvidenceMaker& maker, const Observations& take,
                const StillStretch& still, const RestExplanation& explained, RestPoseReport& report) {
    for (const UpEvidence& up : explained.evidence.ups)
        if (takesPart(explained, up.board)) {
            const auto b = static_cast<size_t>(up.board);
            const std::string id = report.boards[b].id;
            report.boards[b] = boardAtRest(fitter, maker, explained, up, take, still.boards[b]);
            report.boards[b].id = id;
        }
    report.joints = jointsAtRest(fitter, take.actor, explained.fit);
    report.pose = explained.fit.pose;
    report.swapped = explained.swapped;
    report.rivals = explained.rivals;
    report.untold = explained.untold;
    report.sources = static_cast<int>(take.suit.sources.size());
    report.distances = static_cast<int>(explained.evidence.distances.size());
    report.distance_rms_m = distanceRms(explained);
    report.iterations = explained.fit.iterations;
    report.converged = explained.fit.converged;
    report.cost = explained.cost;
}

RestPriors restPriors(const Observations& take, const RestPoseSettings& settings) {
    RestPriors priors = priorsOf(take, false);
    priors.sigma_pose_rad = settings.sigma_pose_rad;
    for (BoardPrior& board : priors.boards) {
        board.sigma_turn_rad = settings.sigma_board_turn_rad;
        board.sigma_shift_m = settings.sigma_board_shift_m;
    }
    for (SourcePrior& source : priors.sources)
        source.sigma_shift_m = settings.sigma_source_shift_m;
    return priors;
}

}  // namespace

Calibration RestPoseReport::applied(const Calibration& base, const Suit& suit) const {
    Calibration calibration = base;
    for (size_t b = 0; b < boards.size(); ++b) {
        const BoardAtRest& board = boards[b];
        if (!board.measured)
            continue;
        BoardCalibration& known = entryOf(calibration, suit.boards[b]);
        known.q_segment_board = board.q_segment_board;
        known.sigma_mounting_rad.reset();  // the old one is of another mounting
        known.gyro.zero_counts = board.gyro_zero_counts;
        known.gyro.sigma_zero_counts = board.sigma_gyro_zero_counts;
        known.accel.zero_counts = board.accel_zero_counts;
    }
    return calibration;
}

Result<RestPoseReport> calibrateRestPose(const Observations& take, const RestPoseSettings& settings,
                                         const JobContext& job) {
    RestPoseReport report;
    for (const Board& board : take.suit.boards) {
        report.boards.emplace_back();
        report.boards.back().id = board.id;
    }
    const StillStretch still = findStillStretch(take);
    report.stretch = still.stretch;
    report.rest_marked = still.marked;
    if (!still.isUsable() || take.actor.skeleton.size() == 0) {
        addWhyNotStill(take, still, report.findings);
        return report;
    }
    const RestPoseFit fitter(take.actor);
    const RestEvidenceMaker maker(take, still, settings.sigma_distance_m);
    auto explained =
        explainRest(fitter, maker, RestSight(take, still, maker), restPriors(take, settings), job);
    if (!explained)
        return explained.error();
    fitter.addCovariance(explained->priors, explained->evidence, explained->fit);
    fillReport(fitter, maker, take, still, *explained, report);
    addStandingFindings(take, still, report.findings);
    addPlaceFindings(take, settings, *explained, report);
    addSensorFindings(take, settings, maker, report);
    job.progress(1, "Rest pose");
    return report;
}

}  // namespace noctule
