// SPDX-License-Identifier: Apache-2.0
// What frames carry, as values (README.md, section 2): every type but HELLO, ANNOUNCE and SET, which are JSON
// (hello.h). toPayload() of a value is what the wire carries; reading gives nothing when the payload is
// damaged: its length does not fit its count, or a number is out of the range the protocol allows. Samples
// count on the box's clock since START.
#pragma once

#include <optional>
#include <string>

#include "devices/driver_box/wire.h"

namespace noctule::link {

enum class Type : uint8_t {
    kHello = 0x01,
    kAck = 0x02,
    kAdc = 0x03,
    kPulses = 0x04,
    kStatus = 0x05,
    kError = 0x06,
    kPong = 0x07,
    kAnnounce = 0x08,
    kQuery = 0x81,
    kStart = 0x82,
    kStop = 0x83,
    kIdentify = 0x84,
    kSet = 0x85,
    kPing = 0x86,
};
/// "START"; of a number that is no type "type 0x42".
std::string nameOf(Type type);

/// Of ACK and ERROR. Others may come: they are text for people.
enum class Code : uint16_t {
    kOk = 0,
    kUnknownType = 1,
    kBadPayload = 2,
    kNotNow = 3,  ///< busy or wrong state
    kNotSupported = 4,
    kHardwareFault = 5,
    kOverrun = 6,
    kBoardLost = 7,
    kBoardFound = 8,
    kBoardRestarted = 9,
    kBatteryLow = 10,  ///< stops in about a minute
    kShuttingDown = 11,
};
/// "not now (busy or wrong state)"; of an unknown code "code 17".
std::string nameOf(Code code);

/// Two years at 150 kHz, as in takes; what lies beyond is damage.
inline constexpr int64_t kHighestSample = 10'000'000'000'000;
inline constexpr int kMaxBlockSamples = 4096, kUsualBlockSamples = 600;
inline constexpr int kMaxBoards = 32;
inline constexpr size_t kMaxPingBytes = 64;
inline constexpr uint16_t kAllBoardsOff = 0xFFFF;

struct Ack {
    uint32_t request = 0;  ///< its sequence number
    Code code = Code::kOk;
    std::string text;
    bool operator==(const Ack&) const = default;
};

/// `values`: sample by sample, in each the boards in the order of HELLO.
struct SoundBlock {
    int64_t first_sample = 0;
    int board_count = 0;
    std::vector<int16_t> values;

    int64_t sampleCount() const { return static_cast<int64_t>(values.size()) / board_count; }
    bool operator==(const SoundBlock&) const = default;
};

enum class AdcFormat : uint16_t { kPlain = 0, kZstd = 1 };

struct EmittedPulse {
    int64_t sample = 0;  ///< start of the electrical drive
    int source = 0;
    bool operator==(const EmittedPulse&) const = default;
};

inline constexpr uint16_t kBoardConnected = 1, kBoardClipping = 2, kBoardLowSupply = 4;

/// Absent: not measured, or no finite number.
struct BoxStatus {
    int64_t sample = 0;  ///< next to be sent
    std::optional<float> temperature_c, humidity_percent, battery_v, battery_percent;
    uint32_t dropped_samples = 0;  ///< since START
    std::vector<uint16_t> board_flags;
    bool operator==(const BoxStatus&) const = default;
};

struct BoxError {
    Code code = Code::kOk;
    int64_t sample = 0;
    std::string text;  ///< for the operator
    bool operator==(const BoxError&) const = default;
};

struct Identify {
    uint16_t board = kAllBoardsOff;
    uint16_t duration_ms = 0;
    bool operator==(const Identify&) const = default;
};

Bytes toPayload(const Ack& ack);
Bytes toPayload(const SoundBlock& block, AdcFormat format = AdcFormat::kPlain);
Bytes toPayload(const std::vector<EmittedPulse>& pulses);
Bytes toPayload(const BoxStatus& status);
Bytes toPayload(const BoxError& error);
Bytes toPayload(const Identify& identify);
Bytes startPayload();

std::optional<Ack> readAck(ByteView payload);
std::optional<SoundBlock> readSoundBlock(ByteView payload);
std::optional<std::vector<EmittedPulse>> readPulses(ByteView payload);
std::optional<BoxStatus> readStatus(ByteView payload);
std::optional<BoxError> readError(ByteView payload);
std::optional<Identify> readIdentify(ByteView payload);

/// Text from the wire with everything that is no UTF-8 replaced by U+FFFD.
std::string cleanText(ByteView bytes);

}  // namespace noctule::link
