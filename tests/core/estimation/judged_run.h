// SPDX-License-Identifier: Apache-2.0
// An estimator in a world that is as it assumes: how far off its poses are and whether its sigmas say so.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "core/job/unnamed_file.h"
#include "tests/core/estimation/small_world.h"

namespace noctule::testing {

struct Judged {
    std::vector<TimedPose> poses;
    double rms_deg = 0;  ///< over all joints' axes that move, after the first part
    double nees = 0;     ///< error over sigma, squared, mean of the same
};

/// `seconds` of a world that was drawn by `seed`; judged after the first `left_out` of them.
inline Judged judge(Estimator& estimator, const ManifoldParameters& parameters, unsigned seed, double seconds,
                    double left_out = 1.0 / 3) {
    World world(parameters, seed);
    std::map<int64_t, Pose> truth;
    estimator.start(smallSkeleton().zeroPose(), {}, nullptr);
    truth[0] = world.tree.poseFromState(world.motion);
    play(world, estimator, seconds, [&](int64_t, double t) {
        truth[std::llround(t * 1e9)] = world.tree.poseFromState(world.motion);
        estimator.advanceTo(t);
    });
    estimator.end();
    estimator.advanceTo(seconds);
    Judged judged;
    judged.poses = estimator.takePoses();
    while (estimator.portionsLeft() > 0) {  // earlier and earlier ones
        EXPECT_TRUE(estimator.finishPortion({}));
        std::vector<TimedPose> poses = estimator.takePoses();
        if (!judged.poses.empty() && judged.poses.front().time_ns < poses.front().time_ns)
            std::swap(poses, judged.poses);
        poses.insert(poses.end(), judged.poses.begin(), judged.poses.end());
        judged.poses = std::move(poses);
    }
    double squares = 0, ratios = 0;
    int count = 0;
    for (const TimedPose& pose : judged.poses) {
        if (static_cast<double>(pose.time_ns) * 1e-9 < left_out * seconds)
            continue;
        for (size_t j = 0; j < pose.pose->q_parent_joint.size(); ++j) {
            const Vector3d error = logQuaternion(pose.pose->q_parent_joint[j].conjugate() *
                                                 truth.at(pose.time_ns).q_parent_joint[j]);
            for (size_t axis = 0; axis < 3; ++axis) {
                const double sigma = pose.sigma_rad[3 * j + axis], e = error[static_cast<Eigen::Index>(axis)];
                if (sigma == 0)
                    continue;
                squares += e * e;
                ratios += e * e / (sigma * sigma);
                ++count;
            }
        }
    }
    judged.rms_deg = degrees(std::sqrt(squares / count));
    judged.nees = ratios / count;
    return judged;
}

inline UnnamedFile spool() {
    return UnnamedFile::make(std::filesystem::temp_directory_path(), "a test's spool", "").value();
}

}  // namespace noctule::testing
