// SPDX-License-Identifier: Apache-2.0
// The module noctule-video: OpenCV's videoio.
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "core/film/video_backend.h"

namespace noctule {
namespace {

class OpenCvEncoder : public VideoEncoder {
public:
    void add(const Picture& picture) override {
        const cv::Mat rgba(picture.height_px, picture.width_px, CV_8UC4,
                           const_cast<uint8_t*>(picture.rgba.data()));  // cv::Mat only reads here
        cv::cvtColor(rgba, bgr_, cv::COLOR_RGBA2BGR);
        writer.write(bgr_);
    }
    cv::VideoWriter writer;

private:
    cv::Mat bgr_;
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
    cv::Mat bgr, rgba;
    for (; capture.grab(); ++facts.frames)
        if (looked_at.contains(facts.frames) && capture.retrieve(bgr)) {
            cv::cvtColor(bgr, rgba, cv::COLOR_BGR2RGBA);
            look(facts.frames, {rgba.cols, rgba.rows, {rgba.datastart, rgba.dataend}});
        }
    return true;
}

constexpr VideoBackend kOpenCv{openEncoder, readFilm};

}  // namespace
}  // namespace noctule

extern "C" const noctule::VideoBackend* noctuleVideoBackend() {
    return &noctule::kOpenCv;
}
