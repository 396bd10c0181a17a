// SPDX-License-Identifier: Apache-2.0
// Which way is up and how long is a unit.
#include <algorithm>
#include <cmath>

#include "core/mesh/import/scene_import.h"

namespace noctule {
namespace {

/// A signed axis of an FBX file's settings; zero when they make no sense.
Vector3d axisOf(const aiMetadata& settings, const std::string& name) {
    int axis = -1, sign = 0;
    if (!settings.Get(name, axis) || !settings.Get(name + "Sign", sign) || axis < 0 || axis > 2 || sign == 0)
        return Vector3d::Zero();
    return Vector3d::Unit(axis) * (sign > 0 ? 1 : -1);
}

WorldChange fbxWorld(const aiScene& scene) {
    WorldChange change;
    if (!scene.mMetaData)
        return change;
    float cm = 1;
    if (scene.mMetaData->Get("UnitScaleFactor", cm) && std::isfinite(cm) && cm > 1e-6F && cm < 1e6F)
        change.scale = static_cast<double>(cm) * 0.01;
    Matrix3d turn;
    turn << axisOf(*scene.mMetaData, "CoordAxis").transpose(), axisOf(*scene.mMetaData, "UpAxis").transpose(),
        axisOf(*scene.mMetaData, "FrontAxis").transpose();
    if (std::abs(turn.determinant() - 1) < 1e-9)  // a left-handed or senseless one says nothing
        change.turn = turn;
    return change;
}

Eigen::AlignedBox3d boxOf(const aiScene& scene) {
    Eigen::AlignedBox3d box;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned v = 0; v < scene.mMeshes[m]->mNumVertices; ++v)
            if (const Vector3d p = toEigen(scene.mMeshes[m]->mVertices[v]); p.allFinite())
                box.extend(p);
    return box;
}

/// A figure is taller than deep: Z up when the file is. Of the usual units the one that makes a person of it.
WorldChange guessedWorld(const aiScene& scene) {
    constexpr double kUnits_m[] = {1, 0.1, 0.01, 0.001, 0.0254, 0.3048};
    constexpr double kPerson_m = 1.7, kShortest_m = 1.3, kTallest_m = 2.3;
    WorldChange change;
    const Eigen::AlignedBox3d box = boxOf(scene);
    if (box.isEmpty())
        return change;
    const Vector3d size = box.sizes();
    if (size.z() > 1.5 * size.y())
        change.turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    const double height = std::max(size.y(), size.z() > 1.5 * size.y() ? size.z() : 0.0);
    const double unit = *std::min_element(std::begin(kUnits_m), std::end(kUnits_m), [&](double a, double b) {
        return std::abs(std::log(a * height / kPerson_m)) < std::abs(std::log(b * height / kPerson_m));
    });
    if (unit * height > kShortest_m && unit * height < kTallest_m)
        change.scale = unit;
    return change;
}

}  // namespace

WorldChange worldChangeOf(const aiScene& scene, const std::string& suffix,
                          const MeshImportSettings& settings) {
    WorldChange change;
    if (settings.keeps_axes)
        return change;
    if (suffix == ".fbx")
        change = fbxWorld(scene);
    else if (suffix == ".obj" || suffix == ".ply")
        change = guessedWorld(scene);
    if (settings.unit_m)
        change.scale = *settings.unit_m;
    return change;
}

}  // namespace noctule
