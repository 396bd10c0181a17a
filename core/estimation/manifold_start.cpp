// SPDX-License-Identifier: Apache-2.0
// How the filter begins: from the pose that was asked for and what the boards read while it was held.
#include <cmath>

#include "core/body/usual_pose.h"
#include "core/estimation/manifold_filter.h"

namespace noctule {
namespace {

constexpr int kRestIterations = 6;

}  // namespace

void ManifoldFilter::initialise(const Pose& rest_pose) {
    const auto square = [](double x) { return x * x; };
    now_.state.motion = tree_.stateFromPose(rest_pose);
    expectUsualPose(rest_pose);
    now_.state.gyro_bias.assign(suit_.boards.size(), Vector3d::Zero());
    now_.state.accel_bias.assign(suit_.boards.size(), Vector3d::Zero());
    now_.state.source_offset_m.assign(suit_.sources.size(), 0.0);
    now_.state.sound_scale = 0;
    const int n = layout_.freedoms;
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(layout_.size);
    variance.segment(0, n).setConstant(square(parameters_.initial_pose_rad));
    variance.segment(n, n).setConstant(square(parameters_.rest_rate_rad_per_s));
    variance.segment(2 * n, n).setConstant(square(parameters_.rest_accel_rad_per_s2));
    const auto fill = [&](int first, size_t count, double sigma) {
        if (first >= 0)
            variance.segment(first, static_cast<Eigen::Index>(count)).setConstant(square(sigma));
    };
    fill(layout_.gyro_bias, 3 * suit_.boards.size(), parameters_.gyro_bias_rad_per_s);
    fill(layout_.accel_bias, 3 * suit_.boards.size(), parameters_.accel_bias_m_per_s2);
    fill(layout_.source_offset, suit_.sources.size(), parameters_.source_offset_m);
    fill(layout_.sound_scale, 1, parameters_.sound_scale);
    now_.P = Covariance(variance);
}

void ManifoldFilter::expectUsualPose(const Pose& rest_pose) {
    Pose pose = rest_pose;
    usual_variance_.setConstant(tree_.freedoms(), std::pow(parameters_.unlearnt_rad, 2));
    for (const Link& link : tree_.links()) {
        const auto usual = usualTurn(skeleton_.joint(link.joint).name);
        if (!usual || link.count == 0)
            continue;
        pose.q_parent_joint[static_cast<size_t>(link.joint)] = usual->q_parent_joint;
        const Eigen::Array3d variance =
            usual->sigma_rad.array().square() + std::pow(parameters_.unusual_rad, 2);
        if (link.type == LinkType::kHinge)
            usual_variance_[link.first] = (variance * link.axis.array().square()).sum();
        else
            usual_variance_.segment<3>(link.first) = variance.matrix();
    }
    usual_ = tree_.stateFromPose(pose);
}

void ManifoldFilter::start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) {
    Pose pose = rest_pose;
    if (root) {
        pose.p_world_root = root->p_world_root;
        pose.q_parent_joint[0] = root->q_world_root;
    }
    initialise(pose);
    correct(now_.P.update(now_.give.initial(now_.state.motion)));
    now_.step_index = static_cast<int64_t>(std::ceil(rest.end_s / step_s_ - 1e-9));
    settle(rest, root);
    now_.ground = GroundContacts(skeleton_, tree_, suit_, now_.state.motion, groundParameters());
    if (rest.end_s > rest.begin_s)
        now_.ground.rest(rest.begin_s, rest.end_s, contacts_);
    const int n = layout_.freedoms;
    now_.P.dense().diagonal().segment(n, n).array() += std::pow(parameters_.initial_rate_rad_per_s, 2);
    now_.P.dense().diagonal().segment(2 * n, n).array() += std::pow(parameters_.initial_accel_rad_per_s2, 2);
    now_.fitted = now_.state.motion;
    emitRestPoses(rest);
}

GroundParameters ManifoldFilter::groundParameters() const {
    GroundParameters ground = parameters_.ground;
    ground.holds_feet = ground.holds_feet && !parameters_.root_given;
    ground.stance.uses_accelerometers = parameters_.sensors.accelerometers;
    ground.stance.g_m_per_s2 = parameters_.g_m_per_s2;
    if (!parameters_.sensors.gyroscopes || tree_.link(0).type != LinkType::kFree)
        ground.ground = Ground::kNone;
    return ground;
}

/// Mean readings of a still body as one iterated update: mean accelerations point up (section 5.4), mean
/// rates are zero plus the bias.
void ManifoldFilter::settle(const RestReadings& rest, const RootMeasurement* root) {
    const BodyState prior = now_.state;
    Eigen::VectorXd total = Eigen::VectorXd::Zero(layout_.size);
    for (int iteration = 0; iteration < kRestIterations; ++iteration) {
        std::vector<ObservationBlock> blocks;
        for (const InertialMeasurement& mean : rest.mean_by_board) {
            if (parameters_.sensors.gyroscopes)
                blocks.push_back(observations_.gyro(now_.state, mean, 0));
            // The paper levels the asked-for pose by the accelerometers before the filter begins, so this
            // holds also where the run itself does without them; then nothing estimates their bias.
            blocks.push_back(observations_.accel(now_.state, mean, 0).block);
            if (layout_.accel_bias < 0)
                blocks.back().variance.array() +=
                    parameters_.accel_bias_m_per_s2 * parameters_.accel_bias_m_per_s2;
        }
        if (root)
            blocks.push_back(observations_.root(now_.state, *root, 0));
        for (ObservationBlock& block : blocks)
            for (Eigen::Index k = 0; k < block.H.cols(); ++k)
                block.residual += block.H.col(k) * total[block.columns[static_cast<size_t>(k)]];
        Covariance P = now_.P;
        const Eigen::VectorXd delta = P.update(blocks);
        const double change = (delta - total).norm();
        total = delta;
        now_.state = prior;
        correct(total);
        if (iteration + 1 == kRestIterations || change < 1e-9) {
            now_.P = P;
            break;
        }
    }
}

void ManifoldFilter::emitRestPoses(const RestReadings& rest) {
    const int64_t frame_steps = parameters_.steps_per_frame;
    for (int64_t k = 0; k < now_.step_index; k += frame_steps)
        poses_.push_back(estimateAt(static_cast<double>(k) * step_s_));
    if (now_.step_index % frame_steps == 0 && rest.end_s >= 0)
        poses_.push_back(estimateAt(static_cast<double>(now_.step_index) * step_s_));
}

}  // namespace noctule
