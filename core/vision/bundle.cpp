// SPDX-License-Identifier: Apache-2.0
#include "core/vision/bundle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Vector<double, 6>;

constexpr double kNearest_m = 1e-3;  ///< before a camera
constexpr double kHuberSigmas = 3, kFirstSigma_px = 1, kSmallestSigma_px = 0.02;
constexpr int kSigmaRounds = 3, kMostIterations = 100;
constexpr double kConvergedDecrease = 1e-9, kRounding = 1e-12;  ///< of the cost, or of 1
constexpr double kFirstDamping = 1e-3;
/// The scale hangs on little once edges may move; more damping than this holds it where it began.
constexpr double kHardlyDamped = 1e-8;

/// One corner and its derivatives by lens, camera (rotation, position) and marker (rotation, position).
struct CornerTerm {
    Eigen::Vector2d residual_px;
    Eigen::Matrix<double, 2, Lens::kValues> J_lens;
    Eigen::Matrix<double, 2, 6> J_camera, J_marker;
};

/// Nothing behind the camera.
std::optional<CornerTerm> cornerTerm(const Bundle& bundle, const Sighting& sighting, const Vector3d& corner,
                                     const Eigen::Vector2d& seen_px, const Eigen::Vector2d& per_edge) {
    const CameraPose& camera = bundle.cameras[size_t(sighting.camera)];
    const MarkerPose& marker = bundle.markers[size_t(sighting.marker)];
    const Vector3d p_jig = marker.p_jig_marker_m + marker.q_jig_marker * corner,
                   p_camera = camera.toCamera(p_jig);
    if (!(p_camera.z() > kNearest_m))
        return {};
    const Matrix3d R_camera_jig = camera.q_camera_jig.toRotationMatrix();
    LensJacobians lens;
    CornerTerm term;
    const Lens& taken_by = bundle.lenses[size_t(camera.lens)];
    term.residual_px = project(taken_by, p_camera, &lens) + taken_by.edge_px * per_edge - seen_px;
    term.J_lens = lens.J_pixel_lens;
    term.J_lens.rightCols<1>() = per_edge;
    term.J_camera << -lens.J_pixel_point * R_camera_jig * skew(p_jig), lens.J_pixel_point;
    term.J_marker << -lens.J_pixel_point * R_camera_jig * marker.q_jig_marker.toRotationMatrix() *
                         skew(corner),
        lens.J_pixel_point * R_camera_jig;
    return term;
}

/// Huber's cost and weight of a corner's error, in sigmas.
double huberCost(double error) {
    return error <= kHuberSigmas ? error * error : kHuberSigmas * (2 * error - kHuberSigmas);
}
double huberWeight(double error) {
    return error <= kHuberSigmas ? 1 : kHuberSigmas / error;
}

/// What is common (lenses, then cameras) and what is each marker's own.
struct NormalEquations {
    Eigen::MatrixXd common;
    Eigen::VectorXd common_gradient;
    std::vector<Matrix6d> own;
    std::vector<Vector6d> own_gradient;
    std::vector<Eigen::MatrixXd> mixed;  ///< common x own
    double weights = 0, squares_px2 = 0, cost = 0;
    int corners = 0;
};

Eigen::Index lensAt(int lens) {
    return lens * Lens::kValues;
}
Eigen::Index cameraAt(const Bundle& bundle, int camera) {
    return lensAt(static_cast<int>(bundle.lenses.size())) + 6 * camera;
}

Lens::Values beliefError(const Bundle& bundle, size_t lens) {
    const LensBelief& belief = bundle.beliefs[lens];
    return (bundle.lenses[lens].values() - belief.lens.values()).cwiseQuotient(belief.sigma);
}

void addBeliefs(const Bundle& bundle, NormalEquations& sum) {
    for (size_t l = 0; l < bundle.lenses.size(); ++l) {
        const Lens::Values error = beliefError(bundle, l), by_sigma = bundle.beliefs[l].sigma.cwiseInverse();
        const Eigen::Index at = lensAt(static_cast<int>(l));
        sum.common.diagonal().segment<Lens::kValues>(at) += by_sigma.cwiseAbs2();
        sum.common_gradient.segment<Lens::kValues>(at) += by_sigma.cwiseProduct(error);
        sum.cost += error.squaredNorm();
    }
}

void addCorner(const Bundle& bundle, const Sighting& sighting, const CornerTerm& term, double sigma_px,
               NormalEquations& sum) {
    const CameraPose& camera = bundle.cameras[size_t(sighting.camera)];
    const double error = term.residual_px.norm() / sigma_px, huber = huberWeight(error);
    const double weight = huber / (sigma_px * sigma_px);
    Eigen::Matrix<double, 2, Lens::kValues + 6> J_common;
    J_common << term.J_lens, term.J_camera;
    if (camera.stays)
        J_common.rightCols<6>().setZero();
    const Eigen::Index at[] = {lensAt(camera.lens), cameraAt(bundle, sighting.camera)};
    const Eigen::Index from[] = {0, Lens::kValues}, size[] = {Lens::kValues, 6};
    const auto m = size_t(sighting.marker);
    for (const int a : {0, 1}) {
        const auto J_a = J_common.middleCols(from[a], size[a]);
        for (const int b : {0, 1})
            sum.common.block(at[a], at[b], size[a], size[b]) +=
                weight * J_a.transpose() * J_common.middleCols(from[b], size[b]);
        sum.common_gradient.segment(at[a], size[a]) += weight * J_a.transpose() * term.residual_px;
        sum.mixed[m].middleRows(at[a], size[a]) += weight * J_a.transpose() * term.J_marker;
    }
    sum.own[m] += weight * term.J_marker.transpose() * term.J_marker;
    sum.own_gradient[m] += weight * term.J_marker.transpose() * term.residual_px;
    sum.weights += huber;
    sum.squares_px2 += huber * term.residual_px.squaredNorm();
    sum.cost += huberCost(error);
    ++sum.corners;
}

/// What nothing is known about stays where it is.
void holdUnseen(const Bundle& bundle, NormalEquations& sum) {
    for (int c = 0; c < static_cast<int>(bundle.cameras.size()); ++c) {
        auto block = sum.common.block<6, 6>(cameraAt(bundle, c), cameraAt(bundle, c));
        if (block.isZero(0))
            block.setIdentity();
    }
    for (Matrix6d& own : sum.own)
        if (own.isZero(0))
            own.setIdentity();
}

NormalEquations normalEquations(const Bundle& bundle, double sigma_px) {
    const Eigen::Index n = cameraAt(bundle, static_cast<int>(bundle.cameras.size()));
    NormalEquations sum{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n),
                        std::vector<Matrix6d>(bundle.markers.size(), Matrix6d::Zero()),
                        std::vector<Vector6d>(bundle.markers.size(), Vector6d::Zero()),
                        std::vector<Eigen::MatrixXd>(bundle.markers.size(), Eigen::MatrixXd::Zero(n, 6))};
    addBeliefs(bundle, sum);
    const auto corners = markerCorners(bundle.side_m);
    for (const Sighting& sighting : bundle.sightings) {
        const auto per_edge = cornersPerEdge(sighting.corners_px);
        for (size_t k = 0; sighting.used && k < corners.size(); ++k)
            if (const auto term =
                    cornerTerm(bundle, sighting, corners[k], sighting.corners_px[k], per_edge[k]))
                addCorner(bundle, sighting, *term, sigma_px, sum);
    }
    holdUnseen(bundle, sum);
    return sum;
}

/// Of each corner, how far it is from where it should be; nothing behind the camera.
std::optional<std::array<double, 4>> cornerErrors_px(const Bundle& bundle, const Sighting& sighting) {
    const CameraPose& camera = bundle.cameras[size_t(sighting.camera)];
    const MarkerPose& marker = bundle.markers[size_t(sighting.marker)];
    const Lens& lens = bundle.lenses[size_t(camera.lens)];
    const auto corners = markerCorners(bundle.side_m);
    const auto per_edge = cornersPerEdge(sighting.corners_px);
    std::array<double, 4> errors_px{};
    for (size_t k = 0; k < corners.size(); ++k) {
        const Vector3d p = camera.toCamera(marker.p_jig_marker_m + marker.q_jig_marker * corners[k]);
        if (!(p.z() > kNearest_m))
            return {};
        errors_px[k] = (project(lens, p) + lens.edge_px * per_edge[k] - sighting.corners_px[k]).norm();
    }
    return errors_px;
}

double costOf(const Bundle& bundle, double sigma_px) {
    double cost = 0;
    for (size_t l = 0; l < bundle.lenses.size(); ++l)
        cost += beliefError(bundle, l).squaredNorm();
    for (const Sighting& sighting : bundle.sightings) {
        if (!sighting.used)
            continue;
        const auto errors_px = cornerErrors_px(bundle, sighting);
        if (!errors_px)
            return INFINITY;
        for (const double error_px : *errors_px)
            cost += huberCost(error_px / sigma_px);
    }
    return cost;
}

/// Where a damped step of Newton's leads to.
Bundle stepped(const Bundle& bundle, const NormalEquations& sum, double damping) {
    Eigen::MatrixXd reduced = sum.common;
    reduced.diagonal() *= 1 + damping;
    Eigen::VectorXd right = -sum.common_gradient;
    const Eigen::Index common = reduced.rows();
    std::vector<Eigen::MatrixXd> own;  ///< per marker: its move by the common step, then the move without one
    for (size_t m = 0; m < bundle.markers.size(); ++m) {
        Matrix6d damped = sum.own[m];
        damped.diagonal() *= 1 + damping;
        Eigen::MatrixXd known(6, common + 1);
        known << -sum.mixed[m].transpose(), -sum.own_gradient[m];
        own.push_back(solvePositive(damped, known));
        reduced.noalias() += sum.mixed[m] * own.back().leftCols(common);
        right.noalias() -= sum.mixed[m] * own.back().rightCols<1>();
    }
    const Eigen::VectorXd step = solveSymmetric(reduced, right);
    Bundle next = bundle;
    for (int l = 0; l < static_cast<int>(next.lenses.size()); ++l)
        next.lenses[size_t(l)].add(step.segment<Lens::kValues>(lensAt(l)));
    for (int c = 0; c < static_cast<int>(next.cameras.size()); ++c) {
        CameraPose& camera = next.cameras[size_t(c)];
        const Vector6d move = step.segment<6>(cameraAt(bundle, c));
        if (camera.stays)
            continue;
        camera.q_camera_jig = (camera.q_camera_jig * expQuaternion(move.head<3>())).normalized();
        camera.p_camera_jig_m += move.tail<3>();
    }
    for (size_t m = 0; m < next.markers.size(); ++m) {
        const Vector6d move = own[m].leftCols(common) * step + own[m].rightCols<1>();
        MarkerPose& marker = next.markers[m];
        marker.q_jig_marker = (marker.q_jig_marker * expQuaternion(move.head<3>())).normalized();
        marker.p_jig_marker_m += move.tail<3>();
    }
    return next;
}

struct Descent {
    bool converged = false, cancelled = false;
    int iterations = 0;
};

Descent descend(Bundle& bundle, double sigma_px, const JobContext& job) {
    Descent descent;
    double damping = kFirstDamping, cost = costOf(bundle, sigma_px);
    NormalEquations sum = normalEquations(bundle, sigma_px);
    for (; descent.iterations < kMostIterations && !descent.converged; ++descent.iterations) {
        if (job.cancelled()) {
            descent.cancelled = true;
            break;
        }
        Bundle next = stepped(bundle, sum, damping);
        const double next_cost = costOf(next, sigma_px), whole = std::max(1.0, cost);
        if (next_cost < cost) {
            descent.converged = damping <= kHardlyDamped && cost - next_cost < kConvergedDecrease * whole;
            bundle = std::move(next);
            cost = next_cost;
            sum = normalEquations(bundle, sigma_px);
            damping = std::max(damping / 10, 1e-12);
        } else {
            // At the bottom rounding alone tells steps apart: one more with hardly any damping, then enough.
            const bool is_level = next_cost - cost < kRounding * whole;
            descent.converged = (is_level && damping <= kHardlyDamped) || damping > 1e6;
            damping = is_level ? std::min(damping, kHardlyDamped) : 5 * damping;
        }
    }
    return descent;
}

/// As if no corner were wild: from the median, as two coordinates of a normal error give it.
double sigmaFromMedian_px(const Bundle& bundle) {
    std::vector<double> errors_px;
    for (const Sighting& sighting : bundle.sightings)
        if (sighting.used)
            errors_px.push_back(sightingError_px(bundle, sighting));
    // Root mean square of four corners' lengths: eight coordinates, two of each corner.
    return std::clamp(medianOf(std::move(errors_px)) / std::sqrt(2.0), kSmallestSigma_px, 1e3);
}

double sigmaFromResiduals_px(const Bundle& bundle, const NormalEquations& sum) {
    const double unknowns = double(sum.common.rows()) -
                            6 * double(std::ranges::count_if(bundle.cameras, &CameraPose::stays)) +
                            6 * double(bundle.markers.size());
    const double left = std::max(1.0, 2 * sum.weights - unknowns);
    return std::max(kSmallestSigma_px, std::sqrt(sum.squares_px2 / left));
}

}  // namespace

std::array<Vector3d, 4> markerCorners(double side_m) {
    const double half = side_m / 2;
    return {Vector3d(-half, half, 0), Vector3d(half, half, 0), Vector3d(half, -half, 0),
            Vector3d(-half, -half, 0)};
}

std::array<Eigen::Vector2d, 4> cornersPerEdge(const std::array<Eigen::Vector2d, 4>& corners_px) {
    std::array<Eigen::Vector2d, 4> outwards, per_edge;
    for (size_t k = 0; k < 4; ++k) {
        const Eigen::Vector2d along = (corners_px[(k + 1) % 4] - corners_px[k]).normalized();
        outwards[k] = {along.y(), -along.x()};
    }
    for (size_t k = 0; k < 4; ++k) {
        // d with d . a = d . b = 1 for the two edges that meet there.
        const Eigen::Vector2d &a = outwards[(k + 3) % 4], &b = outwards[k];
        per_edge[k] = (a + b) / std::max(0.1, 1 + a.dot(b));
    }
    return per_edge;
}

double sightingError_px(const Bundle& bundle, const Sighting& sighting) {
    const auto errors_px = cornerErrors_px(bundle, sighting);
    if (!errors_px)
        return INFINITY;
    double sum_px2 = 0;
    for (const double error_px : *errors_px)
        sum_px2 += error_px * error_px;
    return std::sqrt(sum_px2 / 4);
}

Result<BundleFit> adjust(Bundle& bundle, const JobContext& job) {
    require(bundle.lenses.size() == bundle.beliefs.size(), "adjust: a belief for every lens");
    BundleFit fit;
    fit.sigma_px = std::max(kFirstSigma_px, sigmaFromMedian_px(bundle));
    for (int round = 0; round < kSigmaRounds; ++round) {
        const Descent descent = descend(bundle, fit.sigma_px, job);
        if (descent.cancelled)
            return JobContext::cancelledError();
        fit.iterations += descent.iterations;
        fit.converged = descent.converged;
        if (round + 1 < kSigmaRounds)
            fit.sigma_px = sigmaFromMedian_px(bundle);
    }
    const NormalEquations sum = normalEquations(bundle, fit.sigma_px);
    fit.cost = sum.cost;
    fit.sigma_px = sigmaFromResiduals_px(bundle, sum);
    return fit;
}

BundleCovariance::BundleCovariance(const Bundle& bundle, double sigma_px) {
    const NormalEquations sum = normalEquations(bundle, sigma_px);
    Eigen::MatrixXd reduced = sum.common;
    for (size_t m = 0; m < bundle.markers.size(); ++m) {
        const Matrix6d cov_own = solvePositive(sum.own[m], Matrix6d::Identity());
        const Eigen::MatrixXd J = cov_own * sum.mixed[m].transpose();
        reduced.noalias() -= sum.mixed[m] * J;
        markers_.push_back(
            {bundle.markers[m].p_jig_marker_m, cov_own.bottomRightCorner<3, 3>(), J.bottomRows<3>()});
    }
    cov_common_ = solveSymmetric(reduced, Eigen::MatrixXd::Identity(reduced.rows(), reduced.cols()));
}

double BundleCovariance::distanceSigma_m(int marker, int other) const {
    const MarkerPart &a = markers_[size_t(marker)], &b = markers_[size_t(other)];
    const Vector3d along = (a.p_jig_m - b.p_jig_m).normalized();
    const Eigen::RowVectorXd J_common = along.transpose() * (a.J_marker_common - b.J_marker_common);
    const double variance_m2 = along.dot((a.own + b.own) * along) + (J_common * cov_common_).dot(J_common);
    return std::sqrt(std::max(0.0, variance_m2));
}

}  // namespace noctule
