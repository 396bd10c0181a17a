// SPDX-License-Identifier: Apache-2.0
// A surface of several looks, as characters have them: skin, eyes, clothes.
#pragma once

#include "core/mesh/skinned_mesh.h"

namespace noctule::test {

inline constexpr size_t kPngBytes = 69;
/// One pixel that every program can open.
inline const std::string kRedPng(
    "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x01\0\0\0\x01\x08\x02\0\0\0\x90wS\xde\0\0\0\x0cIDATx\xda"
    "c\xf8\xcf\xc0\0\0\x03\x01\x01\0\xf7\x03\x41\x43\0\0\0\0IEND\xae\x42\x60\x82",
    kPngBytes);
inline const std::string kBluePng(
    "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x01\0\0\0\x01\x08\x02\0\0\0\x90wS\xde\0\0\0\x0cIDATx\xda"
    "c``\xf8\x0f\0\x01\x03\x01\0\x36t\x11\x40\0\0\0\0IEND\xae\x42\x60\x82",
    kPngBytes);

inline std::shared_ptr<const SurfaceTexture> pixel(const std::string& png, bool is_red) {
    const uint8_t red = is_red ? 255 : 0, blue = is_red ? 0 : 255;
    return std::make_shared<const SurfaceTexture>(SurfaceTexture{png, 1, 1, {red, 0, blue, 255}});
}

/// Four looks, each on a quarter of the triangles: a colour, a picture, the same picture in another colour,
/// and another picture.
inline void paint(SkinnedMesh& mesh) {
    const auto red = pixel(kRedPng, true), blue = pixel(kBluePng, false);
    const SurfaceLook looks[] = {
        {{0.1F, 0.7F, 0.2F}, nullptr}, {{1, 1, 1}, red}, {{0.5F, 0.25F, 1}, red}, {{1, 1, 1}, blue}};
    const auto count = static_cast<uint32_t>(mesh.triangles.size());
    mesh.surface.clear();
    for (uint32_t p = 0; p < 4; ++p)
        mesh.surface.push_back({p * count / 4, (p + 1) * count / 4 - p * count / 4, looks[p]});
    for (size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.vertices[v].uv = {0.01F * static_cast<float>(v % 100), 0.3F};
}

}  // namespace noctule::test
