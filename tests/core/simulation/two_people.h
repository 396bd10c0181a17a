// SPDX-License-Identifier: Apache-2.0
// Two people with three transceivers each, and a room with two anchors.
#pragma once

#include "core/math/rotation.h"
#include "core/simulation/cast.h"
#include "tests/core/simulation/simulated_body.h"

namespace noctule::simulation {

/// A transceiver: board and source in one housing, 1 cm apart across the board's z axis.
inline void addTransceiver(Suit& suit, const std::string& id, const std::string& segment, const Vector3d& p_m,
                           const Quaterniond& q) {
    Board board;
    board.id = id;
    board.segment = segment;
    board.p_segment_board_m = p_m;
    board.q_segment_board = q;
    suit.boards.push_back(board);
    Source source;
    source.id = id;
    source.segment = segment;
    source.board = id;
    source.p_segment_source_m = p_m + q * Vector3d(0.01, 0, 0);
    source.normal_segment = q * Vector3d::UnitZ();
    suit.sources.push_back(source);
}

inline Suit threeTransceivers() {
    Suit suit;
    suit.name = "three";
    addTransceiver(suit, "chest", "Chest", {0, 0.09, 0.13}, Quaterniond::Identity());
    addTransceiver(suit, "l_hand", "LeftHand", {0.085, 0.03, 0},
                   smallestRotation(Vector3d::UnitZ(), Vector3d::UnitY()));
    addTransceiver(suit, "hips", "Hips", {0, -0.03, 0.125}, Quaterniond::Identity());
    return suit;
}

inline Suit twoAnchors() {
    Suit room;
    room.name = "anchors";
    addTransceiver(room, "south", "", {0.1, 2.2, -2},
                   smallestRotation(Vector3d::UnitZ(), Vector3d(0, -0.4, 1)));
    addTransceiver(room, "north", "", {0, 2.2, 2},
                   smallestRotation(Vector3d::UnitZ(), Vector3d(0, -0.4, -1)));
    return room;
}

inline CastRequest twoPeople(const Scenario& scenario) {
    CastRequest request;
    for (const std::string name : {"A", "B"}) {
        CastSubject subject;
        subject.name = name;
        subject.stage.clip = madeMotion(2);
        subject.stage.suit = threeTransceivers();
        subject.place = name == "A" ? StandingPlace{0, -0.6, 0} : StandingPlace{0, 0.7, std::numbers::pi};
        request.subjects.push_back(std::move(subject));
    }
    request.room = twoAnchors();
    request.scenario = scenario;
    request.rest_seconds = 1;
    return request;
}

}  // namespace noctule::simulation
