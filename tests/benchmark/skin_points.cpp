// SPDX-License-Identifier: Apache-2.0
// skin_points T.noctule FPS STEP OUT: where the body's skin is in every STEPth frame of an export of the last
// run, straight from the take, without any file format between. OUT: two uint32 (frames, points), then
// float32 x, y, z, world, metres. What other programs show of our exports is held against it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/job/atomic_file.h"
#include "core/mesh/skinning.h"
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
    const SkinnedMesh body = bodyFor(motion->skeleton);
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

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fputs("usage: skin_points T.noctule FPS STEP OUT\n", stderr);
        return 2;
    }
    const auto bytes = skinPoints(argv[1], std::atof(argv[2]), std::atoi(argv[3]));
    const Status written = bytes ? writeFileAtomically(argv[4], *bytes, true) : Status(bytes.error());
    if (!written)
        std::fprintf(stderr, "skin_points: %s\n", written.error().text().c_str());
    return written ? 0 : 1;
}
