// SPDX-License-Identifier: Apache-2.0
// The most likely pose against one that is known: what of it the fit finds, and what it says about the rest.
#include "core/calibration/rest_pose/rest_pose_fit.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"
#include "core/simulation/random.h"
#include "core/suit/default_suit.h"
#include "tests/support/nees.h"

namespace noctule {
namespace {

constexpr double kPose_rad = radians(4), kTurn_rad = radians(1), kSensor_rad = radians(0.3);
constexpr double kShift_m = 0.004, kHeld = 1e-5, kDistance_m = 0.003;

/// The default suit on the default actor, in a pose, on straps and with distances that are all drawn as the
/// fit expects them; `share` of what is measured wrongly.
struct KnownStand {
    Actor actor = defaultActor();
    RestPoseFit fitter{actor};
    RestPriors priors;
    RestEvidence evidence;
    Eigen::VectorXd deviation_rad;

    explicit KnownStand(uint64_t seed, double share = 1) {
        simulation::Random random(seed, "known stand");
        const Suit suit = defaultSuit();
        priors.sigma_pose_rad = kPose_rad;
        for (const Board& board : suit.boards)
            priors.boards.push_back({actor.skeleton.find(board.segment),
                                     board.p_segment_board_m + board.q_segment_board * board.p_board_mic_m,
                                     board.q_segment_board, kTurn_rad, kShift_m});
        for (const Source& source : suit.sources)
            priors.sources.push_back(
                {actor.skeleton.find(source.segment), source.p_segment_source_m, kShift_m});
        const GlobalPose stands = stand(random);
        measure(stands, random, share);
    }

    /// As the covariance counts it: a turn of each ball joint's found orientation.
    Eigen::VectorXd errorOf(const RestFit& fit) const {
        Eigen::VectorXd error = fit.deviation_rad - deviation_rad;
        for (const Link& link : fitter.tree().links())
            if (link.type == LinkType::kBall || link.type == LinkType::kFree) {
                const int first = link.first + link.count - 3;
                const auto turned = [&](const Eigen::VectorXd& by) {
                    return expQuaternion(Vector3d(by.segment<3>(first)));
                };
                error.segment<3>(first) =
                    logQuaternion(turned(deviation_rad).conjugate() * turned(fit.deviation_rad));
            }
        return error;
    }

private:
    /// The root's place and its turn about the vertical are held.
    GlobalPose stand(simulation::Random& random) {
        const KinematicTree& tree = fitter.tree();
        MotionState state = tree.stateFromPose(actor.restPose());
        deviation_rad =
            Eigen::VectorXd::NullaryExpr(tree.freedoms(), [&] { return random.gaussian(kPose_rad); });
        for (const Link& link : tree.links())
            if (link.type == LinkType::kFree)
                for (const int held : {0, 1, 2, 4})
                    deviation_rad[link.first + held] = random.gaussian(kHeld);
        tree.retract(state, deviation_rad);
        return globalPose(actor.skeleton, tree.poseFromState(state));
    }

    void measure(const GlobalPose& stands, simulation::Random& random, double share) {
        std::vector<Vector3d> mics_m;
        for (int b = 0; b < static_cast<int>(priors.boards.size()); ++b) {
            const BoardPrior& board = priors.boards[static_cast<size_t>(b)];
            const auto joint = static_cast<size_t>(board.joint);
            const Vector3d worn_rad = random.gaussianVector(share * kTurn_rad),
                           glued_rad = random.gaussianVector(share * kSensor_rad);
            const Quaterniond q_world_board = stands.q_world_joint[joint] * board.q_segment_board *
                                              expQuaternion(worn_rad) * expQuaternion(glued_rad);
            evidence.ups.push_back({b, q_world_board.conjugate() * Vector3d::UnitY(), kSensor_rad});
            mics_m.push_back(stands.p_world_joint[joint] +
                             stands.q_world_joint[joint] *
                                 (board.p_segment_mic_m + random.gaussianVector(share * kShift_m)));
        }
        for (int s = 0; s < static_cast<int>(priors.sources.size()); ++s) {
            const SourcePrior& source = priors.sources[static_cast<size_t>(s)];
            const auto joint = static_cast<size_t>(source.joint);
            const Vector3d place_m = stands.p_world_joint[joint] +
                                     stands.q_world_joint[joint] * (source.p_segment_source_m +
                                                                    random.gaussianVector(share * kShift_m));
            for (int b = 0; b < static_cast<int>(mics_m.size()); ++b)
                evidence.distances.push_back(
                    {s, b,
                     (mics_m[static_cast<size_t>(b)] - place_m).norm() + random.gaussian(share * kDistance_m),
                     kDistance_m});
        }
    }
};

TEST(RestPoseFit, ExplainsExactReadingsInAFewSteps) {
    KnownStand stand(1, 0);
    stand.priors.sigma_pose_rad = 20 * kPose_rad;  // the pose is free, evidence decides
    const RestFit fit = stand.fitter.fit(stand.priors, stand.evidence, 40);
    EXPECT_TRUE(fit.converged);
    EXPECT_LE(fit.iterations, 8) << "derivatives that are wrong take more";
    const GlobalPose found = globalPose(stand.actor.skeleton, fit.pose);
    for (const UpEvidence& up : stand.evidence.ups) {
        const BoardPrior& board = stand.priors.boards[static_cast<size_t>(up.board)];
        const Vector3d up_world =
            found.q_world_joint[static_cast<size_t>(board.joint)] * (board.q_segment_board * up.up_board);
        EXPECT_LT(std::acos(std::min(1.0, up_world.y())), radians(0.1)) << "board " << up.board;
    }
    for (const double residual_m : fit.distance_residual_m)
        EXPECT_LT(std::abs(residual_m), 5e-4);
}

/// The fit ends where no shift makes it better, by differences of its own cost.
TEST(RestPoseFit, EndsAtTheBottom) {
    const KnownStand stand(2);
    const RestFit fit = stand.fitter.fit(stand.priors, stand.evidence, 60);
    ASSERT_TRUE(fit.converged);
    const double step_m = 1e-4;
    const auto costAt = [&](size_t board, int axis, double move_m) {
        RestFit moved = fit;
        moved.board_shift_m[board][axis] += move_m;
        return stand.fitter.fit(stand.priors, stand.evidence, 0, &moved).cost;
    };
    for (const size_t board : {0U, 6U, 13U})
        for (int axis = 0; axis < 3; ++axis) {
            const double up = costAt(board, axis, step_m), down = costAt(board, axis, -step_m);
            const double curve = (up + down - 2 * fit.cost) / (step_m * step_m);
            EXPECT_GT(curve, 1 / (kShift_m * kShift_m));
            EXPECT_LT(std::abs((up - down) / (2 * step_m) / curve), 2e-5) << "m to the bottom";
        }
}

/// Squared errors of all freedoms together over their covariance.
TEST(RestPoseFit, CovarianceIsHonest) {
    constexpr int kStands = 60;
    double sum = 0;
    for (int i = 1; i <= kStands; ++i) {
        const KnownStand stand(static_cast<uint64_t>(i));
        RestFit fit = stand.fitter.fit(stand.priors, stand.evidence, 60);
        stand.fitter.addCovariance(stand.priors, stand.evidence, fit);
        sum += test::nees(stand.errorOf(fit), fit.cov_pose);
    }
    std::printf("squared errors of the rest pose over their covariance: %.2f\n", sum / kStands);
    EXPECT_NEAR(sum / kStands, 1, 0.25) << "the robust weights and large angles cost a little";
}

TEST(RestPoseFit, ABoardLeansByWhatThePoseLeavesOver) {
    const BoardPrior prior{0, Vector3d::Zero(), expQuaternion({0.3, -0.2, 0.5}), radians(3), 0.01};
    const Quaterniond q_world_segment = expQuaternion({-0.4, 1.1, 0.2});
    const Quaterniond q_segment_true =
        axisAngle(Vector3d(1, 0.2, -0.4).normalized(), radians(8)) * prior.q_segment_board;
    const UpEvidence up{0, (q_world_segment * q_segment_true).conjugate() * Vector3d::UnitY(), 0};
    const Quaterniond found = RestPoseFit::boardOrientation(prior, up, q_world_segment);
    EXPECT_LT((q_world_segment * (found * up.up_board) - Vector3d::UnitY()).norm(), 1e-9);
    const UpEvidence unsure{0, up.up_board, radians(3)};
    const Quaterniond half = RestPoseFit::boardOrientation(prior, unsure, q_world_segment);
    EXPECT_NEAR(angleBetween(prior.q_segment_board, half), angleBetween(prior.q_segment_board, found) / 2,
                1e-9)
        << "as sure as the strap: half of it each";
}

}  // namespace
}  // namespace noctule
