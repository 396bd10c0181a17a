// SPDX-License-Identifier: Apache-2.0
// How boards on flesh lie against the vertical, and limbs against each other, from all that accelerometers
// felt in a window. The board's own gyroscope brings the forces to one frame, whatever flesh does meanwhile;
// their sum is gravity times the window, and the velocity that the board has gained. What flesh adds to a
// velocity is bounded, so it counts the less the longer the window; what it adds to a single force is often
// larger than the motion, and a filter that believes forces one by one must believe each of them little.
// Errors of the attitude count as constant over a window.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <utility>

#include "core/body/kinematics.h"
#include "core/estimation/observation.h"

namespace noctule {

struct VelocityGainParameters {
    int frames = 140;         ///< of a window
    double longest_s = 0.03;  ///< between readings; more is a gap
    /// Of a velocity at an end of the window: of a body at rest, and more by the largest force lately.
    double still_m_per_s = 0.02, per_motion_s = 0.003, wobble_s = 0.3;
    double least_flesh_share = 0.05;  ///< on less flesh each force tells more
    double huber_sigma = 2.5;
};

/// One board, one window, as it is when it ends.
struct VelocityWindow {
    double lasted_s = 0;
    Vector3d felt_m_per_s = Vector3d::Zero();    ///< sum of forces, bias included, in the board's frame
    Matrix3d felt_by_bias_s = Matrix3d::Zero();  ///< its derivative
    Eigen::Matrix3Xd v_begin_m_per_s{};          ///< velocitiesOf() when it began

    Eigen::VectorXd packed() const;
    /// The first that `numbers` hold, and what follows it.
    static std::pair<VelocityWindow, Eigen::VectorXd> unpacked(const Eigen::VectorXd& numbers);
};

/// Velocity of a point on the chain's last link against each pivot of the chain, and in the world: world
/// axes, a column each.
Eigen::Matrix3Xd velocitiesOf(const ChainMotion& chain, const Vector3d& p_link_m);

/// What a window says of the state at its end; without variance. `chain` ends with the board's link;
/// `accel_bias`: its place in the state, -1 for none.
ObservationBlock observeGain(const VelocityWindow& window, const ChainMotion& chain,
                             const PlacedBoard& placed, const Vector3d& bias_m_per_s2, int accel_bias,
                             const StateLayout& layout, double g_m_per_s2);

/// `one` less `other`, whose columns may be the same; variances add up.
ObservationBlock lessTheOther(ObservationBlock one, const ObservationBlock& other);

/// For a free root: what remains, along the world's axes, turns together with the body about the vertical, so
/// that it tells nothing of the heading (heading_shift.h).
void leaveHeadingUntold(ObservationBlock& block, const StateLayout& layout, const MotionState& motion);

/// Sums up one board's readings.
class VelocityGain {
public:
    explicit VelocityGain(const VelocityGainParameters& parameters = {}) : parameters_(parameters) {}

    /// In the board's frame, the rate without its bias.
    void add(double time_s, const Vector3d& rate_rad_per_s, const Vector3d& force_m_per_s2);
    /// The board's turn was not seen.
    void breakOff() { *this = VelocityGain(parameters_); }
    void open(const Eigen::Matrix3Xd& velocities_m_per_s);
    /// Up to `time_s`, when it lasted whole.
    std::optional<VelocityWindow> window(double time_s) const;
    /// Of the velocity gained.
    double variance_m2_per_s2() const;

private:
    double endVariance() const;

    struct Reading {
        double time_s;
        Vector3d rate_rad_per_s, force_m_per_s2;
    };
    VelocityGainParameters parameters_;
    std::optional<Reading> last_;
    double shaken_m_per_s2_ = 0, begin_variance_ = 0;
    Quaterniond q_begin_now_ = Quaterniond::Identity();
    VelocityWindow sum_;  ///< in the board's frame when it began; no velocities: none is open
};

}  // namespace noctule
