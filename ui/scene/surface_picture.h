// SPDX-License-Identifier: Apache-2.0
// A body's surface as it stands, drawn without a window in the colours of the theme: what is marked by hand
// is painted over it. Keeps its drawing context from picture to picture.
#pragma once

#include <QImage>
#include <memory>

#include "core/render/offscreen.h"

namespace noctule::ui {

/// The same pixels.
QImage imageOf(const Picture& picture);

class SurfacePicture {
public:
    /// `surface` as of standingSurface(). `ratio`: pixels of the screen to one of `size`. Null without
    /// OpenGL, and must not be called while a context is current in the thread.
    QImage draw(const std::shared_ptr<const SkinnedMesh>& surface, const Camera& camera,
                const PictureSize& size, double ratio);

private:
    std::unique_ptr<Offscreen> offscreen_;
    bool tried_ = false;
};

}  // namespace noctule::ui
