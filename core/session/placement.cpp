// SPDX-License-Identifier: Apache-2.0
#include "core/session/placement.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/body/joint_names.h"

namespace noctule {
namespace {

constexpr const char* kIdPrefixes[] = {"l_", "r_"};
constexpr const char* kIdSuffixes[] = {"_l", "_r"};

/// Left to right in the world and in every segment's frame.
Vector3d mirrored(const Vector3d& v) {
    return {-v.x(), v.y(), v.z()};
}

/// diag(-1,1,1) R diag(1,-1,1): x and z are mirrored, y follows from both.
Quaterniond mirrored(const Quaterniond& q) {
    const Matrix3d R = q.toRotationMatrix();
    Matrix3d image;
    image << mirrored(R.col(0)), -mirrored(R.col(1)), mirrored(R.col(2));
    return Quaterniond(image).normalized();
}

/// The id of the other side, or empty.
std::string mirroredId(const std::string& id) {
    for (const int side : {0, 1}) {
        if (id.starts_with(kIdPrefixes[side]))
            return kIdPrefixes[1 - side] + id.substr(2);
        if (id.ends_with(kIdSuffixes[side]))
            return id.substr(0, id.size() - 2) + kIdSuffixes[1 - side];
    }
    return {};
}

template <class Part>
int onOtherSide(const std::vector<Part>& parts, int index) {
    const Part& part = parts.at(static_cast<size_t>(index));
    const auto indexWhere = [&](const auto& fits) {
        const auto found = std::find_if(parts.begin(), parts.end(), fits);
        return found == parts.end() ? -1 : static_cast<int>(found - parts.begin());
    };
    const std::string id = mirroredId(part.id), segment = mirroredSegment(part.segment);
    if (!id.empty())
        if (const int same_id = indexWhere([&](const Part& other) { return other.id == id; }); same_id >= 0)
            return same_id;
    const auto on_segment = [&](const Part& other) { return other.segment == segment; };
    const bool unique = std::count_if(parts.begin(), parts.end(), on_segment) == 1;
    return segment != part.segment && unique ? indexWhere(on_segment) : -1;
}

/// From a segment's joint to the next one, or to its tip.
std::optional<Vector3d> boneOf(const Skeleton& skeleton, const std::string& segment) {
    const int index = skeleton.find(segment);
    if (index < 0)
        return std::nullopt;
    for (const Joint& joint : skeleton.joints())
        if (joint.parent == index)
            return joint.offset_m;
    return skeleton.joint(index).end_m;
}

Vector3d onBone(const Vector3d& p_m, const Vector3d& from_bone, const Vector3d& to_bone, double across) {
    const Vector3d from_axis = from_bone.normalized();
    const double along_m = p_m.dot(from_axis);
    return along_m * (to_bone.norm() / from_bone.norm()) * to_bone.normalized() +
           across * (p_m - along_m * from_axis);
}

Vector3d onActor(const Vector3d& p_m, const std::string& segment, const Actor& from, const Actor& to) {
    const auto from_bone = boneOf(from.skeleton, segment), to_bone = boneOf(to.skeleton, segment);
    if (!from_bone || !to_bone || from_bone->isZero() || to_bone->isZero())
        return p_m;
    const bool known = from.height_m > 0 && to.height_m > 0;
    return onBone(p_m, *from_bone, *to_bone, known ? to.height_m / from.height_m : 1);
}

}  // namespace

Board mirrorBoard(const Board& board) {
    Board image = board;
    image.segment = mirroredSegment(board.segment);
    image.p_segment_board_m = mirrored(board.p_segment_board_m);
    image.q_segment_board = mirrored(board.q_segment_board);
    image.p_board_mic_m.y() = -board.p_board_mic_m.y();
    return image;
}

Source mirrorSource(const Source& source) {
    Source image = source;
    image.segment = mirroredSegment(source.segment);
    image.p_segment_source_m = mirrored(source.p_segment_source_m);
    image.normal_segment = mirrored(source.normal_segment);
    return image;
}

int boardOnOtherSide(const Suit& suit, int board) {
    return onOtherSide(suit.boards, board);
}

int sourceOnOtherSide(const Suit& suit, int source) {
    return onOtherSide(suit.sources, source);
}

Suit suitOnActor(const Suit& suit, const Actor& from, const Actor& to) {
    Suit placed = suit;
    for (Board& board : placed.boards)
        board.p_segment_board_m = onActor(board.p_segment_board_m, board.segment, from, to);
    for (Source& source : placed.sources)
        source.p_segment_source_m = onActor(source.p_segment_source_m, source.segment, from, to);
    return placed;
}

Suit suitOnActor(const Suit& suit, const Actor& to) {
    return suitOnActor(suit, defaultActor(), to);
}

void setMeasures(Performer& performer, const BodyMeasures& measures) {
    performer.suit = suitOnActor(performer.suit, defaultActor(performer.measures), defaultActor(measures));
    performer.measures = measures;
}

SourceDirection directionOf(const Vector3d& normal) {
    const Vector3d n = normal.normalized();
    return {std::atan2(n.x(), n.z()), std::asin(std::clamp(n.y(), -1.0, 1.0))};
}

Vector3d normalFrom(const SourceDirection& direction) {
    return {std::cos(direction.up_rad) * std::sin(direction.left_rad), std::sin(direction.up_rad),
            std::cos(direction.up_rad) * std::cos(direction.left_rad)};
}

}  // namespace noctule
