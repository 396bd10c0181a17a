// SPDX-License-Identifier: Apache-2.0
#include "core/suit/default_suit.h"

namespace noctule {

namespace {

/// Where a board sits: on the skin (flesh of the default actor plus 1 cm), x along the bone, z out of the
/// body.
struct Place {
    const char* id;
    const char* segment;
    Vector3d p_segment_board_m;
    Vector3d along;
    Vector3d outward;
};

Board makeBoard(const Place& place, const std::string& id, const std::string& segment) {
    const Vector3d x = place.along.normalized();
    const Vector3d z = place.outward.normalized();
    Matrix3d R_segment_board;
    R_segment_board << x, z.cross(x), z;
    Board board;
    board.id = id;
    board.segment = segment;
    board.p_segment_board_m = place.p_segment_board_m;
    board.q_segment_board = Quaterniond(R_segment_board).normalized();
    return board;
}

/// Left to right: x changes its sign.
Vector3d mirrored(const Vector3d& v) {
    return {-v.x(), v.y(), v.z()};
}

Source makeSource(const char* id, const char* segment, const Vector3d& p_m, const Vector3d& direction) {
    Source source;
    source.id = id;
    source.segment = segment;
    source.p_segment_source_m = p_m;
    source.normal_segment = direction.normalized();
    return source;
}

std::vector<Board> defaultBoards() {
    // All in front, where the sources' sound goes; a back full of boards would be deaf.
    const std::vector<Place> middle{
        {"hips", "Hips", {0, -0.03, 0.125}, Vector3d::UnitY(), Vector3d::UnitZ()},
        {"spine", "Spine", {0, 0.06, 0.122}, Vector3d::UnitY(), Vector3d::UnitZ()},
        {"chest", "Chest", {0, 0.09, 0.13}, Vector3d::UnitY(), Vector3d::UnitZ()},
        {"head", "Head", {0, 0.07, 0.118}, Vector3d::UnitY(), Vector3d::UnitZ()},
    };
    // T pose: arms along +-X, the back of the hand up, the thumb in front.
    const std::vector<Place> left{
        {"shoulder", "Shoulder", {0.09, 0.035, 0.03}, Vector3d::UnitX(), Vector3d::UnitY()},
        {"arm", "Arm", {0.2, 0, 0.055}, Vector3d::UnitX(), Vector3d::UnitZ()},
        {"forearm", "ForeArm", {0.21, 0.029, 0.029}, Vector3d::UnitX(), {0, 1, 1}},
        {"hand", "Hand", {0.085, 0.026, 0.015}, Vector3d::UnitX(), {0, 26, 15}},
        {"upleg", "UpLeg", {0.02, -0.24, 0.077}, -Vector3d::UnitY(), Vector3d::UnitZ()},
        {"leg", "Leg", {0, -0.2, 0.06}, -Vector3d::UnitY(), Vector3d::UnitZ()},
        {"foot", "Foot", {0, 0.011, 0.084}, {0, -5, 11}, {0, 11, 5}},
    };
    std::vector<Board> boards;
    for (const Place& place : middle)
        boards.push_back(makeBoard(place, place.id, place.segment));
    for (const Place& place : left)
        boards.push_back(makeBoard(place, std::string("l_") + place.id, std::string("Left") + place.segment));
    for (Place place : left) {
        place.p_segment_board_m = mirrored(place.p_segment_board_m);
        place.along = mirrored(place.along);
        boards.push_back(
            makeBoard(place, std::string("r_") + place.id, std::string("Right") + place.segment));
    }
    return boards;
}

std::vector<Source> defaultSources() {
    return {
        makeSource("chest_l", "Chest", {0.09, 0.13, 0.12}, {0.5, 0, 0.85}),
        makeSource("chest_r", "Chest", {-0.09, 0.13, 0.12}, {-0.5, 0, 0.85}),
        makeSource("rib_l", "Chest", {0.1, 0.02, 0.115}, {0.7, -0.1, 0.7}),
        makeSource("rib_r", "Chest", {-0.1, 0.02, 0.115}, {-0.7, -0.1, 0.7}),
        makeSource("navel", "Spine", {0, 0.03, 0.135}, {0, -0.35, 0.94}),
        makeSource("belly_l", "Hips", {0.1, 0, 0.115}, {0.4, -0.3, 0.86}),
        makeSource("belly_r", "Hips", {-0.1, 0, 0.115}, {-0.4, -0.3, 0.86}),
        makeSource("hat", "Head", {0, 0.13, 0.2}, {0, -1, 0.1}),
    };
}

}  // namespace

Suit defaultSuit() {
    return {"Noctule 18/8", defaultBoards(), defaultSources()};
}

Suit paperSuit() {
    Suit suit = defaultSuit();
    suit.name = "Vlasic 2007";
    for (Board& board : suit.boards) {
        board.gyro_full_scale_rad_per_s = 6.5;
        board.accel_full_scale_m_per_s2 = 4 * kStandardGravity_m_per_s2;
    }
    return suit;
}

}  // namespace noctule
