// SPDX-License-Identifier: Apache-2.0
// Little-endian numbers of payloads and headers, written to and read from bytes. Reading past the end gives
// zeros and is remembered: look at ok() once, after the last member.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace noctule::link {

using Bytes = std::vector<uint8_t>;
using ByteView = std::span<const uint8_t>;

class WireWriter {
public:
    explicit WireWriter(Bytes& out) : out_(out) {}

    template <std::unsigned_integral T>
    void number(T value) {
        for (size_t i = 0; i < sizeof(T); ++i)
            out_.push_back(static_cast<uint8_t>(value >> (8 * i)));
    }
    void real(float value) { number(std::bit_cast<uint32_t>(value)); }
    void bytes(ByteView view) { out_.insert(out_.end(), view.begin(), view.end()); }
    void text(std::string_view text) { out_.insert(out_.end(), text.begin(), text.end()); }

private:
    Bytes& out_;
};

class WireReader {
public:
    explicit WireReader(ByteView bytes) : bytes_(bytes) {}

    template <std::unsigned_integral T>
    T number() {
        T value = 0;
        if (bytes_.size() < sizeof(T)) {
            ok_ = false;
            bytes_ = {};
            return value;
        }
        for (size_t i = 0; i < sizeof(T); ++i)
            value = static_cast<T>(value | static_cast<T>(static_cast<T>(bytes_[i]) << (8 * i)));
        bytes_ = bytes_.subspan(sizeof(T));
        return value;
    }
    float real() { return std::bit_cast<float>(number<uint32_t>()); }
    ByteView rest() const { return bytes_; }

    bool ok() const { return ok_; }
    /// All members were there and nothing follows.
    bool complete() const { return ok_ && bytes_.empty(); }

private:
    ByteView bytes_;
    bool ok_ = true;
};

}  // namespace noctule::link
