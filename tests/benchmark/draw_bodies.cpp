// SPDX-License-Identifier: Apache-2.0
// Pictures to look at: our motion on the default body and on those of others, side by side, each as tall as a
// person. draw_bodies FOLDER [dual]: one PNG for each of some frames of the sample motion; "dual"
// with dual quaternions. Needs the meshes beside the repository (../shared/data).
#include <QImage>
#include <cstdio>
#include <filesystem>

#include "core/body/actor.h"
#include "core/formats/bvh.h"
#include "core/mesh/import/glb_reader.h"
#include "core/mesh/retarget/retarget.h"
#include "core/mesh/rig/wearable.h"
#include "core/render/offscreen.h"
#include "core/simulation/motion_fit.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

constexpr PictureSize kSize{1600, 620};
constexpr double kApart_m = 1.15;

class Figures {
public:
    Figures(const Skeleton& skeleton, Blending blending) : skeleton_(skeleton), blending_(blending) {
        mannequin_ = std::make_shared<const SkinnedMesh>(
            *readSkinnedMesh(NOCTULE_SOURCE_DIR "/resources/bodies/mannequin.glb"));
        add(test::sharedMesh(test::kKenney), "Kenney");
        add(test::sharedMesh(test::kCesiumMan), "CesiumMan");
        add(test::MakeHuman().mesh(), "MakeHuman");
        add(wearable(test::sharedMesh(test::kMakeHuman + "base.obj"), "base.obj")->mesh, "automatic");
    }

    Scene scene(const Pose& pose) const {
        Scene scene;
        scene.background = {{0.10F, 0.12F, 0.15F, 1}, {0.2F, 0.22F, 0.26F, 1}};
        scene.grid.emplace().line = {0.3F, 0.32F, 0.36F, 1};
        put(scene, mannequin_, skinMatrices(*mannequin_, skeleton_, globalPose(skeleton_, pose)), 1, 0);
        for (size_t i = 0; i < figures_.size(); ++i) {
            const Figure& figure = figures_[i];
            const RigPose rig_pose = figure.retargeter.pose(pose);
            put(scene, figure.skin, skinMatrices(figure.rig, rig_pose), 1 / figure.retargeter.scale(), i + 1);
        }
        return scene;
    }

private:
    struct Figure {
        RiggedMesh rig;
        Retargeter retargeter;
        std::shared_ptr<const SkinnedMesh> skin;
    };

    void add(const RiggedMesh& rig, const std::string& name) {
        auto retargeter = Retargeter::make(rig, findBoneMap(rig), skeleton_, feetAtRest(skeleton_), name);
        figures_.push_back({rig, *retargeter, std::make_shared<const SkinnedMesh>(rig.skin)});
    }

    void put(Scene& scene, const std::shared_ptr<const SkinnedMesh>& mesh, std::vector<Eigen::Matrix4f> skin,
             double scale, size_t place) const {
        Eigen::Affine3f move = Eigen::Affine3f::Identity();
        move.linear() *= static_cast<float>(scale);
        move.translation().x() = static_cast<float>(kApart_m * (static_cast<double>(place) - 2));
        for (Eigen::Matrix4f& matrix : skin)
            matrix = move.matrix() * matrix;
        SceneBody body;
        body.mesh = mesh;
        body.skin = std::move(skin);
        body.color = {0.62F, 0.66F, 0.72F, 1};
        body.blending = blending_;
        scene.bodies.push_back(body);
    }

    Skeleton skeleton_;
    Blending blending_;
    std::shared_ptr<const SkinnedMesh> mannequin_;
    std::vector<Figure> figures_;
};

/// Fitted to the default actor's joints, as the virtual suit would be worn.
struct Motion {
    Skeleton skeleton;
    std::vector<Pose> poses;
};

Motion motionOf(const std::string& path) {
    const MotionClip clip = toClip(*readBvh(path)).value();
    const Actor actor = *simulation::actorFromClip(clip);
    const auto fitted = simulation::fitMotion(clip, {actor, actor.skeleton});
    Motion motion{actor.skeleton, {}};
    for (const auto& row : fitted->rows)
        motion.poses.push_back(simulation::Coordinates(actor.skeleton).toPose(row));
    return motion;
}

int drawAll(const std::string& folder, Blending blending, const Motion& motion) {
    constexpr size_t kPictures = 10;
    auto offscreen = Offscreen::create();
    if (!offscreen || !test::isShared(test::kMakeHuman)) {
        std::puts(offscreen ? "the meshes beside the repository are missing"
                            : offscreen.error().text().c_str());
        return 1;
    }
    const Figures figures(motion.skeleton, blending);
    std::filesystem::create_directories(folder);
    for (size_t f = 0; f < motion.poses.size(); f += motion.poses.size() / kPictures) {
        Pose pose = motion.poses[f];
        pose.p_world_root.x() = pose.p_world_root.z() = 0;
        Camera camera;
        camera.target_m = {0.2, 1.1, 0};
        camera.distance_m = 6;
        camera.azimuth_rad = 0.15;
        camera.elevation_rad = 0.08;
        const auto picture = (*offscreen)->render(figures.scene(pose), camera, kSize);
        const QImage image(picture->rgba.data(), picture->width_px, picture->height_px,
                           QImage::Format_RGBA8888);
        const std::string path = folder + "/frame_" + std::to_string(f) + ".png";
        if (!image.save(QString::fromStdString(path)))
            return 1;
        std::puts(path.c_str());
    }
    return 0;
}

}  // namespace
}  // namespace noctule

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: draw_bodies FOLDER [dual|linear] [MOTION.bvh]\n", stderr);
        return 2;
    }
    const bool dual = argc > 2 && std::string(argv[2]) == "dual";
    const std::string motion = argc > 3 ? argv[3] : NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh";
    return noctule::drawAll(argv[1], dual ? noctule::Blending::kDualQuaternion : noctule::Blending::kLinear,
                            noctule::motionOf(motion));
}
