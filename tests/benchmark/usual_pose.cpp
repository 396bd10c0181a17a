// SPDX-License-Identifier: Apache-2.0
// How the joints of recorded people turn in the mean and how far they deviate: the table of
// core/body/usual_pose.cpp.
//
//   learn_usual_pose MOTION.bvh...
//
// Every motion counts alike, however long, and as much as its mirror image. Rows: joint, rotation vector of
// the mean turn from the zero pose, deviation about each axis of the joint's frame then; whole degrees; of
// the left side and the middle.
#include <cstdio>
#include <map>
#include <numbers>
#include <vector>

#include "core/body/joint_names.h"
#include "core/formats/bvh.h"
#include "core/math/rotation.h"
#include "core/simulation/motion_fit.h"

namespace noctule {
namespace {

struct Turn {
    Quaterniond q;
    double weight = 0;
};
using Turns = std::map<std::string, std::vector<Turn>>;  ///< per joint

Status addMotion(const std::string& path, Turns& turns) {
    const auto document = readBvh(path);
    if (!document)
        return document.error();
    const auto clip = toClip(*document);
    if (!clip)
        return clip.error();
    const auto actor = simulation::actorFromClip(*clip);
    if (!actor)
        return actor.error();
    const auto fitted = simulation::fitMotion(*clip, {*actor, actor->skeleton});
    if (!fitted)
        return fitted.error();
    const simulation::Coordinates coordinates(actor->skeleton);
    const double weight = 1 / static_cast<double>(fitted->rows.size());
    for (const auto& row : fitted->rows) {
        const Pose pose = coordinates.toPose(row);
        for (int j = 1; j < actor->skeleton.size(); ++j) {
            const std::string& joint = actor->skeleton.joint(j).name;
            const Quaterniond& q = pose.q_parent_joint[static_cast<size_t>(j)];
            turns[joint].push_back({q, weight});
            turns[mirroredSegment(joint)].push_back({mirroredInX(q), weight});
        }
    }
    return Done{};
}

void print(const std::string& joint, const std::vector<Turn>& turns) {
    constexpr int kIterations = 20;
    Quaterniond mean = Quaterniond::Identity();
    Vector3d variance;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        Vector3d step = Vector3d::Zero();
        variance.setZero();
        double weight = 0;
        for (const Turn& turn : turns) {
            const Vector3d away = logQuaternion(mean.conjugate() * turn.q);
            step += turn.weight * away;
            variance += turn.weight * away.cwiseAbs2();
            weight += turn.weight;
        }
        mean = mean * expQuaternion(step / weight);
        variance /= weight;
    }
    constexpr double kDegrees = 180 / std::numbers::pi;
    const Vector3d turn = kDegrees * logQuaternion(mean), sigma = kDegrees * variance.cwiseSqrt();
    std::printf("    {\"%s\", {%.0f, %.0f, %.0f}, {%.0f, %.0f, %.0f}},\n", joint.c_str(), turn.x(), turn.y(),
                turn.z(), sigma.x(), sigma.y(), sigma.z());
}

}  // namespace
}  // namespace noctule

int main(int argc, char** argv) {
    using namespace noctule;
    Turns turns;
    for (int i = 1; i < argc; ++i)
        if (const Status added = addMotion(argv[i], turns); !added) {
            std::fprintf(stderr, "%s: %s\n", argv[i], added.error().text().c_str());
            return 1;
        }
    for (const auto& [joint, all] : turns)
        if (!joint.starts_with("Right"))
            print(joint, all);
    return 0;
}
