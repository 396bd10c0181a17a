// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "ui/scene/dressed_body.h"
#include "ui/scene/scene_view.h"
#include "ui/scene/surface_picture.h"

namespace noctule::ui {

namespace {

QImage drawn(const std::shared_ptr<const SkinnedMesh>& body, const Skeleton& skeleton, const Pose& pose,
             const QSize& size_px) {
    if (!body || size_px.isEmpty())
        return {};
    const SceneColors colors = SceneColors::of(Theme::get());
    const BodyPlaces places = placeBody(skeleton, pose, {}, nullptr);
    Scene scene;
    scene.background = colors.background;
    addShadow(scene, colors, places);
    addSurface(scene, colors, MovingBody::ofOurs(*body, skeleton, feetAtRest(skeleton)), pose,
               Blending::kLinear);
    const PictureSize size{size_px.width(), size_px.height()};
    Camera camera;
    Eigen::AlignedBox3d box = places.box();
    box.extend(Vector3d(box.max() + Vector3d(0.1, 0.1, 0.1)));
    camera.frame(box, size, 0.06);

    auto offscreen = Offscreen::create();
    if (!offscreen)
        return {};
    const auto picture = (*offscreen)->render(scene, camera, size);
    return picture ? imageOf(*picture) : QImage();
}

}  // namespace

QImage thumbnail(const std::shared_ptr<const SkinnedMesh>& body, const TimedMotion& motion, double t_s,
                 const QSize& size_px) {
    const auto pose = poseAt(motion, std::llround(t_s * 1e9), bridgeableGap_ns(motion));
    return pose ? drawn(body, motion.skeleton, *pose, size_px) : QImage();
}

QImage thumbnail(const std::shared_ptr<const SkinnedMesh>& body, const Actor& actor, const QSize& size_px) {
    return drawn(body, actor.skeleton, actor.restPose(), size_px);
}

}  // namespace noctule::ui
