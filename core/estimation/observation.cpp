// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/observation.h"

#include <algorithm>

#include "core/math/rotation.h"

namespace noctule {
namespace {

void resize(ChainMotion::Columns& columns, Eigen::Index rows, size_t count) {
    const Eigen::Index n = static_cast<Eigen::Index>(count);
    columns.theta.setZero(rows, n);
    columns.rate.setZero(rows, n);
    columns.accel.setZero(rows, n);
}

/// Appends the chain's columns (coordinate, rate, acceleration) to the block.
void append(ObservationBlock& block, const StateLayout& layout, const ChainMotion& chain,
            const ChainMotion::Columns& columns) {
    const Eigen::Index old = block.H.cols(), n = columns.theta.cols();
    block.H.conservativeResize(columns.theta.rows(), old + 3 * n);
    block.H.middleCols(old, n) = columns.theta;
    block.H.middleCols(old + n, n) = columns.rate;
    block.H.middleCols(old + 2 * n, n) = columns.accel;
    constexpr size_t kMore = 3;  // biases
    block.columns.reserve(static_cast<size_t>(block.H.cols()) + kMore);
    for (const auto& c : chain.coordinates())
        block.columns.push_back(layout.theta(c.index));
    for (const auto& c : chain.coordinates())
        block.columns.push_back(layout.rate(c.index));
    for (const auto& c : chain.coordinates())
        block.columns.push_back(layout.accel(c.index));
}

void appendColumn(ObservationBlock& block, int index, const Eigen::VectorXd& column) {
    block.H.conservativeResize(column.size(), block.H.cols() + 1);
    block.H.rightCols<1>() = column;
    block.columns.push_back(index);
}

}  // namespace

void limitPull(ObservationBlock& block, const Eigen::VectorXd& innovation_variance, double huber_sigma) {
    const Eigen::ArrayXd ratio =
        block.residual.array().abs() / innovation_variance.array().sqrt() / huber_sigma;
    block.variance.array() += (ratio - 1).max(0) * innovation_variance.array();
}

ObservationBlock pull(int index, double residual, double variance) {
    return {{index},
            Eigen::MatrixXd::Ones(1, 1),
            Eigen::VectorXd::Constant(1, residual),
            Eigen::VectorXd::Constant(1, variance)};
}

ObservationBlock velocityOfRoot(const StateLayout& layout, const MotionState& motion,
                                const Vector3d& residual, const Vector3d& variance) {
    const Vector3d up_root = motion.q_parent_link[0].conjugate() * Vector3d::UnitY();
    ObservationBlock block{
        {layout.rate(0), layout.rate(1), layout.rate(2), layout.theta(3), layout.theta(4), layout.theta(5)},
        Eigen::MatrixXd(3, 6),
        residual,
        variance};
    block.H << Matrix3d::Identity(), -Vector3d::UnitY().cross(motion.rate.head<3>()) * up_root.transpose();
    return block;
}

ObservationBlock ObservationModel::triad(const BodyState& state, const InertialMeasurement& measurement,
                                         double offset_s, bool is_gyro) {
    const MountedBoard& board = suit_.boards[static_cast<size_t>(measurement.board)];
    const TriadReading& triad = is_gyro ? measurement.gyro : measurement.accel;
    const Vector3d& bias =
        (is_gyro ? state.gyro_bias : state.accel_bias)[static_cast<size_t>(measurement.board)];
    ObservationBlock block;
    if (triad.count == 0 || board.link < 0)
        return block;
    chain_.evaluate(tree_, state.motion, board.link, offset_s);
    placed_ = placeBoard(board, tree_, state.motion, offset_s);
    const auto point = chain_.point(placed_.p_m);
    const Vector3d& omega = chain_.end().omega_rad_per_s;
    const Vector3d sensed = is_gyro ? omega : Vector3d(point.a_m_per_s2 + g_m_per_s2_ * Vector3d::UnitY());

    const Matrix3d R_world_board = chain_.end().R_world_link * placed_.R;
    const Vector3d own_turn_board =
        is_gyro ? Vector3d(placed_.R.transpose() * placed_.omega_rad_per_s) : Vector3d(Vector3d::Zero());
    Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> axes_board(triad.count, 3), axes_world(triad.count, 3);
    block.residual.resize(triad.count);
    block.variance.resize(triad.count);
    for (int i = 0; i < triad.count; ++i) {
        const AxisReading& axis = triad.axes[static_cast<size_t>(i)];
        axes_board.row(i) = axis.sensitive_axis_board.transpose();
        axes_world.row(i) = (R_world_board * axis.sensitive_axis_board).transpose();
        block.residual[i] =
            axis.value - axes_world.row(i).dot(sensed) - axes_board.row(i).dot(bias + own_turn_board);
        block.variance[i] = axis.sigma * axis.sigma;
    }

    resize(columns_, triad.count, chain_.coordinates().size());
    for (size_t k = 0; k < chain_.coordinates().size(); ++k) {
        const auto& c = chain_.coordinates()[k];
        const Eigen::Index column = static_cast<Eigen::Index>(k);
        // A turn of the link turns the sensor too, hence the second term of each derivative by theta.
        const Vector3d turn = chain_.rotationByTheta(c);
        if (is_gyro) {
            columns_.theta.col(column) = axes_world * (chain_.omegaByTheta(c) - turn.cross(sensed));
            columns_.rate.col(column) = axes_world * turn;
        } else {
            const auto d = chain_.pointDerivative(c, point);
            columns_.theta.col(column) = axes_world * (d.a_theta - turn.cross(sensed));
            columns_.rate.col(column) = axes_world * d.a_rate;
            columns_.accel.col(column) = axes_world * d.a_accel;
        }
    }
    chain_.transportToState(columns_);
    append(block, layout_, chain_, columns_);
    const int first_bias = is_gyro ? layout_.gyro_bias : layout_.accel_bias;
    if (first_bias >= 0)
        for (int i = 0; i < 3; ++i)
            appendColumn(block, first_bias + 3 * measurement.board + i, axes_board.col(i));
    return block;
}

ObservationBlock ObservationModel::gyro(const BodyState& state, const InertialMeasurement& measurement,
                                        double offset_s) {
    return triad(state, measurement, offset_s, true);
}

ObservationModel::Acceleration ObservationModel::accel(const BodyState& state,
                                                       const InertialMeasurement& measurement,
                                                       double offset_s) {
    Acceleration result{triad(state, measurement, offset_s, false), 0};
    if (result.block.rows() == 0)
        return result;
    const Vector3d up_board = (chain_.end().R_world_link * placed_.R).transpose() * Vector3d::UnitY();
    for (int i = 0; i < measurement.accel.count; ++i) {
        const AxisReading& axis = measurement.accel.axes[static_cast<size_t>(i)];
        result.motion_m_per_s2 = std::hypot(
            result.motion_m_per_s2, axis.value - g_m_per_s2_ * up_board.dot(axis.sensitive_axis_board));
    }
    return result;
}

Vector3d ObservationModel::pointAt(const BodyState& state, int link, const Vector3d& p_link, double offset_s,
                                   ChainMotion& chain) {
    if (link < 0)
        return p_link;
    chain.evaluate(tree_, state.motion, link, offset_s);
    return chain.point(p_link).p_m;
}

void ObservationModel::addDirectional(ObservationBlock& block, const ChainMotion& chain,
                                      const Vector3d& p_link, const Vector3d& direction) {
    const auto point = chain.point(p_link);
    resize(columns_, 1, chain.coordinates().size());
    for (size_t k = 0; k < chain.coordinates().size(); ++k)
        columns_.theta(0, static_cast<Eigen::Index>(k)) =
            direction.dot(chain.pointDerivative(chain.coordinates()[k], point).p_theta);
    chain.transportToState(columns_);

    // Source and microphone share ancestors: their columns are added, and cancel where nothing moves between.
    const Eigen::Index n = columns_.theta.cols();
    const auto add = [&](int index, double value) {
        const auto found = std::find(block.columns.begin(), block.columns.end(), index);
        if (found != block.columns.end())
            block.H(0, found - block.columns.begin()) += value;
        else
            appendColumn(block, index, Eigen::VectorXd::Constant(1, value));
    };
    if (block.columns.empty()) {
        append(block, layout_, chain, columns_);
        return;
    }
    for (Eigen::Index k = 0; k < n; ++k) {
        const int index = chain.coordinates()[static_cast<size_t>(k)].index;
        add(layout_.theta(index), columns_.theta(0, k));
        add(layout_.rate(index), columns_.rate(0, k));
        add(layout_.accel(index), columns_.accel(0, k));
    }
}

ObservationModel::Distance ObservationModel::distance(const BodyState& state,
                                                      const DistanceMeasurement& measurement,
                                                      double emission_offset_s, double arrival_offset_s) {
    const MountedBoard& board = suit_.boards[static_cast<size_t>(measurement.board)];
    const MountedSource& source = suit_.sources[static_cast<size_t>(measurement.source)];
    const Vector3d p_source =
        pointAt(state, source.link, source.p_link_source, emission_offset_s, other_chain_);
    const Vector3d p_link_mic = placeBoard(board, tree_, state.motion, arrival_offset_s).p_mic_m;
    const Vector3d p_mic = pointAt(state, board.link, p_link_mic, arrival_offset_s, chain_);
    const Vector3d between = p_mic - p_source;
    const double geometric = std::max(between.norm(), 1e-6);
    const Vector3d direction = between / geometric;
    const Vector3d normal =
        source.link < 0 ? source.normal_link : Vector3d(other_chain_.end().R_world_link * source.normal_link);
    Distance result;
    result.cos_angle = normal.dot(direction);
    ObservationBlock& block = result.block;
    const double stretch = 1 + state.sound_scale;
    const double offset_m = state.source_offset_m[static_cast<size_t>(measurement.source)];
    block.residual = Eigen::VectorXd::Constant(1, measurement.distance_m - geometric * stretch - offset_m);
    block.variance = Eigen::VectorXd::Constant(1, measurement.sigma_m * measurement.sigma_m);
    block.H.resize(1, 0);
    if (board.link >= 0)
        addDirectional(block, chain_, p_link_mic, stretch * direction);
    if (source.link >= 0)
        addDirectional(block, other_chain_, source.p_link_source, -stretch * direction);
    if (layout_.source_offset >= 0)
        appendColumn(block, layout_.source_offset + measurement.source, Eigen::VectorXd::Ones(1));
    if (layout_.sound_scale >= 0)
        appendColumn(block, layout_.sound_scale, Eigen::VectorXd::Constant(1, geometric));
    return result;
}

ObservationModel::End ObservationModel::sourceEnd(const BodyState& state, int source, double offset_s) {
    const MountedSource& mounted = suit_.sources[static_cast<size_t>(source)];
    end_link_ = mounted.link;
    p_link_end_ = mounted.p_link_source;
    End end{pointAt(state, end_link_, p_link_end_, offset_s, chain_), mounted.normal_link};
    if (end_link_ >= 0)
        end.normal_world = chain_.end().R_world_link * mounted.normal_link;
    return end;
}

ObservationModel::End ObservationModel::boardEnd(const BodyState& state, int board, double offset_s) {
    const MountedBoard& mounted = suit_.boards[static_cast<size_t>(board)];
    end_link_ = mounted.link;
    p_link_end_ = placeBoard(mounted, tree_, state.motion, offset_s).p_mic_m;
    return {pointAt(state, end_link_, p_link_end_, offset_s, chain_), Vector3d::Zero()};
}

ObservationModel::End ObservationModel::linkEnd(const BodyState& state, int link) {
    end_link_ = link;
    p_link_end_ = Vector3d::Zero();
    return {pointAt(state, end_link_, p_link_end_, 0, chain_), Vector3d::Zero()};
}

void ObservationModel::addEnd(ObservationBlock& block, const Vector3d& direction) {
    if (end_link_ >= 0)
        addDirectional(block, chain_, p_link_end_, direction);
}

ObservationBlock ObservationModel::root(const BodyState& state, const RootMeasurement& measurement,
                                        double offset_s) {
    chain_.evaluate(tree_, state.motion, tree_.linkOfJoint(0), offset_s);
    const Matrix3d& R = chain_.end().R_world_link;
    ObservationBlock block;
    block.residual.resize(6);
    block.residual << measurement.p_world_root - chain_.end().p_m,
        logQuaternion(Quaterniond(R).conjugate() * measurement.q_world_root);
    block.variance.resize(6);
    block.variance << Vector3d::Constant(measurement.sigma_p_m * measurement.sigma_p_m),
        Vector3d::Constant(measurement.sigma_q_rad * measurement.sigma_q_rad);
    resize(columns_, 6, chain_.coordinates().size());
    for (size_t k = 0; k < chain_.coordinates().size(); ++k) {
        const auto& c = chain_.coordinates()[k];
        if (c.translation)
            columns_.theta.col(static_cast<Eigen::Index>(k)).head<3>() = c.axis;
        else
            columns_.theta.col(static_cast<Eigen::Index>(k)).tail<3>() = R.transpose() * c.axis;
    }
    chain_.transportToState(columns_);
    append(block, layout_, chain_, columns_);
    return block;
}

}  // namespace noctule
