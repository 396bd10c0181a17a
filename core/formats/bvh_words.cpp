// SPDX-License-Identifier: Apache-2.0
#include "core/formats/bvh_words.h"

#include <array>
#include <cmath>

#include "core/formats/bvh_scanner.h"
#include "core/formats/number_text.h"

namespace noctule {
namespace {

constexpr std::array<std::string_view, 6> kChannels{"Xposition", "Yposition", "Zposition",
                                                    "Xrotation", "Yrotation", "Zrotation"};

struct UnitWord {
    BvhUnit unit;
    std::string_view word;
    double metres;
};
constexpr std::array<UnitWord, 7> kUnits{{{BvhUnit::kMetre, "m", 1},
                                          {BvhUnit::kCentimetre, "cm", 0.01},
                                          {BvhUnit::kMillimetre, "mm", 0.001},
                                          {BvhUnit::kInch, "inch", 0.0254},
                                          {BvhUnit::kCmu, "cmu", 0.0254 / 0.45},
                                          {BvhUnit::kDecimetre, "dm", 0.1},
                                          {BvhUnit::kAuto, "auto", 0}}};

}  // namespace

std::optional<BvhChannel> channelFromText(std::string_view text) {
    for (size_t n = 0; n < kChannels.size(); ++n)
        if (sameWord(text, kChannels[n]))
            return static_cast<BvhChannel>(n);
    return std::nullopt;
}

std::string toText(BvhChannel channel) {
    return std::string(kChannels.at(static_cast<size_t>(channel)));
}

std::string numberRemedy(std::string_view word) {
    double value = 0;
    const char* end = word.data() + word.size();
    if (word.find(',') != std::string_view::npos)
        return "Write numbers with a decimal point and put spaces between them";
    if (word.find('#') != std::string_view::npos || parseNumber(word.data(), end, value) == end)
        return "Repair this value in the program that made the motion, or delete the row";
    return "Write a number here; a space may be missing";
}

Result<BvhUnit> bvhUnitFromText(const std::string& text) {
    for (const UnitWord& known : kUnits)
        if (text == known.word)
            return known.unit;
    return Error{ErrorKind::kUsage, inQuotes(text) + " is not a unit of BVH lengths",
                 "Give m, cm, mm, inch, cmu, dm or auto"};
}

std::string toText(BvhUnit unit) {
    return std::string(kUnits.at(static_cast<size_t>(unit)).word);
}

double metresPer(BvhUnit unit) {
    require(unit != BvhUnit::kAuto, "chooseUnit() says what auto means");
    return kUnits.at(static_cast<size_t>(unit)).metres;
}

}  // namespace noctule
