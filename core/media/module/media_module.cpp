// SPDX-License-Identifier: Apache-2.0
// The module noctule-media: OpenCV's imgcodecs and videoio.
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "core/media/media_backend.h"

namespace noctule {
namespace {

cv::Mat toBgr(const Picture& picture) {
    const cv::Mat rgba(picture.height_px, picture.width_px, CV_8UC4,
                       const_cast<uint8_t*>(picture.rgba.data()));  // cv::Mat only reads here
    cv::Mat bgr;
    cv::cvtColor(rgba, bgr, cv::COLOR_RGBA2BGR);
    return bgr;
}

Picture fromBgr(const cv::Mat& bgr) {
    cv::Mat rgba;
    cv::cvtColor(bgr, rgba, cv::COLOR_BGR2RGBA);
    return {rgba.cols, rgba.rows, {rgba.datastart, rgba.dataend}};
}

/// Empty when there is no picture in it.
cv::Mat decoded(const std::string& bytes, int flags) {
    if (bytes.empty() || bytes.size() >= size_t(1) << 30)
        return {};
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U,
                      const_cast<char*>(bytes.data()));  // cv::imdecode only reads
    try {
        return cv::imdecode(raw, flags | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const std::exception&) {  // a size that no picture has, or more than there is memory
        return {};
    }
}

Picture decodeColour(const std::string& bytes) {
    const cv::Mat bgr = decoded(bytes, cv::IMREAD_COLOR);
    return bgr.empty() ? Picture{} : fromBgr(bgr);
}

GreyPicture decodeGrey(const std::string& bytes) {
    const cv::Mat grey = decoded(bytes, cv::IMREAD_GRAYSCALE);
    return grey.empty() ? GreyPicture{} : GreyPicture{grey.cols, grey.rows, {grey.datastart, grey.dataend}};
}

std::string encodePng(const Picture& picture) {
    std::vector<uint8_t> bytes;
    require(cv::imencode(".png", toBgr(picture), bytes), "a picture in memory can be encoded as PNG");
    return {bytes.begin(), bytes.end()};
}

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

constexpr MediaBackend kOpenCv{decodeColour, decodeGrey, encodePng, openEncoder, readFilm};

}  // namespace
}  // namespace noctule

extern "C" const noctule::MediaBackend* noctuleMediaBackend() {
    return &noctule::kOpenCv;
}
