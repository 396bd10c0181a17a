// SPDX-License-Identifier: Apache-2.0
// A person in the dialects of many programs, for tests that let it wear the same motion and compare points.
#pragma once

#include <gtest/gtest.h>

#include "core/formats/fbx_writer.h"
#include "core/formats/glb_writer.h"
#include "core/formats/rigged_figure.h"
#include "core/formats/scene_check.h"
#include "core/math/rotation.h"
#include "core/mesh/import/mesh_import.h"
#include "core/mesh/skinning.h"
#include "tests/core/formats/sample_figure.h"
#include "tests/support/files.h"
#include "tests/support/glb_body.h"
#include "tests/support/shared_meshes.h"

namespace noctule {

using test::GlbBody;
using test::GlbDialect;

inline constexpr size_t kDialectFrames = 12;
using PointsOfFrames = std::vector<std::vector<Vector3d>>;

inline Eigen::Affine3d scaledBy(double size) {
    return Eigen::Affine3d(Eigen::Scaling(size));
}

/// From a program with Z up.
inline Eigen::Affine3d zUp(double size) {
    return Eigen::Affine3d(axisAngle(Vector3d::UnitX(), -M_PI / 2) * Eigen::Scaling(size));
}

inline double largestGap(const std::vector<Vector3d>& from, const std::vector<Vector3d>& to) {
    double worst = 0;
    for (const Vector3d& p : from) {
        double nearest = 1e18;
        for (auto q = to.begin(); q != to.end() && nearest > 1e-9; ++q)
            nearest = std::min(nearest, (p - *q).squaredNorm());
        worst = std::max(worst, nearest);
    }
    return std::sqrt(worst);
}

/// Largest distance, both ways, in any frame.
inline double largestGap(const PointsOfFrames& a, const PointsOfFrames& b) {
    double worst = a.size() == b.size() ? 0 : 1e9;
    for (size_t f = 0; f < std::min(a.size(), b.size()); ++f)
        worst = std::max({worst, largestGap(a[f], b[f]), largestGap(b[f], a[f])});
    return worst;
}

inline double heightOfPoints(const std::vector<Vector3d>& points) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [](const auto& a, const auto& b) { return a.y() < b.y(); });
    return points.empty() ? 0 : high->y() - low->y();
}

class BodyDialects : public testing::Test {
protected:
    std::string written(const std::string& bytes, const std::string& name = "body.glb") const {
        test::writeBytes(folder_.file(name), bytes);
        return folder_.file(name);
    }

    static Result<WearableBody> bodyOf(const std::string& path) {
        auto mesh = importMesh(path);
        return mesh ? wearable(std::move(*mesh), path) : Result<WearableBody>(mesh.error());
    }

    /// The body's points in every frame, as the importer finds them in a file that we wrote.
    PointsOfFrames exported(const std::string& path, SceneFormat format) const {
        const auto body = bodyOf(path);
        EXPECT_TRUE(body) << body.error().text();
        if (!body)
            return {};
        const auto figure = riggedFigure(test::sampleClip(kDialectFrames), {}, *body, JointNames::kOwn, {});
        EXPECT_TRUE(figure) << figure.error().text();
        if (!figure)
            return {};
        const std::string out = folder_.file(format == SceneFormat::kFbx ? "out.fbx" : "out.glb");
        const Status done =
            format == SceneFormat::kFbx ? writeFbx(out, *figure, {}, true) : writeGlb(out, *figure, true);
        EXPECT_TRUE(done) << path << ": " << done.error().text();
        const auto again = importMesh(out);
        EXPECT_TRUE(again && !again->clips.empty()) << path;
        PointsOfFrames points;
        for (size_t f = 0; again && done && f < kDialectFrames; ++f) {
            const RigPose pose =
                posed(*again, again->clips[0], static_cast<double>(f) * figure->clip.frame_time_s);
            points.emplace_back();
            for (const Eigen::Vector3f& p : skinned(again->skin, skinMatrices(*again, pose)).points_m)
                points.back().push_back(p.cast<double>());
        }
        return points;
    }

    /// Both formats against the plain body, in the plain body's metres.
    void expectSameAs(const PointsOfFrames& plain, const std::string& path, const std::string& what,
                      double size = 1) const {
        for (const SceneFormat format : {SceneFormat::kGlb, SceneFormat::kFbx}) {
            PointsOfFrames points = exported(path, format);
            for (auto& frame : points)
                for (Vector3d& p : frame)
                    p /= size;
            EXPECT_LT(largestGap(points, plain), 2e-4)
                << what << (format == SceneFormat::kGlb ? " glb" : " fbx");
        }
    }

    PointsOfFrames plain() const {
        return exported(written(GlbBody().glb(), "plain.glb"), SceneFormat::kGlb);
    }

    test::Folder folder_;
};

}  // namespace noctule
