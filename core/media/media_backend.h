// SPDX-License-Identifier: Apache-2.0
// What encodes and decodes pictures and films: the module noctule-media beside the program, loaded when the
// first of them is. Linked in, the two hundred libraries of OpenCV's imgcodecs and videoio (GDAL, ffmpeg)
// would make every start of every program a fifth of a second longer. Two parts of one build, so plain C++
// goes between them.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>

#include "core/job/result.h"
#include "core/media/video_file.h"

namespace noctule {

/// Its end completes the file.
class VideoEncoder {
public:
    virtual ~VideoEncoder() = default;
    virtual void add(const Picture& picture) = 0;
};

struct MediaBackend {
    /// As decodePicture(), decodeGreyPicture() and pngBytes().
    Picture (*decode)(const std::string& bytes);
    GreyPicture (*decodeGrey)(const std::string& bytes);
    std::string (*encodePng)(const Picture& picture);
    /// `encoder`: four letters. Null when it cannot.
    std::unique_ptr<VideoEncoder> (*openVideo)(const std::string& path, const std::string& encoder,
                                               const PictureSize& size, double frames_per_second);
    /// As readVideo(); false when it is no film.
    bool (*readVideo)(const std::string& path, VideoFacts& facts, const std::set<size_t>& looked_at,
                      const std::function<void(size_t frame, const Picture&)>& look);
};

/// Loaded once, and for good. kInternal: it is not there.
Result<const MediaBackend*> mediaBackend();

/// Of the module; what media_backend.cpp looks for.
inline constexpr const char* kMediaModule = "noctule-media.so";
inline constexpr const char* kMediaBackend = "noctuleMediaBackend";

}  // namespace noctule
