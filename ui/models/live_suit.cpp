// SPDX-License-Identifier: Apache-2.0
// Connecting, and following what the link tells; takes are in live_suit_takes.cpp.
#include "ui/models/live_suit.h"

#include <QPointer>

#include "devices/device/device.h"
#include "ui/language/core_words.h"
#include "ui/models/live_steps.h"

namespace noctule::ui {
namespace {

constexpr int kLookEvery_ms = 16, kLooksPerStatus = 6;
constexpr qint64 kTryAgain_ms = 2000;
constexpr uint16_t kBlink_ms = 5000;
constexpr int kLoneSource_ms = 4000;

}  // namespace

LiveSuit::LiveSuit(Jobs& jobs, SessionModel& session, Surroundings surroundings, QObject* parent)
    : QObject(parent), jobs_(jobs), session_(session), surroundings_(std::move(surroundings)) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kLookEvery_ms);
    lone_timer_.setSingleShot(true);
    lone_timer_.setInterval(kLoneSource_ms);
    connect(&timer_, &QTimer::timeout, this, &LiveSuit::look);
    connect(&lone_timer_, &QTimer::timeout, this, [this] {
        lone_source_.reset();
        look_again_ = true;
    });
    blink_timer_.setSingleShot(true);
    blink_timer_.setInterval(kBlink_ms);
    connect(&blink_timer_, &QTimer::timeout, this, &LiveSuit::endBlinking);
    connect(&session_, &SessionModel::changed, this, &LiveSuit::wear);
}

/// The one place that waits: the studio ends, and a take that is open ends with it, intact.
LiveSuit::~LiveSuit() = default;

std::span<const PhaseTransition<LiveSuit::Phase>> LiveSuit::transitions() {
    using enum Phase;
    static constexpr PhaseTransition<Phase> kTable[] = {
        {kNone, kConnecting},                                                                     //
        {kConnecting, kReady},   {kConnecting, kRefused}, {kConnecting, kNone},                   //
        {kReady, kLooking},      {kReady, kStarting},     {kReady, kRefused},   {kReady, kNone},  //
        {kLooking, kReady},      {kLooking, kStarting},   {kLooking, kRefused}, {kLooking, kNone},
        {kLooking, kSaving},                                                 // evidence of a calibration
        {kStarting, kRecording}, {kStarting, kNone},                         //
        {kStarting, kLooking},   {kStarting, kReady},                        // no take came to be
        {kRecording, kSaving},                                               //
        {kSaving, kLooking},     {kSaving, kReady},       {kSaving, kNone},  //
        {kRefused, kNone},
    };
    return kTable;
}

void LiveSuit::setPhase(Phase phase) {
    if (phase == phase_)
        return;
    expectTransition(transitions(), phase_, phase, "suit");
    phase_ = phase;
    emit phaseChanged();
    emit statusChanged();
}

void LiveSuit::connectTo(const QString& address, const KnownWearing& known) {
    if (live_) {
        next_address_ = address;
        next_known_ = known;
        disconnectSuit();
        return;
    }
    auto device = makeDevice(address.toStdString());
    if (!device) {
        emit failed(coreWords(device.error().message), coreWords(device.error().remedy));
        return;
    }
    address_ = address;
    known_ = known;
    own_ = known.calibration;
    is_own_ = true;
    live_ = std::make_shared<LiveSession>(std::move(*device));
    if (closing_.isEmpty())
        live_->connect();
    looks_ = 0;
    timer_.start();
    setPhase(Phase::kConnecting);
}

void LiveSuit::disconnectSuit() {
    if (!live_)
        return;
    if (phase_ == Phase::kStarting || phase_ == Phase::kRecording || phase_ == Phase::kSaving) {
        leave_wanted_ = true;
        if (is_lent_)
            emit leaveWanted();
        else
            stopRecording();
    } else {
        release();
    }
}

/// Closing a device may take a while: a job does it. A box serves one studio at a time: the next connection
/// waits for it.
void LiveSuit::release() {
    ++connection_;
    closing_.append(address_);
    timer_.stop();
    lone_timer_.stop();
    endBlinking();
    jobs_.start<Done>(
        tr("Disconnecting %1").arg(address_),
        [live = std::move(live_)](const JobContext&) mutable -> Result<Done> {
            live.reset();
            return Done{};
        },
        [self = QPointer(this), address = address_](const Result<Done>&) {
            if (self && self->closing_.removeOne(address) && self->closing_.isEmpty() && self->live_)
                self->live_->connect();
            return QString();
        },
        Jobs::Loudness::kQuiet);
    live_.reset();
    working_ = is_lent_ = look_again_ = stop_wanted_ = leave_wanted_ = told_ = sources_set_ = false;
    next_take_.reset();
    lone_source_.reset();
    recorded_.reset();
    frame_.reset();
    status_ = std::make_shared<const SessionStatus>();
    wearing_ = {};
    known_ = {};
    own_.reset();
    address_.clear();
    box_.clear();
    performer_.clear();
    setPhase(Phase::kNone);
    emit frameChanged();
    emit wearingChanged();
    if (const QString next = std::exchange(next_address_, {}); !next.isEmpty())
        connectTo(next, std::exchange(next_known_, {}));
}

QString LiveSuit::serial() const {
    const auto hello = status()->hello;
    return hello ? QString::fromStdString(hello->serial) : QString();
}

std::shared_ptr<const SessionStatus> LiveSuit::status() const {
    return live_ ? live_->status() : status_;
}

link::LinkStatistics LiveSuit::link() const {
    return live_ ? live_->linkStatistics() : link::LinkStatistics{};
}

void LiveSuit::look() {
    // Whoever hears of one of these may disconnect the suit.
    const int connection = connection_;
    lookAtFrame();
    if (connection == connection_)
        followLink();
    if (connection == connection_ && looks_++ % kLooksPerStatus == 0)
        lookAtStatus();
}

void LiveSuit::lookAtFrame() {
    const auto latest = live_->latest();
    const bool is_frame = latest && !latest->health.boards.empty();
    if (!is_frame || latest == frame_)
        return;
    frame_ = latest;
    emit frameChanged();
}

void LiveSuit::lookAtStatus() {
    if (const auto now = live_->recording())
        recorded_ = now;
    const auto now = live_->status();
    const bool same = now == status_ && !now->stream_is_open;
    status_ = now;
    if (!same)
        emit statusChanged();
}

void LiveSuit::followLink() {
    if (working_ || is_lent_)
        return;
    const auto status = live_->status();
    if (phase_ == Phase::kRecording) {
        const auto recording = live_->recording();
        if (!status->stream_is_open || (recording && recording->ended))
            endTake();
    } else if (status->link == LinkState::kRefused) {
        frame_.reset();
        setPhase(Phase::kRefused);
    } else if ((phase_ == Phase::kReady || phase_ == Phase::kLooking) && serial() != box_) {
        emit warned(tr("Another box answers at %1 now: %2 instead of %3.", "address, two serial numbers")
                        .arg(address_, serial(), box_));
        connectTo(QString(address_));  // what is known is known of the one that was here
    } else if (phase_ == Phase::kConnecting && status->link == LinkState::kReady) {
        box_ = serial();
        wear();
        setPhase(Phase::kReady);
        begin(std::nullopt);
    } else if (phase_ == Phase::kLooking && !status->stream_is_open) {
        since_trouble_.start();
        setPhase(Phase::kReady);
    } else if (phase_ == Phase::kReady && status->link == LinkState::kReady &&
               (!since_trouble_.isValid() || since_trouble_.elapsed() > kTryAgain_ms)) {
        begin(std::nullopt);
    } else if (phase_ == Phase::kLooking && look_again_ && status->link == LinkState::kStreaming) {
        begin(std::nullopt);
    }
}

void LiveSuit::wear() {
    const auto hello = status()->hello;
    if (!live_ || !hello)
        return;
    const Performer* performer = nullptr;
    if (session_.isOpen())
        performer = session_.session().findPerformer(
            performer_.isEmpty() ? session_.session().current_performer : performer_.toStdString());
    Wearing now = wearingOf(*hello, performer, known_.actor);
    if (wearing_.suit.boards.size() == now.suit.boards.size() && toJson(now.suit) == toJson(wearing_.suit) &&
        toJson(now.actor) == toJson(wearing_.actor) && now.performer == wearing_.performer &&
        now.is_assigned == wearing_.is_assigned)
        return;
    wearing_ = std::move(now);
    look_again_ = true;
    emit wearingChanged();
}

void LiveSuit::setPerformer(const QString& name) {
    performer_ = name;
    wear();
}

void LiveSuit::setCalibration(std::optional<Calibration> calibration) {
    known_.calibration = std::move(calibration);
    is_own_ = false;
    look_again_ = true;
    emit wearingChanged();
}

void LiveSuit::noteWornOtherwise() {
    known_.is_exact = false;
    emit wearingChanged();
}

void LiveSuit::takeOwnCalibration() {
    setCalibration(own_);
    is_own_ = true;
}

void LiveSuit::blinkBoard(int board) {
    if (!live_ || !status()->hello || !isPlugged(board))
        return;
    live_->identify({static_cast<uint16_t>(board), kBlink_ms});
    blinking_ = board;
    blink_timer_.start();
    emit blinkingChanged();
}

bool LiveSuit::isPlugged(int board) const {
    const auto& flags = status()->board_flags;
    const auto index = static_cast<size_t>(board);
    return board >= 0 && index < wearing_.suit.boards.size() &&
           (index >= flags.size() || flags[index] & link::kBoardConnected);
}

void LiveSuit::endBlinking() {
    blink_timer_.stop();
    if (std::exchange(blinking_, -1) >= 0)
        emit blinkingChanged();
}

void LiveSuit::playSource(int source) {
    if (phase_ != Phase::kLooking)
        return;
    lone_source_ = source;
    look_again_ = true;
    lone_timer_.start();
}

}  // namespace noctule::ui
