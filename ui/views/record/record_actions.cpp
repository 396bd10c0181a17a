// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_actions.h"

#include "ui/models/place_reset.h"
#include "ui/views/record/record_bar.h"
#include "ui/views/record/record_center.h"
#include "ui/views/record/record_page.h"

namespace noctule::ui {

RecordActions::RecordActions(RecordPage& page, PlaceReset& place)
    : PageActions(page), page_(page), place_(place) {
    record_ = add("record/record", tr("Record or stop"), Qt::Key_Space, [this] { page_.run().press(); });
    end_countdown_ = add("record/end_countdown", tr("End the countdown"), Qt::Key_Escape, [this] {
        page_.run().endCountdown();
        place_.endCountdown();
    });
    marker_ = add("record/marker", tr("Marker now"), Qt::Key_M, [this] { page_.run().addMarker(); });
    note_ = add("record/note", tr("Note now"), Qt::Key_N, [this] { page_.center().bar().writeNote(); });
    add("record/take_name", tr("Take name"), Qt::Key_T, [this] { page_.center().bar().editName(); });
    for (QAction* action : all())
        action->setAutoRepeat(false);  // a key that is held would begin and end takes
    connect(&page.run(), &RecordRun::changed, this, &RecordActions::refresh);
    connect(&place, &PlaceReset::changed, this, &RecordActions::refresh);
    refresh();
}

void RecordActions::refresh() {
    const RecordRun::State state = page_.run().state();
    for (QAction* action : all())
        action->setEnabled(state != RecordRun::State::kNoSuit);
    end_countdown_->setEnabled(state == RecordRun::State::kCountdown || place_.isCounting());
    for (QAction* action : {marker_, note_})
        action->setEnabled(state == RecordRun::State::kRecording);
}

}  // namespace noctule::ui
