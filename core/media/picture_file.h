// SPDX-License-Identifier: Apache-2.0
// Pictures as files: JPEG, PNG and what else OpenCV reads, as stored, whichever way the camera was held.
#pragma once

#include <string>

#include "core/job/result.h"
#include "core/media/picture.h"

namespace noctule {

/// Without pixels when `bytes` are no picture, or one too large for memory; alpha is 255. The error says that
/// the program is not whole.
Result<Picture> decodePicture(const std::string& bytes);
Result<GreyPicture> decodeGreyPicture(const std::string& bytes);

/// PNG, 8 bits each of red, green and blue.
Result<std::string> pngBytes(const Picture& picture);
/// kUnreadable when there is no picture in it.
Result<Picture> readPicture(const std::string& path);

}  // namespace noctule
