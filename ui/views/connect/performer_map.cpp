// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/performer_map.h"

#include "core/suit/default_suit.h"

namespace noctule::ui {

BodyMap* makeSuitMap(Studio& studio, const Actor& actor, const Suit& suit) {
    auto* map = new BodyMap(actor, suit, studio.body());
    if (!studio.body())
        studio.whenBodyIsThere(map, [map, &studio] { map->setBody(studio.body()); });
    for (int i = 0; i < map->boardCount(); ++i)
        map->setBoardState(i, Tone::kNeutral, BodyMap::tr("board %1").arg(i + 1));
    return map;
}

BodyMap* makePerformerMap(Studio& studio) {
    const SessionModel& model = studio.session();
    const Performer* performer =
        model.isOpen() ? model.session().findPerformer(model.session().current_performer) : nullptr;
    return makeSuitMap(studio, defaultActor(performer ? performer->measures : BodyMeasures{}),
                       performer ? performer->suit : defaultSuit());
}

}  // namespace noctule::ui
