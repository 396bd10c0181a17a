// SPDX-License-Identifier: Apache-2.0
// Pictures of scenes without a window or a display: an OpenGL context of its own through EGL (surfaceless
// platform of Mesa) and a framebuffer. Every call makes that context current in the calling thread and
// releases it; another context must not be current there.
#pragma once

#include <memory>

#include "core/job/result.h"
#include "core/media/picture.h"
#include "core/render/camera.h"
#include "core/render/scene.h"

namespace noctule {

class Offscreen {
public:
    /// kUnusable when EGL or OpenGL 3.3 is not there.
    static Result<std::unique_ptr<Offscreen>> create();
    ~Offscreen();

    /// kUsage for sizes outside 1..8192 pixels.
    Result<Picture> render(const Scene& scene, const Camera& camera, const PictureSize& size, int samples = 4,
                           double pixel_ratio = 1);

private:
    struct Context;
    explicit Offscreen(std::unique_ptr<Context> context);
    std::unique_ptr<Context> context_;
};

}  // namespace noctule
