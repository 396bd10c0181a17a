// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/surface_picture.h"

#include <cmath>

#include "ui/scene/scene_colors.h"

namespace noctule::ui {

QImage imageOf(const Picture& picture) {
    return QImage(picture.rgba.data(), picture.width_px, picture.height_px, QImage::Format_RGBA8888)
        .convertToFormat(QImage::Format_RGB32);
}

QImage SurfacePicture::draw(const std::shared_ptr<const SkinnedMesh>& surface, const Camera& camera,
                            const PictureSize& size, double ratio) {
    if (!tried_) {
        tried_ = true;
        if (auto made = Offscreen::create())
            offscreen_ = std::move(*made);
    }
    if (!offscreen_ || !surface)
        return {};
    const SceneColors colors = SceneColors::of(Theme::get());
    Scene scene;
    scene.background = colors.background;
    SceneBody body;
    body.mesh = surface;
    body.skin = {Eigen::Matrix4f::Identity()};
    body.color = colors.body;
    body.opacity = colors.body_opacity;
    scene.bodies.push_back(std::move(body));
    const auto scaled = [ratio](int px) { return static_cast<int>(std::lround(px * ratio)); };
    const auto picture =
        offscreen_->render(scene, camera, {scaled(size.width_px), scaled(size.height_px)}, 4, ratio);
    if (!picture)
        return {};
    QImage image = imageOf(*picture);
    image.setDevicePixelRatio(ratio);
    return image;
}

}  // namespace noctule::ui
