// SPDX-License-Identifier: Apache-2.0
#include "core/vision/photograph.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/aruco.hpp>
#include <optional>

#include "core/job/atomic_file.h"
#include "core/media/picture_file.h"
#include "core/vision/marker_sides.h"

namespace noctule {
namespace {

/// The smallest marker that is looked for, as the length around it by the picture's longer side. Its cells
/// are then 4 pixels wide at 12 megapixels; smaller ones are read wrongly.
constexpr double kSmallestAround = 0.02;

/// A JPEG that was cut off decodes to grey below the cut, without a word; only its end marker tells. In the
/// segments before the scan (a thumbnail has an end of its own) lengths lead on, in the scan FF D9 is the
/// end.
bool isCutOffJpeg(const std::string& bytes) {
    const auto at = [&](size_t i) { return static_cast<unsigned char>(bytes[i]); };
    if (bytes.size() < 4 || at(0) != 0xFF || at(1) != 0xD8)
        return false;
    size_t i = 2;
    while (i + 4 <= bytes.size() && at(i) == 0xFF && at(i + 1) != 0xDA)
        i += at(i + 1) == 0xFF ? 1 : 2 + size_t(at(i + 2)) * 256 + at(i + 3);
    return i >= bytes.size() || bytes.find("\xFF\xD9", i) == std::string::npos;
}

Error unreadable(const std::string& name, const std::string& what) {
    return {ErrorKind::kUnreadable, name + ": " + what,
            "Copy it from the camera again, or leave it out and take another photograph"};
}

Result<GreyPicture> decode(const std::string& bytes, const std::string& name) {
    if (isCutOffJpeg(bytes))
        return unreadable(name, "the photograph is cut off");
    auto grey = decodeGreyPicture(bytes);
    if (grey && grey->brightness.empty())
        return unreadable(name, "is not a photograph that can be read");
    return grey;
}

cv::Ptr<cv::aruco::DetectorParameters> detectorSettings() {
    auto settings = cv::aruco::DetectorParameters::create();
    settings->minMarkerPerimeterRate = kSmallestAround;
    settings->minMarkerDistanceRate = 0.02;
    // With 50 numbers in 16 bits a wrong cell more makes markers out of anything square.
    settings->errorCorrectionRate = 0;
    settings->maxErroneousBitsInBorderRate = 0.1;
    // Cells are read from enough of their pixels, away from their blurred borders.
    settings->perspectiveRemovePixelPerCell = 8;
    settings->perspectiveRemoveIgnoredMarginPerCell = 0.25;
    settings->cornerRefinementMethod = cv::aruco::CORNER_REFINE_NONE;
    return settings;
}

/// Nothing when its sides cannot be made out.
std::optional<SeenMarker> refined(const cv::Mat& grey, int number, const std::vector<cv::Point2f>& about) {
    const auto corners = cornersFromSides(grey, {about[0], about[1], about[2], about[3]});
    if (!corners)
        return {};
    SeenMarker seen{number, {}};
    for (size_t k = 0; k < 4; ++k)
        seen.corners_px[k] = {(*corners)[k].x, (*corners)[k].y};
    return seen;
}

/// One marker on the paper that was found by two outlines, that of its border and that of its margin.
bool isSame(const SeenMarker& a, const SeenMarker& b) {
    const auto middle = [](const SeenMarker& m) -> Eigen::Vector2d {
        return (m.corners_px[0] + m.corners_px[1] + m.corners_px[2] + m.corners_px[3]) / 4;
    };
    const double side_px =
        std::max((a.corners_px[2] - a.corners_px[0]).norm(), (b.corners_px[2] - b.corners_px[0]).norm()) /
        std::numbers::sqrt2;
    return a.number == b.number && (middle(a) - middle(b)).norm() < side_px / 2;
}

}  // namespace

Result<Photograph> findMarkers(const std::string& bytes, const std::string& name) {
    cv::setNumThreads(1);  // core starts no threads
    auto decoded = decode(bytes, name);
    if (!decoded)
        return decoded.error();
    const cv::Mat grey(decoded->height_px, decoded->width_px, CV_8U, decoded->brightness.data());
    Photograph photograph{name, grey.cols, grey.rows, {}};
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> numbers;
    try {
        cv::aruco::detectMarkers(grey, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), corners,
                                 numbers, detectorSettings());
        for (size_t i = 0; i < numbers.size(); ++i)
            if (const auto seen = refined(grey, numbers[i], corners[i]);
                seen && std::ranges::none_of(photograph.markers,
                                             [&](const SeenMarker& other) { return isSame(*seen, other); }))
                photograph.markers.push_back(*seen);
    } catch (const cv::Exception&) {  // a picture of a few pixels
        return unreadable(name, "is too small to look for markers");
    }
    return photograph;
}

Result<std::vector<Photograph>> readPhotographs(const std::vector<std::string>& paths,
                                                const JobContext& job) {
    std::vector<Photograph> photographs;
    for (const std::string& path : paths) {
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(double(photographs.size()) / double(paths.size()), "Looking for markers in " + path);
        const auto bytes = readWholeFile(path);
        if (!bytes)
            return bytes.error();
        auto photograph = findMarkers(*bytes, path);
        if (!photograph)
            return photograph.error();
        photographs.push_back(std::move(*photograph));
    }
    return photographs;
}

Result<std::string> placementOf(const std::string& path, const std::vector<std::string>& labels) {
    const std::string file = std::filesystem::path(path).filename().string();
    std::string best, all;
    for (const std::string& label : labels) {
        if (label.size() > best.size() && file.starts_with(label + "_"))
            best = label;
        all += (all.empty() ? "" : ", ") + label;
    }
    if (best.empty())
        return Error{ErrorKind::kUsage,
                     path + ": the file's name does not begin with a placement of the take" +
                         (all.empty() ? ", which has none" : " and _ (" + all + ")"),
                     "Name photographs PLACEMENT_*.jpg, for example " +
                         (labels.empty() ? std::string("1") : labels.front()) + "_1.jpg"};
    return best;
}

}  // namespace noctule
