// SPDX-License-Identifier: Apache-2.0
// Damaged inputs in any number, the same on every machine: input `number` of a fuzzer comes from good
// examples by the random numbers of that number alone. A test runs few of them; NOCTULE_FUZZ_INPUTS=1000000
// runs more, and NOCTULE_FUZZ_FIRST=N begins at that one.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace noctule::test {

/// Of the environment, else `otherwise`.
inline int64_t countFromEnvironment(const char* name, int64_t otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoll(text) : otherwise;
}

class Mutator {
public:
    Mutator(uint64_t number, const std::vector<std::string>& examples)
        : random_(number * 0x9E3779B97F4A7C15U + 1), examples_(examples) {}

    /// One of the examples with one to many wounds; seldom whole.
    std::string next() {
        std::string text = pick();
        const size_t wounds = size_t{1} << below(below(4) == 0 ? 7 : 3);
        for (size_t i = 0; i < wounds; ++i)
            wound(text);
        return text;
    }
    size_t below(size_t count) { return static_cast<size_t>(random_() % count); }

private:
    const std::string& pick() { return examples_[below(examples_.size())]; }

    void wound(std::string& text) {
        static constexpr std::string_view kWords[] = {"0",
                                                      "-1",
                                                      "1e999",
                                                      "4294967296",
                                                      "9223372036854775807",
                                                      "99999999999999999999",
                                                      "null",
                                                      "{}",
                                                      "[]",
                                                      "\"\"",
                                                      "{",
                                                      "}",
                                                      "[",
                                                      ",",
                                                      "nan",
                                                      "\xff\xfe",
                                                      "\xc3",
                                                      "NCTL",
                                                      "\"format\"",
                                                      "\\u0000"};
        static constexpr unsigned char kBytes[] = {0, 1, 0x7f, 0x80, 0xff, 0x20, 0x0a, 0x0d};
        const size_t at = below(text.size() + 1);
        const size_t length = std::min(text.size() - at, below(below(4) == 0 ? 300 : 8) + 1);
        switch (below(9)) {
            case 0:
                return at < text.size() ? void(text[at] ^= static_cast<char>(1 << below(8))) : void();
            case 1:
                return at < text.size() ? void(text[at] = static_cast<char>(kBytes[below(8)])) : void();
            case 2:
                for (size_t i = at; i < at + length; ++i)
                    text[i] = static_cast<char>(random_());
                return;
            case 3:
                return void(text.erase(at, length));
            case 4:
                return void(text.insert(at, text.substr(at, length)));
            case 5:
                return void(text.insert(at, kWords[below(std::size(kWords))]));
            case 6:
                return void(text.replace(at, length, kWords[below(std::size(kWords))]));
            case 7: {
                const std::string& other = pick();
                return void(text.replace(at, length, other.substr(below(other.size() + 1), length)));
            }
            default:
                return below(8) == 0 ? text.resize(at) : void();
        }
    }

    std::mt19937_64 random_;
    const std::vector<std::string>& examples_;
};

/// Feeds `few` damaged inputs, or as many as the environment says, and sees that the memory stays bounded.
/// What crashes names itself: the number of the input stands in a trace.
template <class Feed>
void feedDamaged(const std::vector<std::string>& examples, int64_t few, int64_t most_growth_kb, Feed feed) {
    const auto residentPeak_kb = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    const int64_t first = countFromEnvironment("NOCTULE_FUZZ_FIRST", 0);
    const int64_t count = countFromEnvironment("NOCTULE_FUZZ_INPUTS", few);
    int64_t before_kb = 0;
    for (int64_t number = first; number < first + count; ++number) {
        if (number == first + few / 10)
            before_kb = residentPeak_kb();  // by now everything has been made once
        SCOPED_TRACE("NOCTULE_FUZZ_INPUTS=1 NOCTULE_FUZZ_FIRST=" + std::to_string(number));
        feed(Mutator(static_cast<uint64_t>(number), examples).next(), number);
        if (testing::Test::HasFailure())
            return;
    }
#ifdef NOCTULE_SANITIZED
    most_growth_kb += 512 * 1024;  // what was freed is kept for a while
#endif
    const int64_t growth_kb = residentPeak_kb() - before_kb;
    EXPECT_TRUE(before_kb == 0 || growth_kb <= most_growth_kb) << growth_kb << " kB";
    std::printf("%lld damaged inputs, memory grew by %lld kB\n", static_cast<long long>(count),
                static_cast<long long>(before_kb == 0 ? 0 : growth_kb));
}

}  // namespace noctule::test
