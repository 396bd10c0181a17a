// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/rest_pose_fit.h"

#include <cmath>

#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kCauchyScale = 2;      // in sigma: beyond it evidence pulls less and less
constexpr double kHeldSigma = 1e-5;     // m or rad: what nothing in the rest pose can show
constexpr double kStepThatEnds = 1e-6;  // m or rad
constexpr double kGainThatEnds = 1e-6;  // of -2 log likelihood
constexpr int kMostHalvings = 8;
constexpr double kLeastDistance_m = 1e-4;

/// Cost of a squared residual in units of sigma, and the weight that makes least squares of it.
struct CauchyLoss {
    double cost, weight;
};
CauchyLoss cauchyLoss(double square) {
    constexpr double kScaleSquare = kCauchyScale * kCauchyScale;
    return {kScaleSquare * std::log1p(square / kScaleSquare), 1 / (1 + square / kScaleSquare)};
}

struct RowEntry {
    int column;
    double value;
};
using SparseRow = std::vector<RowEntry>;

}  // namespace

/// J^T W J (lower triangle) and J^T W r over pose, then boards' shifts, then sources'.
struct RestPoseFit::Equations {
    Eigen::MatrixXd JtJ;
    Eigen::VectorXd Jtr;

    explicit Equations(int size) : JtJ(Eigen::MatrixXd::Zero(size, size)), Jtr(Eigen::VectorXd::Zero(size)) {}

    /// A column may stand in the row several times.
    void add(const SparseRow& row, double residual, double weight) {
        for (const RowEntry& a : row) {
            Jtr[a.column] += weight * a.value * residual;
            for (const RowEntry& b : row)
                if (a.column >= b.column)
                    JtJ(a.column, b.column) += weight * a.value * b.value;
        }
    }
};

RestPoseFit::RestPoseFit(const Actor& actor)
    : tree_(actor.skeleton, BallCoordinates::kManifold), rest_(tree_.stateFromPose(actor.restPose())) {}

RestFit RestPoseFit::begin(const RestPriors& priors) const {
    RestFit fit;
    fit.state_ = rest_;
    fit.board_shift_m.assign(priors.boards.size(), Vector3d::Zero());
    fit.source_shift_m.assign(priors.sources.size(), Vector3d::Zero());
    return fit;
}

RestFit RestPoseFit::moved(const RestFit& fit, const Eigen::VectorXd& step) const {
    RestFit next = fit;
    tree_.retract(next.state_, step.head(tree_.freedoms()));
    Eigen::Index at = tree_.freedoms();
    for (auto* shifts : {&next.board_shift_m, &next.source_shift_m})
        for (Vector3d& shift : *shifts) {
            shift += step.segment<3>(at);
            at += 3;
        }
    return next;
}

void RestPoseFit::addPose(const RestPriors& priors, RestFit& fit, Equations* into) const {
    fit.deviation_rad = Eigen::VectorXd::Zero(tree_.freedoms());
    const auto add = [&](int column, double deviation, double sigma, const SparseRow& row) {
        fit.deviation_rad[column] = deviation;
        fit.cost += deviation * deviation / (sigma * sigma);
        if (into)
            into->add(row, deviation, 1 / (sigma * sigma));
    };
    for (size_t i = 0; i < tree_.links().size(); ++i) {
        const Link& link = tree_.links()[i];
        if (link.type == LinkType::kHinge)
            add(link.first, fit.state_.angle_rad[i] - rest_.angle_rad[i], priors.sigma_pose_rad,
                {{link.first, 1.0}});
        if (link.type != LinkType::kBall && link.type != LinkType::kFree)
            continue;
        const int first = link.first + link.count - 3;
        for (int column = link.first; column < first; ++column)
            add(column, fit.state_.p_world_root[column] - rest_.p_world_root[column], kHeldSigma,
                {{column, 1.0}});
        const Vector3d turn = logQuaternion(rest_.q_parent_link[i].conjugate() * fit.state_.q_parent_link[i]);
        const Matrix3d by_step = rightJacobian(turn).inverse();
        for (int axis = 0; axis < 3; ++axis)
            add(first + axis, turn[axis],
                link.type == LinkType::kFree && axis == 1 ? kHeldSigma : priors.sigma_pose_rad,
                {{first, by_step(axis, 0)}, {first + 1, by_step(axis, 1)}, {first + 2, by_step(axis, 2)}});
    }
}

RestPoseFit::Chains RestPoseFit::chainsOf(const RestPriors& priors, const MotionState& state) const {
    Chains chains{std::vector<ChainMotion>(priors.boards.size()),
                  std::vector<ChainMotion>(priors.sources.size())};
    for (size_t b = 0; b < priors.boards.size(); ++b)
        if (priors.boards[b].joint >= 0)
            chains.boards[b].evaluate(tree_, state, tree_.linkOfJoint(priors.boards[b].joint), 0);
    for (size_t s = 0; s < priors.sources.size(); ++s)
        if (priors.sources[s].joint >= 0)
            chains.sources[s].evaluate(tree_, state, tree_.linkOfJoint(priors.sources[s].joint), 0);
    return chains;
}

void RestPoseFit::addUp(const BoardPrior& board, const UpEvidence& up, const ChainMotion& chain, RestFit& fit,
                        Equations* into) {
    const Vector3d up_world = chain.end().R_world_link * (board.q_segment_board * up.up_board);
    const Vector3d residual = up_world - Vector3d::UnitY();
    const double square_sigma = board.sigma_turn_rad * board.sigma_turn_rad + up.sigma_rad * up.sigma_rad;
    const CauchyLoss loss = cauchyLoss(residual.squaredNorm() / square_sigma);
    fit.cost += loss.cost;
    if (!into)
        return;
    SparseRow rows[3];
    for (const ChainMotion::Coordinate& c : chain.coordinates()) {
        const Vector3d change = chain.rotationByTheta(c).cross(up_world);
        for (int axis = 0; axis < 3 && !c.translation; ++axis)
            rows[axis].push_back({c.index, change[axis]});
    }
    for (int axis = 0; axis < 3; ++axis)
        into->add(rows[axis], residual[axis], loss.weight / square_sigma);
}

void RestPoseFit::addDistance(const RestPriors& priors, const DistanceEvidence& distance,
                              const Chains& chains, RestFit& fit, Equations* into) const {
    const auto b = static_cast<size_t>(distance.board), s = static_cast<size_t>(distance.source);
    const ChainMotion &to_board = chains.boards[b], &to_source = chains.sources[s];
    const auto mic = to_board.point(priors.boards[b].p_segment_mic_m + fit.board_shift_m[b]);
    const auto source = to_source.point(priors.sources[s].p_segment_source_m + fit.source_shift_m[s]);
    const Vector3d between_m = mic.p_m - source.p_m;
    const double expected_m = between_m.norm();
    fit.distance_residual_m.push_back(distance.distance_m - expected_m);
    const double residual = (expected_m - distance.distance_m) / distance.sigma_m;
    const CauchyLoss loss = cauchyLoss(residual * residual);
    fit.cost += loss.cost;
    if (!into || expected_m < kLeastDistance_m)
        return;
    const Vector3d along = between_m / expected_m / distance.sigma_m;
    SparseRow row;
    const auto addChain = [&](const ChainMotion& chain, const ChainMotion::Point& point, double sign,
                              int first_shift) {
        for (const ChainMotion::Coordinate& c : chain.coordinates())
            row.push_back({c.index, sign * along.dot(chain.pointDerivative(c, point).p_theta)});
        const Vector3d by_shift = sign * (chain.end().R_world_link.transpose() * along);
        for (int axis = 0; axis < 3; ++axis)
            row.push_back({first_shift + axis, by_shift[axis]});
    };
    const int boards_first = tree_.freedoms();
    const int sources_first = boards_first + 3 * static_cast<int>(priors.boards.size());
    addChain(to_board, mic, 1, boards_first + 3 * distance.board);
    addChain(to_source, source, -1, sources_first + 3 * distance.source);
    into->add(row, residual, loss.weight);
}

void RestPoseFit::assemble(const RestPriors& priors, const RestEvidence& evidence, RestFit& fit,
                           Equations* into) const {
    fit.cost = 0;
    fit.distance_residual_m.clear();
    addPose(priors, fit, into);
    int column = tree_.freedoms();
    const auto addShift = [&](const Vector3d& shift_m, double sigma_m) {
        const double weight = 1 / (sigma_m * sigma_m);
        fit.cost += weight * shift_m.squaredNorm();
        for (int axis = 0; axis < 3; ++axis, ++column)
            if (into)
                into->add({{column, 1.0}}, shift_m[axis], weight);
    };
    for (size_t b = 0; b < priors.boards.size(); ++b)
        addShift(fit.board_shift_m[b], priors.boards[b].sigma_shift_m);
    for (size_t s = 0; s < priors.sources.size(); ++s)
        addShift(fit.source_shift_m[s], priors.sources[s].sigma_shift_m);
    const Chains chains = chainsOf(priors, fit.state_);
    for (const UpEvidence& up : evidence.ups) {
        const auto b = static_cast<size_t>(up.board);
        addUp(priors.boards[b], up, chains.boards[b], fit, into);
    }
    for (const DistanceEvidence& distance : evidence.distances)
        addDistance(priors, distance, chains, fit, into);
}

RestFit RestPoseFit::fit(const RestPriors& priors, const RestEvidence& evidence, int most_iterations,
                         const RestFit* start) const {
    RestFit fit = start ? *start : begin(priors);
    fit.iterations = 0;
    fit.converged = false;
    const int size = tree_.freedoms() + 3 * static_cast<int>(priors.boards.size() + priors.sources.size());
    assemble(priors, evidence, fit, nullptr);
    while (fit.iterations < most_iterations && !fit.converged) {
        Equations equations(size);
        assemble(priors, evidence, fit, &equations);
        Eigen::VectorXd step = -solvePositive(equations.JtJ, equations.Jtr);
        RestFit next = moved(fit, step);
        assemble(priors, evidence, next, nullptr);
        for (int halving = 0; next.cost > fit.cost && halving < kMostHalvings; ++halving) {
            step /= 2;
            next = moved(fit, step);
            assemble(priors, evidence, next, nullptr);
        }
        next.iterations = fit.iterations + 1;
        next.converged = step.norm() < kStepThatEnds || std::abs(fit.cost - next.cost) < kGainThatEnds;
        if (!(next.cost <= fit.cost)) {  // as low as rounding lets it be
            fit.converged = true;
            break;
        }
        fit = std::move(next);
    }
    fit.pose = tree_.poseFromState(fit.state_);
    return fit;
}

void RestPoseFit::addCovariance(const RestPriors& priors, const RestEvidence& evidence, RestFit& fit) const {
    const int freedoms = tree_.freedoms();
    Equations equations(freedoms + 3 * static_cast<int>(priors.boards.size() + priors.sources.size()));
    assemble(priors, evidence, fit, &equations);
    const auto size = equations.Jtr.size();
    fit.cov_pose = solvePositive(equations.JtJ, Eigen::MatrixXd::Identity(size, freedoms)).topRows(freedoms);
}

Quaterniond RestPoseFit::boardOrientation(const BoardPrior& board, const UpEvidence& up,
                                          const Quaterniond& q_world_segment) {
    const Vector3d up_segment = q_world_segment.conjugate() * Vector3d::UnitY();
    const Vector3d tilt = logQuaternion(smallestRotation(board.q_segment_board * up.up_board, up_segment));
    const double strap = board.sigma_turn_rad * board.sigma_turn_rad, sensor = up.sigma_rad * up.sigma_rad;
    return (expQuaternion(tilt * (strap / (strap + sensor))) * board.q_segment_board).normalized();
}

Matrix3d RestPoseFit::segmentCovariance(const RestFit& fit, int joint) const {
    ChainMotion chain;
    chain.evaluate(tree_, fit.state_, tree_.linkOfJoint(joint), 0);
    Matrix3d covariance = Matrix3d::Zero();
    for (const auto& a : chain.coordinates())
        for (const auto& b : chain.coordinates())
            covariance += chain.rotationByTheta(a) * fit.cov_pose(a.index, b.index) *
                          chain.rotationByTheta(b).transpose();
    return covariance;
}

}  // namespace noctule
