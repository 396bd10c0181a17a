// SPDX-License-Identifier: Apache-2.0
// The performer as a flat figure seen from the front, every segment a surface of its own: the studio's body
// mesh in a stance, painted once per size and colour. Where boards and sources sit comes from the same
// pose, so that drawing and suit cannot disagree.
#pragma once

#include <QColor>
#include <QImage>
#include <QPointF>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/body/actor.h"
#include "core/mesh/skinned_mesh.h"
#include "core/suit/suit.h"

namespace noctule::ui {

class BodyFigure {
public:
    enum class Stance {
        kOpen,  ///< arms half-way down, legs apart: nothing hides anything else
        kRest,  ///< the rest pose that calibrations take for granted
    };
    /// Without a mesh the actor's capsules stand for the flesh.
    BodyFigure(const Actor& actor, const std::shared_ptr<const SkinnedMesh>& mesh,
               Stance stance = Stance::kOpen);
    /// In any pose, with room for raised arms, so that all poses of one body are drawn at one scale.
    BodyFigure(const Actor& actor, const std::shared_ptr<const SkinnedMesh>& mesh, const Pose& pose);
    /// The same one as last time for the same bones and mesh: what it has painted is not painted again.
    static std::shared_ptr<const BodyFigure> of(const Actor& actor,
                                                const std::shared_ptr<const SkinnedMesh>& mesh,
                                                Stance stance = Stance::kOpen);

    /// Metres in the front view: x to the right of the picture (the performer's left), y up from the floor.
    QPointF board(const Board& board) const;
    QPointF source(const Source& source) const;
    /// Of everything drawn, metres.
    double height_m() const { return height_m_; }
    double half_width_m() const { return half_width_m_; }

    /// Of the given height; segments in `body`, those in `marked` in their own colour, with thin gaps in
    /// between.
    QImage paint(int height_px, const QColor& body, const std::map<std::string, QColor>& marked = {}) const;
    /// The same scale as paint(): pixels per metre.
    double scale(int height_px) const { return height_px / height_m_; }

private:
    using Corners = std::array<QPointF, 3>;
    /// What part of the flesh at each corner moves with a segment, 0 to 1.
    struct Share {
        int segment;
        std::array<double, 3> weights;
    };
    struct Face {
        Corners corners_m;
        std::vector<Share> shares;
    };
    void stand(const Actor& actor, const std::shared_ptr<const SkinnedMesh>& mesh);
    void addMesh(const SkinnedMesh& mesh);
    void addCapsules(const Actor& actor);
    QPointF place(const std::string& segment, const Vector3d& p_segment_m) const;
    int segmentIndex(const std::string& name);
    static void fill(QImage& image, const Corners& corners, const std::vector<Share>& shares);
    static std::vector<Share> sharesOf(const std::array<const SkinnedVertex*, 3>& vertices,
                                       const std::vector<int>& segment_of_bone);
    QImage segmentImage(int height_px) const;

    Skeleton skeleton_;
    GlobalPose stance_;
    std::vector<Face> faces_;  ///< far ones first
    std::vector<std::string> segments_;
    double height_m_ = 1, half_width_m_ = 0.5;
    mutable QImage segment_image_;  ///< the last one
};

}  // namespace noctule::ui
