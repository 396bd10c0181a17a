// SPDX-License-Identifier: Apache-2.0
// Films as files. .mp4 and .mkv hold H.264, or MPEG-4 where that encoder is missing, .avi motion JPEG.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>

#include "core/job/result.h"
#include "core/media/picture.h"

namespace noctule {

class VideoEncoder;

/// Whether a film can be written under this name, by its ending.
bool isVideoFileName(const std::string& path);

class VideoWriter {
public:
    /// kUsage: an ending that is none of a film, or a side that is odd; kDisk: it cannot be opened;
    /// kUnusable: no encoder. `path` must end as `named` does.
    static Result<std::unique_ptr<VideoWriter>> create(const std::string& path, const std::string& named,
                                                       const PictureSize& size, double frames_per_second);
    ~VideoWriter();

    void add(const Picture& picture);
    /// The file is complete after that.
    void finish();

private:
    explicit VideoWriter(std::unique_ptr<VideoEncoder> encoder);
    std::unique_ptr<VideoEncoder> encoder_;
};

struct VideoFacts {
    size_t frames = 0;  ///< that could be decoded
    PictureSize size;
    double frames_per_second = 0;
};

/// Decodes the whole file; `look` sees the frames of `looked_at`. kUnreadable when it is no film.
Result<VideoFacts> readVideo(const std::string& path, const std::set<size_t>& looked_at = {},
                             const std::function<void(size_t frame, const Picture&)>& look = {});

}  // namespace noctule
