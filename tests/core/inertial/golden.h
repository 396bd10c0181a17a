// SPDX-License-Identifier: Apache-2.0
// Reads the golden vectors: rows of text cells, without comment lines and the heading.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "core/inertial/frame_layout.h"

namespace noctule {

using Row = std::vector<std::string>;

inline std::vector<Row> goldenRows(const std::string& name) {
    std::ifstream file(std::string(NOCTULE_TEST_DATA) + "/inertial/" + name);
    EXPECT_TRUE(file.is_open()) << name;
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#')
            continue;
        Row cells(1);
        for (char c : line)
            if (c == ',')
                cells.emplace_back();
            else if (c != '\r')
                cells.back() += c;
        rows.push_back(cells);
    }
    if (!rows.empty())
        rows.erase(rows.begin());
    EXPECT_FALSE(rows.empty()) << name;
    return rows;
}

inline std::optional<int> cell(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(std::stoi(text));
}

template <size_t N>
std::array<int, N> numbers(const Row& row, size_t from) {
    std::array<int, N> values{};
    for (size_t i = 0; i < N; ++i)
        values[i] = std::stoi(row[from + i]);
    return values;
}

inline LineBits lineBits(const std::string& text) {
    EXPECT_EQ(text.size(), static_cast<size_t>(kBitsPerFrame));
    LineBits bits{};
    for (size_t i = 0; i < bits.size(); ++i)
        bits[i] = text[i] == '1';
    return bits;
}

}  // namespace noctule
