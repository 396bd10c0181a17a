// SPDX-License-Identifier: Apache-2.0
// Bytes for tests of the link: the golden vectors, random ones, and what a reader makes of a stream.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "devices/driver_box/frame.h"
#include "devices/driver_box/messages.h"

namespace noctule::link {

inline Bytes fromHex(const std::string& hex) {
    Bytes bytes;
    for (size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}

/// A row of link_frames.txt.
struct GoldenFrame {
    bool from_box = false;
    uint32_t sequence = 0;
    std::string name;
    Bytes bytes;

    Bytes payload() const { return {bytes.begin() + kHeaderBytes, bytes.end() - kTailBytes}; }
    Type type() const { return static_cast<Type>(bytes[5]); }
};

inline std::vector<GoldenFrame> goldenFrames() {
    std::ifstream file(std::string(NOCTULE_TEST_DATA) + "/link/link_frames.txt");
    EXPECT_TRUE(file.is_open());
    std::vector<GoldenFrame> frames;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#')
            continue;
        std::vector<std::string> cells;
        size_t at = 0;
        for (size_t bar; (bar = line.find(" | ", at)) != std::string::npos; at = bar + 3)
            cells.push_back(line.substr(at, bar - at));
        cells.push_back(line.substr(at));
        frames.push_back(
            {cells[0] == "box", static_cast<uint32_t>(std::stoul(cells[1])), cells[2], fromHex(cells[3])});
    }
    EXPECT_EQ(frames.size(), 15u);
    return frames;
}

inline GoldenFrame goldenFrame(Type type) {
    for (const GoldenFrame& frame : goldenFrames())
        if (frame.type() == type)
            return frame;
    ADD_FAILURE() << nameOf(type);
    return {};
}

inline Bytes damagedStream() {
    std::ifstream file(std::string(NOCTULE_TEST_DATA) + "/link/link_damaged.hex");
    EXPECT_TRUE(file.is_open());
    std::string hex;
    for (std::string word; file >> word;)
        hex += word;
    return fromHex(hex);
}

inline void append(Bytes& to, const Bytes& bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

inline Bytes bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

inline Bytes randomBytes(std::mt19937& random, size_t count) {
    Bytes bytes(count);
    for (uint8_t& byte : bytes)
        byte = static_cast<uint8_t>(random());
    return bytes;
}

/// Everything a stream turned into, one line a frame, and the counts.
inline std::string readAll(FrameReader& reader, ByteView bytes, size_t piece) {
    std::ostringstream text;
    const FrameReader::Sink sink = [&](const LinkFrame& frame) {
        text << int{frame.header.type} << ' ' << frame.header.sequence << ':';
        for (const uint8_t byte : frame.payload)
            text << ' ' << int{byte};
        text << '\n';
    };
    for (size_t at = 0; at < bytes.size(); at += piece)
        reader.push(bytes.subspan(at, std::min(piece, bytes.size() - at)), 0, sink);
    const FrameStatistics& counts = reader.statistics();
    text << counts.frames << ' ' << counts.skipped_bytes << ' ' << counts.bad_headers << ' '
         << counts.damaged_payloads << ' ' << counts.unknown_versions << ' ' << counts.lost_frames << '\n';
    return text.str();
}

}  // namespace noctule::link
