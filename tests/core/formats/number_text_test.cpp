// SPDX-License-Identifier: Apache-2.0
#include "core/formats/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace noctule {
namespace {

std::string fixedText(double value, int decimals) {
    std::string text;
    appendFixed(text, value, decimals);
    return text;
}

TEST(NumberText, ReadsWhatPeopleWrite) {
    for (const auto& [text, expected] : {std::pair("0", 0.0),
                                         {"+1.5", 1.5},
                                         {"-.5", -0.5},
                                         {"1.", 1.0},
                                         {"1E-3", 1e-3},
                                         {"0.0417083750417", 0.0417083750417},
                                         {"1e-400", 0.0}}) {
        double value = -1;
        EXPECT_TRUE(parseFiniteNumber(text, value)) << text;
        EXPECT_EQ(value, expected) << text;
    }
}

TEST(NumberText, RefusesEverythingElse) {
    double value = 0;
    for (const char* text : {"", " 1", "1 ", "+", "-", "+-1", "++1", "1,5", "1.5.2", "1e", "0x10", "nan",
                             "-inf", "1e999", "one"})
        EXPECT_FALSE(parseFiniteNumber(text, value)) << text;
    const char* infinite = "1e999";
    EXPECT_EQ(parseNumber(infinite, infinite + 5, value), infinite + 5);
    EXPECT_TRUE(std::isinf(value));
}

TEST(NumberText, WritesFixedDecimalsWithoutNegativeZero) {
    EXPECT_EQ(fixedText(-0.0000004, 6), "0.000000");
    EXPECT_EQ(fixedText(-0.0000006, 6), "-0.000001");
    EXPECT_EQ(fixedText(-12.5, 2), "-12.50");
    EXPECT_EQ(fixedText(std::numeric_limits<double>::max(), 8).size(), 309u + 9);
}

TEST(NumberText, ExactTextReadsBackTheSame) {
    for (const double value : {1.0 / 120, 1.0 / 3, 1e-6, 5e-324, 1e300, 0.1}) {
        std::string text;
        appendExact(text, value);
        EXPECT_EQ(text.find('e'), std::string::npos);
        double read = 0;
        EXPECT_TRUE(parseFiniteNumber(text, read)) << text;
        EXPECT_EQ(read, value) << text;
    }
}

TEST(NumberText, QuotesForPeople) {
    EXPECT_EQ(inQuotes("a\tb\x01"), "\"a?b?\"");
    EXPECT_EQ(inQuotes(std::string(100, 'x')), "\"" + std::string(40, 'x') + "...\"");
    EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \n"), "");
}

}  // namespace
}  // namespace noctule
