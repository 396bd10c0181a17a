// SPDX-License-Identifier: Apache-2.0
// A small BVH text for tests, and ways to change and read it.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/formats/bvh.h"

namespace noctule::test {

/// Two joints, nine channels, two rows; line numbers in the tests below count from its first line.
inline const std::string kSmall =
    "HIERARCHY\n"                                                                 // 1
    "ROOT Hips\n"                                                                 // 2
    "{\n"                                                                         // 3
    "  OFFSET 0 90 0\n"                                                           // 4
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"  // 5
    "  JOINT Head\n"                                                              // 6
    "  {\n"                                                                       // 7
    "    OFFSET 0 60 0\n"                                                         // 8
    "    CHANNELS 3 Zrotation Xrotation Yrotation\n"                              // 9
    "    End Site\n"                                                              // 10
    "    {\n"                                                                     // 11
    "      OFFSET 0 20 0\n"                                                       // 12
    "    }\n"                                                                     // 13
    "  }\n"                                                                       // 14
    "}\n"                                                                         // 15
    "MOTION\n"                                                                    // 16
    "Frames: 2\n"                                                                 // 17
    "Frame Time: 0.01\n"                                                          // 18
    "1 2 3 10 20 30 40 50 60\n"                                                   // 19
    "4 5 6 11 21 31 41 51 61\n";                                                  // 20

inline std::string changed(const std::string& from, const std::string& to, std::string text = kSmall) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

inline BvhDocument parsed(const std::string& text) {
    Result<BvhDocument> document = parseBvh(text, "test.bvh");
    EXPECT_TRUE(document.ok()) << document.error().text();
    return document.ok() ? *document : BvhDocument{};
}

}  // namespace noctule::test
