// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer_map.h"

#include "core/suit/default_suit.h"

namespace noctule::ui {

BodyMap* makePerformerMap(Studio& studio) {
    BodyMeasures measures;
    Suit suit = defaultSuit();
    if (studio.session().isOpen()) {
        const Session& session = studio.session().session();
        if (const Performer* performer = session.findPerformer(session.current_performer)) {
            measures = performer->measures;
            suit = performer->suit;
        }
    }
    auto* map = new BodyMap(defaultActor(measures), suit, studio.body());
    if (!studio.body())
        studio.whenBodyIsThere(map, [map, &studio] { map->setBody(studio.body()); });
    for (int i = 0; i < map->boardCount(); ++i)
        map->setBoardState(i, Tone::kNeutral, BodyMap::tr("board %1").arg(i + 1));
    return map;
}

}  // namespace noctule::ui
