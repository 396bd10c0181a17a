// SPDX-License-Identifier: Apache-2.0
// How near the estimator comes to what the data allow: the posterior Cramer-Rao bound of the mean angle over
// all joints beside what the filter and the smoother get, in degrees, on one simulated take (readings level,
// nominal), for all sets of sensors, with the root given and free.
//
//     measure_bounds [MOTION.bvh [SECONDS [SEED]]]
//
// The bound is the information recursion of Tichavsky, Muravchik and Nehorai ("Posterior Cramer-Rao bounds
// for discrete-time nonlinear filtering", 1998, equation 21) along the true trajectory, carried out in its
// covariance form (the same by the matrix inversion lemma) with the estimator's Jacobians, which tests hold
// against differences; smoothed: with the information of what follows. It assumes
// - Gaussian errors: an angle's mean is that of a Gaussian with the bound's variances, its components
//   independent; beyond 60 degrees a linear bound says nothing and stands as "none";
// - sensors' white noise as in the scenario, without what the coding of the stream adds (it is paid back in
//   the next frame) and without errors of the calibration's matrices; biases constant or walking as in the
//   scenario, boards, bones and the spread of the speed of sound as the scenario has them;
// - distances that heard the direct path (within 15 mm of the truth), with the scatter that those of this
//   take have about the truth: echoes' pull included, taken for white;
// - a motion drawn from a Gaussian process. A given motion has no process noise, and nothing would then bound
//   an error; so per coordinate white jerk of the density that gives the accelerations' true changes over
//   1/140 s, decaying such that their true variance is the stationary one; none while the rest pose is held.
//   An estimator that knew more of how people move (movements are smooth over longer than a frame) could go
//   below.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/estimation/backward_pass.h"
#include "core/estimation/censoring.h"
#include "core/estimation/filter_tape.h"
#include "core/estimation/prediction.h"
#include "tests/benchmark/bound_scene.h"
#include "tests/benchmark/judged_take.h"
#include "tests/benchmark/run_scene.h"

namespace noctule {
namespace {

constexpr size_t kStretch = 840;  ///< steps that are kept at once when going back
constexpr double kDegrees = 180 / 3.14159265358979;

/// Beyond it a linear bound says nothing of angles.
constexpr double kMeaningless_deg = 60;

/// Of one sensor set.
struct Setting {
    const char* name;
    SensorSelection sensors;
    bool root_given;
};

/// Mean length of a Gaussian vector with these standard deviations: its square as a gamma distribution of the
/// same mean and variance, which is exact for one component and for equal ones.
double meanLength(const double* sigma) {
    double mean = 0, variance = 0;
    for (int i = 0; i < 3; ++i) {
        mean += std::pow(sigma[i], 2);
        variance += 2 * std::pow(sigma[i], 4);
    }
    if (mean <= 0)
        return 0;
    const double shape = mean * mean / variance;
    return std::sqrt(variance / mean) * std::exp(std::lgamma(shape + 0.5) - std::lgamma(shape));
}

class Bound {
public:
    Bound(const Scene& scene, const Setting& setting)
        : scene_(scene),
          setting_(setting),
          layout_(layoutOf(scene, setting)),
          observations_(scene.tree, scene.model, layout_) {}

    struct Means {
        double filtered_deg = 0, smoothed_deg = 0;
    };
    Means compute() {
        std::vector<Covariance> at_stretch;
        Covariance P(initialVariances());
        for (size_t begin = 0; begin < scene_.instants.size(); begin += kStretch) {
            at_stretch.push_back(P);
            run(P, begin, nullptr);
        }
        BackwardPass backward(layout_.size);
        Sum smoothed;
        for (size_t stretch = at_stretch.size(); stretch-- > 0;) {
            FilterTape tape;
            run(at_stretch[stretch], stretch * kStretch, &tape);
            for (auto event = tape.rbegin(); event != tape.rend(); ++event) {
                if (const auto* transition = std::get_if<LinkTransitions>(&*event))
                    backward.back(*transition);
                else if (const auto* update = std::get_if<ObservedUpdate>(&*event))
                    backward.back(*update);
                else if (const auto* frame = std::get_if<TapedFrame>(&*event))
                    smoothed.add(meanAngle(frame->motion, backward.smooth(frame->P_pose).covariance));
            }
        }
        return {filtered_.mean() * kDegrees, smoothed.mean() * kDegrees};
    }

private:
    struct Sum {
        double sum = 0, count = 0;
        void add(double value) { sum += value, ++count; }
        double mean() const { return sum / std::max(1.0, count); }
    };

    static StateLayout layoutOf(const Scene& scene, const Setting& setting) {
        const int boards = static_cast<int>(scene.model.boards.size());
        StateLayout layout;
        layout.freedoms = scene.tree.freedoms();
        layout.size = 3 * layout.freedoms;
        const auto reserve = [&](bool wanted, int& first, int count) {
            first = wanted ? layout.size : -1;
            layout.size += wanted ? count : 0;
        };
        reserve(setting.sensors.gyroscopes, layout.gyro_bias, 3 * boards);
        reserve(setting.sensors.accelerometers, layout.accel_bias, 3 * boards);
        reserve(setting.sensors.distances, layout.source_offset,
                static_cast<int>(scene.model.sources.size()));
        reserve(setting.sensors.distances, layout.sound_scale, 1);
        return layout;
    }

    Eigen::VectorXd initialVariances() const {
        const simulation::Scenario& s = scene_.stage.scenario;
        const Eigen::Index boards = 3 * std::ssize(scene_.model.boards);
        Eigen::VectorXd sigma = Eigen::VectorXd::Zero(layout_.size);
        sigma.head(layout_.freedoms).setConstant(s.initial_pose_rad);
        if (layout_.gyro_bias >= 0)
            sigma.segment(layout_.gyro_bias, boards).setConstant(s.gyro_bias_rad_per_s);
        if (layout_.accel_bias >= 0)
            sigma.segment(layout_.accel_bias, boards).setConstant(s.accel_bias_m_per_s2);
        if (layout_.source_offset >= 0) {
            sigma.segment(layout_.source_offset, std::ssize(scene_.model.sources))
                .setConstant(offsetSigma_m(s));
            sigma[layout_.sound_scale] = soundScaleSigma(s);
        }
        return sigma.cwiseAbs2();
    }

    double meanAngle(const MotionState& motion, const Eigen::MatrixXd& P) const {
        const Skeleton& skeleton = scene_.stage.actor.skeleton;
        const std::vector<double> sigmas = jointSigmas(scene_.tree, skeleton, motion, P);
        Sum joints;
        for (int j = 1; j < skeleton.size(); ++j)
            if (skeleton.joint(j).type != JointType::kFixed)
                joints.add(meanLength(&sigmas[static_cast<size_t>(3 * j)]));
        return joints.mean();
    }

    void observe(Covariance& P, const std::vector<ObservationBlock>& blocks, FilterTape* tape) const {
        ObservedUpdate observed;
        P.update(blocks, tape ? &observed : nullptr);
        if (tape && !observed.blocks.empty())
            tape->push_back(std::move(observed));
    }

    void observeAll(Covariance& P, size_t k, FilterTape* tape) {
        const Instant& instant = scene_.instants[k];
        const double now_s = static_cast<double>(k) * kStep_s;
        std::vector<ObservationBlock> roots, triads, distances;
        if (setting_.root_given)
            for (const RootMeasurement& root : instant.roots)
                roots.push_back(observations_.root(instant.truth, root, root.time_s - now_s));
        for (const InertialMeasurement& reading : instant.inertial) {
            const double offset_s = reading.time_s - now_s;
            if (setting_.sensors.gyroscopes) {
                triads.push_back(observations_.gyro(instant.truth, reading, offset_s));
                leaveOutBeyond(triads.back(), reading.gyro);
            }
            if (setting_.sensors.accelerometers) {
                triads.push_back(observations_.accel(instant.truth, reading, offset_s).block);
                leaveOutBeyond(triads.back(), reading.accel);
            }
        }
        if (setting_.sensors.distances)
            for (const DistanceMeasurement& distance : instant.distances)
                distances.push_back(observations_
                                        .distance(instant.truth, distance, distance.emission_s - now_s,
                                                  distance.arrival_s - now_s)
                                        .block);
        std::erase_if(triads, [](const ObservationBlock& block) { return block.rows() == 0; });
        for (const auto* blocks : {&roots, &triads, &distances})
            observe(P, *blocks, tape);
    }

    /// A stretch from P on; with a tape nothing is counted, it has been before.
    void run(Covariance& P, size_t begin, FilterTape* tape) {
        const Eigen::VectorXd still = Eigen::VectorXd::Zero(scene_.tree.freedoms());
        for (size_t k = begin; k < std::min(begin + kStretch, scene_.instants.size()); ++k) {
            const bool rests = static_cast<double>(k) * kStep_s <= scene_.rest_s();
            MotionState motion = scene_.instants[std::max<size_t>(k, 1) - 1].truth.motion;
            LinkTransitions transition = predictMotion(scene_.tree, motion, P.dense(), kStep_s, scene_.decay,
                                                       rests ? still : scene_.variance);
            if (tape)
                tape->push_back(std::move(transition));
            if (layout_.gyro_bias >= 0)
                P.dense()
                    .diagonal()
                    .segment(layout_.gyro_bias, 3 * std::ssize(scene_.model.boards))
                    .array() +=
                    std::pow(scene_.stage.scenario.gyro_bias_walk_rad_per_s_per_sqrt_s, 2) * kStep_s;
            observeAll(P, k, tape);
            if (rests || k % kStepsPerFrame != 0)
                continue;
            const MotionState& truth = scene_.instants[k].truth.motion;
            if (tape)
                tape->push_back(TapedFrame{{0}, truth, {}, P.dense().topRows(layout_.freedoms)});
            else
                filtered_.add(meanAngle(truth, P.dense()));
        }
    }

    const Scene& scene_;
    Setting setting_;
    StateLayout layout_;
    ObservationModel observations_;
    Sum filtered_;
};

double estimatorError_deg(const std::string& take_path, const Setting& setting, Smoother smoother) {
    TrackerSettings tracker;
    tracker.sensors = setting.sensors;
    tracker.root_given = setting.root_given;
    tracker.ground = Ground::kNone;  // the bound knows no floor
    tracker.smoother = smoother;
    return processedAndCompared(take_path, tracker).mean_deg;
}

/// What the estimator gets where everything is as the bound assumes.
double drawnError_deg(const Scene& scene, const std::vector<Instant>& instants, const Setting& setting,
                      Smoother smoother, bool joints_give) {
    ManifoldParameters parameters;
    parameters.sensors = setting.sensors;
    parameters.root_given = setting.root_given;
    parameters.ground.ground = Ground::kNone;
    parameters.joints_give = joints_give;
    return meanError_deg(scene, estimatedPoses(scene, instants, parameters, smoother == Smoother::kFull));
}

/// What was got, and its ratio to the bound.
void print(double bound_deg, std::initializer_list<double> got_deg) {
    const bool is_bound = bound_deg < kMeaningless_deg;
    std::printf(is_bound ? "| %.3f " : "| none ", bound_deg);
    for (const double got : got_deg)
        std::printf(is_bound ? "| %.3f (%.2f) " : "| %.3f ", got, got / bound_deg);
}

void measure(const std::string& motion, double seconds, uint64_t seed) {
    const std::string name = std::filesystem::path(motion).stem().string();
    const std::string take_path =
        (std::filesystem::temp_directory_path() / ("bounds_" + name + ".noctule")).string();
    const Scene scene = sceneOf(motion, seconds, seed, take_path);
    std::printf("%s, %.0f s, nominal, seed %d; distances scatter by %.2f mm\n\n", name.c_str(), seconds,
                static_cast<int>(seed), 1e3 * scene.sigma_distance_m);
    std::printf(
        "| root | sensors | filter: bound, deg | drawn, rigid | drawn | got | smoother: bound, deg | drawn, "
        "rigid | drawn | got |\n|-|-|-|-|-|-|-|-|-|-|\n");
    const std::vector<Instant> drawn = drawnInstants(
        scene, sceneOf(motion, seconds, seed, take_path + "_flawless", Boards::kFlawless), seed);
    std::filesystem::remove(take_path + "_flawless");
    const Setting sets[] = {{"A+G+D", {true, true, true}, true}, {"A+G", {true, true, false}, true},
                            {"G+D", {false, true, true}, true},  {"G", {false, true, false}, true},
                            {"A+D", {true, false, true}, true},  {"D", {false, false, true}, true},
                            {"A", {true, false, false}, true}};
    for (const bool root_given : {true, false})
        for (Setting setting : sets) {
            setting.root_given = root_given;
            const auto [filtered_deg, smoothed_deg] = Bound(scene, setting).compute();
            std::printf("| %s | %s ", root_given ? "given" : "free", setting.name);
            for (const Smoother smoother : {Smoother::kNone, Smoother::kFull})
                print(smoother == Smoother::kNone ? filtered_deg : smoothed_deg,
                      {drawnError_deg(scene, drawn, setting, smoother, false),
                       drawnError_deg(scene, drawn, setting, smoother, true),
                       estimatorError_deg(take_path, setting, smoother)});
            std::printf("|\n");
            std::fflush(stdout);
        }
    std::filesystem::remove(take_path);
}

}  // namespace
}  // namespace noctule

int main(int argc, char** argv) {
    noctule::measure(argc > 1 ? argv[1] : "/usr/share/assimp/models/BVH/01_01.bvh",
                     argc > 2 ? std::atof(argv[2]) : 15, argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
    return 0;
}
