// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/driver_box.h"

#include <algorithm>

#include "app/virtual_suit/clock.h"

namespace noctule::virtual_suit {
namespace {

constexpr int64_t kMillisecond_ns = 1'000'000, kSecond_ns = 1'000'000'000;
constexpr int kSampling_ms = 4, kIdle_ms = 50;
constexpr int64_t kMeasureEvery_ns = 500 * kMillisecond_ns;
constexpr int64_t kLastsWhenLow_ns = 60 * kSecond_ns;
constexpr double kBattery_percent = 92;
constexpr double kAhead_s = 0.4, kBuffer_s = 1;
/// So far behind sound may be before the suit's clock stands still; a cast's is made after its beginning
/// only.
constexpr int64_t kPatience_ns = 250 * kMillisecond_ns, kTimedPatience_ns = 5 * kSecond_ns;

link::Hello completed(link::Hello hello) {
    hello.model = "Noctule driver box";
    hello.firmware = "1.0.0";
    hello.name = "Suit " + hello.serial;
    hello.features = {"humidity"};
    return hello;
}

/// Lasts of the clock on the wall, as what holds the sound up does.
double secondsOfSuit(double seconds, double speed) {
    return seconds * std::max(1.0, speed);
}

link::BoxOptions optionsOf(const SoundOfSuit& sound, const BoxSettings& settings) {
    link::BoxOptions options;
    options.buffer_s = secondsOfSuit(kBuffer_s, settings.speed);
    options.drops_silent_clients = settings.drops_silent_clients;
    options.sets_pulses = options.sets_sources = sound.source->isSimulated();
    return options;
}

}  // namespace

DriverBox::DriverBox(SoundOfSuit sound, const BoxSettings& settings)
    : first_hello_(completed(std::move(sound.hello))),
      options_(optionsOf(sound, settings)),
      conversation_(std::make_unique<link::BoxConversation>(first_hello_, options_)),
      maker_(std::move(sound.source), first_hello_.boardCount(),
             static_cast<int64_t>(secondsOfSuit(kAhead_s, settings.speed) * first_hello_.sample_rate_hz)),
      pacer_(first_hello_.sample_rate_hz, settings.speed),
      instruments_(std::move(sound.measurements)),
      wiring_(first_hello_.boardCount(), first_hello_.sample_rate_hz, settings.seed),
      faults_(settings.seed) {
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { tick(); });
    if (!instruments_.read(0, nowNs()).battery_percent)
        instruments_.setBattery(kBattery_percent, nowNs());
    measure(nowNs());
    timer_.start(kIdle_ms);
}

DriverBox::~DriverBox() = default;

bool DriverBox::clientCame(Port& port) {
    if (client_ || !powered_) {
        tell("another client was turned away from " + port.address());
        return false;
    }
    client_ = &port;
    conversation_->connected(nowNs());
    tell("a client came to " + port.address());
    return true;
}

void DriverBox::clientLeft(Port&) {
    client_ = nullptr;
    conversation_->disconnected(nowNs());
    tell("the client left");
}

void DriverBox::bytesCame(Port&, link::ByteView bytes) {
    conversation_->receive(bytes, nowNs());
    handleEvents();
    pump();
}

void DriverBox::roomCame(Port&) {
    pump();
}

void DriverBox::tick() {
    const int64_t now_ns = nowNs();
    restoreLink(now_ns);
    for (const auto& port : ports_)
        port->poll();
    if (now_ns - measured_ns_ >= kMeasureEvery_ns)
        measure(now_ns);
    if (conversation_->streaming())
        sample(now_ns);
    conversation_->tick(now_ns);
    handleEvents();
    pump();
    const int wanted_ms = conversation_->streaming() ? kSampling_ms : kIdle_ms;
    if (timer_.interval() != wanted_ms)
        timer_.start(wanted_ms);
}

void DriverBox::sample(int64_t now_ns) {
    while (auto block = maker_.next(pacer_.due(now_ns))) {
        wiring_.apply(block->adc);
        conversation_->offer(block->pulses);
        conversation_->offer(std::move(block->adc));
    }
    if (!maker_.hasNext())  // else nothing is late: a hole in a take takes its time
        pacer_.holdTo(conversation_->nextSample(), now_ns,
                      maker_.isTimed() ? kTimedPatience_ns : kPatience_ns);
    if (pacer_.lost_ns() > kSecond_ns && !std::exchange(told_late_, true))
        tell(
            "warning: this machine is too slow, the suit's clock stands still now and then; stream a take "
            "made before (--take), or give a lower --speed");
    if (const auto trouble = maker_.takeTrouble()) {
        tell("warning: silence from now on: " + trouble->text());
        report(link::Code::kHardwareFault, trouble->message);
    } else if (maker_.ended() && !std::exchange(told_end_, true)) {
        tell("all has been played, silence follows; --loop begins again");
    }
}

void DriverBox::measure(int64_t now_ns) {
    measured_ns_ = now_ns;
    link::BoxStatus status = instruments_.read(conversation_->nextSample(), now_ns);
    const bool low_supply =
        status.battery_percent && *status.battery_percent <= Instruments::kLowSupply_percent;
    for (int board = 0; board < hello().boardCount(); ++board)
        status.board_flags.push_back(
            static_cast<uint16_t>(wiring_.flags(board) | (low_supply ? link::kBoardLowSupply : 0)));
    conversation_->setConditions(status);
    watchBattery(status, now_ns);
}

void DriverBox::watchBattery(const link::BoxStatus& status, int64_t now_ns) {
    const double percent = status.battery_percent.value_or(100.0F);
    const bool low = percent <= Instruments::kBatteryLow_percent;
    if (low && !std::exchange(battery_is_low_, true)) {
        battery_low_ns_ = now_ns;
        report(link::Code::kBatteryLow, "the battery is almost empty, charge it");
    }
    battery_is_low_ = low;
    if (powered_ && low && (percent <= 0 || now_ns - battery_low_ns_ >= kLastsWhenLow_ns))
        powerOff();
    else if (!powered_ && !low)
        powerOn();
}

void DriverBox::handleEvents() {
    for (const link::BoxEvent& event : conversation_->takeEvents())
        handle(event);
}

void DriverBox::handle(const link::BoxEvent& event) {
    if (std::holds_alternative<link::StartWanted>(event)) {
        const int64_t now_ns = nowNs();
        pacer_.start(now_ns);
        if (maker_.isTimed())
            maker_.restart(now_ns);
        wiring_.restart();
        told_end_ = told_late_ = false;
        timer_.start(kSampling_ms);
        tell("started at " + std::to_string(1e-9 * static_cast<double>(now_ns)) +
             " s of this machine's clock");
    } else if (std::holds_alternative<link::StopWanted>(event)) {
        maker_.restart(nowNs());
        tell("stopped");
    } else if (const auto* wish = std::get_if<link::IdentifyWanted>(&event)) {
        const link::Identify& led = wish->identify;
        tell(led.board == link::kAllBoardsOff ? "all boards' lights are off"
                                              : "the light of " + nameOf(led.board) + " is on for " +
                                                    std::to_string(led.duration_ms) + " ms");
    } else if (const auto* set = std::get_if<link::SettingsWanted>(&event)) {
        maker_.ask([settings = set->settings](SoundSource& source) { source.set(settings); });
        maker_.restart(nowNs());
    } else if (const auto* dropped = std::get_if<link::ClientDropped>(&event)) {
        loseClient(dropped->why);
    }
}

void DriverBox::pump() {
    if (nowNs() < stalled_until_ns_)
        return;
    while (client_) {
        const size_t room = client_->room();
        const link::Bytes bytes = room > 0 ? conversation_->read(room) : link::Bytes();
        if (bytes.empty())
            return;
        client_->write(faults_.pass(bytes));
    }
}

void DriverBox::loseClient(const std::string& why) {
    if (!client_)
        return;
    std::exchange(client_, nullptr)->closeClient();
    conversation_->disconnected(nowNs());
    tell("the client was cut off: " + why);
}

void DriverBox::restoreLink(int64_t now_ns) {
    if (!cut_until_ns_ || now_ns < *cut_until_ns_)
        return;
    cut_until_ns_.reset();
    for (const auto& port : ports_)
        port->setReachable(powered_);
}

/// What an empty battery does: nothing of before is left when it is charged again.
void DriverBox::powerOff() {
    shutDown();
    powered_ = false;
    for (const auto& port : ports_)
        port->setReachable(false);
    tell("the battery is empty, the box is off; `battery PERCENT` charges it");
}

void DriverBox::powerOn() {
    powered_ = true;
    conversation_ = std::make_unique<link::BoxConversation>(first_hello_, options_);
    maker_.restart(nowNs());
    for (const auto& port : ports_)
        port->setReachable(!cut_until_ns_);
    measure(nowNs());
    tell("the box is on");
}

void DriverBox::shutDown() {
    report(link::Code::kShuttingDown, "the box is being switched off");
    pump();
    if (client_)
        client_->drain();
    loseClient("the box is being switched off");
}

std::string DriverBox::nameOf(int board) const {
    return "board " + hello().suit.boards[board].id;
}

void DriverBox::report(link::Code code, const std::string& text) {
    conversation_->report({code, conversation_->nextSample(), text});
}

}  // namespace noctule::virtual_suit
