// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_actions.h"

#include "ui/views/record/record_bar.h"
#include "ui/views/record/record_center.h"
#include "ui/views/record/record_page.h"

namespace noctule::ui {

RecordActions::RecordActions(RecordPage& page) : QObject(&page), page_(page) {
    record_ = add(tr("Record or stop"), Qt::Key_Space, [this] { page_.run().press(); });
    end_countdown_ = add(tr("End the countdown"), Qt::Key_Escape, [this] { page_.run().endCountdown(); });
    marker_ = add(tr("Marker now"), Qt::Key_M, [this] { page_.run().addMarker(); });
    note_ = add(tr("Note now"), Qt::Key_N, [this] { page_.center().bar().writeNote(); });
    add(tr("Take name"), Qt::Key_T, [this] { page_.center().bar().editName(); });
    connect(&page.run(), &RecordRun::changed, this, &RecordActions::refresh);
    refresh();
}

QAction* RecordActions::add(const QString& text, const QKeySequence& keys, std::function<void()> act) {
    auto* action = new QAction(text, this);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, std::move(act));
    page_.addAction(action);
    all_ += action;
    return action;
}

void RecordActions::refresh() {
    const RecordRun::State state = page_.run().state();
    for (QAction* action : all_)
        action->setEnabled(state != RecordRun::State::kNoSuit);
    end_countdown_->setEnabled(state == RecordRun::State::kCountdown);
    for (QAction* action : {marker_, note_})
        action->setEnabled(state == RecordRun::State::kRecording);
}

bool RecordActions::handleKey(const QKeyEvent& event) {
    if (event.modifiers() & ~Qt::KeypadModifier)
        return false;
    for (QAction* action : all_)
        if (action->isEnabled() && action->shortcut() == QKeySequence(event.key())) {
            if (!event.isAutoRepeat())
                action->trigger();
            return true;
        }
    return false;
}

}  // namespace noctule::ui
