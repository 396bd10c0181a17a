// SPDX-License-Identifier: Apache-2.0
// How the filter begins: from the pose that was asked for and what the boards read while it was held.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/body/usual_pose.h"
#include "core/estimation/manifold_filter.h"
#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr int kRestIterations = 6;

/// Candidates for the standard deviation of mountings, none below what a joint held badly looks like, and for
/// how well the rest pose is held, as a share of
/// what is assumed; the gain in log likelihood that errors of mountings need.
constexpr double kLeastMounting_rad = radians(1.5), kMountingStep_rad = radians(0.5),
                 kMostMounting_rad = radians(8), kEvidence = 4;
constexpr double kHeldAs[] = {0.2, 0.3, 0.45, 0.7, 1, 1.5};

/// The rest pose's forces: measured less expected, and the covariance of that where mountings are right.
struct RestForces {
    Eigen::VectorXd residual;
    Eigen::MatrixXd by_pose, others;  ///< parts of the covariance: how joints are held, and sensors
    std::vector<int> boards;          ///< three rows each

    RestForces(ObservationModel& observations, const BodyState& state, const Eigen::MatrixXd& P,
               const RestReadings& rest, int freedoms) {
        std::vector<ObservationBlock> blocks;
        for (const InertialMeasurement& mean : rest.mean_by_board) {
            ObservationBlock block = observations.accel(state, mean, 0).block;
            if (block.rows() != 3)
                continue;
            boards.push_back(mean.board);
            blocks.push_back(std::move(block));
        }
        const Eigen::Index rows = 3 * std::ssize(blocks);
        Eigen::MatrixXd H = Eigen::MatrixXd::Zero(rows, P.rows());
        residual.resize(rows);
        Eigen::VectorXd noise(rows);
        for (Eigen::Index i = 0; i < std::ssize(blocks); ++i) {
            const ObservationBlock& block = blocks[static_cast<size_t>(i)];
            residual.segment<3>(3 * i) = block.residual;
            noise.segment<3>(3 * i) = block.variance;
            for (Eigen::Index k = 0; k < block.H.cols(); ++k)
                H.block<3, 1>(3 * i, block.columns[static_cast<size_t>(k)]) += block.H.col(k);
        }
        const auto H_theta = H.leftCols(freedoms);
        by_pose = H_theta * P.topLeftCorner(freedoms, freedoms) * H_theta.transpose();
        others = H * P * H.transpose() - by_pose;
        others.diagonal() += noise;
    }
    Eigen::MatrixXd covariance(double held_as, double of_mounting) const {
        Eigen::MatrixXd S = held_as * held_as * by_pose + others;
        S.diagonal().array() += of_mounting;
        return S;
    }
    double logLikelihood(const Eigen::MatrixXd& S) const {
        const Eigen::LLT<Eigen::MatrixXd> llt(S);
        return -0.5 * residual.dot(llt.solve(residual)) - llt.matrixLLT().diagonal().array().log().sum();
    }
    /// The most likely parts of the residual that mountings make (empirical Bayes); empty where joints held
    /// badly explain it as well.
    std::optional<Eigen::VectorXd> ofMountings(double g_m_per_s2) const {
        double most = -std::numeric_limits<double>::infinity();
        for (const double held_as : kHeldAs)
            most = std::max(most, logLikelihood(covariance(held_as, 0)) + kEvidence);
        std::optional<Eigen::VectorXd> part;
        for (const double held_as : kHeldAs)
            for (double sigma = kLeastMounting_rad; sigma <= kMostMounting_rad; sigma += kMountingStep_rad) {
                const double variance = std::pow(sigma * g_m_per_s2, 2);
                const Eigen::MatrixXd S = covariance(held_as, variance);
                const double likely = logLikelihood(S);
                if (likely <= most)
                    continue;
                most = likely;
                part = variance * solvePositive(S, residual);
            }
        return part;
    }
};

/// Straps sit some degrees off. Where the rest pose's forces say so, board by board more than joints held
/// badly explain, a board takes over its share of the deviation: else a limb would be turned to fit its
/// board, and be wrong by that from the first second.
void turnBoards(SuitModel& suit, const RestForces& forces, const RestReadings& rest, double g_m_per_s2) {
    const auto of_mounting = forces.boards.empty() ? std::nullopt : forces.ofMountings(g_m_per_s2);
    if (!of_mounting)
        return;
    for (size_t i = 0; i < forces.boards.size(); ++i) {
        MountedBoard& board = suit.boards[static_cast<size_t>(forces.boards[i])];
        const auto mean =
            std::ranges::find(rest.mean_by_board, forces.boards[i], &InertialMeasurement::board);
        const auto measured = sensedVector(mean->accel);
        if (!measured)
            continue;
        const auto at = 3 * static_cast<Eigen::Index>(i);
        const Vector3d expected = *measured - forces.residual.segment<3>(at);
        const Quaterniond turn = smallestRotation(expected + of_mounting->segment<3>(at), expected);
        const Vector3d p_board_mic = board.R_link_board.transpose() * (board.p_link_mic - board.p_link_board);
        board.R_link_board *= turn.toRotationMatrix();
        board.p_link_mic = board.p_link_board + board.R_link_board * p_board_mic;
    }
}

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
    if (parameters_.joints_give) {
        const Covariance P = now_.P;  // a copy: asked as a whole, it sums up otherwise
        RestForces forces(observations_, now_.state, P.dense(), rest, layout_.freedoms);
        if (layout_.accel_bias < 0)
            forces.others.diagonal().array() += std::pow(parameters_.accel_bias_m_per_s2, 2);
        turnBoards(suit_, forces, rest, parameters_.g_m_per_s2);
    }
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
            block.residual += block.of(total);
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
    // A rest of no length is the begin of readings that come late: nothing is known of the time before.
    const double from_s = rest.end_s > rest.begin_s ? 0 : rest.begin_s;
    const auto first =
        frame_steps *
        static_cast<int64_t>(std::ceil(from_s / (step_s_ * static_cast<double>(frame_steps)) - 1e-9));
    for (int64_t k = first; k < now_.step_index; k += frame_steps)
        poses_.push_back(estimateAt(static_cast<double>(k) * step_s_));
    if (now_.step_index % frame_steps == 0 && rest.end_s >= 0)
        poses_.push_back(estimateAt(static_cast<double>(now_.step_index) * step_s_));
}

}  // namespace noctule
