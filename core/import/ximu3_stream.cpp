// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/formats/number_text.h"
#include "core/import/column_text.h"
#include "core/import/ximu3.h"

namespace noctule {

namespace {

constexpr char kTermination = 0x0A, kEscape = char(0xDB), kEscapedEnd = char(0xDC),
               kEscapedEscape = char(0xDD);
constexpr size_t kTimestampBytes = 8, kValueBytes = 4;
constexpr size_t kLongestMessage = 4096;

/// The table of a letter and its width; null: of another kind.
struct StreamTable {
    Ximu3Table* table = nullptr;
    size_t width = 0;
};

StreamTable tableOfLetter(char letter, Ximu3Device& device) {
    switch (letter) {
        case 'I':
            return {&device.inertial, 6};
        case 'M':
            return {&device.magnetometer, 3};
        case 'Q':
            return {&device.quaternion, 4};
        case 'R':
            return {&device.matrix, 9};
        default:
            return {};
    }
}

/// Bytes without their stuffing; false when an escape is followed by anything else.
bool unstuff(std::string_view message, std::string& plain) {
    plain.clear();
    for (size_t i = 0; i < message.size(); ++i) {
        if (message[i] != kEscape) {
            plain += message[i];
            continue;
        }
        if (++i == message.size() || (message[i] != kEscapedEnd && message[i] != kEscapedEscape))
            return false;
        plain += message[i] == kEscapedEnd ? kTermination : kEscape;
    }
    return true;
}

template <class T>
T littleEndian(const char* bytes) {
    T value = 0;
    for (size_t i = 0; i < sizeof(T); ++i)
        value |= T(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return value;
}

double floatAt(const char* bytes) {
    const auto bits = littleEndian<uint32_t>(bytes);
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return std::isfinite(value) ? double(value) : kMissing;
}

bool addBinary(const std::string& plain, const StreamTable& into) {
    if (plain.size() != 1 + kTimestampBytes + kValueBytes * into.width)
        return false;
    into.table->time_s.push_back(1e-6 * double(littleEndian<uint64_t>(plain.data() + 1)));
    for (size_t i = 0; i < into.width; ++i)
        into.table->values.push_back(floatAt(plain.data() + 1 + kTimestampBytes + kValueBytes * i));
    return true;
}

bool addText(std::string_view message, const StreamTable& into) {
    const auto cells = cellsOfLine(message, ',');
    if (cells.size() != into.width + 2)
        return false;
    std::vector<double> numbers(into.width + 1);
    for (size_t i = 0; i < numbers.size(); ++i)
        if (!readCell(cells[i + 1], false, numbers[i]))
            return false;
    into.table->time_s.push_back(1e-6 * numbers[0]);
    into.table->values.insert(into.table->values.end(), numbers.begin() + 1, numbers.end());
    return true;
}

}  // namespace

Result<Ximu3Device> parseXimu3(std::string_view bytes, const JobContext& job) {
    Ximu3Device device;
    std::string plain;
    size_t messages = 0;
    for (size_t begin = 0; begin < bytes.size();) {
        const size_t end = bytes.find(kTermination, begin);
        if (end == std::string_view::npos) {
            device.cut = true;
            break;
        }
        const std::string_view message = bytes.substr(begin, end - begin);
        begin = end + 1;
        if (++messages % 4096 == 0 && job.cancelled())
            return JobContext::cancelledError();
        if (message.empty() || message[0] == '^')
            continue;
        if (message[0] == '{') {
            if (message.size() <= kLongestMessage)
                addXimu3Commands(message, device.settings);
            continue;
        }
        const bool binary = (static_cast<unsigned char>(message[0]) & 0x80) != 0;
        const StreamTable into = tableOfLetter(char(message[0] & 0x7F), device);
        if (!into.table)
            continue;
        const bool whole =
            message.size() <= kLongestMessage &&
            (binary ? unstuff(message, plain) && addBinary(plain, into) : addText(message, into));
        device.damaged += !whole;
    }
    return device;
}

}  // namespace noctule
