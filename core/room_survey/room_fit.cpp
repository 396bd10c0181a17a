// SPDX-License-Identifier: Apache-2.0
#include "core/room_survey/room_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/calibration/motion/arrowhead_system.h"
#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"
#include "core/math/rotation.h"
#include "core/room_survey/anchor_start.h"

namespace noctule::room_survey {
namespace {

constexpr int kTurn = 3, kClock = 6, kNodeSize = 7;  ///< of a node; its displacement comes first
constexpr int kAnchorSize = 6;
constexpr double kAnywhere_m = 3;  ///< about the start: nothing, but it keeps the system solvable
constexpr double kLooseFrame = 1;  ///< without a performer: metres and radians
constexpr double kPinned_m = 1e-6;
constexpr double kEnd_m = 2e-5;  ///< step of an anchor with which the fit has converged
constexpr double kMostDamping = 1e6;
constexpr int kFirstLearning = 2;
constexpr double kBelieved_m = 1;  ///< sigma from which a range says nothing

Matrix3d firstRow(const Vector3d& row) {
    Matrix3d J = Matrix3d::Zero();
    J.row(0) = row.transpose();
    return J;
}

class Fit {
public:
    Fit(const Evidence& evidence, const std::vector<Vector3d>& places_m, double clock_m,
        const FitSettings& settings)
        : evidence_(evidence), settings_(settings), pairs_(pairDistances(evidence)), start_m_(places_m) {
        result.unknowns.places_m = places_m;
        result.unknowns.halves_m.assign(anchors(), Vector3d::Zero());
        result.unknowns.devices_m.assign(static_cast<size_t>(evidence.devices), Vector3d::Zero());
        result.flesh_m = settings.first_flesh_m;
        layOutNodes(clock_m);
        motions_ = commonMotions(places_m);
    }

    Status run(const JobContext& job) {
        double damping = 1e-6, least = -1;
        RoomUnknowns kept = result.unknowns;
        for (result.iterations = 0; result.iterations < settings_.most_iterations; ++result.iterations) {
            if (job.cancelled())
                return JobContext::cancelledError();
            job.progress(static_cast<double>(result.iterations) / settings_.most_iterations,
                         "Surveying the room");
            ArrowheadSystem system(static_cast<int>(result.unknowns.nodes.size()), kNodeSize, borderSize());
            const double cost = assemble(system);
            const bool worse = least >= 0 && cost > least * (1 + 1e-9);
            if (worse && damping < kMostDamping && !learnt_) {
                result.unknowns = kept;
                damping *= 10;
                least = -1;
                continue;
            }
            least = cost, kept = result.unknowns;
            learnt_ = false;
            if (!system.solve(damping, job))
                return Done{};
            damping = std::max(damping * 0.3, 1e-9);
            result.converged = move(system) < kEnd_m && result.iterations > kFirstLearning + 2;
            if (result.converged)
                break;
            if (result.iterations >= kFirstLearning)
                learnFlesh();
        }
        return finish(job);
    }

    RoomFit result;

private:
    size_t anchors() const { return evidence_.anchors.size(); }
    int anchorAt(int anchor) const { return kAnchorSize * anchor; }
    int deviceAt(int device) const { return kAnchorSize * static_cast<int>(anchors()) + 3 * device; }
    int scaleAt() const { return deviceAt(evidence_.devices); }
    int borderSize() const { return scaleAt() + 1; }

    void layOutNodes(double clock_m) {
        if (evidence_.walk.empty())
            return;
        const double begin_s = evidence_.walk.front().time_s;
        std::map<std::tuple<int, int, bool, int>, int> copies;
        std::vector<std::tuple<int, int, bool, int>> keys;
        for (const WalkRange& range : evidence_.walk) {
            const auto node = static_cast<int>((range.time_s - begin_s) / settings_.node_s);
            node_of_.push_back(node);
            keys.emplace_back(node, range.anchor, range.anchor_hears, range.device);
            ++copies[keys.back()];
        }
        for (const auto& key : keys)
            copies_.push_back(copies[key]);
        const auto nodes = static_cast<size_t>(node_of_.back()) + 1;
        Correction first;
        first.clock_m = clock_m;
        result.unknowns.nodes.assign(nodes, first);
        // Where the performer is: neighbouring corrections are compared there.
        middle_m_.assign(nodes, Vector3d::Zero());
        std::vector<double> count(nodes, 0);
        for (size_t i = 0; i < node_of_.size(); ++i) {
            const auto node = static_cast<size_t>(node_of_[i]);
            middle_m_[node] += (evidence_.walk[i].p_m - middle_m_[node]) / ++count[node];
        }
        for (size_t k = 1; k < nodes; ++k)
            if (count[k] == 0)
                middle_m_[k] = middle_m_[k - 1];
    }

    double loss(double square) const {
        const double c2 = settings_.loss_sigma * settings_.loss_sigma;
        return c2 * std::log1p(square / c2);
    }
    /// One measured row with Cauchy's loss; `copies` of it share one error.
    double addRow(ArrowheadSystem& system, ResidualBlock block, double variance, double copies) const {
        block.rows = 1;
        const double square = block.residual[0] * block.residual[0] / (variance * copies);
        const double c2 = settings_.loss_sigma * settings_.loss_sigma;
        const double r2 = block.residual[0] * block.residual[0] / variance;
        block.weight = Vector3d(1 / (variance * copies * (1 + r2 / c2)), 0, 0);
        system.add(block);
        return loss(r2) * (r2 > 0 ? square / r2 : 0);
    }
    /// Three rows of a prior.
    static double addPrior(ArrowheadSystem& system, ResidualBlock block, const Vector3d& sigma) {
        block.weight = sigma.cwiseAbs2().cwiseInverse();
        system.add(block);
        return block.weight.dot(block.residual.cwiseAbs2());
    }
    double addBorderPrior(ArrowheadSystem& system, int first, const Vector3d& residual, double sigma) const {
        ResidualBlock block{0, 3, residual};
        block.addBorder(first, Matrix3d(Matrix3d::Identity()));
        return addPrior(system, std::move(block), Vector3d::Constant(sigma));
    }

    double assemble(ArrowheadSystem& system) {
        double cost = addBetween(system) + addWalk(system) + addAnchors(system) + addFrame(system);
        for (int device = 0; device < evidence_.devices; ++device)
            cost +=
                addBorderPrior(system, deviceAt(device),
                               result.unknowns.devices_m[static_cast<size_t>(device)], settings_.device_m);
        return cost + addScale(system) + addNodes(system);
    }

    double addScale(ArrowheadSystem& system) const {
        const double weight = 1 / (settings_.scale * settings_.scale), scale = result.unknowns.scale;
        ResidualBlock block{0, 1, Vector3d(scale, 0, 0), Vector3d(weight, 0, 0)};
        block.addBorder(scaleAt(), Vector3d(1, 0, 0));
        system.add(block);
        return weight * scale * scale;
    }

    double addBetween(ArrowheadSystem& system) {
        const RoomUnknowns& x = result.unknowns;
        double cost = 0;
        result.between_m.clear();
        for (const PairDistance& pair : pairs_) {
            // The mean of both directions knows nothing of the halves, to first order.
            const Vector3d between =
                x.places_m[static_cast<size_t>(pair.a)] - x.places_m[static_cast<size_t>(pair.b)];
            const double length = std::max(between.norm(), 1e-6);
            ResidualBlock block{0, 1, Vector3d(pair.distance_m - length * (1 + x.scale), 0, 0)};
            block.addBorder(anchorAt(pair.a), firstRow(-between / length));
            block.addBorder(anchorAt(pair.b), firstRow(between / length));
            block.addBorder(scaleAt(), Vector3d(-length, 0, 0));
            result.between_m.push_back(block.residual[0]);
            cost += addRow(system, std::move(block), pair.sigma_m * pair.sigma_m, 1);
        }
        return cost;
    }

    double addWalk(ArrowheadSystem& system) {
        double cost = 0;
        result.walk_m.clear();
        result.devices_at_m.clear();
        for (size_t i = 0; i < evidence_.walk.size(); ++i) {
            const WalkRange& range = evidence_.walk[i];
            const Correction& at = result.unknowns.nodes[static_cast<size_t>(node_of_[i])];
            result.devices_at_m.push_back(at.t_m + at.q * devicePlace_m(range));
            ResidualBlock block = walkRow(range, node_of_[i]);
            result.walk_m.push_back(block.residual[0]);
            // n ranges of one pair within a node: noise averages, flesh does not.
            const double copies = copies_[i], noise = range.sigma_m * range.sigma_m,
                         flesh = result.flesh_m * result.flesh_m;
            cost +=
                addRow(system, std::move(block), noise + flesh, (noise + copies * flesh) / (noise + flesh));
        }
        return cost;
    }

    /// In the world of the poses.
    Vector3d devicePlace_m(const WalkRange& range) const {
        return range.p_m +
               range.R_world_segment * result.unknowns.devices_m[static_cast<size_t>(range.device)];
    }

    ResidualBlock walkRow(const WalkRange& range, int node) const {
        const RoomUnknowns& x = result.unknowns;
        const Correction& at = x.nodes[static_cast<size_t>(node)];
        const auto anchor = static_cast<size_t>(range.anchor);
        const double side = range.anchor_hears ? -1 : 1;
        const Vector3d turned = at.q * devicePlace_m(range);
        const Vector3d between = x.places_m[anchor] + side * x.halves_m[anchor] - turned - at.t_m;
        const double length = std::max(between.norm(), 1e-6);
        const Vector3d n = between / length;
        const double late = range.anchor_hears ? 1 : -1;
        // The distance is scaled and not the range: else noise would make the room smaller.
        ResidualBlock block{node, 1,
                            Vector3d(range.distance_m - length * (1 + x.scale) - late * at.clock_m, 0, 0)};
        block.addNode(0, firstRow(n));
        block.addNode(kTurn, firstRow(turned.cross(n)));
        block.columns.push_back({false, kClock, 1, firstRow(Vector3d(-late, 0, 0))});
        block.addBorder(anchorAt(range.anchor), firstRow(-n));
        block.addBorder(anchorAt(range.anchor) + 3, firstRow(-side * n));
        block.addBorder(deviceAt(range.device),
                        firstRow((at.q.toRotationMatrix() * range.R_world_segment).transpose() * n));
        block.addBorder(scaleAt(), Vector3d(-length, 0, 0));
        return block;
    }

    double addAnchors(ArrowheadSystem& system) const {
        double cost = 0;
        for (size_t i = 0; i < anchors(); ++i) {
            const Anchor& anchor = evidence_.anchors[i];
            const int at = anchorAt(static_cast<int>(i));
            const bool has_both = anchor.hears && anchor.sounds && anchor.apart_m > 0;
            cost += addBorderPrior(system, at + 3, result.unknowns.halves_m[i],
                                   has_both ? anchor.apart_m / 2 / std::sqrt(3) : kPinned_m);
            cost += addBorderPrior(system, at, result.unknowns.places_m[i] - start_m_[i], kAnywhere_m);
        }
        for (const KnownHeight& known : evidence_.heights) {
            ResidualBlock block{
                0, 1,
                Vector3d(result.unknowns.places_m[static_cast<size_t>(known.anchor)].y() - known.height_m, 0,
                         0)};
            block.addBorder(anchorAt(known.anchor), firstRow(Vector3d::UnitY()));
            cost += addRow(system, std::move(block), settings_.height_m * settings_.height_m, 1);
        }
        return cost;
    }

    /// Without a performer: the frame of the start.
    double addFrame(ArrowheadSystem& system) const {
        if (!evidence_.walk.empty())
            return 0;
        double cost = 0;
        for (Eigen::Index part = 0; part < 6; part += 3) {
            ResidualBlock block{0, 3};
            for (size_t i = 0; i < anchors(); ++i) {
                const auto at = 3 * static_cast<Eigen::Index>(i);
                const Matrix3d J =
                    motions_.block<3, 3>(at, part).transpose() / motions_.col(part).squaredNorm();
                block.residual += J * (result.unknowns.places_m[i] - start_m_[i]);
                block.addBorder(anchorAt(static_cast<int>(i)), J);
            }
            cost += addPrior(system, std::move(block), Vector3d::Constant(kLooseFrame));
        }
        return cost;
    }

    double addNodes(ArrowheadSystem& system) const {
        const auto& nodes = result.unknowns.nodes;
        const bool known = evidence_.clock_known;
        double cost = 0;
        for (size_t k = 0; k < nodes.size(); ++k) {
            cost += addStanding(system, k);
            const double sigma_m = known ? settings_.clock_m : settings_.unknown_clock_m;
            const double expected_m = known ? 0 : nodes[k].clock_m;
            if (known || k == 0)
                cost += addClock(system, static_cast<int>(k), nodes[k].clock_m - expected_m, sigma_m, false);
            if (k + 1 == nodes.size())
                break;
            cost += addStep(system, k);
            const double drift_m =
                (known ? settings_.clock_drift_m : settings_.unknown_drift_m) * std::sqrt(settings_.node_s);
            cost +=
                addClock(system, static_cast<int>(k), nodes[k + 1].clock_m - nodes[k].clock_m, drift_m, true);
        }
        return cost;
    }

    static double addClock(ArrowheadSystem& system, int node, double residual, double sigma, bool step) {
        ResidualBlock block{node, 1, Vector3d(residual, 0, 0)};
        block.weight = Vector3d(1 / (sigma * sigma), 0, 0);
        block.columns.push_back({false, kClock, 1, firstRow(Vector3d(step ? -1 : 1, 0, 0))});
        if (step)
            block.columns.push_back({false, kNodeSize + kClock, 1, firstRow(Vector3d(1, 0, 0))});
        system.add(block);
        return residual * residual / (sigma * sigma);
    }

    /// Displaced and turned about where the performer is, by how much at most.
    double addStanding(ArrowheadSystem& system, size_t k) const {
        constexpr double kFree = 1e3;
        const Correction& at = result.unknowns.nodes[k];
        const Vector3d p = at.q * middle_m_[k];
        ResidualBlock place{static_cast<int>(k), 3, p + at.t_m - middle_m_[k]};
        place.addNode(0, Matrix3d::Identity());
        place.addNode(kTurn, -skew(p));
        ResidualBlock turn{static_cast<int>(k), 3, logQuaternion(at.q)};
        turn.addNode(kTurn, Matrix3d::Identity());
        const bool first = k == 0;
        const Vector3d place_m =
            first ? Vector3d::Constant(settings_.begin_m) : Vector3d(kFree, settings_.floor_m, kFree);
        const double tilt_rad = settings_.tilt_rad;
        return addPrior(system, std::move(place), place_m) +
               addPrior(system, std::move(turn),
                        Vector3d(tilt_rad, first ? settings_.begin_rad : kFree, tilt_rad));
    }

    double addStep(ArrowheadSystem& system, size_t k) const {
        const Correction &a = result.unknowns.nodes[k], &b = result.unknowns.nodes[k + 1];
        const Vector3d p_a = a.q * middle_m_[k + 1], p_b = b.q * middle_m_[k + 1];
        const double root_s = std::sqrt(settings_.node_s);
        ResidualBlock place{static_cast<int>(k), 3, p_b + b.t_m - p_a - a.t_m};
        place.addNode(0, -Matrix3d::Identity());
        place.addNode(kTurn, skew(p_a));
        place.addNode(kNodeSize, Matrix3d::Identity());
        place.addNode(kNodeSize + kTurn, -skew(p_b));
        ResidualBlock turn{static_cast<int>(k), 3, logQuaternion(b.q * a.q.conjugate())};
        turn.addNode(kTurn, -Matrix3d::Identity());
        turn.addNode(kNodeSize + kTurn, Matrix3d::Identity());
        return addPrior(system, std::move(place), Vector3d::Constant(settings_.drift_m * root_s)) +
               addPrior(system, std::move(turn), Vector3d::Constant(settings_.drift_rad * root_s));
    }

    /// Returns by how far the anchor went that went farthest.
    double move(const ArrowheadSystem& solved) {
        RoomUnknowns& x = result.unknowns;
        const Eigen::VectorXd& border = solved.borderStep();
        double farthest_m = 0;
        for (size_t i = 0; i < anchors(); ++i) {
            const int at = anchorAt(static_cast<int>(i));
            x.places_m[i] += border.segment<3>(at);
            x.halves_m[i] += border.segment<3>(at + 3);
            farthest_m = std::max(farthest_m, border.segment<3>(at).norm());
        }
        for (int device = 0; device < evidence_.devices; ++device)
            x.devices_m[static_cast<size_t>(device)] += border.segment<3>(deviceAt(device));
        x.scale += border[scaleAt()];
        for (size_t k = 0; k < x.nodes.size(); ++k) {
            const auto step = solved.nodeSteps().col(static_cast<Eigen::Index>(k));
            x.nodes[k].t_m += step.head<3>();
            x.nodes[k].q = (expQuaternion(step.segment<3>(kTurn)) * x.nodes[k].q).normalized();
            x.nodes[k].clock_m += step[kClock];
        }
        return farthest_m;
    }

    /// From the spread of the residuals less what the ranges' own noise explains.
    void learnFlesh() {
        if (result.walk_m.empty())
            return;
        std::vector<double> noise, residuals;
        for (size_t i = 0; i < evidence_.walk.size(); ++i)
            if (const double sigma_m = evidence_.walk[i].sigma_m; sigma_m < kBelieved_m)
                noise.push_back(sigma_m), residuals.push_back(result.walk_m[i]);
        const double all_m = spreadAbout(0, std::move(residuals)), own_m = medianOf(std::move(noise));
        const double flesh_m =
            std::max(settings_.least_flesh_m, std::sqrt(std::max(0.0, all_m * all_m - own_m * own_m)));
        learnt_ = std::abs(flesh_m - result.flesh_m) > 1e-3 * result.flesh_m;
        result.flesh_m = flesh_m;
    }

    Status finish(const JobContext& job) {
        ArrowheadSystem system(static_cast<int>(result.unknowns.nodes.size()), kNodeSize, borderSize());
        assemble(system);
        if (!system.solve(0, job)) {
            result.converged = false;
            return job.cancelled() ? Status(JobContext::cancelledError()) : Status(Done{});
        }
        const Eigen::MatrixXd border = system.borderCovariance();
        const auto n = static_cast<Eigen::Index>(anchors());
        result.cov_places_m2.resize(3 * n, 3 * n);
        for (Eigen::Index a = 0; a < n; ++a)
            for (Eigen::Index b = 0; b < n; ++b)
                result.cov_places_m2.block<3, 3>(3 * a, 3 * b) =
                    border.block<3, 3>(kAnchorSize * a, kAnchorSize * b);
        return Done{};
    }

    const Evidence& evidence_;
    const FitSettings& settings_;
    std::vector<PairDistance> pairs_;
    std::vector<Vector3d> start_m_, middle_m_;
    std::vector<int> node_of_;    ///< per range of the walk
    std::vector<double> copies_;  ///< likewise: ranges of its pair in its node
    Eigen::MatrixXd motions_;
    bool learnt_ = false;
};

}  // namespace

Result<RoomFit> fitRoom(const Evidence& evidence, const std::vector<Vector3d>& places_m, double clock_m,
                        const FitSettings& settings, const JobContext& job) {
    Fit fit(evidence, places_m, clock_m, settings);
    if (Status run = fit.run(job); !run)
        return run.error();
    return std::move(fit.result);
}

Eigen::MatrixXd commonMotions(const std::vector<Vector3d>& places_m) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& place : places_m)
        middle += place / static_cast<double>(places_m.size());
    Eigen::MatrixXd motions(3 * std::ssize(places_m), 6);
    for (size_t i = 0; i < places_m.size(); ++i) {
        const auto at = 3 * static_cast<Eigen::Index>(i);
        motions.block<3, 3>(at, 0) = Matrix3d::Identity();
        motions.block<3, 3>(at, 3) = -skew(places_m[i] - middle);
    }
    return motions;
}

Eigen::MatrixXd constellationCovariance(const std::vector<Vector3d>& places_m,
                                        const Eigen::MatrixXd& cov_places_m2) {
    const Eigen::MatrixXd G = commonMotions(places_m);
    const Eigen::MatrixXd basis = basisOf(G);
    const Eigen::MatrixXd P = Eigen::MatrixXd::Identity(G.rows(), G.rows()) - basis * basis.transpose();
    return P * cov_places_m2 * P.transpose();
}

}  // namespace noctule::room_survey
