// SPDX-License-Identifier: Apache-2.0
// The most likely pose near the rest pose, given which way is up on every board and how far apart sources and
// microphones are (Vlasic 2007, section 5.4, plus distances). Gauss-Newton over the pose's freedoms and the
// places of boards and sources, robust (Cauchy) in every direction and distance. Boards' orientations are
// eliminated: what the pose leaves over of the direction of up is the board's tilt, its turn about the
// vertical shows in nothing and stays as expected (boardOrientation). World: Y up; the root neither
// moves nor turns about the vertical. SI units.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/body/actor.h"
#include "core/body/kinematics.h"
#include "core/suit/suit.h"

namespace noctule {

/// Where a board is thought to sit, and how sure that is. Joint -1: not on the body, no part of the fit.
struct BoardPrior {
    int joint = -1;
    Vector3d p_segment_mic_m = Vector3d::Zero();
    Quaterniond q_segment_board = Quaterniond::Identity();
    double sigma_turn_rad = 0, sigma_shift_m = 0;  ///< per axis
};

struct SourcePrior {
    int joint = -1;
    Vector3d p_segment_source_m = Vector3d::Zero();
    double sigma_shift_m = 0;
};

struct RestPriors {
    std::vector<BoardPrior> boards;
    std::vector<SourcePrior> sources;
    double sigma_pose_rad = 0;  ///< per freedom
};

/// The direction that a board's accelerometer calls up.
struct UpEvidence {
    int board = 0;
    Vector3d up_board = Vector3d::UnitY();  ///< unit vector
    double sigma_rad = 0;                   ///< of the sensor alone
};

struct DistanceEvidence {
    int source = 0, board = 0;
    double distance_m = 0, sigma_m = 0;
};

struct RestEvidence {
    std::vector<UpEvidence> ups;
    std::vector<DistanceEvidence> distances;
};

struct RestFit {
    Pose pose;
    Eigen::VectorXd deviation_rad;                        ///< per velocity index of the tree
    Eigen::MatrixXd cov_pose;                             ///< of these; empty unless asked for
    std::vector<Vector3d> board_shift_m, source_shift_m;  ///< in the segments' frames
    std::vector<double> distance_residual_m;              ///< measured minus expected, as the evidence
    double cost = 0;                                      ///< -2 log likelihood, up to a constant
    int iterations = 0;
    bool converged = false;

    friend class RestPoseFit;

private:
    MotionState state_;
};

class RestPoseFit {
public:
    explicit RestPoseFit(const Actor& actor);

    /// Iterates at most so often; from `start` (a fit with as many boards and sources) instead of the rest
    /// pose.
    RestFit fit(const RestPriors& priors, const RestEvidence& evidence, int most_iterations,
                const RestFit* start = nullptr) const;
    /// Fills in cov_pose.
    void addCovariance(const RestPriors& priors, const RestEvidence& evidence, RestFit& fit) const;

    /// q_segment_board: the board's prior, tilted by what its own up leaves over (less when the accelerometer
    /// is no surer than the strap).
    static Quaterniond boardOrientation(const BoardPrior& board, const UpEvidence& up,
                                        const Quaterniond& q_world_segment);

    const KinematicTree& tree() const { return tree_; }
    /// Covariance of a segment's orientation in the world, as a rotation about the world's axes.
    Matrix3d segmentCovariance(const RestFit& fit, int joint) const;

private:
    struct Equations;
    /// To the segments of boards and sources; empty ones for those that are not on the body.
    struct Chains {
        std::vector<ChainMotion> boards, sources;
    };
    Chains chainsOf(const RestPriors& priors, const MotionState& state) const;
    RestFit begin(const RestPriors& priors) const;
    void assemble(const RestPriors& priors, const RestEvidence& evidence, RestFit& fit,
                  Equations* into) const;
    void addPose(const RestPriors& priors, RestFit& fit, Equations* into) const;
    static void addUp(const BoardPrior& board, const UpEvidence& up, const ChainMotion& chain, RestFit& fit,
                      Equations* into);
    void addDistance(const RestPriors& priors, const DistanceEvidence& distance, const Chains& chains,
                     RestFit& fit, Equations* into) const;
    RestFit moved(const RestFit& fit, const Eigen::VectorXd& step) const;

    KinematicTree tree_;
    MotionState rest_;
};

}  // namespace noctule
