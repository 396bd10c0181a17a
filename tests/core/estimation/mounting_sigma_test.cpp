// SPDX-License-Identifier: Apache-2.0
// What a calibration says of its mountings goes into the sigmas of joints.
#include <gtest/gtest.h>

#include "core/estimation/prediction.h"
#include "tests/core/estimation/small_world.h"

namespace noctule {
namespace {

constexpr int kChest = 1, kArm = 2;  // joints, and links of the small body

class MountingSigma : public ::testing::Test {
protected:
    MountingSigma() : by_link(tree.links().size(), Matrix3d::Zero()) {
        Pose pose = skeleton.zeroPose();
        pose.q_parent_joint[kChest] = q_hips_chest;
        motion = tree.stateFromPose(pose);
    }
    Vector3d sigmas(int joint, double flesh_rad2 = 0) const {
        const int n = tree.freedoms();
        const Eigen::MatrixXd P = 1e-4 * Eigen::MatrixXd::Identity(n, n);
        return Vector3d::Map(jointSigmas(tree, skeleton, motion, P, flesh_rad2, by_link).data() + 3 * joint);
    }

    const Quaterniond q_hips_chest = expQuaternion(Vector3d(0.3, 0.5, 0.7));
    Skeleton skeleton = testing::smallSkeleton();
    KinematicTree tree{skeleton, BallCoordinates::kManifold};
    std::vector<Matrix3d> by_link;
    MotionState motion;
};

TEST_F(MountingSigma, IsThatOfBothLinksInTheFrameOfTheLowerOne) {
    by_link[0] = Vector3d(4e-4, 0, 0).asDiagonal();
    by_link[kChest] = Vector3d(0, 0, 8e-4).asDiagonal();
    const Vector3d x_hips = q_hips_chest.conjugate() * Vector3d::UnitX();  // in the chest's frame
    const Vector3d variances = Vector3d(1e-4, 1e-4, 9e-4) + 4e-4 * x_hips.cwiseAbs2();
    EXPECT_LT((sigmas(kChest) - variances.cwiseSqrt()).norm(), 1e-12);
    EXPECT_NEAR(sigmas(kArm).z(), 0.03, 1e-12) << "the chest is above the arm";
    by_link.clear();
    EXPECT_LT((sigmas(kChest) - Vector3d::Constant(0.01)).norm(), 1e-12);
}

TEST_F(MountingSigma, OrWhatTheMotionShowsOfFleshIfThatIsMore) {
    by_link[kChest] = Vector3d(0, 0, 8e-4).asDiagonal();
    EXPECT_LT((sigmas(kChest, 3e-4) - Vector3d(0.02, 0.02, 0.03)).norm(), 1e-12);
}

TEST_F(MountingSigma, SeveralBoardsOnALinkShareWhatTheyErrBy) {
    SuitModel suit;
    MountedBoard board;
    board.link = kArm;
    board.R_link_board = expQuaternion(Vector3d(0.3, 0.5, 0.7)).toRotationMatrix();
    board.sigma_mounting_rad = {0.02, 0, 0.01};
    const Vector3d x = board.R_link_board.col(0), z = board.R_link_board.col(2);
    const Matrix3d expected = 4e-4 * x * x.transpose() + 1e-4 * z * z.transpose();
    for (const size_t boards : {1u, 2u}) {
        suit.boards.assign(boards, board);
        EXPECT_LT((mountingCovariances(suit, tree, 0.5)[kArm] - expected).norm(), 1e-12) << boards;
    }
    suit.boards[1].sigma_mounting_rad = Vector3d::Zero();
    EXPECT_LT((mountingCovariances(suit, tree, 0.5)[kArm] - expected).norm(), 1e-12) << "one is exact";
    suit.boards[0].link = -1;
    EXPECT_EQ(mountingCovariances(suit, tree, 0.5)[0], Matrix3d::Zero())
        << "what stands in the room is on no link";
}

/// After a rest pose alone nothing is stated, which is not the same as zero.
TEST_F(MountingSigma, WhereNothingIsStatedIsAssumed) {
    Calibration calibration = nominalCalibration(testing::smallSuit());
    const auto ofTheHips = [&] {
        const Actor actor = testing::actorOf(skeleton);
        const SuitModel suit = mountSuit(testing::smallSuit(), calibration, actor, tree).value();
        return mountingCovariances(suit, tree, 0.03)[0];
    };
    EXPECT_LT((ofTheHips() - 9e-4 * Matrix3d::Identity()).norm(), 1e-12);
    for (BoardCalibration& board : calibration.boards)
        board.sigma_mounting_rad = Vector3d::Zero();
    EXPECT_EQ(ofTheHips(), Matrix3d::Zero()) << "stated to be exact";
}

/// A neck that does not turn hides the chest from the head no more than a link of no board would.
TEST(MountingSigmas, ReachThroughFixedJoints) {
    std::vector<Joint> joints = testing::smallSkeleton().joints();
    joints.resize(2);
    joints.push_back({"Neck", 1, {0, 0.2, 0}, JointType::kFixed, {}, {}, {}});
    Joint head = joints[1];
    head.name = "Head";
    head.parent = 2;
    joints.push_back(head);
    const Skeleton skeleton = Skeleton::make(joints).value();
    const KinematicTree tree(skeleton, BallCoordinates::kManifold);
    std::vector<Matrix3d> by_link(tree.links().size(), Matrix3d::Zero());
    by_link[static_cast<size_t>(tree.linkOfJoint(1))] = Vector3d(0, 0, 8e-4).asDiagonal();
    const int n = tree.freedoms();
    const auto sigmas = jointSigmas(tree, skeleton, tree.stateFromPose(skeleton.zeroPose()),
                                    1e-4 * Eigen::MatrixXd::Identity(n, n), 0, by_link);
    EXPECT_LT((Vector3d::Map(sigmas.data() + 9) - Vector3d(0.01, 0.01, 0.03)).norm(), 1e-12);
    EXPECT_EQ(sigmas[8], 0) << "the neck itself does not move";
}

/// Mean of |error|^2 / (3 sigma^2) of the chest against the hips, whose attitude is given, over runs in each
/// of which the chest's board hangs otherwise than believed.
double neesOfTheChest(const std::optional<Vector3d>& stated_rad) {
    constexpr double kTurned_rad = radians(2);
    constexpr unsigned kRuns = 24;
    double nees = 0;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        ManifoldParameters parameters = testing::fittingParameters({true, true, false}, true);
        parameters.joints_give = true;  // a turned board makes joints seem to give
        testing::World world(parameters, seed);
        SuitModel believed = world.suit;
        believed.boards[kChest].sigma_mounting_rad = stated_rad;
        Matrix3d& R_link_board = world.suit.boards[kChest].R_link_board;
        R_link_board = R_link_board * expQuaternion(world.random.vector(kTurned_rad)).toRotationMatrix();
        ManifoldFilter filter(testing::smallSkeleton(), believed, parameters);
        filter.start(testing::smallSkeleton().zeroPose(), {}, nullptr);
        std::vector<Quaterniond> truth{Quaterniond::Identity()};  // per frame
        testing::play(world, filter, 3, [&](int64_t, double time_s) {
            filter.advanceTo(time_s + testing::kUntilSure_s);
            truth.push_back(world.tree.poseFromState(world.motion).q_parent_joint[kChest]);
        });
        const TimedPose last = filter.takePoses().back();
        const auto frame = std::llround(static_cast<double>(last.time_ns) * 1e-9 * kInertialFramesPerSecond);
        const Vector3d error =
            logQuaternion(truth[static_cast<size_t>(frame)].conjugate() * last.pose->q_parent_joint[kChest]);
        nees += error.cwiseQuotient(Vector3d::Map(last.sigma_rad.data() + 3 * kChest)).squaredNorm() /
                (3 * kRuns);
    }
    return nees;
}

TEST(MountingSigmas, AreHonestWhereBoardsHangOtherwiseThanBelieved) {
    const double stated = neesOfTheChest(Vector3d::Constant(radians(2))),
                 silent = neesOfTheChest(Vector3d::Zero()), assumed = neesOfTheChest(std::nullopt);
    // 24 runs of three axes: the mean spreads by 0.2.
    EXPECT_GT(stated, 0.6);
    EXPECT_LT(stated, 1.6);
    EXPECT_GT(silent, 5) << "else the test tells nothing";
    EXPECT_GT(assumed, 0.3) << "2 degrees, where 2.5 are assumed";
    EXPECT_LT(assumed, 1.6);
}

}  // namespace
}  // namespace noctule
