// SPDX-License-Identifier: Apache-2.0
// The sample motion on the shipped body, as scene files hold it.
#pragma once

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/formats/bvh.h"
#include "core/formats/figure.h"
#include "core/mesh/import/glb_reader.h"

namespace noctule::test {

/// Every `step`th frame of the sample motion, on the default performer's skeleton.
inline MotionClip sampleClip(size_t step = 7) {
    MotionClip clip =
        toClip(readBvh(NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh").value(), BvhUnit::kCentimetre)
            .value();
    const Skeleton skeleton = defaultActor().skeleton;
    std::vector<Pose> frames;
    for (size_t f = 0; f < clip.frames.size(); f += step) {
        Pose pose = skeleton.zeroPose();
        pose.p_world_root = clip.frames[f].p_world_root;
        for (int j = 0; j < skeleton.size(); ++j)
            pose.q_parent_joint[static_cast<size_t>(j)] =
                clip.frames[f]
                    .q_parent_joint[static_cast<size_t>(clip.skeleton.find(skeleton.joint(j).name))];
        frames.push_back(pose);
    }
    clip.name = "walk_001";
    clip.skeleton = skeleton;
    clip.frames = frames;
    clip.frame_time_s *= static_cast<double>(step);
    return clip;
}

inline const SkinnedMesh& shippedBody() {
    static const SkinnedMesh body =
        readSkinnedMesh(NOCTULE_SOURCE_DIR "/resources/bodies/mannequin.glb").value();
    return body;
}

inline Figure sampleFigure(bool with_body, JointNames names = JointNames::kOwn) {
    auto figure = makeFigure(sampleClip(), with_body ? std::optional(shippedBody()) : std::nullopt, names);
    EXPECT_TRUE(figure) << figure.error().text();
    return *figure;
}

}  // namespace noctule::test
