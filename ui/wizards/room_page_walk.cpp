// SPDX-License-Identifier: Apache-2.0
// The page of the room while somebody walks: beginning and end, what is said meanwhile, and of a walk that
// failed.
#include <QBoxLayout>
#include <algorithm>

#include "ui/language/core_words.h"
#include "ui/style/words.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/wizards/hold_ring.h"
#include "ui/wizards/room_drawing.h"
#include "ui/wizards/room_page.h"

namespace noctule::ui {

void RoomPage::pressWalk() {
    if (walk_->isRunning())
        return walk_->end();
    follows_walk_ = true;
    opens_walked_ = false;
    walked_.clear();
    walk_->begin();
    if (!walk_->isRunning())
        emit studio_.failed(tr("The walk did not begin"), walk_->trouble(), About::kCapture);
    else
        walk_button_->setFocus();  // the page's own button goes, and the next key would leave the walk
}

/// Its take becomes the one that is open; followRun() has it surveyed then.
void RoomPage::openWalked(const QString& take) {
    SessionModel& session = studio_.session();
    const int index = session.isOpen() ? session.session().findTake(take.toStdString()) : -1;
    if (!follows_walk_ || index < 0)
        return;
    walked_ = session.takePath(index);
    opens_walked_ = true;
    session.setCurrentTake(index);
    refresh();
}

void RoomPage::showWalk() {
    switch (walk_->phase()) {
        case RoomWalk::Phase::kStarting:
            headline_->setText(tr("The recording begins"));
            break;
        case RoomWalk::Phase::kStanding:
            headline_->setText(tr("Stand still in the rest pose"));
            break;
        case RoomWalk::Phase::kSaving:
            headline_->setText(tr("The take is being saved"));
            break;
        default:
            headline_->setText(tr("Walk slowly past all %n anchor(s)", nullptr, walk_->anchorCount()));
            break;
    }
    walk_words_->setText(walkWords());
    const QString caution = walk_->caution();
    words_->setText(caution.isEmpty() ? tr("What was recorded is kept as a take when you leave.") : caution);
    if (const SurveyedTake* found = walk_->found()) {
        note_->setText(tr("Nobody has to measure: places come from what the anchors and the suit hear."));
        showSurvey(*found, SurveyStage::kWalking);
    }
    showTime();
}

void RoomPage::showTime() {
    if (!walk_->isRunning())
        return;
    const double seconds = walk_->seconds(), usual_s = walk_->times().usual_s;
    const int now = static_cast<int>(seconds);
    lead_->setText(seconds <= usual_s ? tr("Survey, %1 of %2 s").arg(now).arg(static_cast<int>(usual_s))
                                      : tr("Survey, %1 s").arg(now));
    const bool is_good = walk_->found() && RoomWalk::isEnough(walk_->found()->survey);
    ring_->show(std::min(1.0, seconds / usual_s), usual_s, is_good ? Tone::kOk : Tone::kAccent);
}

/// What to do now.
QString RoomPage::walkWords() const {
    if (walk_->phase() == RoomWalk::Phase::kStanding)
        return tr(
            "In the middle, in sight of all anchors. The origin becomes where you stand, forward is "
            "where you face.");
    if (walk_->phase() != RoomWalk::Phase::kWalking)
        return {};
    if (walk_->hindrance())
        return tr("Nothing is found yet: %1").arg(coreWords(*walk_->hindrance()));
    if (!walk_->found())
        return tr("The first places come after some seconds of walking.");
    QStringList missing;
    const auto& anchors = walk_->found()->survey.anchors;
    for (size_t i = 0; i < anchors.size(); ++i)
        if (stateOf(anchors[i]).tone != Tone::kOk)
            missing << QString::number(i + 1);
    if (missing.isEmpty())
        return tr("Every anchor is good. Walk on until the survey ends by itself.");
    return tr("Not good yet: anchor %1. Walk slowly past, and turn.", nullptr, int(missing.size()))
        .arg(missing.join(", "));
}

/// Whatever take is open: nothing else tells it.
void RoomPage::showWalkTrouble() {
    if (walk_->trouble().isEmpty())
        return;
    const QString name = walk_->takeName();
    const bool is_open = studio_.take().isOpen() && studio_.take().path() == walked_;
    QString text = withFullStop(walk_->trouble());
    if (name.isEmpty())
        text += ' ' + tr("Mend this, then walk once more.");
    else if (!is_open && !opens_walked_)
        text += ' ' + tr("Its take is %1: open it to survey the room from it.").arg(name);
    walk_trouble_->addWidget(name.isEmpty()
                                 ? new ProblemCard(Tone::kError, tr("The walk brought no take"), text)
                                 : new ProblemCard(Tone::kWarn, tr("The walk ended by itself"), text));
}

}  // namespace noctule::ui
