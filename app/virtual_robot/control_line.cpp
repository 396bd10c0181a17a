// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_robot/control_line.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <vector>

#include "app/batch/option.h"

namespace noctule::virtual_robot {
namespace {

enum class Operand { kNone, kNumber, kJoint };

struct FaultShape {
    const char* name;
    FaultKind kind;
    Operand operand;
    const char* placeholder;
    double max;
};

constexpr FaultShape kFaults[] = {
    {"stall", FaultKind::kStall, Operand::kNumber, "SECONDS", 3600},
    {"cut", FaultKind::kCut, Operand::kNumber, "SECONDS", 3600},
    {"latency", FaultKind::kLatency, Operand::kNumber, "MS", 10'000},
    {"lag", FaultKind::kLag, Operand::kNumber, "MS", 10'000},
    {"refuse", FaultKind::kRefuse, Operand::kNone, "", 0},
    {"accept", FaultKind::kAccept, Operand::kNone, "", 0},
    {"joint-stuck", FaultKind::kJointStuck, Operand::kJoint, "NAME", 0},
    {"joint-free", FaultKind::kJointFree, Operand::kJoint, "NAME", 0},
    {"quit", FaultKind::kQuit, Operand::kNone, "", 0},
};

std::string usageOf(const FaultShape& shape) {
    return std::string(shape.name) + (*shape.placeholder ? " " + std::string(shape.placeholder) : "");
}

Error wrongLine(const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUsage, what, remedy};
}

}  // namespace

std::string controlHelp() {
    std::string text;
    for (const FaultShape& shape : kFaults)
        text += (text.empty() ? "  " : ", ") + usageOf(shape);
    return text + ".\n";
}

Result<ControlLine> parseControlLine(std::string_view line) {
    std::istringstream words{std::string(line)};
    std::string name, operand, more;
    words >> name >> operand >> more;
    std::vector<std::string> known;
    for (const FaultShape& shape : kFaults)
        known.emplace_back(shape.name);
    const auto shape =
        std::ranges::find(kFaults, name, [](const FaultShape& s) { return std::string(s.name); });
    if (shape == std::end(kFaults))
        return wrongLine("'" + name + "' is no command", "Write one of " + batch::listed(known));
    if ((shape->operand == Operand::kNone) != operand.empty() || !more.empty())
        return wrongLine("'" + std::string(line) + "' has too few or too many words",
                         "Write " + usageOf(*shape));
    ControlLine command{shape->kind, 0, operand};
    if (shape->operand != Operand::kNumber)
        return command;
    const char* const end = operand.data() + operand.size();
    const auto [read_to, error] = std::from_chars(operand.data(), end, command.number);
    if (error != std::errc() || read_to != end || !(command.number >= 0 && command.number <= shape->max))
        return wrongLine(
            "'" + operand + "' is no number from 0 to " + std::to_string(static_cast<int>(shape->max)),
            "Write " + usageOf(*shape));
    return command;
}

}  // namespace noctule::virtual_robot
