// SPDX-License-Identifier: Apache-2.0
#include "core/media/video_file.h"

#include <algorithm>
#include <filesystem>

#include "core/job/atomic_file.h"
#include "core/media/media_backend.h"

namespace noctule {
namespace {

std::string endingOf(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// Encoders by four letters, the best first.
std::vector<std::string> encodersFor(const std::string& ending) {
    if (ending == ".mp4" || ending == ".mkv")
        return {"avc1", "mp4v"};
    return ending == ".avi" ? std::vector<std::string>{"MJPG"} : std::vector<std::string>{};
}

}  // namespace

bool isVideoFileName(const std::string& path) {
    return !encodersFor(endingOf(path)).empty();
}

VideoWriter::VideoWriter(std::unique_ptr<VideoEncoder> encoder) : encoder_(std::move(encoder)) {}
VideoWriter::~VideoWriter() = default;

Result<std::unique_ptr<VideoWriter>> VideoWriter::create(const std::string& path, const std::string& named,
                                                         const PictureSize& size, double frames_per_second) {
    const std::vector<std::string> encoders = encodersFor(endingOf(named));
    if (encoders.empty())
        return Error{ErrorKind::kUsage, named + ": films of this kind cannot be written",
                     "End its name with .mp4, .mkv or .avi"};
    if (size.width_px % 2 != 0 || size.height_px % 2 != 0)
        return Error{ErrorKind::kUsage,
                     named + ": a film of " + std::to_string(size.width_px) + " x " +
                         std::to_string(size.height_px) + " pixels cannot be encoded",
                     "Choose an even width and an even height"};
    const auto backend = mediaBackend();
    if (!backend)
        return backend.error();
    if (const Status free = writeFileAtomically(path, "", true); !free)
        return Error{free.error().kind, named + ": cannot be written", free.error().remedy};
    for (const std::string& name : encoders)
        if (auto encoder = (*backend)->openVideo(path, name, size, frames_per_second))
            return std::unique_ptr<VideoWriter>(new VideoWriter(std::move(encoder)));
    return Error{ErrorKind::kUnusable, named + ": OpenCV finds no encoder for it",
                 "Install ffmpeg's libraries, or write an .avi file"};
}

void VideoWriter::add(const Picture& picture) {
    encoder_->add(picture);
}

void VideoWriter::finish() {
    encoder_.reset();
}

Result<VideoFacts> readVideo(const std::string& path, const std::set<size_t>& looked_at,
                             const std::function<void(size_t frame, const Picture&)>& look) {
    const auto backend = mediaBackend();
    if (!backend)
        return backend.error();
    VideoFacts facts;
    if (!(*backend)->readVideo(path, facts, looked_at, look))
        return Error{ErrorKind::kUnreadable, path + ": is no film that can be read", "Write it again"};
    return facts;
}

}  // namespace noctule
