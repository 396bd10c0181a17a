// SPDX-License-Identifier: Apache-2.0
// skin_points T.noctule FPS STEP OUT [MESH JOINTS.csv]: where the body's skin is in every STEPth frame of an
// export of the last run, straight from the take, without any file format between. OUT: two uint32 (frames,
// points), then float32 x, y, z, world, metres. With MESH it is that body, at its own size, and JOINTS.csv
// gets the places of the bones that turn as ours, by their own names, in every frame. What other programs
// show of our exports is held against it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/job/atomic_file.h"
#include "core/mesh/retarget/moving_body.h"
#include "core/processing/contacts_in_force.h"
#include "core/processing/export_files.h"
#include "core/processing/pose_runs.h"

namespace {

using namespace noctule;

template <class T>
void appendTo(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

Result<std::string> skinPoints(const std::string& path, double frames_per_second, int step) {
    const auto take = Take::open(path);
    if (!take)
        return take.error();
    const auto run = choosePoseRun(*take, "");
    const auto motion = run ? take->poses(run->run) : Result<TimedMotion>(run.error());
    if (!motion)
        return motion.error();
    const auto contacts = contactsInForce(*take, *run, *motion);
    if (!contacts)
        return contacts.error();
    const SkinnedMesh body = bodyFor(motion->skeleton, feetAtRest(*motion, contacts->feet));
    PoseSampler sampler(*motion, std::numeric_limits<int64_t>::max());
    std::string points;
    uint32_t frames = 0;
    for (int64_t i = 0;; i += step, ++frames) {
        const double since_s = static_cast<double>(i) / frames_per_second;
        const auto pose = sampler.at(motion->frames.front().time_ns + std::llround(since_s * 1e9));
        if (!pose)
            break;
        const auto matrices = skinMatrices(body, motion->skeleton, globalPose(motion->skeleton, *pose));
        for (const Eigen::Vector3f& p_m : skinned(body, matrices).points_m)
            for (int axis = 0; axis < 3; ++axis)
                appendTo(points, p_m[axis]);
    }
    std::string bytes;
    appendTo(bytes, frames);
    appendTo(bytes, static_cast<uint32_t>(body.vertices.size()));
    return bytes + points;
}

/// The bones of a body that our joints turn.
std::vector<size_t> turnedNodes(const WearableBody& body) {
    std::vector<size_t> nodes;
    for (const auto& [joint, name] : body.bones.node_of_joint)
        nodes.push_back(static_cast<size_t>(body.mesh.find(name)));
    return nodes;
}

struct BodyPoints {
    std::string skin, joints;  ///< the contents of OUT and JOINTS.csv
};

Result<BodyPoints> bodyPoints(const std::string& path, double frames_per_second, int step,
                              const std::string& mesh_path) {
    ExportRequest request;
    request.take_path = path;
    request.frames_per_second = frames_per_second;
    const auto worn = readWearable(mesh_path);
    if (!worn)
        return worn.error();
    request.worn = *worn;
    const auto motion = exportedMotion(request);
    if (!motion)
        return motion.error();
    const WearableBody& body = **worn;
    const auto retargeter = Retargeter::make(body.mesh, bonesFor(body.bones, motion->clip.skeleton),
                                             motion->clip.skeleton, motion->feet_at_rest, body.name);
    if (!retargeter)
        return retargeter.error();
    const auto feet = lockFeet(*retargeter, motion->feet);
    BodyPoints points;
    points.joints = "time_s";
    for (const size_t node : turnedNodes(body))
        for (const char axis : {'x', 'y', 'z'})
            points.joints += "," + body.mesh.nodes[node].name + "." + axis;
    points.joints += "\n";
    uint32_t frames = 0;
    std::string skin;
    for (size_t f = 0; f < feet.size(); ++f) {
        const RigPose pose = retargeter->pose(motion->clip.frames[f], feet[f]);
        points.joints += std::to_string(static_cast<double>(f) / frames_per_second);
        for (const size_t node : turnedNodes(body))
            for (int axis = 0; axis < 3; ++axis)
                points.joints += "," + std::to_string(pose[node].translation()[axis]);
        points.joints += "\n";
        if (f % static_cast<size_t>(step) != 0)
            continue;
        ++frames;
        for (const Eigen::Vector3f& p_m : skinned(body.mesh.skin, skinMatrices(body.mesh, pose)).points_m)
            for (int axis = 0; axis < 3; ++axis)
                appendTo(skin, p_m[axis]);
    }
    appendTo(points.skin, frames);
    appendTo(points.skin, static_cast<uint32_t>(body.mesh.skin.vertices.size()));
    points.skin += skin;
    return points;
}

Status writePoints(char** argv, bool of_mesh) {
    const double frames_per_second = std::atof(argv[2]);
    const int step = std::atoi(argv[3]);
    if (!of_mesh) {
        const auto bytes = skinPoints(argv[1], frames_per_second, step);
        return bytes ? writeFileAtomically(argv[4], *bytes, true) : Status(bytes.error());
    }
    const auto points = bodyPoints(argv[1], frames_per_second, step, argv[5]);
    if (!points)
        return points.error();
    const Status written = writeFileAtomically(argv[4], points->skin, true);
    return written ? writeFileAtomically(argv[6], points->joints, true) : written;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5 && argc != 7) {
        std::fputs("usage: skin_points T.noctule FPS STEP OUT [MESH JOINTS.csv]\n", stderr);
        return 2;
    }
    const Status written = writePoints(argv, argc == 7);
    if (!written)
        std::fprintf(stderr, "skin_points: %s\n", written.error().text().c_str());
    return written ? 0 : 1;
}
