// SPDX-License-Identifier: Apache-2.0
// A device that says what a test lets it say, when it lets it, on the test's own thread, and a session that
// looks at it.
#pragma once

#include "devices/live/live_session.h"
#include "devices/machine/clock.h"
#include "tests/devices/live/fake_device.h"

namespace noctule::test {

class HandDevice : public Device {
public:
    const std::string& address() const override { return address_; }
    void open(Listener listener) override { listener_ = std::move(listener); }
    void start() override { ++starts; }
    void stop() override { ++stops; }
    void identify(const link::Identify& identify) override { identified.push_back(identify); }
    void set(const link::Settings& wanted) override { settings.push_back(wanted); }
    link::LinkStatistics statistics() const override { return {}; }

    void tell(link::StudioEvent event) { listener_({std::move(event), steadyNow_ns()}); }
    void tell(const std::vector<link::StudioEvent>& events) {
        for (const link::StudioEvent& event : events)
            tell(event);
    }

    int starts = 0, stops = 0;
    std::vector<link::Identify> identified;
    std::vector<link::Settings> settings;

private:
    std::string address_ = "hand://box";
    Listener listener_;
};

/// Two boards, greeted and streaming, for somebody who only looks.
struct LookedAt {
    static constexpr int kBoards = 2;

    LookedAt() {
        session.connect();
        hand->tell(link::Greeted{madeHello(kBoards)});
        StreamRequest look;
        look.process = false;
        EXPECT_TRUE(session.begin(look));
        hand->tell(link::Started{});
    }
    void hear(int64_t first, int64_t end) { hand->tell(madeEvents(first, end, kBoards)); }
    LinkState link() const { return session.status()->link; }

    HandDevice* hand = new HandDevice;  ///< the session's
    LiveSession session{std::unique_ptr<Device>(hand)};
};

}  // namespace noctule::test
