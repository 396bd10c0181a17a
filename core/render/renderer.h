// SPDX-License-Identifier: Apache-2.0
// Draws scenes with OpenGL 3.3 core (through libepoxy, no windows). A Renderer belongs to the context that is
// current at create() and must be used and destroyed with that context current. Meshes stay on the card as
// long as scenes mention them.
#pragma once

#include <memory>

#include "core/job/result.h"
#include "core/render/camera.h"
#include "core/render/scene.h"

namespace noctule {

struct RenderOptions {
    int samples = 4;           ///< smoothed edges of bodies: 0 (off), 2, 4 or 8; lines are always smooth
    double pixel_ratio = 1;    ///< lengths in pixels of the scene are multiplied by this
    unsigned framebuffer = 0;  ///< where the picture goes, its whole size
};

class Renderer {
public:
    /// kUnusable with what is missing when there is no OpenGL 3.3 in the current context.
    static Result<std::unique_ptr<Renderer>> create();
    ~Renderer();

    /// `size` in pixels of the framebuffer.
    void draw(const Scene& scene, const Camera& camera, const PictureSize& size,
              const RenderOptions& options = {});

    /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
    const std::string& description() const;

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace noctule
