// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/shared_context.h"
#include "ui/views/connect/body_map.h"

namespace noctule::ui {

/// Boards with their numbers; the studio's body mesh joins in when it has been loaded.
BodyMap* makeSuitMap(SharedContext& shared, const Actor& actor, const Suit& suit);
/// The suit of the present performer on that performer's body, else the suit that Noctule comes with.
BodyMap* makePerformerMap(SharedContext& shared);

}  // namespace noctule::ui
