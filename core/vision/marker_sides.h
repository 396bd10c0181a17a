// SPDX-License-Identifier: Apache-2.0
// A marker's corners to a few hundredths of a pixel: where lines through its four sides meet. A blurred
// corner is round, and what refines corners as such (cv::cornerSubPix) finds it too far inside: 0.1 px, which
// makes every distance 0.3 % too long. A blurred straight side stays where it was, once light is counted as
// light: levels of a photograph are about the 2.2th root of it (IEC 61966-2-1), and blur happens in the lens.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <optional>

namespace noctule {

/// `corners` clockwise within about a pixel, `grey` the photograph's bytes. Nothing when a side is not a
/// straight edge from black to white.
std::optional<std::array<cv::Point2d, 4>> cornersFromSides(const cv::Mat& grey,
                                                           const std::array<cv::Point2d, 4>& corners);

}  // namespace noctule
