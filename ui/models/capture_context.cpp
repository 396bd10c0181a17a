// SPDX-License-Identifier: Apache-2.0
#include "ui/models/capture_context.h"

#include <QDir>
#include <QStandardPaths>

namespace noctule::ui {
namespace {

QString captureText(const std::string& text) {
    return QString::fromStdString(text);
}

VirtualSuit::Parts virtualSuitParts(const StudioParts& parts) {
    return {captureText(parts.virtual_suit_program),
            QStandardPaths::writableLocation(QStandardPaths::CacheLocation), parts.software,
            parts.make_sample_take, parts.make_pair_take};
}

}  // namespace

CaptureContext::CaptureContext(SharedContext& shared)
    : shared_(shared),
      finder_(shared.settings()),
      suits_(shared.jobs(), shared.session(), {shared.parts().software, shared.parts().utc_now},
             {[&shared] { return shared.takesFolder(); }, suitsFolder()}),
      virtual_suit_(shared.jobs(), virtualSuitParts(shared.parts())),
      second_virtual_suit_(shared.jobs(), virtualSuitParts(shared.parts())),
      remote_start_(shared.settings()),
      place_reset_(suits_, shared.session(), shared.settings()) {
    connectSuits();
    connectVirtualSuits();
}

QString CaptureContext::suitsFolder() const {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return shared_.settings().value("folders/suits", QDir(data).filePath("suits")).toString();
}

void CaptureContext::connectSuits() {
    QObject::connect(&suits_, &LiveSuits::failed, &here_, [this](const QString& what, const QString& remedy) {
        emit shared_.failed(what, remedy, About::kCapture);
    });
    QObject::connect(&suits_, &LiveSuits::warned, &here_,
                     [this](const QString& what) { emit shared_.warned(what, About::kCapture); });
    QObject::connect(&suits_, &LiveSuits::refused, &shared_, &SharedContext::say);
    QObject::connect(&place_reset_, &PlaceReset::said, &shared_, &SharedContext::say);
    suits_.forEach(&here_, [this](SuitInUse& worn) {
        QObject::connect(&worn.suit, &LiveSuit::phaseChanged, &here_, [this, &worn] { followSuit(worn); });
        CalibrationShelf& shelf = worn.calibrations;
        QObject::connect(&shelf, &CalibrationShelf::warned, &here_,
                         [this](const QString& what) { emit shared_.warned(what, About::kSuit); });
        QObject::connect(&shelf, &CalibrationShelf::replaced, &here_,
                         [this, &worn] { settleCalibration(worn); });
        QObject::connect(&shelf, &CalibrationShelf::told, &shared_, &SharedContext::said);
        QObject::connect(&shelf, &CalibrationShelf::changed, &here_,
                         [this, &worn] { suits_.setChecked(worn, {}); });
        QObject::connect(&shelf, &CalibrationShelf::saved, &here_,
                         [this, &worn](const QString& task, bool is_good) {
                             // A rest pose that was found just now is as good as a check of it.
                             if (task == QLatin1String("rest-pose"))
                                 suits_.setChecked(worn, CheckedSuit{QDateTime::currentDateTime(), is_good});
                         });
    });
}

void CaptureContext::connectVirtualSuits() {
    for (VirtualSuit* suit : {&virtual_suit_, &second_virtual_suit_}) {
        QObject::connect(suit, &VirtualSuit::failed, &here_,
                         [this](const QString& what, const QString& remedy) {
                             emit shared_.failed(what, remedy, About::kCapture);
                         });
        QObject::connect(suit, &VirtualSuit::wornOtherwise, &here_, [this, suit] {
            if (SuitInUse* worn = suits_.at(suit->address())) {
                worn->suit.noteWornOtherwise();
                suits_.setChecked(*worn, {});
            }
        });
    }
    QObject::connect(&virtual_suit_, &VirtualSuit::started, &here_, [this] {
        if (virtual_suit_.role() == VirtualSuit::Role::kAlone && !suits_.areSeveral())
            return suit().connectTo(virtual_suit_.address(), virtual_suit_.known());
        suits_.add(virtual_suit_.address(), virtual_suit_.known());
        if (std::exchange(second_virtual_suit_waits_, false))
            suits_.add(second_virtual_suit_.address(), second_virtual_suit_.known());
    });
    QObject::connect(&second_virtual_suit_, &VirtualSuit::started, &here_, [this] {
        second_virtual_suit_waits_ = virtual_suit_.role() != VirtualSuit::Role::kFirst ||
                                     virtual_suit_.state() != VirtualSuit::State::kOn;
        if (!second_virtual_suit_waits_)
            return suits_.add(second_virtual_suit_.address(), second_virtual_suit_.known());
        virtual_suit_.stop();
        virtual_suit_.start(VirtualSuit::Role::kFirst);
    });
    QObject::connect(&virtual_suit_, &VirtualSuit::changed, &here_, [this] { followVirtualSuits(); });
    QObject::connect(&second_virtual_suit_, &VirtualSuit::changed, &here_, [this] { followVirtualSuits(); });
}

void CaptureContext::startVirtualSuit() {
    const bool on = virtual_suit_.state() == VirtualSuit::State::kOn;
    if (on && suits_.at(virtual_suit_.address()))
        return;
    if (!on)
        virtual_suit_.start();
    else if (suits_.areSeveral())
        suits_.add(virtual_suit_.address(), virtual_suit_.known());
    else
        suit().connectTo(virtual_suit_.address(), virtual_suit_.known());
}

void CaptureContext::startSecondVirtualSuit() {
    if (suits_.isTakeOpen()) {
        emit shared_.failed(tr("A take is being recorded"),
                            tr("Start the second virtual suit when it has ended"), About::kCapture);
        return;
    }
    if (second_virtual_suit_.state() != VirtualSuit::State::kOn)
        return second_virtual_suit_.start(VirtualSuit::Role::kSecond);
    suits_.add(second_virtual_suit_.address(), second_virtual_suit_.known());
}

void CaptureContext::stopVirtualSuit() {
    if (second_virtual_suit_.state() != VirtualSuit::State::kOff)
        stopSecondVirtualSuit();
    virtual_suit_ends_ = true;
    if (SuitInUse* worn = suits_.at(virtual_suit_.address()))
        worn->suit.disconnectSuit();
    followVirtualSuits();
}

void CaptureContext::stopSecondVirtualSuit() {
    second_virtual_suit_ends_ = true;
    if (SuitInUse* worn = suits_.at(second_virtual_suit_.address()))
        worn->suit.disconnectSuit();
    followVirtualSuits();
}

void CaptureContext::setChecked(const std::optional<CheckedSuit>& checked) {
    suits_.setChecked(suits_.current(), checked);
}

/// A suit is connected, or a take begins: what went wrong before is over. What was told of the only suit was
/// of the one before it.
void CaptureContext::settleCapture(const SuitInUse& worn) {
    const LiveSuit::Phase phase = worn.suit.phase();
    if (phase == LiveSuit::Phase::kConnecting || phase == LiveSuit::Phase::kStarting)
        emit shared_.settled(About::kCapture);
    if (phase == LiveSuit::Phase::kConnecting && !suits_.areSeveral())
        emit shared_.settled(About::kSuit);
}

/// Of several suits nobody knows which one a warning was about: it stays.
void CaptureContext::settleCalibration(const SuitInUse& worn) {
    if (!suits_.areSeveral() && &worn == &suits_.current())
        emit shared_.settled(About::kSuit);
}

void CaptureContext::followSuit(SuitInUse& worn) {
    settleCapture(worn);
    if (worn.suit.phase() == LiveSuit::Phase::kNone)
        suits_.setChecked(worn, {});
    followVirtualSuits();
    const QString& address = worn.suit.address();
    const bool is_virtual = address == virtual_suit_.address() || address == second_virtual_suit_.address();
    if (worn.suit.phase() == LiveSuit::Phase::kReady && !is_virtual && worn.suit.status()->hello)
        finder_.remember(captureText(worn.suit.status()->hello->serial), worn.suit.suit().isFixed());
}

void CaptureContext::followVirtualSuits() {
    const auto follow = [this](VirtualSuit& program, bool& ends) {
        SuitInUse* worn = program.address().isEmpty() ? nullptr : suits_.at(program.address());
        if (program.state() == VirtualSuit::State::kOff && worn) {
            // Nobody is there to connect to again; what the others record goes on.
            if (!worn->suit.isLent())
                worn->suit.disconnectSuit();
        } else if (ends && !worn) {
            ends = false;
            program.stop();
        }
    };
    follow(virtual_suit_, virtual_suit_ends_);
    follow(second_virtual_suit_, second_virtual_suit_ends_);
}

}  // namespace noctule::ui
