// SPDX-License-Identifier: Apache-2.0
// How the suit that is connected sits on its performer: what the box says of itself, and what the session
// knows of the performer and of these boards. Values only.
#pragma once

#include <optional>
#include <string>

#include "core/session/session.h"
#include "core/suit/calibration.h"
#include "devices/driver_box/hello.h"

namespace noctule::ui {

struct Wearing {
    Suit suit;  ///< boards and sources in the box's order
    Actor actor;
    std::string performer;    ///< empty: no session is open
    bool is_assigned = true;  ///< false: nobody has said which board sits where; the order is a guess
};

/// What was known before the suit was worn: of the virtual suit it stands in its take.
struct KnownWearing {
    std::optional<Calibration> calibration;
    std::optional<Actor> actor;  ///< absent: the performer's
    double rest_s = 0;           ///< each stream begins in the rest pose and holds it so long
    bool is_exact = true;        ///< boards have neither slipped nor been exchanged since
};

/// `performer` may be null. The performer's own suit is taken where all its parts are those of the box, else
/// the places that the box names, else those of the performer's suit in the box's order.
Wearing wearingOf(const link::Hello& hello, const Performer* performer, const std::optional<Actor>& actor);

}  // namespace noctule::ui
