// SPDX-License-Identifier: Apache-2.0
#include "core/film/texture_decoder.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/media/picture_file.h"

namespace noctule {

void decodeTexture(SurfaceTexture& texture, int side_px) {
    // As exported files show it: as stored, not as a camera was held.
    auto picture = decodePicture({texture.file.begin(), texture.file.end()});
    if (!picture || picture->rgba.empty())
        return;
    const double smaller = static_cast<double>(side_px) / std::max(picture->width_px, picture->height_px);
    if (smaller < 1) {
        const cv::Mat whole(picture->height_px, picture->width_px, CV_8UC4, picture->rgba.data());
        const auto side = [&](int px) { return std::max(1, cvRound(smaller * px)); };
        cv::Mat resized;
        cv::resize(whole, resized, {side(whole.cols), side(whole.rows)}, 0, 0, cv::INTER_AREA);
        *picture = {resized.cols, resized.rows, {resized.datastart, resized.dataend}};
    }
    texture.width_px = picture->width_px;
    texture.height_px = picture->height_px;
    texture.rgba = std::move(picture->rgba);
}

}  // namespace noctule
