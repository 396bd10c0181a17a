// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/velocity_gain.h"

#include <algorithm>
#include <cmath>

#include "core/inertial/reading.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr Eigen::Index kFixedNumbers = 14;  // count of columns, seconds, sum, its derivative

}  // namespace

Eigen::VectorXd VelocityWindow::packed() const {
    Eigen::VectorXd numbers(kFixedNumbers + v_begin_m_per_s.size());
    numbers << static_cast<double>(v_begin_m_per_s.cols()), lasted_s, felt_m_per_s, felt_by_bias_s.reshaped(),
        v_begin_m_per_s.reshaped();
    return numbers;
}

std::pair<VelocityWindow, Eigen::VectorXd> VelocityWindow::unpacked(const Eigen::VectorXd& numbers) {
    const auto columns = static_cast<Eigen::Index>(numbers[0]);
    VelocityWindow window{numbers[1], numbers.segment<3>(2), numbers.segment<9>(5).reshaped(3, 3),
                          numbers.segment(kFixedNumbers, 3 * columns).reshaped(3, columns)};
    return {window, numbers.tail(numbers.size() - kFixedNumbers - 3 * columns)};
}

Eigen::Matrix3Xd velocitiesOf(const ChainMotion& chain, const Vector3d& p_link_m) {
    const Vector3d v_point = chain.point(p_link_m).v_m_per_s;
    Eigen::Matrix3Xd velocities(3, std::ssize(chain.frames()) + 1);
    for (size_t i = 0; i < chain.frames().size(); ++i)
        velocities.col(static_cast<Eigen::Index>(i)) = v_point - chain.frames()[i].v_m_per_s;
    velocities.rightCols<1>() = v_point;
    return velocities;
}

/// A turn of a link turns what its board felt and what everything below its pivot gained.
ObservationBlock observeGain(const VelocityWindow& window, const ChainMotion& chain,
                             const PlacedBoard& placed, const Vector3d& bias_m_per_s2, int accel_bias,
                             const StateLayout& layout, double g_m_per_s2) {
    const Matrix3d R_world_board = chain.end().R_world_link * placed.R;
    const Matrix3d by_bias = R_world_board * window.felt_by_bias_s;
    const Vector3d felt = R_world_board * window.felt_m_per_s - by_bias * bias_m_per_s2;
    const Eigen::Matrix3Xd gained = velocitiesOf(chain, placed.p_m) - window.v_begin_m_per_s;
    ObservationBlock block;
    block.residual = felt - gained.rightCols<1>() - g_m_per_s2 * window.lasted_s * Vector3d::UnitY();
    block.variance = Vector3d::Zero();
    const auto& coordinates = chain.coordinates();
    const int biases = accel_bias >= 0 ? 3 : 0;
    block.H.resize(3, std::ssize(coordinates) + biases);
    for (size_t k = 0; k < coordinates.size(); ++k) {
        const ChainMotion::Coordinate& c = coordinates[k];
        block.H.col(static_cast<Eigen::Index>(k)) =
            chain.rotationByTheta(c).cross(Vector3d(gained.col(c.frame) - felt));
        block.columns.push_back(layout.theta(c.index));
    }
    block.H.rightCols(biases) = by_bias.leftCols(biases);
    for (int i = 0; i < biases; ++i)
        block.columns.push_back(accel_bias + i);
    return block;
}

ObservationBlock lessTheOther(ObservationBlock one, const ObservationBlock& other) {
    one.residual -= other.residual;
    one.variance += other.variance;
    for (size_t k = 0; k < other.columns.size(); ++k) {
        auto found = std::find(one.columns.begin(), one.columns.end(), other.columns[k]);
        if (found == one.columns.end()) {
            one.H.conservativeResize(Eigen::NoChange, one.H.cols() + 1);
            one.H.rightCols<1>().setZero();
            one.columns.push_back(other.columns[k]);
            found = std::prev(one.columns.end());
        }
        one.H.col(found - one.columns.begin()) -= other.H.col(static_cast<Eigen::Index>(k));
    }
    return one;
}

void leaveHeadingUntold(ObservationBlock& block, const StateLayout& layout, const MotionState& motion) {
    constexpr int kRootRotation = 3;  // of a free root, after its place
    const Vector3d up_root = motion.q_parent_link[0].conjugate() * Vector3d::UnitY();
    const Vector3d turned = Vector3d::UnitY().cross(Vector3d(block.residual));
    for (size_t k = 0; k < block.columns.size(); ++k)
        if (const int axis = block.columns[k] - layout.theta(kRootRotation); axis >= 0 && axis < 3)
            block.H.col(static_cast<Eigen::Index>(k)) += up_root[axis] * turned;
}

void VelocityGain::add(double time_s, const Vector3d& rate_rad_per_s, const Vector3d& force_m_per_s2) {
    if (last_ && time_s - last_->time_s > parameters_.longest_s)
        breakOff();
    const auto last = std::exchange(last_, Reading{time_s, rate_rad_per_s, force_m_per_s2});
    if (!last)
        return;
    const double dt_s = time_s - last->time_s;
    shaken_m_per_s2_ = std::max(std::abs(force_m_per_s2.norm() - kStandardGravity_m_per_s2),
                                shaken_m_per_s2_ * std::exp(-dt_s / parameters_.wobble_s));
    const Matrix3d before = q_begin_now_.toRotationMatrix();
    q_begin_now_ *= expQuaternion(0.5 * dt_s * (last->rate_rad_per_s + rate_rad_per_s));
    q_begin_now_.normalize();
    const Matrix3d now = q_begin_now_.toRotationMatrix();
    sum_.felt_m_per_s += 0.5 * dt_s * (before * last->force_m_per_s2 + now * force_m_per_s2);
    sum_.felt_by_bias_s += 0.5 * dt_s * (before + now);
    sum_.lasted_s += dt_s;
}

double VelocityGain::endVariance() const {
    return std::pow(parameters_.still_m_per_s, 2) + std::pow(parameters_.per_motion_s * shaken_m_per_s2_, 2);
}

void VelocityGain::open(const Eigen::Matrix3Xd& velocities_m_per_s) {
    begin_variance_ = endVariance();
    q_begin_now_.setIdentity();
    sum_ = {};
    sum_.v_begin_m_per_s = velocities_m_per_s;
}

double VelocityGain::variance_m2_per_s2() const {
    return begin_variance_ + endVariance();
}

std::optional<VelocityWindow> VelocityGain::window(double time_s) const {
    constexpr double kFrame_s = 1.0 / kInertialFramesPerSecond;
    if (sum_.v_begin_m_per_s.size() == 0 || !last_ || last_->time_s < time_s - 0.5 * kFrame_s ||
        sum_.lasted_s < (parameters_.frames - 0.5) * kFrame_s)
        return std::nullopt;
    const Matrix3d R_now_begin = q_begin_now_.conjugate().toRotationMatrix();
    return VelocityWindow{sum_.lasted_s, R_now_begin * sum_.felt_m_per_s, R_now_begin * sum_.felt_by_bias_s,
                          sum_.v_begin_m_per_s};
}

}  // namespace noctule
