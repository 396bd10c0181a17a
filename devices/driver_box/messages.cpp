// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/messages.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/job/contract.h"

namespace noctule::link {

namespace {

constexpr size_t kPulseBytes = 12;

std::optional<float> finite(float value) {
    return std::isfinite(value) ? std::optional<float>(value) : std::nullopt;
}

float orNan(std::optional<float> value) {
    return value.value_or(std::numeric_limits<float>::quiet_NaN());
}

bool isSample(uint64_t sample) {
    return sample <= static_cast<uint64_t>(kHighestSample);
}

size_t announcedBytes(uint8_t first) {
    if (first < 0x80)
        return 1;
    if (first < 0xC2 || first > 0xF4)
        return 0;
    return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

/// Bytes of the UTF-8 character that `bytes` begins with (Unicode 15, table 3-7); 0: none.
size_t characterBytes(ByteView bytes) {
    const uint8_t first = bytes[0];
    const size_t length = announcedBytes(first);
    if (length < 2 || bytes.size() < length)
        return length == 1 ? 1 : 0;
    for (size_t i = 1; i < length; ++i)
        if ((bytes[i] & 0xC0) != 0x80)
            return 0;
    const bool overlong = (first == 0xE0 && bytes[1] < 0xA0) || (first == 0xF0 && bytes[1] < 0x90);
    const bool surrogate = first == 0xED && bytes[1] >= 0xA0;
    const bool beyond = first == 0xF4 && bytes[1] >= 0x90;
    return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

std::string nameOf(Type type) {
    switch (type) {
        case Type::kHello:
            return "HELLO";
        case Type::kAck:
            return "ACK";
        case Type::kAdc:
            return "ADC";
        case Type::kPulses:
            return "PULSES";
        case Type::kStatus:
            return "STATUS";
        case Type::kError:
            return "ERROR";
        case Type::kPong:
            return "PONG";
        case Type::kAnnounce:
            return "ANNOUNCE";
        case Type::kQuery:
            return "QUERY";
        case Type::kStart:
            return "START";
        case Type::kStop:
            return "STOP";
        case Type::kIdentify:
            return "IDENTIFY";
        case Type::kSet:
            return "SET";
        case Type::kPing:
            return "PING";
    }
    char text[16];
    std::snprintf(text, sizeof text, "type 0x%02x", static_cast<unsigned>(type));
    return text;
}

std::string nameOf(Code code) {
    static constexpr std::array<const char*, 12> kNames = {"ok",
                                                           "unknown type",
                                                           "bad payload",
                                                           "not now (busy or wrong state)",
                                                           "not supported",
                                                           "hardware fault",
                                                           "overrun",
                                                           "board lost",
                                                           "board found",
                                                           "board restarted",
                                                           "battery low",
                                                           "shutting down"};
    const auto number = static_cast<size_t>(code);
    return number < kNames.size() ? kNames[number] : "code " + std::to_string(number);
}

Bytes toPayload(const Ack& ack) {
    Bytes payload;
    WireWriter writer(payload);
    writer.number(ack.request);
    writer.number(static_cast<uint16_t>(ack.code));
    writer.text(ack.text);
    return payload;
}

std::optional<Ack> readAck(ByteView payload) {
    WireReader reader(payload);
    Ack ack;
    ack.request = reader.number<uint32_t>();
    ack.code = static_cast<Code>(reader.number<uint16_t>());
    ack.text = cleanText(reader.rest());
    return reader.ok() ? std::optional(ack) : std::nullopt;
}

Bytes toPayload(const std::vector<EmittedPulse>& pulses) {
    Bytes payload;
    WireWriter writer(payload);
    writer.number(static_cast<uint32_t>(pulses.size()));
    for (const EmittedPulse& pulse : pulses) {
        writer.number(static_cast<uint64_t>(pulse.sample));
        writer.number(static_cast<uint16_t>(pulse.source));
        writer.number(uint16_t{0});
    }
    return payload;
}

std::optional<std::vector<EmittedPulse>> readPulses(ByteView payload) {
    WireReader reader(payload);
    const uint64_t count = reader.number<uint32_t>();
    if (!reader.ok() || reader.rest().size() != count * kPulseBytes)
        return std::nullopt;
    std::vector<EmittedPulse> pulses(count);
    for (EmittedPulse& pulse : pulses) {
        const auto sample = reader.number<uint64_t>();
        if (!isSample(sample))
            return std::nullopt;
        pulse = {static_cast<int64_t>(sample), reader.number<uint16_t>()};
        reader.number<uint16_t>();
    }
    return pulses;
}

Bytes toPayload(const BoxStatus& status) {
    require(status.board_flags.size() <= kMaxBoards, "STATUS: too many boards");
    Bytes payload;
    WireWriter writer(payload);
    writer.number(static_cast<uint64_t>(status.sample));
    writer.real(orNan(status.temperature_c));
    writer.real(orNan(status.humidity_percent));
    writer.real(orNan(status.battery_v));
    writer.real(orNan(status.battery_percent));
    writer.number(status.dropped_samples);
    writer.number(static_cast<uint16_t>(status.board_flags.size()));
    writer.number(uint16_t{0});
    for (const uint16_t flags : status.board_flags)
        writer.number(flags);
    return payload;
}

std::optional<BoxStatus> readStatus(ByteView payload) {
    WireReader reader(payload);
    const auto sample = reader.number<uint64_t>();
    BoxStatus status;
    status.sample = static_cast<int64_t>(sample);
    status.temperature_c = finite(reader.real());
    status.humidity_percent = finite(reader.real());
    status.battery_v = finite(reader.real());
    status.battery_percent = finite(reader.real());
    status.dropped_samples = reader.number<uint32_t>();
    const size_t boards = reader.number<uint16_t>();
    reader.number<uint16_t>();
    if (!reader.ok() || !isSample(sample) || boards > kMaxBoards || reader.rest().size() != 2 * boards)
        return std::nullopt;
    for (size_t i = 0; i < boards; ++i)
        status.board_flags.push_back(reader.number<uint16_t>());
    return status;
}

Bytes toPayload(const BoxError& error) {
    Bytes payload;
    WireWriter writer(payload);
    writer.number(static_cast<uint16_t>(error.code));
    writer.number(uint16_t{0});
    writer.number(static_cast<uint64_t>(error.sample));
    writer.text(error.text);
    return payload;
}

std::optional<BoxError> readError(ByteView payload) {
    WireReader reader(payload);
    BoxError error;
    error.code = static_cast<Code>(reader.number<uint16_t>());
    reader.number<uint16_t>();
    const auto sample = reader.number<uint64_t>();
    error.sample = static_cast<int64_t>(sample);
    error.text = cleanText(reader.rest());
    return reader.ok() && isSample(sample) ? std::optional(error) : std::nullopt;
}

Bytes toPayload(const Identify& identify) {
    Bytes payload;
    WireWriter writer(payload);
    writer.number(identify.board);
    writer.number(identify.duration_ms);
    return payload;
}

std::optional<Identify> readIdentify(ByteView payload) {
    WireReader reader(payload);
    Identify identify;
    identify.board = reader.number<uint16_t>();
    identify.duration_ms = reader.number<uint16_t>();
    return reader.complete() ? std::optional(identify) : std::nullopt;
}

Bytes startPayload() {
    return Bytes(sizeof(uint64_t), 0);
}

std::string cleanText(ByteView bytes) {
    std::string text;
    while (!bytes.empty()) {
        const size_t length = characterBytes(bytes);
        if (length == 0)
            text += "\xEF\xBF\xBD";
        else
            text.append(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
        bytes = bytes.subspan(length == 0 ? 1 : length);
    }
    return text;
}

}  // namespace noctule::link
