// SPDX-License-Identifier: Apache-2.0
// A suit's samples and how it fares, whatever they come from: a driver box over TCP or a serial line, or a
// take that is played again. A device works on a thread of its own; its events are those of the link
// (devices/driver_box/studio_event.h) in the order in which they happened, for every kind of device alike.
// Opening, starting and the rest return at once; their outcome is an event.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/job/result.h"
#include "devices/driver_box/studio_conversation.h"

namespace noctule {

/// One event and when it arrived: nanoseconds of std::chrono::steady_clock, of ADC blocks when their last
/// byte came.
struct DeviceEvent {
    link::StudioEvent event;
    int64_t arrived_ns = 0;
};

class Device {
public:
    /// Called on the device's thread, one event after the other; hands on and returns, never waits for disk
    /// or screen.
    using Listener = std::function<void(DeviceEvent)>;

    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    /// Closes; no event comes any more when it returns.
    virtual ~Device() = default;

    /// "tcp://10.0.0.7:41941", "serial:///dev/ttyACM0", "replay:/takes/walk_001.noctule"
    virtual const std::string& address() const = 0;

    /// Greeted follows, or Refused. Once only, and before the wishes below.
    virtual void open(Listener listener) = 0;
    /// Started follows with the first data, or RequestFailed. Samples count from 0. A take that is played
    /// again comes to its end by itself: then Stopped follows as well.
    virtual void start() = 0;
    /// Stopped follows when all that the device still held has come.
    virtual void stop() = 0;
    /// RequestDone or RequestFailed follows.
    virtual void identify(const link::Identify& identify) = 0;
    virtual void set(const link::Settings& settings) = 0;

    virtual link::LinkStatistics statistics() const = 0;
};

struct DeviceOptions {
    double replay_speed = 1;  ///< of a take played again; 0: as fast as its events are taken
};

/// kUsage names what is wrong with the address and what addresses look like. Opens nothing yet.
Result<std::unique_ptr<Device>> makeDevice(const std::string& address, const DeviceOptions& options = {});

}  // namespace noctule
