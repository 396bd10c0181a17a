// SPDX-License-Identifier: Apache-2.0
// The paper's three observation models (Vlasic 2007, equations 2 to 4) and the given root, linearised with
// analytic Jacobians. Each measurement is predicted at its own instant: the body is carried from the state's
// time with accelerations held, and the Jacobian is taken back to the state's time.
#pragma once

#include <vector>

#include "core/body/kinematics.h"
#include "core/estimation/measurement.h"
#include "core/estimation/suit_model.h"

namespace noctule {

/// Where things stand in a filter's error state: coordinates, their rates and accelerations (one block each,
/// in the order of the tree's velocity indices), then what is listed here; -1: not estimated.
struct StateLayout {
    int freedoms = 0;
    int gyro_bias = -1;      ///< 3 per board, rad/s
    int accel_bias = -1;     ///< 3 per board, m/s^2
    int source_offset = -1;  ///< 1 per source, m: constant error of the source's distances
    int sound_scale = -1;    ///< relative error of the speed of sound
    int size = 0;

    int theta(int index) const { return index; }
    int rate(int index) const { return freedoms + index; }
    int accel(int index) const { return 2 * freedoms + index; }
};

/// The state that observations are predicted from. Biases are sized by the suit, zero when not estimated.
struct BodyState {
    MotionState motion;
    std::vector<Vector3d> gyro_bias, accel_bias;  ///< per board
    std::vector<double> source_offset_m;          ///< per source
    double sound_scale = 0;
};

/// What a block was made of, so that it can be made again about another state.
struct ObservationOrigin {
    /// kPull: single states that are pulled to known values; kTurn: a limb that was found elsewhere; kGain:
    /// what a board felt over a window.
    enum class Kind { kPull, kTurn, kGyro, kAccel, kGain, kDistance, kRoot, kGive };
    Kind kind = Kind::kPull;
    /// Of the reading in its step; of the joint's constraint; kTurn: of the link; kGain: of the board.
    int index = 0;
    /// kGive: of the deviation what was let be, if not all counts; kDistance: the distance that was believed;
    /// kPull: the values; kTurn: the quaternions from its parent and to the axes of its variances, x y z w;
    /// kGain: the packed windows; kGyro, kAccel: what the readings' ends of ranges stood for, less those
    /// ends, empty when there were none.
    Eigen::VectorXd target;
};

/// Linearised measurements: residual = measured - expected = H * error + noise, H given by its non-zero
/// columns.
struct ObservationBlock {
    std::vector<int> columns;
    Eigen::MatrixXd H;  ///< rows x columns.size()
    Eigen::VectorXd residual;
    Eigen::VectorXd variance;  ///< of the noise; diagonal
    ObservationOrigin origin = {};

    Eigen::Index rows() const { return residual.size(); }
    /// H error, of all states.
    Eigen::VectorXd of(const Eigen::VectorXd& error) const { return H * error(columns); }
};

/// One state pulled towards a value that is `residual` away.
ObservationBlock pull(int index, double residual, double variance);

/// What is known of the root's velocity without knowing the heading: `residual` along the world's axes, but
/// turned about the vertical together with the velocity the body would be as likely.
ObservationBlock velocityOfRoot(const StateLayout& layout, const MotionState& motion,
                                const Vector3d& residual, const Vector3d& variance);

/// Huber: an innovation beyond `huber_sigma` of what is expected of it pulls no further, by more variance.
void limitPull(ObservationBlock& block, const Eigen::VectorXd& innovation_variance, double huber_sigma);

/// Predicts measurements of one suit on one tree. Holds scratch space; not shared between threads.
class ObservationModel {
public:
    ObservationModel(const KinematicTree& tree, const SuitModel& suit, const StateLayout& layout,
                     double g_m_per_s2 = kStandardGravity_m_per_s2)
        : tree_(tree), suit_(suit), layout_(layout), g_m_per_s2_(g_m_per_s2) {}

    /// Equation 3. `offset_s` is the reading's instant minus the state's time.
    ObservationBlock gyro(const BodyState& state, const InertialMeasurement& measurement, double offset_s);
    struct Acceleration {
        ObservationBlock block;
        double motion_m_per_s2 = 0;  ///< length of the reading without gravity, as far as its axes tell
    };
    /// Equation 2.
    Acceleration accel(const BodyState& state, const InertialMeasurement& measurement, double offset_s);

    struct Distance {
        ObservationBlock block;
        double cos_angle = 1;  ///< between the source's normal and the direction to the microphone
    };
    /// Equation 4 with source and microphone at their own times. `variance` is left to the caller.
    Distance distance(const BodyState& state, const DistanceMeasurement& measurement,
                      double emission_offset_s, double arrival_offset_s);
    /// Position (3 rows), then rotation (3 rows, right perturbation) of the root.
    ObservationBlock root(const BodyState& state, const RootMeasurement& measurement, double offset_s);

    /// One end of a distance of which other bodies have the other end.
    struct End {
        Vector3d p_world_m = Vector3d::Zero();
        Vector3d normal_world = Vector3d::Zero();  ///< of a source
    };
    End sourceEnd(const BodyState& state, int source, double offset_s);
    End boardEnd(const BodyState& state, int board, double offset_s);
    /// The origin of a link.
    End linkEnd(const BodyState& state, int link);
    /// Adds to a block of one row the derivative, along `direction`, of the end that was asked for last.
    void addEnd(ObservationBlock& block, const Vector3d& direction);

private:
    ObservationBlock triad(const BodyState& state, const InertialMeasurement& measurement, double offset_s,
                           bool is_gyro);
    /// Position of a point on a link (-1: the world) and its derivative along `direction` by all coordinates.
    Vector3d pointAt(const BodyState& state, int link, const Vector3d& p_link, double offset_s,
                     ChainMotion& chain);
    void addDirectional(ObservationBlock& block, const ChainMotion& chain, const Vector3d& p_link,
                        const Vector3d& direction);

    const KinematicTree& tree_;
    const SuitModel& suit_;
    const StateLayout& layout_;
    double g_m_per_s2_;
    ChainMotion chain_, other_chain_;
    PlacedBoard placed_;  ///< the board of the last triad
    ChainMotion::Columns columns_;
    int end_link_ = -1;  ///< of the end asked for last
    Vector3d p_link_end_ = Vector3d::Zero();
};

}  // namespace noctule
