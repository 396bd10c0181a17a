// SPDX-License-Identifier: Apache-2.0
// Which suits are connected and who wears them; their take is in live_suits_take.cpp.
#include "ui/models/live_suits.h"

#include <algorithm>

#include "core/suit/default_suit.h"
#include "devices/live/suit_voices.h"

namespace noctule::ui {
namespace {

constexpr int kLookAtTake_ms = 16;

QString textIn(const std::string& text) {
    return QString::fromStdString(text);
}

bool hasSuit(const SuitInUse& worn) {
    return worn.suit.phase() != LiveSuit::Phase::kNone;
}

}  // namespace

LiveSuits::LiveSuits(Jobs& jobs, SessionModel& session, LiveSuit::Surroundings surroundings, Folders folders,
                     QObject* parent)
    : QObject(parent),
      jobs_(jobs),
      session_(session),
      surroundings_(std::move(surroundings)),
      folders_(std::move(folders)),
      storage_(jobs, folders_.takes) {
    timer_.setInterval(kLookAtTake_ms);
    connect(&timer_, &QTimer::timeout, this, &LiveSuits::lookAtTake);
    current_ = &make();
    connect(&session_, &SessionModel::opened, this, &LiveSuits::assignPerformers);
    connect(&session_, &SessionModel::changed, this, &LiveSuits::assignPerformers);
    connect(&session_, &SessionModel::opened, &storage_, &StorageWatch::look);
}

SuitInUse& LiveSuits::make() {
    all_.push_back(std::make_unique<SuitInUse>(
        jobs_, session_, surroundings_, [this] { return storageLeft_s(); }, folders_.suits));
    SuitInUse& worn = *all_.back();
    connect(&worn.suit, &LiveSuit::failed, this, &LiveSuits::failed);
    connect(&worn.suit, &LiveSuit::warned, this, &LiveSuits::warned);
    connect(&worn.suit, &LiveSuit::phaseChanged, this, [this, &worn] { followPhase(worn); });
    connect(&worn.suit, &LiveSuit::statusChanged, this, &LiveSuits::changed);
    connect(&worn.suit, &LiveSuit::wearingChanged, this, &LiveSuits::changed);
    connect(&worn.suit, &LiveSuit::streamBegan, this,
            [&worn] { worn.floor = std::make_shared<FloorMove>(); });
    connect(&worn.suit, &LiveSuit::recordingStarted, this, &LiveSuits::recordingStarted);
    connect(&worn.suit, &LiveSuit::recordingEnded, this, &LiveSuits::recordingEnded);
    connect(&worn.suit, &LiveSuit::posesMissing, this, &LiveSuits::posesMissing);
    connect(&worn.suit, &LiveSuit::leaveWanted, this, &LiveSuits::stopRecording);
    for (const Follower& follower : followers_)
        if (follower.owner)
            follower.act(worn);
    return worn;
}

void LiveSuits::forEach(QObject* owner, std::function<void(SuitInUse&)> act) {
    std::erase_if(followers_, [](const Follower& follower) { return !follower.owner; });
    for (const auto& worn : all_)
        act(*worn);
    followers_.push_back({owner, std::move(act)});
}

void LiveSuits::setChoiceGuard(QObject* owner, std::function<QString()> why_not) {
    guard_ = owner;
    why_not_other_ = std::move(why_not);
}

void LiveSuits::setCurrent(SuitInUse& worn) {
    const QString why = &worn != current_ && guard_ ? why_not_other_() : QString();
    if (why.isEmpty())
        lookAt(worn);
    else
        emit refused(why);
}

void LiveSuits::lookAt(SuitInUse& worn) {
    if (&worn == current_)
        return;
    current_ = &worn;
    emit currentChanged();
    emit changed();
}

std::vector<SuitInUse*> LiveSuits::connected() const {
    std::vector<SuitInUse*> connected;
    for (const auto& worn : all_)
        if (hasSuit(*worn))
            connected.push_back(worn.get());
    return connected;
}

SuitInUse* LiveSuits::at(const QString& address) const {
    for (SuitInUse* worn : connected())
        if (worn->suit.address() == address)
            return worn;
    return nullptr;
}

SuitInUse* LiveSuits::lost(const QString& serial) const {
    for (SuitInUse* worn : connected())
        if (!serial.isEmpty() && worn->suit.serial() == serial && worn->suit.isLost())
            return worn;
    return nullptr;
}

void LiveSuits::add(const QString& address, const KnownWearing& known) {
    if (SuitInUse* there = at(address))
        return setCurrent(*there);
    if (isTakeOpen()) {
        emit failed(tr("A take is being recorded"), tr("Add the suit when it has ended"));
        return;
    }
    if (isFull()) {
        emit failed(tr("%n suit(s) are connected, and more cannot be", nullptr, kMost),
                    tr("Disconnect one of them first"));
        return;
    }
    // The one that was at this address before waits until its earlier connection is closed.
    auto free = std::ranges::find_if(
        all_, [&](const auto& worn) { return !hasSuit(*worn) && worn->suit.isClosing(address); });
    if (free == all_.end())
        free = std::ranges::find_if(all_, [](const auto& worn) { return !hasSuit(*worn); });
    SuitInUse& worn = free != all_.end() ? **free : make();
    worn.suit.connectTo(address, known);
    if (hasSuit(worn))
        setCurrent(worn);
}

/// When the one that was looked at leaves, another one is.
void LiveSuits::followPhase(SuitInUse& worn) {
    const auto others = connected();
    if (worn.suit.phase() == Phase::kNone)
        worn.floor = std::make_shared<FloorMove>();
    if (worn.suit.phase() == Phase::kConnecting) {
        worn.is_beside = others.size() > 1;
        worn.performer = -1;
        worn.calibrations.setBeside(worn.is_beside);
    } else if (worn.suit.phase() == Phase::kNone && &worn == current_) {
        lookAt(others.empty() ? *all_.front() : *others.front());
    } else if (worn.is_beside && worn.performer < 0) {
        assignPerformer(worn);
    }
    emit changed();
}

bool LiveSuits::isWornByAnother(const SuitInUse& worn, const std::string& performer) const {
    return std::ranges::any_of(connected(), [&](const SuitInUse* other) {
        return other != &worn && other->suit.wearing().performer == performer;
    });
}

void LiveSuits::assignPerformers() {
    for (SuitInUse* worn : connected())
        if (worn->is_beside)
            assignPerformer(*worn);
    emit changed();
}

/// One of the session that nobody wears a suit of, else a new one. One that is renamed keeps the suit.
void LiveSuits::assignPerformer(SuitInUse& worn) {
    if (!session_.isOpen() || !worn.suit.status()->hello || worn.suit.suit().isFixed()) {
        worn.performer = -1;
        return;
    }
    const auto& performers = session_.session().performers;
    const int count = static_cast<int>(performers.size());
    if (worn.performer < 0 || worn.performer >= count) {
        worn.performer = 0;
        while (
            worn.performer < count &&
            (performers[static_cast<size_t>(worn.performer)].name == session_.session().current_performer ||
             isWornByAnother(worn, performers[static_cast<size_t>(worn.performer)].name)))
            ++worn.performer;
        if (worn.performer == count) {
            Performer added;
            added.suit = defaultSuit();
            for (int number = count + 1; added.name.empty() || session_.session().findPerformer(added.name);
                 ++number)
                added.name = tr("Performer %1").arg(number).toStdString();
            return session_.addPerformer(added);  // and comes here again
        }
    }
    worn.suit.setPerformer(textIn(performers[static_cast<size_t>(worn.performer)].name));
}

void LiveSuits::setPerformer(SuitInUse& worn, const QString& name) {
    if (!session_.isOpen() || textIn(worn.suit.wearing().performer) == name)
        return;
    const auto& performers = session_.session().performers;
    const auto indexOf = [&](const std::string& wanted) {
        return static_cast<int>(std::ranges::find(performers, wanted, &Performer::name) - performers.begin());
    };
    const std::string before = worn.suit.wearing().performer;
    for (SuitInUse* other : connected())
        if (other != &worn && other->suit.wearing().performer == name.toStdString() && other->is_beside) {
            other->performer = indexOf(before);
            other->suit.setPerformer(textIn(before));
        } else if (other != &worn && other->suit.wearing().performer == name.toStdString()) {
            session_.setCurrentPerformer(textIn(before));
        }
    if (!worn.is_beside)
        return session_.setCurrentPerformer(name);
    worn.performer = indexOf(name.toStdString());
    worn.suit.setPerformer(name);
}

int LiveSuits::letterOf(const SuitInUse& worn) const {
    const auto all = connected();
    return static_cast<int>(std::ranges::find(all, &worn) - all.begin());
}

QString LiveSuits::nameOf(const SuitInUse& worn) const {
    if (worn.suit.suit().isFixed())
        return tr("Room", "anchors that nobody wears");
    const std::string& performer = worn.suit.wearing().performer;
    return performer.empty() ? tr("Performer %1").arg(letterOf(worn) + 1) : textIn(performer);
}

std::string LiveSuits::nameInTake(const SuitInUse& worn) const {
    const auto hello = worn.suit.status()->hello;
    return nameOf(worn).toStdString() + (hello ? " (" + hello->serial + ")" : "");
}

std::optional<Error> LiveSuits::whyNotTogether() const {
    std::vector<SuitVoice> voices;
    for (const SuitInUse* worn : connected())
        if (const auto hello = worn->suit.status()->hello)
            voices.push_back({nameInTake(*worn), *hello});
    const Status told_apart = checkVoices(voices);
    return told_apart ? std::nullopt : std::optional(told_apart.error());
}

void LiveSuits::setChecked(SuitInUse& worn, const std::optional<CheckedSuit>& checked) {
    worn.checked = checked;
    worn.check.setChecked(checked ? std::optional(checked->is_good) : std::nullopt);
    emit checkedChanged();
}

}  // namespace noctule::ui
