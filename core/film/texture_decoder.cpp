// SPDX-License-Identifier: Apache-2.0
#include "core/film/texture_decoder.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "core/film/picture_mat.h"

namespace noctule {

void decodeTexture(SurfaceTexture& texture) {
    cv::Mat bgr;
    try {
        bgr = cv::imdecode(std::vector<uint8_t>(texture.file.begin(), texture.file.end()), cv::IMREAD_COLOR);
    } catch (const cv::Exception&) {
        return;  // damaged, or larger than OpenCV reads
    }
    if (bgr.empty())
        return;
    const double smaller = static_cast<double>(MeshLimits::kTextureSide_px) / std::max(bgr.cols, bgr.rows);
    if (smaller < 1)
        cv::resize(bgr, bgr, {}, smaller, smaller, cv::INTER_AREA);
    Picture picture = fromBgr(bgr);
    texture.width_px = picture.width_px;
    texture.height_px = picture.height_px;
    texture.rgba = std::move(picture.rgba);
}

}  // namespace noctule
