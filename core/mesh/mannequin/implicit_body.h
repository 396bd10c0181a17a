// SPDX-License-Identifier: Apache-2.0
// The mannequin as an implicit surface: about the distance in metres to the smooth union of its parts,
// negative inside. In the zero pose of the default actor, soles on y = 0; symmetric about x = 0.
#pragma once

#include <vector>

#include "core/body/skeleton.h"
#include "core/mesh/mannequin/mannequin_parts.h"

namespace noctule {

class ImplicitBody {
public:
    /// `part.joint` names a joint of the skeleton; the root's frame is at `root_height_m`.
    ImplicitBody(const std::vector<Part>& parts, const Skeleton& skeleton, double root_height_m);

    double distance_m(const Vector3d& p_m) const;
    /// Gradient of the distance over `step_m`, of length 1: a larger step smooths small creases.
    Vector3d normal(const Vector3d& p_m, double step_m) const;
    /// The nearest point of the surface, for points near it.
    Vector3d onSurface(Vector3d p_m) const;

private:
    using Profile = Eigen::Matrix<double, 5, 1>;  ///< a Section without its place along the axis
    struct Loft {
        Matrix3d R_part_mesh;  ///< rows: across, front, along
        Vector3d origin_m;
        Part shape;
        std::vector<Profile> profiles, slopes;  ///< per section
        Vector3d centre_m;                      ///< of a ball that holds it
        double radius_m;
    };
    static Loft placed(const Part& part, const Vector3d& joint_m);
    static Profile profileAt(const Loft& loft, double along_m);
    static double loftDistance_m(const Loft& loft, const Vector3d& p_m);
    static double partDistance_m(const Loft& loft, const Vector3d& p_m, double nothing_beyond_m);

    std::vector<Loft> lofts_;
};

}  // namespace noctule
