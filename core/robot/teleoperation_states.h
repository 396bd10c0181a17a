// SPDX-License-Identifier: Apache-2.0
// States of teleoperation and the one table of what leads from one to another. An event that the table does
// not name leaves the state as it is.
#pragma once

#include <array>
#include <cstdint>

namespace noctule::robot {

enum class TeleopState : std::uint8_t {
    kIdle,           ///< connected; nothing is followed
    kSynchronising,  ///< the robot holds; shows how far each joint is from what the performer asks for
    kBlending,       ///< accepted; goes over to following within a second
    kFollowing,
    kHolding,  ///< clutch or dead man's key released
    kLost,     ///< no fresh pose; the robot has braked
    kStopped,  ///< stop was pressed; only a reset leads out
};
inline constexpr int kTeleopStates = 7;

enum class TeleopEvent : std::uint8_t {
    kEngage,   ///< clutch closes, with the dead man's key held
    kAccept,   ///< the operator accepts, and no joint is too far
    kBlended,  ///< the blend is over
    kRelease,  ///< clutch opens, or the dead man's key is let go
    kLose,     ///< the watchdog: no fresh pose
    kFind,     ///< poses come again
    kStop,
    kReset,
};
inline constexpr int kTeleopEvents = 8;

struct TeleopTransition {
    TeleopState from;
    TeleopEvent event;
    TeleopState to;
};

inline constexpr std::array kTeleopTransitions{
    TeleopTransition{TeleopState::kIdle, TeleopEvent::kEngage, TeleopState::kSynchronising},
    TeleopTransition{TeleopState::kIdle, TeleopEvent::kStop, TeleopState::kStopped},
    TeleopTransition{TeleopState::kSynchronising, TeleopEvent::kAccept, TeleopState::kBlending},
    TeleopTransition{TeleopState::kSynchronising, TeleopEvent::kRelease, TeleopState::kIdle},
    TeleopTransition{TeleopState::kSynchronising, TeleopEvent::kLose, TeleopState::kLost},
    TeleopTransition{TeleopState::kSynchronising, TeleopEvent::kStop, TeleopState::kStopped},
    TeleopTransition{TeleopState::kBlending, TeleopEvent::kBlended, TeleopState::kFollowing},
    TeleopTransition{TeleopState::kBlending, TeleopEvent::kRelease, TeleopState::kHolding},
    TeleopTransition{TeleopState::kBlending, TeleopEvent::kLose, TeleopState::kLost},
    TeleopTransition{TeleopState::kBlending, TeleopEvent::kStop, TeleopState::kStopped},
    TeleopTransition{TeleopState::kFollowing, TeleopEvent::kRelease, TeleopState::kHolding},
    TeleopTransition{TeleopState::kFollowing, TeleopEvent::kLose, TeleopState::kLost},
    TeleopTransition{TeleopState::kFollowing, TeleopEvent::kStop, TeleopState::kStopped},
    TeleopTransition{TeleopState::kHolding, TeleopEvent::kEngage, TeleopState::kSynchronising},
    TeleopTransition{TeleopState::kHolding, TeleopEvent::kStop, TeleopState::kStopped},
    TeleopTransition{TeleopState::kLost, TeleopEvent::kFind, TeleopState::kHolding},
    TeleopTransition{TeleopState::kLost, TeleopEvent::kStop, TeleopState::kStopped},
    TeleopTransition{TeleopState::kStopped, TeleopEvent::kReset, TeleopState::kIdle},
};

constexpr TeleopState after(TeleopState state, TeleopEvent event) {
    for (const TeleopTransition& transition : kTeleopTransitions)
        if (transition.from == state && transition.event == event)
            return transition.to;
    return state;
}

}  // namespace noctule::robot
