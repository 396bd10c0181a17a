// SPDX-License-Identifier: Apache-2.0
// A driver box: it wires sound, clock, instruments and faults to the conversation with the studio, and that
// to the ports. Lives in the thread of the event loop; only the sound is made elsewhere.
#pragma once

#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "app/virtual_suit/board_wiring.h"
#include "app/virtual_suit/byte_faults.h"
#include "app/virtual_suit/control_command.h"
#include "app/virtual_suit/pacing.h"
#include "app/virtual_suit/port.h"
#include "app/virtual_suit/sound_maker.h"
#include "devices/driver_box/box_conversation.h"

namespace noctule::virtual_suit {

struct BoxSettings {
    double speed = 1;  ///< seconds of the suit in one of the clock
    uint64_t seed = 1;
    bool drops_silent_clients = true;
};

class DriverBox : public PortOwner {
public:
    DriverBox(SoundOfSuit sound, const BoxSettings& settings);
    ~DriverBox() override;

    void addPort(std::unique_ptr<Port> port) { ports_.push_back(std::move(port)); }
    /// What happens, one line each.
    std::function<void(const std::string&)> tell = [](const std::string&) {};

    const link::Hello& hello() const { return conversation_->hello(); }
    /// Before that nobody should be let in: START wants sound within a second.
    bool isReady() { return maker_.isReady(); }
    bool isBusy() const { return client_ != nullptr; }
    Status execute(const ControlCommand& command);
    /// The client is told, and gone when this returns.
    void shutDown();

private:
    bool clientCame(Port& port) override;
    void clientLeft(Port& port) override;
    void bytesCame(Port& port, link::ByteView bytes) override;
    void roomCame(Port& port) override;

    void tick();
    void sample(int64_t now_ns);
    void measure(int64_t now_ns);
    void watchBattery(const link::BoxStatus& status, int64_t now_ns);
    void handleEvents();
    void handle(const link::BoxEvent& event);
    void pump();
    void loseClient(const std::string& why);
    void restoreLink(int64_t now_ns);
    void powerOff();
    void powerOn();

    Status plug(int board, bool connected);
    Status changeWorld(const ControlCommand& command);
    std::string nameOf(int board) const;
    void report(link::Code code, const std::string& text);

    const link::Hello first_hello_;
    const link::BoxOptions options_;
    std::unique_ptr<link::BoxConversation> conversation_;
    SoundMaker maker_;
    Pacer pacer_;
    Instruments instruments_;
    BoardWiring wiring_;
    ByteFaults faults_;
    std::vector<std::unique_ptr<Port>> ports_;
    Port* client_ = nullptr;
    QTimer timer_;

    bool powered_ = true, battery_is_low_ = false, told_late_ = false, told_end_ = false;
    int64_t battery_low_ns_ = 0, stalled_until_ns_ = 0, measured_ns_ = 0;
    std::optional<int64_t> cut_until_ns_;
};

}  // namespace noctule::virtual_suit
