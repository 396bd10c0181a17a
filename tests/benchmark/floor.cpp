// SPDX-License-Identifier: Apache-2.0
// How near any estimator could come on a person if the attitudes of all boards were known exactly: what
// remains is where flesh takes the boards, what the calibration leaves, and joints between that carry none.
// One simulated take (realistic, readings level, root given), beside what the filter and the smoother get:
//
//     measure_floor CALIBRATION.json PERFORMER.json ACTOR.json MOTION.bvh [SECONDS [SEED]]
//
// CALIBRATION and PERFORMER are what `calibrate motion` wrote of that seed's suit on ACTOR
// (packaging/acceptance.sh accuracy leaves them in out/acceptance/accuracy). "Constant": each board turned by
// its mean over this very take, which no calibration knows; what then remains is flesh. Joints whose segments
// carry no board hold the rest pose.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/estimation/suit_model.h"
#include "core/math/linear_solvers.h"
#include "core/motion/comparison.h"
#include "core/processing/outside_files.h"
#include "tests/benchmark/judged_take.h"
#include "tests/benchmark/nominal_stage.h"

namespace noctule {
namespace {

constexpr double kEvery_s = 0.05;

struct Given {
    Calibration calibration;
    Actor performer;
    simulation::Stage stage;

    KinematicTree tree{performer.skeleton, BallCoordinates::kManifold};
    SuitModel model = mountSuit(stage.suit, calibration, performer, tree).value();

    Quaterniond boardAttitude(size_t board, double time_s) const {
        return stage.world->boardMotion(static_cast<int>(board), time_s).q_world_board;
    }
    Pose truth(double time_s) const { return stage.body->performance().pose(time_s); }
    double begin_s() const { return stage.body->performance().rest_seconds(); }
    size_t jointOf(const MountedBoard& board) const {
        return static_cast<size_t>(tree.link(board.link).joint);
    }
};

/// Of the boards on their segments, each turned by its mean over the take.
std::vector<Quaterniond> meanMountings(const Given& given) {
    std::vector<Eigen::Matrix4d> sums(given.model.boards.size(), Eigen::Matrix4d::Zero());
    for (double t = given.begin_s(); t < given.stage.world->duration_s(); t += kEvery_s) {
        const auto world = globalPose(given.performer.skeleton, given.truth(t)).q_world_joint;
        for (size_t b = 0; b < sums.size(); ++b) {
            const Quaterniond q =
                world[given.jointOf(given.model.boards[b])].conjugate() * given.boardAttitude(b, t);
            sums[b] += q.coeffs() * q.coeffs().transpose();
        }
    }
    std::vector<Quaterniond> means;
    for (const Eigen::Matrix4d& sum : sums)
        means.emplace_back(Eigen::Vector4d(eigensystemOf(sum).vectors.col(3)));
    return means;
}

/// The pose in which every segment with a board is turned as the board and `mounting` say.
template <class Mounting>
Pose poseByBoards(const Given& given, double time_s, const Mounting& mounting) {
    const Skeleton& skeleton = given.performer.skeleton;
    Pose pose = given.performer.restPose();
    std::vector<std::optional<Quaterniond>> seen(static_cast<size_t>(skeleton.size()));
    for (size_t b = 0; b < given.model.boards.size(); ++b)
        seen[given.jointOf(given.model.boards[b])] = given.boardAttitude(b, time_s) * mounting(b).conjugate();
    std::vector<Quaterniond> world;
    for (int j = 0; j < skeleton.size(); ++j) {
        const int parent = skeleton.joint(j).parent;
        Quaterniond& own = pose.q_parent_joint[static_cast<size_t>(j)];
        const Quaterniond above = parent < 0 ? Quaterniond::Identity() : world[static_cast<size_t>(parent)];
        if (const auto& by_board = seen[static_cast<size_t>(j)])
            own = above.conjugate() * *by_board;
        world.push_back(above * own);
    }
    return pose;
}

void measure(const Given& given, const std::string& take_path, const std::string& name) {
    TimedMotion reference{given.stage.mover.skeleton, {}}, constant{given.performer.skeleton, {}},
        calibrated = constant;
    const std::vector<Quaterniond> means = meanMountings(given);
    for (double t = given.begin_s(); t < given.stage.world->duration_s(); t += kEvery_s) {
        const auto time_ns = static_cast<int64_t>(1e9 * t);
        const Pose truth = given.truth(t);
        const MotionState state = given.tree.stateFromPose(truth);
        reference.frames.push_back({time_ns, truth, {}});
        constant.frames.push_back({time_ns, poseByBoards(given, t, [&](size_t b) { return means[b]; }), {}});
        calibrated.frames.push_back(
            {time_ns,
             poseByBoards(given, t,
                          [&](size_t b) {
                              return Quaterniond(placeBoard(given.model.boards[b], given.tree, state, 0).R);
                          }),
             {}});
    }
    std::vector<Comparison> columns{compareMotions(constant, reference).value(),
                                    compareMotions(calibrated, reference).value()};
    for (const Smoother smoother : {Smoother::kNone, Smoother::kFull}) {
        TrackerSettings tracker;
        tracker.root_given = true;
        tracker.smoother = smoother;
        columns.push_back(processedAndCompared(take_path, tracker, given.calibration, given.performer));
    }
    std::printf("%s: degrees\n\n| joint | constant | calibrated | filter | smoother |\n|-|-|-|-|-|\n",
                name.c_str());
    for (const JointComparison& joint : columns[0].joints) {
        std::printf("| %s ", joint.name.c_str());
        for (const Comparison& column : columns)
            std::printf("| %.2f ", column.find(joint.name)->angle.mean_deg);
        std::printf("|\n");
    }
    std::printf("| all ");
    for (const Comparison& column : columns)
        std::printf("| %.2f ", column.mean_deg);
    std::printf("|\n");
}

}  // namespace
}  // namespace noctule

int main(int argc, char** argv) {
    using namespace noctule;
    if (argc < 5) {
        std::fprintf(
            stderr, "measure_floor CALIBRATION.json PERFORMER.json ACTOR.json MOTION.bvh [SECONDS [SEED]]\n");
        return 1;
    }
    const auto actor = [](const std::string& path) {
        return actorFromJson(nlohmann::json::parse(std::ifstream(path)), path).value();
    };
    simulation::StageRequest request = nominalStage(argv[4], argc > 5 ? std::atof(argv[5]) : 20);
    request.scenario = simulation::Scenario::realistic();
    request.actor = actor(argv[3]);
    request.seed = argc > 6 ? std::strtoull(argv[6], nullptr, 10) : 1;
    const std::string path = (std::filesystem::temp_directory_path() / "floor.noctule").string();
    const Given given{readCalibrationFile(argv[1]).value(), actor(argv[2]),
                      simulation::prepareStage(request).value()};
    writeReadings(given.stage, path);
    measure(given, path, std::filesystem::path(argv[4]).stem().string());
    std::filesystem::remove(path);
    return 0;
}
