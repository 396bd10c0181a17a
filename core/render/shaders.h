// SPDX-License-Identifier: Apache-2.0
// The texts of the shaders, GLSL 3.30 core. Colours are blended as they come: sRGB values, not premultiplied.
#pragma once

namespace noctule::shaders {

extern const char* const kBackgroundVertex;
extern const char* const kBackgroundFragment;
extern const char* const kDiscVertex;
extern const char* const kDiscFragment;
extern const char* const kBodyVertex;
extern const char* const kBodyFragment;
extern const char* const kContourFragment;
extern const char* const kLineVertex;
extern const char* const kLineFragment;
extern const char* const kMarkerVertex;
extern const char* const kMarkerFragment;

/// Five texels each fit into the buffer texture that OpenGL 3.3 promises.
inline constexpr int kMaxBones = 65536 / 5;

}  // namespace noctule::shaders
