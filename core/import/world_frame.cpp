// SPDX-License-Identifier: Apache-2.0
#include "core/import/world_frame.h"

#include <algorithm>
#include <cctype>

namespace noctule {

const std::vector<std::string>& worldFrameNames() {
    static const std::vector<std::string> names = {"enu", "nwu", "ned", "opensim", "noctule"};
    return names;
}

std::optional<WorldFrame> worldFrameNamed(const std::string& name) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    const auto& names = worldFrameNames();
    const auto found = std::find(names.begin(), names.end(), lower);
    if (found == names.end())
        return std::nullopt;
    return static_cast<WorldFrame>(found - names.begin());
}

std::string worldFrameText(WorldFrame frame) {
    switch (frame) {
        case WorldFrame::kEastNorthUp:
            return "ENU (X east, Y north, Z up)";
        case WorldFrame::kNorthWestUp:
            return "NWU (X north or forward, Y west or left, Z up)";
        case WorldFrame::kNorthEastDown:
            return "NED (X north, Y east, Z down)";
        case WorldFrame::kForwardUpRight:
            return "OpenSim's ground (X forward, Y up, Z right)";
        case WorldFrame::kOurs:
            break;
    }
    return "Noctule's (X west or left, Y up, Z north or forward)";
}

Quaterniond worldFromFile(WorldFrame frame) {
    Matrix3d R = Matrix3d::Identity();
    switch (frame) {
        case WorldFrame::kEastNorthUp:
            R << -1, 0, 0, 0, 0, 1, 0, 1, 0;
            break;
        case WorldFrame::kNorthWestUp:
            R << 0, 1, 0, 0, 0, 1, 1, 0, 0;
            break;
        case WorldFrame::kNorthEastDown:
            R << 0, -1, 0, 0, 0, -1, 1, 0, 0;
            break;
        case WorldFrame::kForwardUpRight:
            R << 0, 0, -1, 0, 1, 0, 1, 0, 0;
            break;
        case WorldFrame::kOurs:
            break;
    }
    return Quaterniond(R);
}

}  // namespace noctule
