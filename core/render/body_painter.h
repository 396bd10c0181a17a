// SPDX-License-Identifier: Apache-2.0
// Draws skinned bodies: solid ones shaded, ghosts as contours. Solid ones write depth, so that what is drawn
// later knows what they hide.
#pragma once

#include <memory>
#include <vector>

#include "core/render/gl_objects.h"
#include "core/render/screen_shapes.h"

namespace noctule {

class BodyPainter {
public:
    static Result<std::unique_ptr<BodyPainter>> create();

    // Bodies with more than shaders::kMaxBones bones or without skin are left out.
    /// Depth must be cleared.
    void drawSolids(const std::vector<SceneBody>& bodies, const ScreenView& view);
    /// The depth that is bound is cleared for each, so that no body hides another's contours.
    void drawOutlines(const std::vector<SceneBody>& bodies, const ScreenView& view);
    static bool hasOutlines(const std::vector<SceneBody>& bodies);

private:
    struct Upload {
        std::weak_ptr<const SkinnedMesh> mesh;
        GlVertexArray vertex_array;
        GlBuffer vertices, indices;
        std::vector<SurfacePart> surface;
        std::vector<std::shared_ptr<const SurfaceTexture>> pictures;  ///< of the surface, each once
        std::vector<GlTexture> textures;                              ///< as pictures; without pixels: 0
    };
    BodyPainter() = default;
    const Upload& uploaded(const std::shared_ptr<const SkinnedMesh>& mesh);
    void forgetDeadMeshes();

    void drawDepth(const SceneBody& body, const ScreenView& view);
    void drawSolid(const SceneBody& body, const ScreenView& view);
    void drawOutline(const SceneBody& body, const ScreenView& view);
    /// Into the texture that the body's shader reads.
    void uploadBones(const SceneBody& body);
    /// Gives the program all that is the same for the whole body.
    const Upload& prepare(const GlProgram& program, const SceneBody& body, const ScreenView& view,
                          float outwards_px);
    void drawWhole(const GlProgram& program, const SceneBody& body, const ScreenView& view,
                   float outwards_px);
    void drawPart(const Upload& upload, const SurfacePart& part, const SceneBody& body);

    GlProgram surface_, contour_;
    GlBuffer bones_;
    GlTexture bone_texture_;
    std::vector<Upload> uploads_;
};

}  // namespace noctule
