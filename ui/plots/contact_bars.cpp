// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/contact_bars.h"

#include <algorithm>
#include <cmath>

#include "ui/models/part_names.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

/// Of a contact that is added: a short step's.
constexpr double kNewContact_s = 0.2;

}  // namespace

int laneOf(const std::string& foot) {
    return QString::fromStdString(foot).contains(QLatin1String("Right"), Qt::CaseInsensitive) ? 1 : 0;
}

/// Within the contacts as they are now.
const FootContact* ContactBars::contactAt(const ContactPlace& place) const {
    const auto feet = review_.contacts().contacts();
    return feet ? findContact(*feet, place) : nullptr;
}

QString ContactBars::wordsOf(const ContactPlace& place) const {
    const FootContact* contact = contactAt(place);
    if (!contact)
        return {};
    const QString words = contact->by_hand ? tr("%1 stands from %2 to %3, set by hand", "a foot, two times")
                                           : tr("%1 stands from %2 to %3, found", "a foot, two times");
    return words.arg(segmentName(place.foot), timeText(contact->from_s, 2), timeText(contact->to_s, 2));
}

std::optional<QPoint> ContactBars::chosenPoint(const ContactLanes& lanes) const {
    if (chosen_.foot.empty())
        return std::nullopt;
    const FootContact* contact = chosenContact();
    const double t_s = contact ? (contact->from_s + contact->to_s) / 2 : review_.time().time();
    const QRect& row = lanes.feet[static_cast<size_t>(laneOf(chosen_.foot))];
    return QPoint(std::clamp(qRound(lanes.xOf(t_s)), row.left(), row.right()), row.center().y());
}

void ContactBars::letGo() {
    chosen_ = {};
    drag_.reset();
}

/// As the contacts name it, else the usual way.
std::string ContactBars::footOf(int lane) const {
    if (const auto feet = review_.contacts().contacts())
        for (const FootContacts& foot : *feet)
            if (laneOf(foot.foot) == lane)
                return foot.foot;
    return lane == 0 ? "LeftFoot" : "RightFoot";
}

std::optional<ContactBars::Hit> ContactBars::hitAt(const ContactLanes& lanes, const QPoint& position) const {
    const auto feet = review_.contacts().contacts();
    if (!feet)
        return std::nullopt;
    for (int lane = 0; lane < 2; ++lane) {
        const QRect& row = lanes.feet[static_cast<size_t>(lane)];
        if (!row.adjusted(0, -lanes.reach_px, 0, lanes.reach_px).contains(position))
            continue;
        Hit hit{lane, {footOf(lane)}, Part::kAll};
        const double beside_s = lanes.reach_px / lanes.px_per_s, t_s = lanes.timeAt(position.x());
        double nearest_s = beside_s;
        for (int i = 0; const FootContact* contact = findContact(*feet, {hit.place.foot, i}); ++i) {
            if (t_s < contact->from_s - beside_s || t_s > contact->to_s + beside_s)
                continue;
            // A short bar is taken by its ends from outside, and whole in its middle.
            const double within_s = std::min(beside_s, (contact->to_s - contact->from_s) / 4);
            const bool inside = t_s >= contact->from_s + within_s && t_s <= contact->to_s - within_s;
            if (inside)
                return Hit{lane, {hit.place.foot, i}, Part::kAll};
            const double to_from_s = std::abs(t_s - contact->from_s), to_to_s = std::abs(t_s - contact->to_s);
            if (std::min(to_from_s, to_to_s) > nearest_s)
                continue;
            nearest_s = std::min(to_from_s, to_to_s);
            hit = {lane, {hit.place.foot, i}, to_from_s < to_to_s ? Part::kFrom : Part::kTo};
        }
        return hit;
    }
    return std::nullopt;
}

QString ContactBars::tooltipAt(const ContactLanes& lanes, const QPoint& position) const {
    const auto hit = hitAt(lanes, position);
    if (!hit)
        return {};
    if (hit->place.index < 0)
        return tr("%1 does not stand here. Double-click to set a contact.", "a foot")
            .arg(segmentName(hit->place.foot));
    return wordsOf(hit->place);
}

bool ContactBars::isOnEnd(const ContactLanes& lanes, const QPoint& position) const {
    const auto hit = hitAt(lanes, position);
    return hit && hit->place.index >= 0 && hit->part != Part::kAll;
}

bool ContactBars::press(const ContactLanes& lanes, const QPoint& position) {
    const auto hit = hitAt(lanes, position);
    letGo();
    if (!hit)
        return false;
    chosen_ = hit->place;
    const FootContact* contact = chosenContact();
    if (!contact)
        return false;
    drag_ = Drag{hit->place, *contact, *contact, hit->part, lanes.timeAt(position.x())};
    return true;
}

bool ContactBars::drag(const ContactLanes& lanes, const QPoint& position) {
    if (!drag_)
        return false;
    const double moved_s = lanes.timeAt(position.x()) - drag_->grabbed_s;
    FootContact wanted = drag_->before;
    const double length_s = wanted.to_s - wanted.from_s, end_s = review_.time().duration();
    switch (drag_->part) {
        case Part::kFrom:
            wanted.from_s = std::min(wanted.from_s + moved_s, wanted.to_s - review_.time().frameStep());
            break;
        case Part::kTo:
            wanted.to_s = std::max(wanted.to_s + moved_s, wanted.from_s + review_.time().frameStep());
            break;
        case Part::kAll:
            wanted.from_s = std::clamp(wanted.from_s + moved_s, 0.0, std::max(0.0, end_s - length_s));
            wanted.to_s = wanted.from_s + length_s;
            break;
    }
    const bool is_still = std::abs(moved_s * lanes.px_per_s) < 1;
    drag_->now = is_still ? drag_->before : review_.contacts().fitting(wanted);
    return true;
}

bool ContactBars::release() {
    if (!drag_)
        return false;
    const Drag ended = *drag_;
    drag_.reset();
    if (ended.now.from_s != ended.before.from_s || ended.now.to_s != ended.before.to_s)
        put(ended.place, ended.now);
    return true;
}

bool ContactBars::doubleClick(const ContactLanes& lanes, const QPoint& position) {
    const auto hit = hitAt(lanes, position);
    if (!hit)
        return false;
    if (hit->place.index < 0)
        add(hit->place.foot, lanes.timeAt(position.x()));
    return true;
}

/// What the operator has set holds from then on for all results: worth a word the first time.
void ContactBars::tellFirst(bool were_edited) {
    if (!were_edited && review_.contacts().areEdited())
        review_.shared().say(tr("The contacts are yours now. Reprocess the take to hold the body by them."));
}

void ContactBars::put(const ContactPlace& place, const FootContact& wanted) {
    const bool were_edited = review_.contacts().areEdited();
    chosen_ = review_.contacts().put(place, wanted);
    tellFirst(were_edited);
}

/// As long as a short step, as far as the contacts beside it leave room; nothing on one that is there.
void ContactBars::add(const std::string& foot, double t_s) {
    const auto feet = review_.contacts().contacts();
    if (!feet)
        return;
    const double step_s = review_.time().frameStep();
    FootContact wanted{t_s - kNewContact_s / 2, t_s + kNewContact_s / 2};
    for (int i = 0; const FootContact* other = findContact(*feet, {foot, i}); ++i) {
        if (other->from_s <= t_s && t_s <= other->to_s) {
            chosen_ = {foot, i};
            return;
        }
        if (other->to_s < t_s)
            wanted.from_s = std::max(wanted.from_s, std::min(t_s, other->to_s + 2 * step_s));
        else
            wanted.to_s = std::min(wanted.to_s, std::max(t_s, other->from_s - 2 * step_s));
    }
    put({foot}, wanted);
}

void ContactBars::addAtCursor() {
    add(chosen_.foot.empty() ? footOf(0) : chosen_.foot, review_.time().time());
}

void ContactBars::removeChosen() {
    if (!chosenContact())
        return;
    const bool were_edited = review_.contacts().areEdited();
    review_.contacts().remove(chosen_);
    chosen_.index = -1;
    tellFirst(were_edited);
}

void ContactBars::restoreFound() {
    letGo();
    review_.contacts().restoreFound();
}

void ContactBars::beginAtCursor() {
    const FootContact* contact = chosenContact();
    if (contact && review_.time().time() < contact->to_s)
        put(chosen_, {review_.time().time(), contact->to_s});
}

void ContactBars::endAtCursor() {
    const FootContact* contact = chosenContact();
    if (contact && review_.time().time() > contact->from_s)
        put(chosen_, {contact->from_s, review_.time().time()});
}

void ContactBars::chooseAt(int lane) {
    if (const auto feet = review_.contacts().contacts())
        chosen_ = contactNear(*feet, footOf(lane), review_.time().time());
}

void ContactBars::walk(int direction) {
    const auto feet = review_.contacts().contacts();
    const ContactPlace next{chosen_.foot, chosen_.index + direction};
    const FootContact* contact = feet ? findContact(*feet, next) : nullptr;
    if (!contact)
        return;
    chosen_ = next;
    review_.time().setTime(contact->from_s);
}

bool ContactBars::edit(int key) {
    switch (key) {
        case Qt::Key_Insert:
            addAtCursor();
            return true;
        case Qt::Key_Up:
        case Qt::Key_Down:
            chooseAt(key == Qt::Key_Up ? 0 : 1);
            return true;
        case Qt::Key_I:
            beginAtCursor();
            return hasChosen();
        case Qt::Key_O:
            endAtCursor();
            return hasChosen();
        case Qt::Key_Delete:
            if (!hasChosen())
                return false;
            removeChosen();
            return true;
        case Qt::Key_Escape:
            if (chosen_.foot.empty())
                return false;
            letGo();
            return true;
        default:
            return false;
    }
}

bool ContactBars::key(const QKeyEvent& event) {
    if (!review_.contacts().contacts())
        return false;
    const bool walks = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right;
    if (event.modifiers() == Qt::ControlModifier && walks && hasChosen()) {
        walk(event.key() == Qt::Key_Left ? -1 : 1);
        return true;
    }
    return (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier && edit(event.key());
}

void ContactBars::fillEdits(QMenu& menu) {
    const auto offer = [&](const QString& text, const QKeySequence& keys, bool is_possible, auto act) {
        QAction* action = menu.addAction(text, act);
        action->setShortcut(keys);
        action->setEnabled(is_possible);
    };
    const FootContact* contact = chosenContact();
    const double now_s = review_.time().time();
    if (!contact) {
        offer(tr("Set a contact at the cursor"), Qt::Key_Insert, true, [this] { addAtCursor(); });
    } else {
        offer(tr("Begin at the cursor"), Qt::Key_I, now_s < contact->to_s, [this] { beginAtCursor(); });
        offer(tr("End at the cursor"), Qt::Key_O, now_s > contact->from_s, [this] { endAtCursor(); });
        offer(tr("Delete contact"), QKeySequence::Delete, true, [this] { removeChosen(); });
    }
    menu.addSeparator();
    offer(tr("Back to what was found"), {}, review_.contacts().areEdited(), [this] { restoreFound(); });
}

bool ContactBars::fillMenu(QMenu& menu, const ContactLanes& lanes, const QPoint& position) {
    const auto hit = hitAt(lanes, position);
    if (!hit)
        return false;
    chosen_ = hit->place;
    fillEdits(menu);
    return true;
}

}  // namespace noctule::ui
