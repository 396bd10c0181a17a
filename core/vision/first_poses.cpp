// SPDX-License-Identifier: Apache-2.0
#include "core/vision/first_poses.h"

#include <algorithm>
#include <map>
#include <opencv2/calib3d.hpp>
#include <optional>
#include <set>

namespace noctule {
namespace {

/// A rigid motion: p_a = q_a_b p_b + p_a_b.
struct Placing {
    Quaterniond q = Quaterniond::Identity();
    Vector3d p_m = Vector3d::Zero();

    Placing operator*(const Placing& other) const { return {q * other.q, p_m + q * other.p_m}; }
    Placing inverse() const { return {q.conjugate(), -(q.conjugate() * p_m)}; }
};

constexpr double kGrossError_px = 50;  ///< further off counts no more, while poses are compared
constexpr size_t kEnoughCenters = 4;   ///< markers whose middles alone tell a camera's pose

cv::Matx33d cameraMatrix(const Lens& lens) {
    return {lens.focal_px, 0, lens.center_px.x(), 0, lens.focal_px, lens.center_px.y(), 0, 0, 1};
}

Placing placingOf(const cv::Mat& rotation_vector, const cv::Mat& position) {
    cv::Matx33d rotation;
    cv::Rodrigues(rotation_vector, rotation);
    Matrix3d R;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            R(row, column) = rotation(row, column);
    return {Quaterniond(R).normalized(),
            {position.at<double>(0), position.at<double>(1), position.at<double>(2)}};
}

/// Marker before the camera, the likelier first. Empty when the four points are no square's.
std::vector<Placing> possiblePlacings(const Lens& lens, const Sighting& sighting, double side_m) {
    std::vector<cv::Point3d> square;
    std::vector<cv::Point2d> seen;
    for (const Vector3d& corner : markerCorners(side_m))
        square.emplace_back(corner.x(), corner.y(), corner.z());
    for (const Eigen::Vector2d& corner : sighting.corners_px)
        seen.emplace_back(corner.x(), corner.y());
    std::vector<Placing> placings;
    std::vector<cv::Mat> rotations, positions;
    try {
        cv::solvePnPGeneric(square, seen, cameraMatrix(lens), cv::noArray(), rotations, positions, false,
                            cv::SOLVEPNP_IPPE_SQUARE);
    } catch (const cv::Exception&) {
        return {};
    }
    for (size_t i = 0; i < rotations.size(); ++i) {
        const Placing placing = placingOf(rotations[i], positions[i]);
        if (placing.q.coeffs().allFinite() && placing.p_m.allFinite() && placing.p_m.z() > side_m)
            placings.push_back(placing);
    }
    return placings;
}

/// One placement while its cameras find their places.
class Chain {
public:
    Chain(Bundle& bundle, const PlacementParts& parts) : bundle_(bundle), parts_(parts) {
        for (size_t s = 0; s < bundle_.sightings.size(); ++s) {
            Sighting& sighting = bundle_.sightings[s];
            if (!sighting.used || !std::ranges::count(parts.cameras, sighting.camera))
                continue;
            const Lens& lens = bundle_.lenses[size_t(bundle_.cameras[size_t(sighting.camera)].lens)];
            auto placings = possiblePlacings(lens, sighting, bundle_.side_m);
            sighting.used = !placings.empty();
            if (sighting.used)
                of_camera_[sighting.camera].push_back({s, std::move(placings)});
        }
    }

    void place() {
        if (of_camera_.empty())
            return;
        const auto first =
            std::ranges::max_element(of_camera_, {}, [](const auto& seen) { return seen.second.size(); });
        bundle_.cameras[size_t(first->first)].stays = true;
        placeCamera(first->first, {});
        while (const auto next = bestTied())
            placeCamera(*next, bestPlacing(*next));
        for (auto& [camera, seen] : of_camera_)
            for (Seen& one : seen)
                if (!placed_.contains(camera))
                    bundle_.sightings[one.sighting].used = false;
        for (const int marker : parts_.markers)
            chooseTurn(marker);
        for (const auto& [camera, seen] : of_camera_)
            for (const Seen& one : seen)
                if (std::isinf(sightingError_px(bundle_, bundle_.sightings[one.sighting])))
                    bundle_.sightings[one.sighting].used = false;
    }

    /// The pose that suits all photographs best, of those that one photograph suggests.
    bool chooseTurn(int marker) {
        MarkerPose& pose = bundle_.markers[size_t(marker)];
        std::vector<size_t> sightings;
        std::vector<MarkerPose> suggested;
        for (const auto& [camera, seen] : of_camera_)
            for (const Seen& one : seen)
                if (bundle_.sightings[one.sighting].marker == marker &&
                    bundle_.sightings[one.sighting].used) {
                    sightings.push_back(one.sighting);
                    for (const Placing& placing : one.placings)
                        suggested.push_back(markerPose(camera, placing));
                }
        const auto errorOf = [&](const MarkerPose& candidate) {
            const MarkerPose kept = std::exchange(pose, candidate);
            double sum = 0;
            for (const size_t s : sightings)
                sum += std::pow(std::min(kGrossError_px, sightingError_px(bundle_, bundle_.sightings[s])), 2);
            pose = kept;
            return sum;
        };
        double best = errorOf(pose);
        std::optional<MarkerPose> better;
        for (const MarkerPose& candidate : suggested)
            if (const double error = errorOf(candidate); error < best) {
                best = error;
                better = candidate;
            }
        if (better)
            pose = *better;
        return better.has_value();
    }

private:
    struct Seen {
        size_t sighting;
        std::vector<Placing> placings;  ///< camera from marker
    };

    MarkerPose markerPose(int camera, const Placing& placing) const {
        const CameraPose& pose = bundle_.cameras[size_t(camera)];
        const Placing jig = Placing{pose.q_camera_jig, pose.p_camera_jig_m}.inverse() * placing;
        return {jig.q.normalized(), jig.p_m};
    }

    int markerOf(const Seen& seen) const { return bundle_.sightings[seen.sighting].marker; }

    void placeCamera(int camera, const Placing& placing) {
        CameraPose& pose = bundle_.cameras[size_t(camera)];
        pose.q_camera_jig = placing.q.normalized();
        pose.p_camera_jig_m = placing.p_m;
        placed_.insert(camera);
        for (const Seen& seen : of_camera_[camera])
            if (known_.insert(markerOf(seen)).second)
                bundle_.markers[size_t(markerOf(seen))] = markerPose(camera, seen.placings.front());
    }

    /// The camera with the most markers that are known already.
    std::optional<int> bestTied() const {
        std::optional<int> best;
        std::ptrdiff_t most = 0;
        for (const auto& [camera, seen] : of_camera_) {
            const auto shared =
                std::ranges::count_if(seen, [&](const Seen& one) { return known_.contains(markerOf(one)); });
            if (!placed_.contains(camera) && shared > most) {
                most = shared;
                best = camera;
            }
        }
        return best;
    }

    /// By the middles of the markers, which the ambiguity leaves where they are; of a few also by corners.
    double misfit(int camera, const Placing& placing, bool by_corners) const {
        const Lens& lens = bundle_.lenses[size_t(bundle_.cameras[size_t(camera)].lens)];
        double sum = 0;
        for (const Seen& seen : of_camera_.at(camera)) {
            if (!known_.contains(markerOf(seen)))
                continue;
            const MarkerPose& marker = bundle_.markers[size_t(markerOf(seen))];
            const auto& corners_px = bundle_.sightings[seen.sighting].corners_px;
            const auto add = [&](const Vector3d& p_jig, const Eigen::Vector2d& seen_px) {
                const Vector3d p = placing.q * p_jig + placing.p_m;
                const double error = p.z() > 0 ? (project(lens, p) - seen_px).norm() : kGrossError_px;
                sum += std::pow(std::min(error, kGrossError_px), 2);
            };
            if (!by_corners) {
                add(marker.p_jig_marker_m,
                    (corners_px[0] + corners_px[1] + corners_px[2] + corners_px[3]) / 4);
                continue;
            }
            const auto corners = markerCorners(bundle_.side_m);
            for (size_t k = 0; k < corners.size(); ++k)
                add(marker.p_jig_marker_m + marker.q_jig_marker * corners[k], corners_px[k]);
        }
        return sum;
    }

    Placing bestPlacing(int camera) const {
        std::vector<Placing> suggested;
        std::vector<cv::Point3d> centers;
        std::vector<cv::Point2d> seen_px;
        for (const Seen& seen : of_camera_.at(camera)) {
            if (!known_.contains(markerOf(seen)))
                continue;
            const MarkerPose& marker = bundle_.markers[size_t(markerOf(seen))];
            const auto& corners = bundle_.sightings[seen.sighting].corners_px;
            const Eigen::Vector2d middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
            centers.emplace_back(marker.p_jig_marker_m.x(), marker.p_jig_marker_m.y(),
                                 marker.p_jig_marker_m.z());
            seen_px.emplace_back(middle.x(), middle.y());
            for (const Placing& placing : seen.placings)
                suggested.push_back(placing * Placing{marker.q_jig_marker, marker.p_jig_marker_m}.inverse());
        }
        const bool by_corners = centers.size() < kEnoughCenters;
        if (!by_corners)
            try {
                cv::Mat rotation, position;
                const Lens& lens = bundle_.lenses[size_t(bundle_.cameras[size_t(camera)].lens)];
                if (cv::solvePnP(centers, seen_px, cameraMatrix(lens), cv::noArray(), rotation, position,
                                 false, cv::SOLVEPNP_SQPNP))
                    suggested.push_back(placingOf(rotation, position));
            } catch (const cv::Exception&) {  // the single markers' suggestions remain
            }
        return *std::ranges::min_element(
            suggested, {}, [&](const Placing& placing) { return misfit(camera, placing, by_corners); });
    }

    Bundle& bundle_;
    const PlacementParts& parts_;
    std::map<int, std::vector<Seen>> of_camera_;
    std::set<int> placed_, known_;
};

}  // namespace

void setFirstPoses(Bundle& bundle, const PlacementParts& parts) {
    Chain(bundle, parts).place();
}

int turnMistakenMarkers(Bundle& bundle) {
    PlacementParts all;
    for (size_t c = 0; c < bundle.cameras.size(); ++c)
        all.cameras.push_back(static_cast<int>(c));
    Chain chain(bundle, all);
    int turned = 0;
    for (size_t m = 0; m < bundle.markers.size(); ++m)
        turned += chain.chooseTurn(static_cast<int>(m));
    return turned;
}

}  // namespace noctule
