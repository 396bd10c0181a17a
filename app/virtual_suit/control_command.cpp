// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/control_command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "app/batch/option.h"
#include "core/job/nearest_word.h"

namespace noctule::virtual_suit {
namespace {

struct Shape {
    const char* name;
    ControlKind kind;
    size_t boards;
    const char* word;    ///< what it names: a pose, a side; null: none
    const char* number;  ///< its name; null: none
    double min, max;
};

constexpr double kFastest_rpm = 200;

constexpr Shape kShapes[] = {
    {"unplug", ControlKind::kUnplug, 1, nullptr, nullptr, 0, 0},
    {"plug", ControlKind::kPlug, 1, nullptr, nullptr, 0, 0},
    {"swap", ControlKind::kSwap, 2, nullptr, nullptr, 0, 0},
    {"slip", ControlKind::kSlip, 1, nullptr, "DEGREES", -360, 360},
    {"pose", ControlKind::kPose, 0, "NAME", nullptr, 0, 0},
    {"side", ControlKind::kSide, 0, "SIDE", nullptr, 0, 0},
    {"spin", ControlKind::kSpin, 0, "SIDE", "RPM", -kFastest_rpm, kFastest_rpm},
    {"placement", ControlKind::kPlacement, 0, nullptr, "N", 1, 100},
    {"roll", ControlKind::kRoll, 0, nullptr, "SECONDS", 0, 600},
    {"height", ControlKind::kHeight, 0, nullptr, "METRES", 0.05, 2},
    {"drop-bytes", ControlKind::kDropBytes, 0, nullptr, "RATE", 0, 1},
    {"flip-bits", ControlKind::kFlipBits, 0, nullptr, "RATE", 0, 1},
    {"stall", ControlKind::kStall, 0, nullptr, "SECONDS", 0, 3600},
    {"cut", ControlKind::kCut, 0, nullptr, "SECONDS", 0, 3600},
    {"battery", ControlKind::kBattery, 0, nullptr, "PERCENT", 0, 100},
    {"temperature", ControlKind::kTemperature, 0, nullptr, "C", -40, 85},
    {"quit", ControlKind::kQuit, 0, nullptr, nullptr, 0, 0},
};

std::string shortNumber(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

Error mistake(const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUsage, what, remedy};
}

std::string usageOf(const Shape& shape) {
    std::string text = shape.name;
    for (size_t i = 0; i < shape.boards; ++i)
        text += shape.boards == 1 ? " BOARD" : i == 0 ? " A" : " B";
    if (shape.word)
        text += std::string(" ") + shape.word;
    return shape.number ? text + " " + shape.number : text;
}

std::optional<double> numberIn(const std::string& word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole_word = error == std::errc() && end == word.data() + word.size();
    return whole_word && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Result<int> boardNamed(const std::string& word, const Suit& suit) {
    if (const int index = suit.findBoard(word); index >= 0)
        return index;
    const auto number = numberIn(word);
    const auto count = static_cast<double>(suit.boards.size());
    if (number && *number == std::floor(*number) && *number >= 1 && *number <= count)
        return static_cast<int>(*number) - 1;
    return mistake("no board '" + word + "' in this suit", "Give a number from 1 to " + shortNumber(count) +
                                                               " or an id such as " + suit.boards[0].id);
}

Error unknownCommand(const std::string& name) {
    std::vector<std::string> names;
    for (const Shape& shape : kShapes)
        names.emplace_back(shape.name);
    const std::string near = nearestWord(name, names);
    return mistake("unknown command '" + name + "'",
                   near.empty() ? "Choose " + batch::listed(names) : "Did you mean " + near + "?");
}

/// "+x", "-x", "x" of any axis.
Status readSide(const std::string& word, ControlCommand& command) {
    for (const simulation::RigSide side : simulation::allRigSides())
        if (word == side.name() || "+" + word == side.name()) {
            command.side = side;
            return Done{};
        }
    return mistake("no side '" + word + "'", "Give the axis that points up: +x, -x, +y, -y, +z or -z");
}

Status readPose(const std::string& word, ControlCommand& command) {
    if (std::find(std::begin(kPoses), std::end(kPoses), word) == std::end(kPoses))
        return mistake("no pose '" + word + "'", "Choose rest, t or sit");
    command.pose = word;
    return Done{};
}

Result<ControlCommand> filledIn(const Shape& shape, const std::vector<std::string>& words, const Suit& suit) {
    if (words.size() != 1 + shape.boards + (shape.word ? 1 : 0) + (shape.number ? 1 : 0))
        return mistake("'" + words[0] + "' with " + std::to_string(words.size() - 1) + " values",
                       "Write " + usageOf(shape));
    ControlCommand command;
    command.kind = shape.kind;
    for (size_t i = 0; i < shape.boards; ++i) {
        const auto board = boardNamed(words[1 + i], suit);
        if (!board)
            return board.error();
        (i == 0 ? command.board : command.other_board) = *board;
    }
    if (command.board >= 0 && command.board == command.other_board)
        return mistake("both are board " + suit.boards[command.board].id, "Name two boards");
    if (shape.word)
        if (Status read = (shape.kind == ControlKind::kPose ? readPose : readSide)(words[1], command); !read)
            return read.error();
    if (!shape.number)
        return command;
    const auto number = numberIn(words.back());
    if (!number || *number < shape.min || *number > shape.max)
        return mistake(words[0] + " cannot be '" + words.back() + "'",
                       "Give a number from " + shortNumber(shape.min) + " to " + shortNumber(shape.max));
    if (shape.kind == ControlKind::kPlacement && *number != std::floor(*number))
        return mistake("no placement '" + words.back() + "'", "Give a whole number");
    command.number = *number;
    return command;
}

}  // namespace

Result<ControlCommand> parseControlCommand(std::string_view line, const Suit& suit) {
    std::istringstream stream{std::string(line)};
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    if (words.empty())
        return mistake("an empty line", "Write a command, such as quit");
    const auto shape = std::find_if(std::begin(kShapes), std::end(kShapes),
                                    [&](const Shape& one) { return words[0] == one.name; });
    return shape == std::end(kShapes) ? unknownCommand(words[0]) : filledIn(*shape, words, suit);
}

}  // namespace noctule::virtual_suit
