// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "core/formats/number_text.h"
#include "core/formats/opensim.h"
#include "core/math/euler.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

enum class Side { kMiddle, kLeft, kRight };

/// How a body of the model lies in its zero pose, where ours stands in a T with palms down.
enum class Zero {
    kSame,
    kHanging,    ///< the upper arm
    kPalmAhead,  ///< hanging, and turned outwards by a quarter
};

/// A body of the model and the segment that moves it.
struct ModelBody {
    const char* name;
    const char* joint;  ///< without "Left" or "Right"
    Zero zero;
    bool has_sides;
};
constexpr ModelBody kPelvis{"pelvis", "Hips", Zero::kSame, false};
constexpr ModelBody kTorso{"torso", "Chest", Zero::kSame, false};
constexpr ModelBody kFemur{"femur", "UpLeg", Zero::kSame, true};
constexpr ModelBody kTibia{"tibia", "Leg", Zero::kSame, true};
constexpr ModelBody kCalcn{"calcn", "Foot", Zero::kSame, true};
constexpr ModelBody kHumerus{"humerus", "Arm", Zero::kHanging, true};
constexpr ModelBody kRadius{"radius", "ForeArm", Zero::kPalmAhead, true};
constexpr ModelBody kHand{"hand", "Hand", Zero::kPalmAhead, true};
constexpr std::array kBodies{kPelvis, kTorso, kFemur, kTibia, kCalcn, kHumerus, kRadius, kHand};

/// A joint of the model: up to three coordinates about Z, X and Y, empty where it cannot turn.
struct ModelJoint {
    const ModelBody* parent;  ///< nullptr: the ground
    const ModelBody* child;
    std::array<const char*, 3> coordinates;
    double first_sign = 1;
};
constexpr std::array kJoints{
    ModelJoint{nullptr, &kPelvis, {"pelvis_tilt", "pelvis_list", "pelvis_rotation"}},
    ModelJoint{&kPelvis, &kFemur, {"hip_flexion", "hip_adduction", "hip_rotation"}},
    ModelJoint{&kFemur, &kTibia, {"knee_angle", nullptr, nullptr}, -1},
    ModelJoint{&kTibia, &kCalcn, {"ankle_angle", "subtalar_angle", nullptr}},
    ModelJoint{&kPelvis, &kTorso, {"lumbar_extension", "lumbar_bending", "lumbar_rotation"}},
    ModelJoint{&kTorso, &kHumerus, {"arm_flex", "arm_add", "arm_rot"}},
    ModelJoint{&kHumerus, &kRadius, {"elbow_flex", nullptr, "pro_sup"}},
    ModelJoint{&kRadius, &kHand, {"wrist_flex", "wrist_dev", nullptr}}};

std::string nameOf(const char* base, Side side) {
    return std::string(base) + (side == Side::kLeft ? "_l" : side == Side::kRight ? "_r" : "");
}

int jointOf(const Skeleton& skeleton, const ModelBody& body, Side side) {
    const std::string prefix = !body.has_sides ? "" : side == Side::kLeft ? "Left" : "Right";
    return skeleton.find(prefix + body.joint);
}

std::vector<Side> sidesOf(const ModelBody& body) {
    return body.has_sides ? std::vector{Side::kRight, Side::kLeft} : std::vector{Side::kMiddle};
}

/// Our axes (X left, Z forward) to OpenSim's (Z right, X forward).
const Quaterniond& toOpenSim() {
    static const Quaterniond q = axisAngle(Vector3d::UnitY(), M_PI / 2);
    return q;
}

/// q_ground_body of the model's body.
Quaterniond bodyOrientation(const Quaterniond& q_world_joint, const ModelBody& body, Side side) {
    const double quarter_rad = side == Side::kLeft ? M_PI / 2 : -M_PI / 2;
    const Quaterniond hang = axisAngle(Vector3d::UnitZ(), body.zero == Zero::kSame ? 0 : quarter_rad);
    const Quaterniond palm = axisAngle(Vector3d::UnitY(), body.zero == Zero::kPalmAhead ? -quarter_rad : 0);
    return toOpenSim() * q_world_joint * hang * toOpenSim().conjugate() * palm;
}

struct AngleSource {
    const ModelJoint* joint;
    Side side;
    int parent, child;  ///< joints of the skeleton; parent -1: the ground
    Vector3d angles_rad = Vector3d::Zero();
};

std::vector<AngleSource> angleSources(const Skeleton& skeleton) {
    std::vector<AngleSource> sources;
    for (const ModelJoint& joint : kJoints)
        for (const Side side : sidesOf(*joint.child)) {
            const int child = jointOf(skeleton, *joint.child, side);
            const int parent = joint.parent ? jointOf(skeleton, *joint.parent, side) : -1;
            if (child >= 0 && (parent >= 0 || !joint.parent))
                sources.push_back({&joint, side, parent, child});
        }
    return sources;
}

void appendAnglesOf(AngleSource& source, const GlobalPose& pose, std::vector<double>& row) {
    const auto orientation = [&](int joint, const ModelBody& body) {
        return bodyOrientation(pose.q_world_joint[static_cast<size_t>(joint)], body, source.side);
    };
    Quaterniond q = orientation(source.child, *source.joint->child);
    if (source.parent >= 0)
        q = orientation(source.parent, *source.joint->parent).conjugate() * q;
    source.angles_rad = eulerFromRotation(kEulerZXY, q, source.angles_rad);
    const double mirrored = source.side == Side::kLeft ? -1 : 1;
    const double signs[] = {source.joint->first_sign, mirrored, mirrored};
    for (int i = 0; i < 3; ++i)
        if (source.joint->coordinates[static_cast<size_t>(i)])
            row.push_back(degrees(signs[i] * source.angles_rad[i]));
}

Status checkOpenSimClip(const MotionClip& clip) {
    if (clip.frames.empty() || jointOf(clip.skeleton, kPelvis, Side::kMiddle) < 0)
        return Error{ErrorKind::kUnusable,
                     clip.name + ": there is no motion of a body with Hips, which OpenSim calls pelvis",
                     "Process the take on a body with the canonical joints"};
    return Done{};
}

Result<OpenSimTable> checkedTable(OpenSimTable table, const std::string& name) {
    for (size_t v = 0; v < table.values.size(); ++v)
        if (!std::isfinite(table.values[v]))
            return Error{ErrorKind::kUnusable,
                         name + ": frame " + std::to_string(v / table.width + 1) + " is not a finite number",
                         "Process the take again or leave this part out"};
    return table;
}

}  // namespace

Result<OpenSimTable> openSimAngles(const MotionClip& clip) {
    if (Status usable = checkOpenSimClip(clip); !usable)
        return usable.error();
    std::vector<AngleSource> sources = angleSources(clip.skeleton);
    OpenSimTable table;
    table.columns = {"time", "pelvis_tx", "pelvis_ty", "pelvis_tz"};
    for (const AngleSource& source : sources)
        for (const char* coordinate : source.joint->coordinates)
            if (coordinate)
                table.columns.push_back(nameOf(coordinate, source.side));
    table.width = table.columns.size();
    const int pelvis = jointOf(clip.skeleton, kPelvis, Side::kMiddle);
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const GlobalPose pose = globalPose(clip, f);
        const Vector3d p_m = toOpenSim() * pose.p_world_joint[static_cast<size_t>(pelvis)];
        table.values.insert(table.values.end(),
                            {static_cast<double>(f) * clip.frame_time_s, p_m.x(), p_m.y(), p_m.z()});
        for (AngleSource& source : sources)
            appendAnglesOf(source, pose, table.values);
    }
    table.header = {"Coordinates",
                    "version=1",
                    "nRows=" + std::to_string(clip.frames.size()),
                    "nColumns=" + std::to_string(table.width),
                    "inDegrees=yes",
                    "",
                    "Units are S.I. units (second, meters, Newtons, ...)",
                    "Angles are in degrees.",
                    ""};
    return checkedTable(std::move(table), clip.name);
}

Result<OpenSimTable> openSimOrientations(const MotionClip& clip) {
    if (Status usable = checkOpenSimClip(clip); !usable)
        return usable.error();
    OpenSimTable table;
    std::string rate;
    appendExact(rate, 1 / clip.frame_time_s);
    table.header = {"DataRate=" + rate, "DataType=Quaternion", "version=3", "OpenSimVersion=4.1"};
    table.columns = {"time"};
    struct Source {
        const ModelBody* body;
        Side side;
        size_t joint;
    };
    std::vector<Source> sources;
    for (const ModelBody& body : kBodies)
        for (const Side side : sidesOf(body))
            if (const int joint = jointOf(clip.skeleton, body, side); joint >= 0) {
                sources.push_back({&body, side, static_cast<size_t>(joint)});
                table.columns.push_back(nameOf(body.name, side) + "_imu");
            }
    table.width = 1 + 4 * sources.size();
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const GlobalPose pose = globalPose(clip, f);
        table.values.push_back(static_cast<double>(f) * clip.frame_time_s);
        for (const Source& source : sources) {
            const Quaterniond q =
                bodyOrientation(pose.q_world_joint[source.joint], *source.body, source.side).normalized();
            table.values.insert(table.values.end(), {q.w(), q.x(), q.y(), q.z()});
        }
    }
    return checkedTable(std::move(table), clip.name);
}

}  // namespace noctule
