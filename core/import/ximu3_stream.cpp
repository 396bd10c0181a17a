// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/formats/number_text.h"
#include "core/import/column_text.h"
#include "core/import/ximu3.h"
#include "core/math/conventions.h"
#include "core/math/euler.h"

namespace noctule {

namespace {

constexpr char kTermination = 0x0A, kEscape = char(0xDB), kEscapedEnd = char(0xDC),
               kEscapedEscape = char(0xDD);
constexpr size_t kTimestampBytes = 8, kValueBytes = 4;
constexpr size_t kLongestMessage = 4096;
constexpr std::string_view kReadLetters = "IMQRALE";  ///< messages of other kinds are skipped

/// Adds the values of a message to the table of its letter; false when it has another count of them.
bool addValues(char letter, double time_s, const std::vector<double>& values, Ximu3Device& device) {
    const auto add = [&](Ximu3Table& table, size_t width) {
        if (values.size() == width)
            table.add(time_s, values.data(), width);
        return values.size() == width;
    };
    switch (letter) {
        case 'I':
            return add(device.inertial, 6);
        case 'M':
            return add(device.magnetometer, 3);
        case 'Q':
            return add(device.quaternion, 4);
        case 'R':
            return add(device.matrix, 9);
        default:  // A, L, E
            if (values.size() != 3 && (letter == 'A' || values.size() != 7))
                return false;
            if (letter == 'A' || values.size() == 7)
                addOtherAttitude(device.other_attitude, time_s, values.data(), letter == 'A');
            return true;
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

bool addBinary(char letter, const std::string& plain, Ximu3Device& device) {
    constexpr size_t kHead = 1 + kTimestampBytes;
    if (plain.size() < kHead || (plain.size() - kHead) % kValueBytes != 0)
        return false;
    std::vector<double> values;
    for (size_t at = kHead; at < plain.size(); at += kValueBytes)
        values.push_back(floatAt(plain.data() + at));
    return addValues(letter, 1e-6 * double(littleEndian<uint64_t>(plain.data() + 1)), values, device);
}

bool addText(char letter, std::string_view message, Ximu3Device& device) {
    const auto cells = cellsOfLine(message, ',');
    if (cells.size() < 2)
        return false;
    std::vector<double> numbers(cells.size() - 1);
    for (size_t i = 0; i < numbers.size(); ++i)
        if (!readCell(cells[i + 1], false, numbers[i]))
            return false;
    return addValues(letter, 1e-6 * numbers[0], {numbers.begin() + 1, numbers.end()}, device);
}

}  // namespace

void Ximu3Table::add(double time, const double* row, size_t width) {
    time_s.push_back(time);
    values.insert(values.end(), row, row + width);
}

void addOtherAttitude(Ximu3Table& attitude, double time_s, const double* values, bool are_angles) {
    if (!are_angles) {
        attitude.add(time_s, values, 4);
        return;
    }
    const Quaterniond q =
        rotationFromEuler(kEulerZYX, radians(1) * Vector3d(values[2], values[1], values[0]));
    const double wxyz[] = {q.w(), q.x(), q.y(), q.z()};
    attitude.add(time_s, wxyz, 4);
}

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
        const char letter = char(message[0] & 0x7F);
        if (kReadLetters.find(letter) == std::string_view::npos)
            continue;
        const bool whole = message.size() <= kLongestMessage &&
                           (binary ? unstuff(message, plain) && addBinary(letter, plain, device)
                                   : addText(letter, message, device));
        device.damaged += !whole;
    }
    return device;
}

}  // namespace noctule
