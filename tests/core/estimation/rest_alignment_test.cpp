// SPDX-License-Identifier: Apache-2.0
// Two bodies at rest in a room with four anchors, of which some hang elsewhere than stated.
#include "core/estimation/rest_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kSound_m_per_s = 344;

const std::vector<Vector3d> kOnBody{
    {0, 0.97, 0.12}, {0, 1.3, 0.13}, {0, 1.65, 0.12}, {0.75, 1.4, 0}, {-0.75, 1.4, 0}};
const std::vector<Vector3d> kHung{{1.6, 2.3, -2}, {2, 0.8, 1.7}, {-1.8, 2.2, 2}, {-2, 1.2, -1.5}};

Vector3d placed(const RestPlace& place, const Vector3d& p_m) {
    return place.p_m + axisAngle(Vector3d::UnitY(), place.heading_rad) * p_m;
}

/// What ranges say, exact, of bodies that stand there, when anchors are believed to hang `astray` elsewhere.
/// `echoes`: the second body's ranges are off by up to 0.6 m, each by another amount.
RestAlignment alignmentWith(const std::vector<Vector3d>& astray, bool echoes = false) {
    RestPlace places[2];
    places[0].p_m = {0, 0, -0.6};
    places[1].p_m = {0, 0, 0.7};
    places[1].heading_rad = std::numbers::pi;
    std::vector<RestingMember> members(3);
    for (size_t i = 0; i < 2; ++i)
        members[i] = {kOnBody, kOnBody, false, {}, 0, 1, true};
    std::vector<Vector3d> stated = kHung;
    for (size_t anchor = 0; anchor < astray.size(); ++anchor)
        stated[anchor] += astray[anchor];
    members[2] = {stated, stated, true, {0, 1, 2, 3}, 0, 0, true};
    std::vector<JointDistance> distances;
    for (int body = 0; body < 2; ++body)
        for (int source = 0; source < 5; ++source)
            for (int anchor = 0; anchor < 4; ++anchor) {
                JointDistance distance;
                distance.from = body, distance.to = 2;
                distance.source = source, distance.board = anchor;
                const Vector3d way = placed(places[body], kOnBody[static_cast<size_t>(source)]) -
                                     kHung[static_cast<size_t>(anchor)];
                distance.emission_s = 0.2;
                distance.c_m_per_s = kSound_m_per_s;
                const double off_m = echoes && body == 1 ? 0.6 * std::sin(1 + 5 * source + 11 * anchor) : 0;
                distance.arrival_s = distance.emission_s + (way.norm() + off_m) / kSound_m_per_s;
                distance.sigma_m = 0.0025;
                distances.push_back(distance);
            }
    return alignAtRest(members, distances, std::vector<ClockLine>(3), true);
}

TEST(RestAlignment, ARoomInOrderAgrees) {
    const RestAlignment found = alignmentWith({});
    EXPECT_FALSE(found.room_contradicts);
    EXPECT_TRUE(found.moved_anchors.empty());
    EXPECT_LT((found.places[1].p_m - Vector3d(0, 0, 0.7)).norm(), 0.002);
}

TEST(RestAlignment, OneMovedAnchorIsToldFromThree) {
    const RestAlignment found = alignmentWith({Vector3d::Zero(), Vector3d(0.2, 0, -0.3)});
    EXPECT_FALSE(found.room_contradicts);
    EXPECT_EQ(found.moved_anchors, std::vector<int>{1});
}

/// Its ranges contradict every anchor, those of the other body none.
TEST(RestAlignment, ABodyThatFitsNowhereDoesNotBlameTheAnchors) {
    const RestAlignment found = alignmentWith({}, true);
    EXPECT_TRUE(found.places[0].placed);
    EXPECT_FALSE(found.places[1].placed);
    EXPECT_FALSE(found.room_contradicts);
    EXPECT_TRUE(found.moved_anchors.empty());
}

/// Two that agree by chance prove nothing: the bodies stand wherever those two say.
TEST(RestAlignment, OfFourAnchorsTwoOrThreeMovedOnesAreSaidToContradict) {
    EXPECT_TRUE(
        alignmentWith({Vector3d::Zero(), Vector3d(0.2, 0, -0.3), Vector3d(0.3, 0, 0.2)}).room_contradicts);
    EXPECT_TRUE(alignmentWith({Vector3d::Zero(), Vector3d(0.4, 0.1, -0.3), Vector3d(-0.3, 0, 0.35),
                               Vector3d(0.35, 0.2, 0.3)})
                    .room_contradicts);
}

}  // namespace
}  // namespace noctule
