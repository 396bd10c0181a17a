// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/performer_map.h"

#include "core/suit/default_suit.h"

namespace noctule::ui {

BodyMap* makeSuitMap(SharedContext& shared, const Actor& actor, const Suit& suit) {
    auto* map = new BodyMap(actor, suit, shared.body());
    if (!shared.body())
        shared.whenBodyIsThere(map, [map, &shared] { map->setBody(shared.body()); });
    for (int i = 0; i < map->boardCount(); ++i)
        map->setBoardState(i, Tone::kNeutral, BodyMap::tr("board %1").arg(i + 1));
    return map;
}

BodyMap* makePerformerMap(SharedContext& shared) {
    const SessionModel& model = shared.session();
    const Performer* performer =
        model.isOpen() ? model.session().findPerformer(model.session().current_performer) : nullptr;
    return makeSuitMap(shared, defaultActor(performer ? performer->measures : BodyMeasures{}),
                       performer ? performer->suit : defaultSuit());
}

}  // namespace noctule::ui
