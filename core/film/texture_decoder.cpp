// SPDX-License-Identifier: Apache-2.0
#include "core/film/texture_decoder.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/body/text.h"
#include "core/media/media_backend.h"
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

std::optional<Error> undrawnTextures(const RiggedMesh& mesh, const std::string& where) {
    const auto textures = texturesOf(mesh.skin.surface);
    const auto undrawn =
        std::ranges::count_if(textures, [](const auto& texture) { return texture->rgba.empty(); });
    if (undrawn == 0)
        return std::nullopt;
    if (const auto backend = mediaBackend(); !backend)
        return Error{backend.error().kind, where + ": its textures are not drawn: " + backend.error().message,
                     backend.error().remedy};
    return Error{ErrorKind::kUnreadable,
                 where + ": " + text::plural(undrawn, "texture", "textures") + " of " +
                     std::to_string(textures.size()) + " cannot be decoded and will not be drawn",
                 "Save them again as PNG or JPEG"};
}

}  // namespace noctule
