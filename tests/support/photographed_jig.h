// SPDX-License-Identifier: Apache-2.0
// Photographs of printed markers as a camera would take them, for tests: rays through a lens of its own onto
// squares, so that nothing is interpolated; blur, noise and JPEG on top. Independent of the product's lens
// and poses.
#pragma once

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "core/math/rotation.h"
#include "core/vision/marker_cells.h"
#include "core/vision/photograph.h"

namespace noctule::test {

/// x right and y up as printed, z towards who looks at it.
struct StuckMarker {
    int number = 0;
    Vector3d p_m = Vector3d::Zero();
    Matrix3d R = Matrix3d::Identity();
    double side_m = 0.04;
};

/// x right, y down, z forward.
struct TestCamera {
    int width_px = 2592, height_px = 1944;
    double focal_px = 2000;
    Eigen::Vector2d center_px{1310, 960};
    double k1 = 0, k2 = 0;
    Vector3d p_m = Vector3d::Zero();
    Matrix3d R = Matrix3d::Identity();  ///< camera to world

    /// Stands at `from`, looks at `at`, turned about its axis.
    void look(const Vector3d& from, const Vector3d& at, double roll_rad) {
        p_m = from;
        const Vector3d forward = (at - from).normalized(),
                       right = forward.cross(Vector3d::UnitY()).normalized();
        R << right, forward.cross(right), forward;
        R = R * axisAngle(Vector3d::UnitZ(), roll_rad).toRotationMatrix();
    }
    Vector3d inside(const Vector3d& world) const { return R.transpose() * (world - p_m); }
    Eigen::Vector2d pixel(const Vector3d& world) const {
        const Vector3d p = inside(world);
        const double x = p.x() / p.z(), y = p.y() / p.z(), r2 = x * x + y * y;
        const double bend = 1 + k1 * r2 + k2 * r2 * r2;
        return center_px + focal_px * bend * Eigen::Vector2d(x, y);
    }
    /// Direction in the world of what falls on a pixel.
    Vector3d ray(double u, double v) const {
        const Eigen::Vector2d bent = (Eigen::Vector2d(u, v) - center_px) / focal_px;
        Eigen::Vector2d m = bent;
        for (int i = 0; i < 6; ++i)
            m = bent / (1 + m.squaredNorm() * (k1 + k2 * m.squaredNorm()));
        return R * Vector3d(m.x(), m.y(), 1);
    }
    /// Whether all of a marker is in the picture and its face is seen.
    bool sees(const StuckMarker& marker) const {
        if ((p_m - marker.p_m).normalized().dot(marker.R.col(2)) < 0.35)
            return false;
        for (const double x : {-0.7, 0.7})
            for (const double y : {-0.7, 0.7}) {
                const Vector3d corner = marker.p_m + marker.side_m * marker.R * Vector3d(x, y, 0);
                const Eigen::Vector2d at = inside(corner).z() > 0 ? pixel(corner) : Eigen::Vector2d(-1, -1);
                if (at.x() < 0 || at.y() < 0 || at.x() > width_px - 1 || at.y() > height_px - 1)
                    return false;
            }
        return true;
    }
};

struct PhotographLook {
    double blur_px = 0.7, noise_levels = 3;
    double tone = 1;  ///< power that bends the levels: a camera's own look
    int jpeg_quality = 92;
    int samples = 3;        ///< rays across a pixel
    double hole_share = 0;  ///< diameter of a hole in every marker's middle, of its side
};

/// Share of full light of a level of sRGB, and back.
inline double lightOf(double level) {
    const double v = level / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
inline double levelOf(double light) {
    const double v = std::max(0.0, light);
    return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
}

/// Level of a marker and its margin of one cell at a point of its plane in cells from its middle; -1 beside
/// it.
inline double levelAt(const MarkerCells& cells, double x, double y, double hole_cells) {
    const double half = kMarkerCells / 2.0;
    if (std::abs(x) >= half + 1 || std::abs(y) >= half + 1)
        return -1;
    if (std::hypot(x, y) < hole_cells / 2)
        return 60;
    if (std::abs(x) >= half || std::abs(y) >= half)
        return 225;
    const int column = int(x + half), row = int(half - y);
    return cells[size_t(std::min(row, kMarkerCells - 1))][size_t(column)] ? 225 : 25;
}

inline void paintMarker(cv::Mat& picture, const TestCamera& camera, const StuckMarker& marker,
                        const PhotographLook& look) {
    const MarkerCells cells = markerCells(marker.number);
    const double cell_m = marker.side_m / kMarkerCells, reach_m = marker.side_m * 0.75;
    Eigen::AlignedBox2d box;
    for (const double x : {-reach_m, reach_m})
        for (const double y : {-reach_m, reach_m}) {
            const Vector3d corner = marker.p_m + marker.R * Vector3d(x, y, 0);
            if (camera.inside(corner).z() < 0.05)
                return;
            box.extend(camera.pixel(corner));
        }
    const Vector3d from = marker.R.transpose() * (camera.p_m - marker.p_m);
    if (from.z() <= 0)
        return;  // its back
    for (int v = std::max(0, int(box.min().y())); v <= std::min(camera.height_px - 1, int(box.max().y()));
         ++v)
        for (int u = std::max(0, int(box.min().x())); u <= std::min(camera.width_px - 1, int(box.max().x()));
             ++u) {
            double sum = 0;
            for (int i = 0; i < look.samples * look.samples; ++i) {
                const double du = (i % look.samples + 0.5) / look.samples - 0.5,
                             dv = (i / look.samples + 0.5) / look.samples - 0.5;
                const Vector3d ray = marker.R.transpose() * camera.ray(u + du, v + dv);
                const Vector3d hit = from - ray * (from.z() / ray.z());
                const double level =
                    levelAt(cells, hit.x() / cell_m, hit.y() / cell_m, look.hole_share * kMarkerCells);
                sum += level < 0 ? picture.at<float>(v, u) : lightOf(level);
            }
            picture.at<float>(v, u) = float(sum / (look.samples * look.samples));
        }
}

/// The photograph as a JPEG file; light is blurred, then its levels (sRGB) get noise. What is nearer hides
/// what is farther.
inline std::string takePhotograph(const TestCamera& camera, std::vector<StuckMarker> markers,
                                  const PhotographLook& look, uint32_t seed) {
    cv::Mat picture(camera.height_px, camera.width_px, CV_32F);
    for (int v = 0; v < camera.height_px; ++v)  // light from one side on a bench with a pattern
        for (int u = 0; u < camera.width_px; ++u)
            picture.at<float>(v, u) = float(lightOf(120 + 40 * double(u) / camera.width_px +
                                                    10 * std::sin(0.02 * u) * std::cos(0.03 * v)));
    std::ranges::sort(markers, std::greater{},
                      [&](const StuckMarker& marker) { return (marker.p_m - camera.p_m).norm(); });
    for (const StuckMarker& marker : markers)
        paintMarker(picture, camera, marker, look);
    if (look.blur_px > 0)
        cv::GaussianBlur(picture, picture, {0, 0}, look.blur_px);
    picture.forEach<float>(
        [&](float& light, const int*) { light = float(255 * std::pow(levelOf(light) / 255, look.tone)); });
    cv::Mat noise(picture.size(), CV_32F);
    cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0, look.noise_levels);
    picture += noise;
    cv::Mat bytes_picture;
    picture.convertTo(bytes_picture, CV_8U);
    std::vector<uchar> bytes;
    cv::imencode(".jpg", bytes_picture, bytes, {cv::IMWRITE_JPEG_QUALITY, look.jpeg_quality});
    return {bytes.begin(), bytes.end()};
}

/// The same without a picture: what findMarkers() would say, with normal errors of the corners.
inline Photograph seenCorners(const TestCamera& camera, const std::vector<StuckMarker>& markers,
                              double sigma_px, std::mt19937& random, const std::string& name) {
    std::normal_distribution<double> error_px(0, sigma_px > 0 ? sigma_px : 1);
    Photograph photograph{name, camera.width_px, camera.height_px, {}};
    for (const StuckMarker& marker : markers) {
        if (!camera.sees(marker))
            continue;
        SeenMarker seen{marker.number, {}};
        const Vector3d corners[] = {{-0.5, 0.5, 0}, {0.5, 0.5, 0}, {0.5, -0.5, 0}, {-0.5, -0.5, 0}};
        for (size_t k = 0; k < 4; ++k) {
            seen.corners_px[k] = camera.pixel(marker.p_m + marker.side_m * marker.R * corners[k]);
            if (sigma_px > 0)
                seen.corners_px[k] += Eigen::Vector2d{error_px(random), error_px(random)};
        }
        photograph.markers.push_back(seen);
    }
    return photograph;
}

}  // namespace noctule::test
