// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"
#include "core/math/rotation_fit.h"
#include "core/mesh/import/gltf_scene.h"

namespace noctule {
namespace {

/// Root mean square distance of the joints from their nodes when `T` carries them there; the mean way that is
/// left over is put into `T`.
double misfit(const std::vector<Eigen::Affine3d>& T_bind, const std::vector<Eigen::Affine3d>& T_file,
              Eigen::Affine3d& T) {
    Vector3d way = Vector3d::Zero();
    double squares = 0;
    for (size_t j = 0; j < T_bind.size(); ++j)
        way += T_file[j].translation() - T * T_bind[j].translation();
    way /= static_cast<double>(T_bind.size());
    T.pretranslate(way);
    for (size_t j = 0; j < T_bind.size(); ++j)
        squares += (T_file[j].translation() - T * T_bind[j].translation()).squaredNorm();
    return std::sqrt(squares / static_cast<double>(T_bind.size()));
}

double spreadOf(const std::vector<Eigen::Affine3d>& T) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Affine3d& at : T)
        box.extend(at.translation());
    return box.diagonal().norm();
}

/// Lengths in the file over those where the skin was bound: the median between neighbours in the list, which
/// are mostly a bone and its parent, so that the pose does not count.
double sizeOf(const std::vector<Eigen::Affine3d>& T_bind, const std::vector<Eigen::Affine3d>& T_file) {
    std::vector<double> ratios;
    for (size_t j = 1; j < T_bind.size(); ++j) {
        const double bound = (T_bind[j].translation() - T_bind[j - 1].translation()).norm();
        const double there = (T_file[j].translation() - T_file[j - 1].translation()).norm();
        if (bound > 0 && there > 0)
            ratios.push_back(there / bound);
    }
    if (ratios.empty())
        return spreadOf(T_file) / spreadOf(T_bind);
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle;
}

/// The similarity that carries the joints nearest to their nodes.
Eigen::Affine3d nearestSimilarity(const std::vector<Eigen::Affine3d>& T_bind,
                                  const std::vector<Eigen::Affine3d>& T_file) {
    const auto count = static_cast<Eigen::Index>(T_bind.size());
    Eigen::Matrix3Xd from(3, count), to(3, count);
    for (Eigen::Index j = 0; j < count; ++j) {
        from.col(j) = T_bind[static_cast<size_t>(j)].translation();
        to.col(j) = T_file[static_cast<size_t>(j)].translation();
    }
    return similarityFit(from, to);
}

bool isOrdinary(const Eigen::Affine3d& T) {
    const double size = std::cbrt(std::abs(T.linear().determinant()));
    return T.matrix().allFinite() && size > 1e-9 && size < 1e9;
}

}  // namespace

/// Programs bind in the file's world, in the mesh's own space, or (Mixamo and old converters) in one that
/// only differs from these by its unit. One of these that explains the joints' places is taken as it is: a
/// fit would follow an animation's first frame. Where joints and bind match exactly, the place counts too:
/// two figures that share a mesh stand apart.
std::optional<Eigen::Affine3d> gltfBindSpace(const std::vector<Eigen::Affine3d>& T_bind,
                                             const std::vector<Eigen::Affine3d>& T_file,
                                             const Eigen::Affine3d& T_mesh) {
    constexpr double kExact = 1e-4, kAsGood = 1.2, kNearlyAsGood = 0.1, kSameSize = 1.3, kAnyPose = 0.3;
    const double extent = spreadOf(T_file);
    if (T_bind.size() < 2 || !(extent > 0))
        return Eigen::Affine3d::Identity();
    if (!(spreadOf(T_bind) > 0))
        return std::nullopt;
    const double size = sizeOf(T_bind, T_file);
    std::vector<Eigen::Affine3d> spaces{Eigen::Affine3d::Identity(), T_mesh,
                                        Eigen::Affine3d(Eigen::Scaling(size)),
                                        nearestSimilarity(T_bind, T_file)};
    std::erase_if(spaces, [](const Eigen::Affine3d& space) { return !isOrdinary(space); });
    std::vector<double> misfits;
    std::vector<Eigen::Affine3d> moved = spaces;
    for (Eigen::Affine3d& space : moved)
        misfits.push_back(misfit(T_bind, T_file, space));
    const double best = *std::min_element(misfits.begin(), misfits.end());
    if (!(best < kAnyPose * extent))
        return std::nullopt;
    for (size_t s = 0; s < spaces.size(); ++s) {
        const double own_size = std::cbrt(std::abs(spaces[s].linear().determinant()));
        if (misfits[s] <= kExact * extent)
            return moved[s];
        if (misfits[s] <= kAsGood * best + kNearlyAsGood * extent &&
            std::abs(std::log(own_size / size)) < std::log(kSameSize))
            return spaces[s];
    }
    return moved[static_cast<size_t>(std::min_element(misfits.begin(), misfits.end()) - misfits.begin())];
}

}  // namespace noctule
