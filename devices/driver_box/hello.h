// SPDX-License-Identifier: Apache-2.0
// The JSON payloads of the link: HELLO and ANNOUNCE, by which a box says what it is, and SET, by which the
// studio changes it (README.md, sections 2, 3 and 5). Reading fails with kUnreadable when the payload is
// damaged and with kUnusable when it is whole but cannot be worked with (another protocol); unknown members
// are ignored.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/suit/suit.h"
#include "devices/driver_box/wire.h"

namespace noctule::link {

inline constexpr int kProtocol = 1;
inline constexpr uint16_t kDefaultTcpPort = 41941;

struct Hello {
    int minor = 0;
    std::string model;
    std::string serial;  ///< never empty
    std::string firmware;
    std::string name;
    int sample_rate_hz = 150000;
    int adc_bits = 16;
    int pulse_interval_samples = 1200;
    int pulse_cycles = 10;
    double drive_hz = 40000;
    bool streaming = false;
    std::vector<std::string> features;
    Suit suit;  ///< boards in the order of ADC channels, sources in the order of PULSES
    /// False when the box knows serial numbers only: segments are empty, positions zero, orientations
    /// identity.
    bool suit_is_placed = true;

    int boardCount() const { return static_cast<int>(suit.boards.size()); }
    bool hasFeature(const std::string& feature) const;
};

struct Announcement {
    std::string serial;  ///< never empty
    std::string name;
    std::string model;
    uint16_t tcp_port = kDefaultTcpPort;
    int sample_rate_hz = 150000;
    int boards = 0;
    int sources = 0;
    bool busy = false;
    bool operator==(const Announcement&) const = default;
};

/// What is absent stays as it is.
struct Settings {
    std::optional<int> pulse_interval_samples;
    std::optional<std::vector<int>> enabled_sources;  ///< indices in HELLO
    std::optional<int> pulse_cycles;
    std::optional<std::string> name;
    bool operator==(const Settings&) const = default;
};

Bytes toPayload(const Hello& hello);
Bytes toPayload(const Announcement& announcement);
Bytes toPayload(const Settings& settings);

/// `where` names the link in errors: "tcp://10.0.0.7:41941".
Result<Hello> readHello(ByteView payload, const std::string& where);
Result<Announcement> readAnnouncement(ByteView payload, const std::string& where);
Result<Settings> readSettings(ByteView payload);

/// The boards and sources of `box` in their order, placed as those of `own` with the same serial number;
/// those that have none as those of `own` that have none either and the same id. Fails (kUnusable) and names
/// the first that `own` does not know.
Result<Suit> placedBySerial(const Suit& box, const Suit& own);

}  // namespace noctule::link
