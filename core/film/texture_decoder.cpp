// SPDX-License-Identifier: Apache-2.0
#include "core/film/texture_decoder.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "core/film/picture_mat.h"

namespace noctule {

void decodeTexture(SurfaceTexture& texture, int side_px) {
    cv::Mat bgr;
    try {
        // As exported files show it: as stored, not as a camera was held.
        bgr = cv::imdecode(std::vector<uint8_t>(texture.file.begin(), texture.file.end()),
                           cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
        if (bgr.empty())
            return;
        const double smaller = static_cast<double>(side_px) / std::max(bgr.cols, bgr.rows);
        const auto side = [&](int px) { return std::max(1, cvRound(smaller * px)); };
        if (smaller < 1)
            cv::resize(bgr, bgr, {side(bgr.cols), side(bgr.rows)}, 0, 0, cv::INTER_AREA);
        Picture picture = fromBgr(bgr);
        texture.width_px = picture.width_px;
        texture.height_px = picture.height_px;
        texture.rgba = std::move(picture.rgba);
    } catch (const std::exception&) {
        return;  // damaged, larger than OpenCV reads, or than there is memory
    }
}

}  // namespace noctule
