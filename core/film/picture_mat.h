// SPDX-License-Identifier: Apache-2.0
// Pictures as OpenCV holds them: rows from the top, blue, green, red.
#pragma once

#include <opencv2/imgproc.hpp>

#include "core/render/offscreen.h"

namespace noctule {

inline cv::Mat toBgr(const Picture& picture) {
    const cv::Mat rgba(picture.height_px, picture.width_px, CV_8UC4,
                       const_cast<uint8_t*>(picture.rgba.data()));  // cv::Mat only reads here
    cv::Mat bgr;
    cv::cvtColor(rgba, bgr, cv::COLOR_RGBA2BGR);
    return bgr;
}

inline Picture fromBgr(const cv::Mat& bgr) {
    cv::Mat rgba;
    cv::cvtColor(bgr, rgba, cv::COLOR_BGR2RGBA);
    return {rgba.cols, rgba.rows, {rgba.datastart, rgba.dataend}};
}

}  // namespace noctule
