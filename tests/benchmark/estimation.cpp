// SPDX-License-Identifier: Apache-2.0
// The estimator by itself on the default actor and suit, on one core: filter and smoother frames per second,
// kinematics with all Jacobians, and the Kalman update, each beside what a textbook's dense matrices would
// take in the same run. Times are of the processor.
#include <benchmark/benchmark.h>
#include <time.h>

#include <Eigen/LU>
#include <algorithm>
#include <filesystem>

#include "core/estimation/smoothing_filter.h"
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

/// Everything that the suit says while the performer stands still.
class StillSuit {
public:
    explicit StillSuit(bool root_given) : root_given_(root_given) {}

    void start(Estimator& filter) {
        filter.start(rig.actor.restPose(), {0, 0, still_}, root_given_ ? &root_ : nullptr);
    }
    void feedSecond(Estimator& filter) {
        for (int frame = 1; frame <= kFramesPerSecond; ++frame) {
            const double time_s = static_cast<double>(seconds) + frame / double(kFramesPerSecond);
            for (InertialMeasurement reading : still_) {
                reading.time_s = time_s;
                filter.add(reading);
            }
            for (; static_cast<double>(pulse_ + 1) * kPulseInterval_s < time_s; ++pulse_)
                for (DistanceMeasurement distance : heard_[static_cast<size_t>(pulse_) % heard_.size()]) {
                    distance.emission_s = static_cast<double>(pulse_) * kPulseInterval_s;
                    distance.arrival_s = distance.emission_s + distance.distance_m / 344;
                    filter.add(distance);
                    ++distances;
                }
            if (root_given_) {
                RootMeasurement now = root_;
                now.time_s = time_s;
                filter.add(now);
            }
            filter.advanceTo(time_s);
        }
        ++seconds;
        benchmark::DoNotOptimize(filter.takePoses());
        benchmark::DoNotOptimize(filter.takeDecisions());
    }

    const Rig rig;
    int64_t seconds = 0, distances = 0;

private:
    bool root_given_;
    std::vector<InertialMeasurement> still_ = stillReadings(rig, 0);
    std::vector<std::vector<DistanceMeasurement>> heard_ = stillDistances(rig);
    RootMeasurement root_{0, rig.rest.p_world_root, rig.rest.q_parent_link[0], 0.0005, 0.0017};
    int64_t pulse_ = 0;
};

/// Processor time of this thread: what others do on the machine hardly shows.
double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Equations 7 to 9 as they are printed, dense throughout, in Joseph's form.
Eigen::VectorXd denseUpdate(Eigen::MatrixXd& P, const Eigen::MatrixXd& H, const Eigen::VectorXd& residual,
                            const Eigen::VectorXd& variance) {
    const Eigen::MatrixXd R = variance.asDiagonal();
    const Eigen::MatrixXd S = H * P * H.transpose() + R;
    const Eigen::MatrixXd K = P * H.transpose() * S.inverse();
    const Eigen::MatrixXd I_KH = Eigen::MatrixXd::Identity(P.rows(), P.cols()) - K * H;
    P = (I_KH * P * I_KH.transpose() + K * R * K.transpose()).eval();
    return K * residual;
}

/// A frame of n states by dense matrices: three predictions, then `rows` readings in three updates, the
/// fewest that any order of the readings takes. Seconds.
double denseFilterFrame(Eigen::Index n, Eigen::Index rows) {
    const Eigen::MatrixXd F = Eigen::MatrixXd::Identity(n, n), H = Eigen::MatrixXd::Random(rows / 3, n);
    const Eigen::VectorXd residual = Eigen::VectorXd::Ones(rows / 3);
    Eigen::MatrixXd P = Eigen::MatrixXd::Identity(n, n);
    const double begin = cpuSeconds();
    for (int step = 0; step < 3; ++step) {
        P = (F * P * F.transpose()).eval();
        benchmark::DoNotOptimize(denseUpdate(P, H, residual, residual));
    }
    return cpuSeconds() - begin;
}

/// A frame of Rauch, Tung and Striebel's smoother by dense matrices: three steps. Seconds.
double denseSmootherFrame(Eigen::Index n) {
    const Eigen::MatrixXd F = Eigen::MatrixXd::Identity(n, n), P = 2 * F, P_expected = 3 * F;
    Eigen::MatrixXd P_smoothed = F;
    const double begin = cpuSeconds();
    for (int step = 0; step < 3; ++step) {
        const Eigen::MatrixXd C = P * F.transpose() * P_expected.inverse();
        P_smoothed = (P + C * (P_smoothed - P_expected) * C.transpose()).eval();
    }
    benchmark::DoNotOptimize(P_smoothed);
    return cpuSeconds() - begin;
}

/// Rows of readings in a frame: gyroscopes, accelerometers and what is heard of a pulse.
Eigen::Index rowsPerFrame(const Rig& rig) {
    return 6 * std::ssize(rig.suit.boards) + 6;
}

ManifoldParameters benchmarkParameters(const benchmark::State& state) {
    ManifoldParameters parameters;
    parameters.root_given = state.range(0) != 0;
    parameters.joints_give = state.range(1) != 0;
    parameters.estimates_constants = state.range(2) != 0;
    return parameters;
}

void report(benchmark::State& state, double frames, double ours_s, double dense_frame_s, Eigen::Index n) {
    state.counters["frames_per_s"] = frames / ours_s;
    state.counters["states"] = static_cast<double>(n);
    state.counters["dense_over_ours"] = dense_frame_s * frames / ours_s;
}

void filterFrames(benchmark::State& state) {
    StillSuit suit(state.range(0) != 0);
    ManifoldFilter filter(suit.rig.actor.skeleton, suit.rig.model, benchmarkParameters(state));
    suit.start(filter);
    double ours_s = 0, dense_s = 0;
    for (auto _ : state) {
        const double begin = cpuSeconds();
        suit.feedSecond(filter);
        const double this_s = cpuSeconds() - begin;
        state.SetIterationTime(this_s);
        ours_s += this_s;
        dense_s += denseFilterFrame(filter.layout().size, rowsPerFrame(suit.rig));
    }
    const auto seconds = static_cast<double>(suit.seconds);
    report(state, seconds * kFramesPerSecond, ours_s, dense_s / seconds, filter.layout().size);
    state.counters["distances_per_s"] = static_cast<double>(suit.distances) / seconds;
}

/// Smoothing a whole take of two seconds: `frames_per_s` is that of going back alone, on a tape;
/// `whole_frames_per_s` that of all, with two passes of the filter.
void smootherFrames(benchmark::State& state) {
    constexpr int kSeconds = 2;
    const ManifoldParameters parameters = benchmarkParameters(state);
    double whole_s = 0, back_s = 0, dense_s = 0;
    Eigen::Index n = 0;
    for (auto _ : state) {
        StillSuit suit(parameters.root_given);
        const Rig& rig = suit.rig;
        FixedIntervalSmoother smoother(
            rig.actor.skeleton, rig.model, parameters,
            UnnamedFile::make(std::filesystem::temp_directory_path(), "the benchmark's spool", "").value());
        const double begin = cpuSeconds();
        suit.start(smoother);
        for (int second = 0; second < kSeconds; ++second)
            suit.feedSecond(smoother);
        while (smoother.portionsLeft() > 0)
            if (!smoother.finishPortion({}))
                state.SkipWithError("the spool could not be read back");
        const double this_s = cpuSeconds() - begin;
        state.SetIterationTime(this_s);
        whole_s += this_s;

        StillSuit again(parameters.root_given);
        FilterTape tape;
        ManifoldFilter filter(rig.actor.skeleton, rig.model, parameters);
        again.start(filter);
        filter.setTape(&tape);
        again.feedSecond(filter);
        n = filter.layout().size;
        BackwardPass backward(n);
        const double tape_end = cpuSeconds();
        goBackOver(tape, backward, [&](const TapedFrame& frame, const BackwardPass::Smoothed& smoothed) {
            benchmark::DoNotOptimize(
                filter.poseOf(frame, frame.times_ns[0], smoothed.error, smoothed.covariance));
            return true;
        });
        back_s += cpuSeconds() - tape_end;
        dense_s += denseSmootherFrame(n);
    }
    const auto runs = static_cast<double>(state.iterations());
    report(state, runs * kFramesPerSecond, back_s, dense_s / runs, n);
    state.counters["whole_frames_per_s"] = runs * kSeconds * kFramesPerSecond / whole_s;
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

/// Accelerometers of all boards in one update. Time is ours; the dense one's is
/// measured alternately and reported beside it.
void kalmanUpdateBesideDense(benchmark::State& state) {
    const Rig rig;
    ManifoldParameters parameters;
    parameters.joints_give = false;  // then its tree is the rig's
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
        const double begin = cpuSeconds();
        benchmark::DoNotOptimize(P.update(blocks));
        benchmark::DoNotOptimize(P.dense());
        const double middle = cpuSeconds();
        benchmark::DoNotOptimize(denseUpdate(P_dense, H, residual, variance));
        dense_s += cpuSeconds() - middle;
        ours_s += middle - begin;
        state.SetIterationTime(middle - begin);
        difference = (P.dense() - P_dense).norm() / P_dense.norm();
    }
    if (!(difference < 1e-6))
        state.SkipWithError("the two updates do not agree");
    state.counters["n"] = static_cast<double>(start_dense.rows());
    state.counters["m"] = static_cast<double>(m);
    state.counters["dense_us"] = 1e6 * dense_s / static_cast<double>(state.iterations());
    state.counters["dense_over_ours"] = dense_s / ours_s;
}

BENCHMARK(filterFrames)
    ->ArgNames({"root_given", "joints_give", "constants"})
    ->ArgsProduct({{1, 0}, {1, 0}, {1}})
    ->Args({1, 0, 0})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(smootherFrames)
    ->ArgNames({"root_given", "joints_give", "constants"})
    ->ArgsProduct({{1}, {1, 0}, {1}})
    ->Args({1, 0, 0})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(kinematicsWithJacobians)->Unit(benchmark::kMicrosecond);
BENCHMARK(kalmanUpdateBesideDense)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace noctule

BENCHMARK_MAIN();
