// SPDX-License-Identifier: Apache-2.0
#include "ui/models/place_reset.h"

#include <QPointer>
#include <QUndoCommand>
#include <algorithm>

#include "ui/models/countdown_setting.h"

namespace noctule::ui {
namespace {

constexpr int kLookAtCountdown_ms = 33;
constexpr int kWithoutCountdown_s = 5;  ///< where Record has none

bool showsBody(const LiveSuit& suit) {
    const auto frame = suit.frame();
    return frame && frame->pose && frame->pose->pose && suit.canMoveBody();
}

}  // namespace

/// Void, and gone from the stack, once its stream is over.
class PlaceStep : public QUndoCommand {
public:
    struct Labels {
        QString done, undone;
    };
    PlaceStep(PlaceReset& reset, const std::shared_ptr<FloorMove>& floor, const FloorMove& after,
              Labels labels)
        : QUndoCommand(PlaceReset::tr("Reset heading and place")),
          reset_(&reset),
          floor_(floor),
          before_(*floor),
          after_(after),
          labels_(std::move(labels)) {}

    void redo() override { move(after_, labels_.done); }
    void undo() override { move(before_, labels_.undone); }

private:
    void move(const FloorMove& to, const QString& label) {
        const auto floor = floor_.lock();
        if (!floor || !reset_)
            return setObsolete(true);
        *floor = to;
        reset_->tellMoved(label);
    }

    QPointer<PlaceReset> reset_;
    std::weak_ptr<FloorMove> floor_;
    FloorMove before_, after_;
    Labels labels_;
};

PlaceReset::PlaceReset(LiveSuits& suits, SessionModel& session, QSettings& settings, Countdown::Clock now_ms,
                       QObject* parent)
    : QObject(parent),
      suits_(suits),
      session_(session),
      settings_(settings),
      countdown_(CountdownSetting::get().seconds(), std::move(now_ms)) {
    timer_.setInterval(kLookAtCountdown_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &PlaceReset::look);
    connect(&suits, &LiveSuits::changed, this, &PlaceReset::follow);
    suits.follow(&LiveSuit::frameChanged, this, &PlaceReset::follow);
    suits.follow(&LiveSuit::wearingChanged, this, &PlaceReset::follow);
    why_not_ = whyNot();
}

void PlaceReset::follow() {
    const QString now = whyNot();
    if (std::exchange(why_not_, now) != now)
        emit changed();
}

QString PlaceReset::whyNot() const {
    const auto connected = suits_.connected();
    if (connected.empty())
        return tr("No suit is connected. Connect one first.");
    if (std::ranges::any_of(connected, [](const SuitInUse* worn) { return worn->suit.suit().isFixed(); }))
        return tr("The room's anchors give heading and place.");
    const LiveSuit& suit = suits_.current().suit;
    if (suit.isSilent())
        return tr("No sound arrives from the suit.");
    return showsBody(suit) ? QString() : tr("No body is shown live.");
}

bool PlaceReset::tones() const {
    return settings_.value(kTonesSetting, true).toBool();
}

void PlaceReset::stopCounting() {
    countdown_.end();
    if (timer_.isActive()) {
        timer_.stop();
        emit changed();
    }
}

void PlaceReset::endCountdown() {
    if (!countdown_.runs())
        return;
    stopCounting();
    emit said(tr("The countdown has ended. Heading and place stay."));
}

void PlaceReset::reset() {
    stopCounting();
    if (const QString why = whyNot(); !why.isEmpty()) {
        Countdown::cue(tr("Heading and place were not reset"), tones());
        emit said(why);
        return;
    }
    const SuitInUse& worn = suits_.current();
    const QString who = suits_.nameOf(worn);
    PlaceStep::Labels labels{tr("heading and place reset"), tr("heading and place reset, taken back")};
    if (suits_.areSeveral())
        for (QString* label : {&labels.done, &labels.undone})
            *label = tr("%1: %2", "performer, what a marker in the take says").arg(who, *label);
    session_.undoStack().push(
        new PlaceStep(*this, worn.floor, moveToOrigin(*worn.suit.frame()->pose->pose), std::move(labels)));
    Countdown::cue(tr("Heading and place are here"), tones());
    emit wasReset(who);
}

void PlaceReset::resetLater() {
    if (countdown_.runs())
        return endCountdown();
    if (!whyNot().isEmpty())
        return reset();  // says so
    const int seconds = CountdownSetting::get().seconds();
    countdown_.setSeconds(seconds > 0 ? seconds : kWithoutCountdown_s);
    counted_ = &suits_.current();
    countdown_.start(tones());
    timer_.start();
    emit changed();
    emit said(tr("Heading and place are reset in %1\u00A0s. The same key ends the countdown.")
                  .arg(countdown_.seconds()));
}

void PlaceReset::look() {
    if (countdown_.runs() && counted_ != &suits_.current())
        return endCountdown();  // somebody else is looked at now
    if (countdown_.look(tones()))
        reset();
}

void PlaceReset::tellMoved(const QString& label) {
    if (suits_.phase() == LiveSuit::Phase::kRecording)
        emit marked(suits_.addMarker(label), label);
    emit moved();
}

}  // namespace noctule::ui
