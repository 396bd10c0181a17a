// SPDX-License-Identifier: Apache-2.0
#include "core/film/texture_decoder.h"

#include <gtest/gtest.h>

#include "core/media/media_backend.h"

namespace noctule {
namespace {

/// A mesh of one part, whose texture has these pixels.
RiggedMesh painted(std::vector<uint8_t> rgba) {
    auto texture = std::make_shared<SurfaceTexture>();
    texture->file = "\x89PNG\r\n\x1a\nand no more";
    texture->rgba = std::move(rgba);
    texture->width_px = texture->height_px = texture->rgba.empty() ? 0 : 1;
    RiggedMesh mesh;
    mesh.skin.surface.push_back({0, 0, SurfaceLook{Eigen::Vector3f::Ones(), texture}});
    return mesh;
}

TEST(UndrawnTextures, AreSaidWithTheirCauseAndARemedy) {
    EXPECT_FALSE(undrawnTextures(RiggedMesh{}, "body.glb")) << "it has none";
    EXPECT_FALSE(undrawnTextures(painted({1, 2, 3, 255}), "body.glb"));
    const auto said = undrawnTextures(painted({}), "body.glb");
    ASSERT_TRUE(said);
    EXPECT_EQ(said->message.find("body.glb: "), 0U) << said->message;
    EXPECT_FALSE(said->remedy.empty());
    // A program whose module for pictures is gone names it; else the picture is to blame.
    const std::string cause = mediaBackend() ? "1 texture of 1 cannot be decoded" : kMediaModule;
    EXPECT_NE(said->message.find(cause), std::string::npos) << said->message;
}

}  // namespace
}  // namespace noctule
