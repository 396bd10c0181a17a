// SPDX-License-Identifier: Apache-2.0
#include "app/batch/robot_profiles.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "app/batch/files.h"
#include "core/job/shared_folder.h"

namespace noctule::batch {
namespace {

Result<robot::RobotProfile> readProfile(const std::string& path) {
    const auto json = readJson(path);
    if (!json)
        return json.error();
    return robot::profileFromJson(*json, path);
}

/// The name comes from a file: it may not lead elsewhere.
bool isPlainName(const std::string& name) {
    return !name.empty() && name.size() < 200 && std::ranges::all_of(name, [](unsigned char letter) {
        return std::isalnum(letter) || letter == '_' || letter == '-';
    });
}

}  // namespace

Result<robot::RobotProfile> robotProfile(const robot::RobotModel& model, const std::string& path) {
    if (!path.empty())
        return readProfile(path);
    if (!isPlainName(model.name))
        return robot::makeProfile(model);
    const std::string saved = sharedPath("robots") + "/" + model.name + ".json";
    std::error_code ignored;
    return std::filesystem::exists(saved, ignored) ? readProfile(saved) : robot::makeProfile(model);
}

robot::MappingChoice armChoice(const std::string& arms) {
    robot::MappingChoice choice;
    choice.left = arms != "right";
    choice.right = arms != "left";
    return choice;
}

}  // namespace noctule::batch
