// SPDX-License-Identifier: Apache-2.0
// Where cameras and square markers were, so that all corners fall where the photographs show them: bundle
// adjustment (Triggs et al. 2000, "Bundle adjustment, a modern synthesis", sections 4 and 6) by Levenberg and
// Marquardt, the markers eliminated (Schur). The known length of the markers' sides is the only scale. Each
// placement has a frame of its own, "jig": that of its first camera, which stays. Lenses are common to all.
//
// Ceres would do it too. It is not linked: it would be one more dependency for what is 200 lines here, and
// its covariance takes no Schur complement.
#pragma once

#include <array>
#include <vector>

#include "core/job/job.h"
#include "core/vision/lens.h"

namespace noctule {

/// Of the marker's middle; its x to the right, y up as printed, z towards who looks at it.
struct MarkerPose {
    Quaterniond q_jig_marker = Quaterniond::Identity();
    Vector3d p_jig_marker_m = Vector3d::Zero();
};

struct CameraPose {
    Quaterniond q_camera_jig = Quaterniond::Identity();
    Vector3d p_camera_jig_m = Vector3d::Zero();
    int lens = 0;
    bool stays = false;

    Vector3d toCamera(const Vector3d& p_jig) const { return q_camera_jig * p_jig + p_camera_jig_m; }
};

struct Sighting {
    int camera = 0, marker = 0;
    std::array<Eigen::Vector2d, 4> corners_px;  ///< as SeenMarker
    bool used = true;
};

/// What is known of a lens before it has taken any photograph.
struct LensBelief {
    Lens lens;
    Lens::Values sigma = Lens::Values::Ones();
};

struct Bundle {
    double side_m = 0.04;
    std::vector<LensBelief> beliefs;  ///< as many as lenses
    std::vector<Lens> lenses;
    std::vector<CameraPose> cameras;
    std::vector<MarkerPose> markers;
    std::vector<Sighting> sightings;
};

/// In the marker's frame, in the order of SeenMarker.
std::array<Vector3d, 4> markerCorners(double side_m);

/// How corners move when every edge moves by one pixel away from the marker's middle.
std::array<Eigen::Vector2d, 4> cornersPerEdge(const std::array<Eigen::Vector2d, 4>& corners_px);

/// Root mean square distance of its corners from where they should be; infinite behind the camera.
double sightingError_px(const Bundle& bundle, const Sighting& sighting);

struct BundleFit {
    bool converged = false;
    int iterations = 0;
    double sigma_px = 0;  ///< of a corner's coordinate, from the residuals
    double cost = 0;      ///< without unit; comparable between fits of the same sightings and sigma
};

/// Values of `bundle` where it begins; with its used sightings. Corners that fit badly have less weight
/// (Huber, three times their usual error). kCancelled is its only error.
Result<BundleFit> adjust(Bundle& bundle, const JobContext& job);

/// How well the fit knows distances, scale and lens included, the markers' side taken for exact.
class BundleCovariance {
public:
    BundleCovariance(const Bundle& bundle, double sigma_px);
    /// Of the distance between the middles of two markers of one placement.
    double distanceSigma_m(int marker, int other) const;

private:
    struct MarkerPart {
        Vector3d p_jig_m;
        Matrix3d own;                      ///< covariance, were all cameras and lenses known
        Eigen::Matrix3Xd J_marker_common;  ///< how it moves with cameras and lenses
    };
    std::vector<MarkerPart> markers_;
    Eigen::MatrixXd cov_common_;
};

}  // namespace noctule
