// SPDX-License-Identifier: Apache-2.0
// What encodes and decodes films: the module noctule-video beside the program, loaded when the first film is
// written. Linked in, ffmpeg's hundred libraries would make every start of every program a tenth of a second
// longer. Two parts of one build, so plain C++ goes between them.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>

#include "core/film/video_file.h"

namespace noctule {

/// Its end completes the file.
class VideoEncoder {
public:
    virtual ~VideoEncoder() = default;
    virtual void add(const Picture& picture) = 0;
};

struct VideoBackend {
    /// `encoder`: four letters. Null when it cannot.
    std::unique_ptr<VideoEncoder> (*open)(const std::string& path, const std::string& encoder,
                                          const PictureSize& size, double frames_per_second);
    /// As readVideo(); false when it is no film.
    bool (*read)(const std::string& path, VideoFacts& facts, const std::set<size_t>& looked_at,
                 const std::function<void(size_t frame, const Picture&)>& look);
};

/// Of the module; what video_file.cpp looks for.
inline constexpr const char* kVideoModule = "noctule-video.so";
inline constexpr const char* kVideoBackend = "noctuleVideoBackend";

}  // namespace noctule
