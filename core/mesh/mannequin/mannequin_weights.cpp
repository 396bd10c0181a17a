// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/mannequin/mannequin_weights.h"

#include <algorithm>
#include <numeric>

namespace noctule {
namespace {

/// From 0 to 1 along `direction`, within `half_width_m` of a plane through `point_m` (in the joint's frame).
struct Boundary {
    const char* joint;
    Vector3d point_m, direction;
    double half_width_m;
};

/// Left side and middle; the right side is the mirror image. Several boundaries of a joint multiply.
/// A wide boundary bends softly and loses volume; a narrow one creases.
const std::vector<Boundary>& boundaries() {
    static const std::vector<Boundary> table = {
        {"Spine", {0, 0, 0}, {0, 1, 0}, 0.075},
        {"Chest", {0, 0, 0}, {0, 1, 0}, 0.080},
        {"Neck", {0, 0.03, 0}, {0, 1, 0.15}, 0.040},
        {"Head", {0, 0, 0}, {0, 0.85, 0.53}, 0.050},
        {"LeftShoulder", {0.055, 0.02, 0}, {0.8, 0.6, 0}, 0.080},
        {"LeftShoulder", {-0.01, 0, 0}, {1, 0, 0}, 0.010},  // and none beyond the middle
        {"LeftArm", {-0.005, 0, 0}, {0.93, 0.36, 0}, 0.065},
        {"LeftForeArm", {0, 0, 0}, {1, 0, 0}, 0.055},
        {"LeftHand", {0, 0, 0}, {1, 0, 0}, 0.035},
        {"LeftUpLeg", {0, 0, 0}, {0.40, -0.92, 0}, 0.085},
        {"LeftUpLeg", {-0.085, -0.085, 0}, {0.80, -0.60, 0}, 0.050},  // the crotch stays with the pelvis
        {"LeftUpLeg", {-0.09, 0, 0}, {1, 0, 0}, 0.010},               // and the legs share it
        {"LeftLeg", {0, 0, 0}, {0, -1, 0}, 0.065},
        {"LeftFoot", {0, 0.022, 0}, {0, -0.93, 0.37}, 0.040},
        {"LeftToeBase", {0, 0, 0}, {0, 0, 1}, 0.030},
    };
    return table;
}

double softStep(double x) {
    const double t = std::clamp((x + 1) / 2, 0.0, 1.0);
    return t * t * t * (t * (6 * t - 15) + 10);
}

/// Share of what the joint's parent still has that goes on to the joint.
double share(const std::string& joint, const Vector3d& p_joint_m) {
    const bool right = joint.starts_with("Right");
    const std::string left_name = right ? "Left" + joint.substr(5) : joint;
    const Vector3d p(right ? -p_joint_m.x() : p_joint_m.x(), p_joint_m.y(), p_joint_m.z());
    double product = 1;
    for (const Boundary& b : boundaries())
        if (left_name == b.joint)
            product *= softStep((p - b.point_m).dot(b.direction.normalized()) / b.half_width_m);
    return product;
}

/// The joint of the other side that has the same parent, or -1.
int twinOf(const Skeleton& skeleton, const Joint& joint) {
    const bool left = joint.name.starts_with("Left");
    if (!left && !joint.name.starts_with("Right"))
        return -1;
    const int twin = skeleton.find(left ? "Right" + joint.name.substr(4) : "Left" + joint.name.substr(5));
    return twin >= 0 && skeleton.joint(twin).parent == joint.parent ? twin : -1;
}

/// The same with twins on equal terms: together they take at most all of it. The one that comes second gets
/// its share of what the first has left.
double fractionOfRest(const Skeleton& skeleton, const GlobalPose& global, int index, const Vector3d& p_m) {
    const auto shareOf = [&](int j) {
        return share(skeleton.joint(j).name, p_m - global.p_world_joint[static_cast<size_t>(j)]);
    };
    const double own = shareOf(index);
    const int twin = twinOf(skeleton, skeleton.joint(index));
    if (twin < 0 || own == 0)
        return own;
    const double twins = shareOf(twin), whole = std::max(1.0, own + twins);
    return index < twin ? own / whole : own / (whole - twins);
}

/// The four heaviest, without dust, their sum 1.
BoneWeights heaviest(const std::vector<double>& weight_of_joint) {
    std::vector<uint16_t> order(weight_of_joint.size());
    std::iota(order.begin(), order.end(), uint16_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](uint16_t a, uint16_t b) { return weight_of_joint[a] > weight_of_joint[b]; });
    double sum = 0;
    for (size_t i = 0; i < 4; ++i)
        sum += weight_of_joint[order[i]] < 1e-3 ? 0 : weight_of_joint[order[i]];
    BoneWeights result;
    for (size_t i = 0; i < 4 && weight_of_joint[order[i]] >= 1e-3; ++i) {
        result.bones[i] = order[i];
        result.weights[i] = static_cast<float>(weight_of_joint[order[i]] / sum);
    }
    return result;
}

}  // namespace

BoneWeights mannequinWeights(const Skeleton& skeleton, const GlobalPose& global, const Vector3d& p_m) {
    const size_t count = static_cast<size_t>(skeleton.size());
    std::vector<double> weights(count, 0);
    weights[0] = 1;
    for (size_t j = 1; j < count; ++j) {  // every joint takes its share of what its parent still has
        const Joint& joint = skeleton.joint(static_cast<int>(j));
        double& left = weights[static_cast<size_t>(joint.parent)];
        weights[j] = left * fractionOfRest(skeleton, global, static_cast<int>(j), p_m);
        left -= weights[j];
    }
    return heaviest(weights);
}

}  // namespace noctule
