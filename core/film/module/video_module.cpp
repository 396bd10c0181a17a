// SPDX-License-Identifier: Apache-2.0
// The module noctule-video: OpenCV's videoio.
#include <opencv2/videoio.hpp>

#include "core/film/picture_mat.h"
#include "core/film/video_backend.h"

namespace noctule {
namespace {

class OpenCvEncoder : public VideoEncoder {
public:
    void add(const Picture& picture) override { writer.write(toBgr(picture)); }
    cv::VideoWriter writer;
};

std::unique_ptr<VideoEncoder> openEncoder(const std::string& path, const std::string& encoder,
                                          const PictureSize& size, double frames_per_second) {
    auto made = std::make_unique<OpenCvEncoder>();
    const int code = cv::VideoWriter::fourcc(encoder[0], encoder[1], encoder[2], encoder[3]);
    const bool opened = made->writer.open(path, cv::CAP_FFMPEG, code, frames_per_second,
                                          cv::Size(size.width_px, size.height_px));
    return opened ? std::move(made) : nullptr;
}

bool readFilm(const std::string& path, VideoFacts& facts, const std::set<size_t>& looked_at,
              const std::function<void(size_t frame, const Picture&)>& look) {
    cv::VideoCapture capture(path, cv::CAP_FFMPEG);
    if (!capture.isOpened())
        return false;
    facts.frames_per_second = capture.get(cv::CAP_PROP_FPS);
    facts.size = {static_cast<int>(capture.get(cv::CAP_PROP_FRAME_WIDTH)),
                  static_cast<int>(capture.get(cv::CAP_PROP_FRAME_HEIGHT))};
    cv::Mat bgr;
    for (; capture.grab(); ++facts.frames)
        if (looked_at.contains(facts.frames) && capture.retrieve(bgr))
            look(facts.frames, fromBgr(bgr));
    return true;
}

constexpr VideoBackend kOpenCv{openEncoder, readFilm};

}  // namespace
}  // namespace noctule

extern "C" const noctule::VideoBackend* noctuleVideoBackend() {
    return &noctule::kOpenCv;
}
