// SPDX-License-Identifier: Apache-2.0
// The estimator by itself on the default actor and suit, on one core: filter frames per second, kinematics
// with all Jacobians, and the Kalman update beside what a textbook's dense matrices would take.
#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <algorithm>
#include <chrono>

#include "core/estimation/manifold_filter.h"
#include "core/suit/default_suit.h"

namespace noctule {
namespace {

constexpr int kFramesPerSecond = 140;
constexpr double kPulseInterval_s = 0.008;

struct Rig {
    Actor actor = defaultActor();
    Suit suit = defaultSuit();
    KinematicTree tree{actor.skeleton, BallCoordinates::kManifold};
    SuitModel model = mountSuit(suit, nominalCalibration(suit), actor, tree).value();
    MotionState rest = tree.stateFromPose(actor.restPose());

    Vector3d inWorld(int link, const Vector3d& p_link) const {
        ChainMotion chain;
        chain.evaluate(tree, rest, link, 0);
        return chain.point(p_link).p_m;
    }
};

TriadReading triadOf(const Vector3d& value, double sigma) {
    TriadReading triad;
    for (int i = 0; i < 3; ++i)
        triad.add({Vector3d::Unit(i), value[i], sigma});
    return triad;
}

/// What every board reads while the performer stands in the rest pose.
std::vector<InertialMeasurement> stillReadings(const Rig& rig, double time_s) {
    std::vector<InertialMeasurement> readings;
    ChainMotion chain;
    for (size_t b = 0; b < rig.model.boards.size(); ++b) {
        chain.evaluate(rig.tree, rig.rest, rig.model.boards[b].link, 0);
        const Matrix3d R_world_board = chain.end().R_world_link * rig.model.boards[b].R_link_board;
        readings.push_back({static_cast<int>(b), time_s, triadOf(Vector3d::Zero(), 0.003),
                            triadOf(kStandardGravity_m_per_s2 * R_world_board.row(1).transpose(), 0.03)});
    }
    return readings;
}

/// The six boards nearest to each source, in front of it: 29 % of all pairs.
std::vector<std::vector<DistanceMeasurement>> stillDistances(const Rig& rig) {
    constexpr size_t kHeard = 6;
    std::vector<std::vector<DistanceMeasurement>> by_source(rig.model.sources.size());
    for (size_t s = 0; s < by_source.size(); ++s) {
        const MountedSource& source = rig.model.sources[s];
        const Vector3d from = rig.inWorld(source.link, source.p_link_source);
        const Vector3d normal = rig.inWorld(source.link, source.p_link_source + source.normal_link) - from;
        for (size_t b = 0; b < rig.model.boards.size(); ++b) {
            const Vector3d way = rig.inWorld(rig.model.boards[b].link, rig.model.boards[b].p_link_mic) - from;
            if (way.dot(normal) > 0)
                by_source[s].push_back(
                    {0, static_cast<int>(s), static_cast<int>(b), 0, 0, way.norm(), 0.001, 1});
        }
        std::ranges::sort(by_source[s], {}, &DistanceMeasurement::distance_m);
        by_source[s].resize(std::min(kHeard, by_source[s].size()));
    }
    return by_source;
}

/// One second of everything that the suit says, again and again.
void filterFrames(benchmark::State& state) {
    const Rig rig;
    const auto still = stillReadings(rig, 0);
    const auto heard = stillDistances(rig);
    ManifoldParameters parameters;
    parameters.root_given = state.range(0) != 0;
    ManifoldFilter filter(rig.actor.skeleton, rig.model, parameters);
    const RootMeasurement root{0, rig.rest.p_world_root, rig.rest.q_parent_link[0], 0.0005, 0.0017};
    filter.start(rig.actor.restPose(), {0, 0, still}, parameters.root_given ? &root : nullptr);
    int64_t second = 0, pulse = 0, distances = 0;
    for (auto _ : state) {
        for (int frame = 1; frame <= kFramesPerSecond; ++frame) {
            const double time_s = static_cast<double>(second) + frame / double(kFramesPerSecond);
            for (InertialMeasurement reading : still) {
                reading.time_s = time_s;
                filter.add(reading);
            }
            for (; static_cast<double>(pulse + 1) * kPulseInterval_s < time_s; ++pulse)
                for (DistanceMeasurement distance : heard[static_cast<size_t>(pulse) % heard.size()]) {
                    distance.emission_s = static_cast<double>(pulse) * kPulseInterval_s;
                    distance.arrival_s = distance.emission_s + distance.distance_m / 344;
                    filter.add(distance);
                    ++distances;
                }
            if (parameters.root_given) {
                RootMeasurement now = root;
                now.time_s = time_s;
                filter.add(now);
            }
            filter.advanceTo(time_s);
        }
        ++second;
        benchmark::DoNotOptimize(filter.takePoses());
        benchmark::DoNotOptimize(filter.takeDecisions());
    }
    state.counters["frames_per_s"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * kFramesPerSecond, benchmark::Counter::kIsRate);
    state.counters["states"] = filter.layout().size;
    state.counters["distances_per_s"] = static_cast<double>(distances) / static_cast<double>(second);
}

/// Motion of every board's point with its derivatives by all coordinates, rates and accelerations.
void kinematicsWithJacobians(benchmark::State& state) {
    const Rig rig;
    ChainMotion chain;
    Vector3d sum = Vector3d::Zero();
    for (auto _ : state)
        for (const MountedBoard& board : rig.model.boards) {
            chain.evaluate(rig.tree, rig.rest, board.link, 0.001);
            const ChainMotion::Point point = chain.point(board.p_link_board);
            for (const ChainMotion::Coordinate& c : chain.coordinates()) {
                const ChainMotion::PointDerivative d = chain.pointDerivative(c, point);
                sum += d.a_theta + d.a_rate + d.a_accel + d.v_theta + chain.omegaByTheta(c) +
                       chain.rotationByTheta(c);
            }
        }
    benchmark::DoNotOptimize(sum);
    state.counters["boards"] = static_cast<double>(rig.model.boards.size());
}

/// Joseph's form with an explicit inverse, dense throughout: equations 7 to 9 as they are printed.
Eigen::VectorXd denseUpdate(Eigen::MatrixXd& P, const Eigen::MatrixXd& H, const Eigen::VectorXd& residual,
                            const Eigen::VectorXd& variance) {
    const Eigen::MatrixXd R = variance.asDiagonal();
    const Eigen::MatrixXd S = H * P * H.transpose() + R;
    const Eigen::MatrixXd K = P * H.transpose() * S.inverse();
    const Eigen::MatrixXd I_KH = Eigen::MatrixXd::Identity(P.rows(), P.cols()) - K * H;
    P = (I_KH * P * I_KH.transpose() + K * R * K.transpose()).eval();
    return K * residual;
}

/// Accelerometers of all boards in one update. Time is ours; the dense one's is
/// measured alternately and reported beside it.
void kalmanUpdateBesideDense(benchmark::State& state) {
    using Clock = std::chrono::steady_clock;
    const Rig rig;
    ManifoldParameters parameters;
    ManifoldFilter filter(rig.actor.skeleton, rig.model, parameters);
    filter.start(rig.actor.restPose(), {0, 0, {}}, nullptr);
    ObservationModel observations(rig.tree, rig.model, filter.layout());
    std::vector<ObservationBlock> blocks;
    for (const InertialMeasurement& reading : stillReadings(rig, 0))
        blocks.push_back(observations.accel(filter.state(), reading, 0.001).block);

    Eigen::Index m = 0;
    for (const ObservationBlock& block : blocks)
        m += block.rows();
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(m, filter.layout().size);
    Eigen::VectorXd residual(m), variance(m);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        for (Eigen::Index k = 0; k < block.H.cols(); ++k)
            H.block(row, block.columns[static_cast<size_t>(k)], block.rows(), 1) += block.H.col(k);
        residual.segment(row, block.rows()) = block.residual;
        variance.segment(row, block.rows()) = block.variance;
        row += block.rows();
    }

    // A covariance full of correlations, as the filter has after its first frame.
    Covariance start(Eigen::VectorXd(filter.covariance().diagonal()));
    start.update(blocks);
    const Eigen::MatrixXd start_dense = start.dense();
    double ours_s = 0, dense_s = 0, difference = 0;
    for (auto _ : state) {
        Covariance P = start;
        Eigen::MatrixXd P_dense = start_dense;
        const auto begin = Clock::now();
        benchmark::DoNotOptimize(P.update(blocks));
        benchmark::DoNotOptimize(P.dense());
        const auto middle = Clock::now();
        benchmark::DoNotOptimize(denseUpdate(P_dense, H, residual, variance));
        const auto end = Clock::now();
        const double this_s = std::chrono::duration<double>(middle - begin).count();
        ours_s += this_s;
        dense_s += std::chrono::duration<double>(end - middle).count();
        state.SetIterationTime(this_s);
        difference = (P.dense() - P_dense).norm() / P_dense.norm();
    }
    if (!(difference < 1e-6))
        state.SkipWithError("the two updates do not agree");
    state.counters["n"] = static_cast<double>(start_dense.rows());
    state.counters["m"] = static_cast<double>(m);
    state.counters["dense_us"] = 1e6 * dense_s / static_cast<double>(state.iterations());
    state.counters["dense_over_ours"] = dense_s / ours_s;
}

BENCHMARK(filterFrames)->ArgName("root_given")->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond);
BENCHMARK(kinematicsWithJacobians)->Unit(benchmark::kMicrosecond);
BENCHMARK(kalmanUpdateBesideDense)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace noctule

BENCHMARK_MAIN();
