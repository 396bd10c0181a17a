// SPDX-License-Identifier: Apache-2.0
#include "ui/models/wearing.h"

#include <algorithm>

#include "core/session/placement.h"
#include "core/suit/default_suit.h"

namespace noctule::ui {
namespace {

/// As those of `places` one after the other; the box's own names and numbers stay.
Suit inOrder(Suit box, const Suit& places) {
    for (size_t i = 0; i < std::min(box.boards.size(), places.boards.size()); ++i) {
        const Board& place = places.boards[i];
        box.boards[i].segment = place.segment;
        box.boards[i].p_segment_board_m = place.p_segment_board_m;
        box.boards[i].q_segment_board = place.q_segment_board;
    }
    for (size_t i = 0; i < std::min(box.sources.size(), places.sources.size()); ++i) {
        const Source& place = places.sources[i];
        box.sources[i].segment = place.segment;
        box.sources[i].p_segment_source_m = place.p_segment_source_m;
        box.sources[i].normal_segment = place.normal_segment;
    }
    return box;
}

}  // namespace

Wearing wearingOf(const link::Hello& hello, const Performer* performer, const std::optional<Actor>& actor) {
    Actor performers = defaultActor(performer ? performer->measures : BodyMeasures{});
    if (performer)
        performers.name = performer->name;
    Wearing wearing;
    wearing.performer = performer ? performer->name : "";
    wearing.actor = actor.value_or(performers);
    const auto own = performer ? link::placedBySerial(hello.suit, performer->suit)
                               : Result<Suit>(Error{ErrorKind::kUnusable, "no performer", ""});
    if (own) {
        wearing.suit = actor ? suitOnActor(*own, performers, *actor) : *own;
    } else if (hello.suit_is_placed) {
        wearing.suit = actor ? hello.suit : suitOnActor(hello.suit, wearing.actor);
    } else {
        wearing.suit = performer ? inOrder(hello.suit, performer->suit)
                                 : suitOnActor(inOrder(hello.suit, defaultSuit()), wearing.actor);
        wearing.is_assigned = false;
    }
    return wearing;
}

}  // namespace noctule::ui
