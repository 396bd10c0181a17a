// SPDX-License-Identifier: Apache-2.0
// Boards and sources from one side of the body to the other, and from one body to another. Sides mirror about
// the plane x = 0 of the zero pose, in which all segments' frames are parallel.
#pragma once

#include <string>

#include "core/body/actor.h"
#include "core/session/session.h"
#include "core/suit/suit.h"

namespace noctule {

/// The board as it would sit on the other side: place and segment mirrored; along its y axis, which points
/// across the limb, it is turned over, so that x (along the limb) and z (outwards) are mirrored and the axes
/// stay right-handed. Identity and capabilities stay. Twice is the same board again.
Board mirrorBoard(const Board& board);
Source mirrorSource(const Source& source);

/// The board that a board's mirror image is about: of the mirrored id ("l_leg", "r_leg"), else the only one
/// on the mirrored segment; -1: none. Never the board itself.
int boardOnOtherSide(const Suit& suit, int board);
int sourceOnOtherSide(const Suit& suit, int source);

/// The suit as it sits on another body in the same way: along each bone in proportion to the bone's length,
/// across it in proportion to the height. Orientations stay. What sits on no segment of both bodies stays.
Suit suitOnActor(const Suit& suit, const Actor& from, const Actor& to);
/// A suit that was placed for the default actor.
Suit suitOnActor(const Suit& suit, const Actor& to);

/// New measures; the suit goes with the body.
void setMeasures(Performer& performer, const BodyMeasures& measures);

/// Where a source points, as two angles from its segment's forward axis (Z): towards the performer's left (X)
/// and upwards (Y).
struct SourceDirection {
    double left_rad = 0, up_rad = 0;
};
SourceDirection directionOf(const Vector3d& normal);
Vector3d normalFrom(const SourceDirection& direction);

}  // namespace noctule
