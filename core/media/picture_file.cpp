// SPDX-License-Identifier: Apache-2.0
#include "core/media/picture_file.h"

#include "core/job/atomic_file.h"
#include "core/media/media_backend.h"

namespace noctule {

Result<Picture> decodePicture(const std::string& bytes) {
    const auto backend = mediaBackend();
    if (!backend)
        return backend.error();
    return (*backend)->decode(bytes);
}

Result<GreyPicture> decodeGreyPicture(const std::string& bytes) {
    const auto backend = mediaBackend();
    if (!backend)
        return backend.error();
    return (*backend)->decodeGrey(bytes);
}

Result<std::string> pngBytes(const Picture& picture) {
    const auto backend = mediaBackend();
    if (!backend)
        return backend.error();
    return (*backend)->encodePng(picture);
}

Result<Picture> readPicture(const std::string& path) {
    const auto bytes = readWholeFile(path);
    if (!bytes)
        return bytes.error();
    auto picture = decodePicture(*bytes);
    if (picture && picture->rgba.empty())
        return Error{ErrorKind::kUnreadable, path + ": is no picture that can be read", "Write it again"};
    return picture;
}

}  // namespace noctule
