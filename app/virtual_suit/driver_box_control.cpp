// SPDX-License-Identifier: Apache-2.0
// What the control port may do to a box.
#include "app/virtual_suit/clock.h"
#include "app/virtual_suit/driver_box.h"

namespace noctule::virtual_suit {

Status DriverBox::plug(int board, bool connected) {
    if (!(connected ? wiring_.plug(board) : wiring_.unplug(board)))
        return Error{ErrorKind::kUsage, nameOf(board) + " is " + (connected ? "plugged in" : "unplugged"),
                     "Nothing to do"};
    report(connected ? link::Code::kBoardFound : link::Code::kBoardLost,
           nameOf(board) + (connected ? " answers again" : " does not answer"));
    return Done{};
}

Status DriverBox::changeWorld(const ControlCommand& command) {
    if (Status able = maker_.accepts(command); !able)
        return able;
    maker_.ask([command](SoundSource& source) { source.obey(command); });
    return Done{};
}

Status DriverBox::execute(const ControlCommand& command) {
    const int64_t now_ns = nowNs();
    const auto until_ns = now_ns + static_cast<int64_t>(command.number * 1e9);
    Status done = Done{};
    switch (command.kind) {
        case ControlKind::kUnplug:
        case ControlKind::kPlug:
            done = plug(command.board, command.kind == ControlKind::kPlug);
            break;
        case ControlKind::kSwap:
            wiring_.swap(command.board, command.other_board);
            break;
        case ControlKind::kSlip:
        case ControlKind::kPose:
        case ControlKind::kSide:
        case ControlKind::kSpin:
        case ControlKind::kPlacement:
        case ControlKind::kRoll:
        case ControlKind::kHeight:
            return changeWorld(command);
        case ControlKind::kDropBytes:
            faults_.setDropRate(command.number);
            break;
        case ControlKind::kFlipBits:
            faults_.setFlipRate(command.number);
            break;
        case ControlKind::kStall:
            stalled_until_ns_ = until_ns;
            break;
        case ControlKind::kCut:
            loseClient("the cable was cut");
            cut_until_ns_ = until_ns;
            for (const auto& port : ports_)
                port->setReachable(false);
            break;
        case ControlKind::kBattery:
            instruments_.setBattery(command.number, now_ns);
            break;
        case ControlKind::kTemperature:
            instruments_.setTemperature(command.number);
            break;
        case ControlKind::kQuit:
            break;
    }
    measure(now_ns);
    pump();
    return done;
}

}  // namespace noctule::virtual_suit
