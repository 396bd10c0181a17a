// SPDX-License-Identifier: Apache-2.0
#include "core/robot/saved_profile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/job/atomic_file.h"
#include "core/job/shared_folder.h"
#include "core/math/json.h"

namespace noctule::robot {
namespace {

constexpr size_t kMostProfileBytes = 1'000'000;

Result<RobotProfile> readProfile(const std::string& path, const CancelFlag* cancel) {
    ReadOptions options;
    options.cancel = cancel;
    options.most_bytes = options.most_stream_bytes = kMostProfileBytes;
    const auto text = readWholeFile(path, options);
    if (!text)
        return text.error();
    const nlohmann::json json = noctule::json::parse(*text);
    if (json.is_discarded())
        return Error{ErrorKind::kUnreadable, path + ": is not JSON", "Check that it is the right file"};
    return profileFromJson(json, path);
}

/// The name comes from a file: it may not lead elsewhere.
bool isPlainName(const std::string& name) {
    return !name.empty() && name.size() < 200 && std::ranges::all_of(name, [](unsigned char letter) {
        return std::isalnum(letter) || letter == '_' || letter == '-';
    });
}

Result<RobotProfile> foundProfile(const RobotModel& model, const std::string& path,
                                  const CancelFlag* cancel) {
    if (!path.empty())
        return readProfile(path, cancel);
    if (!isPlainName(model.name))
        return makeProfile(model);
    const std::string saved = sharedPath("robots") + "/" + model.name + ".json";
    std::error_code ignored;
    return std::filesystem::exists(saved, ignored) ? readProfile(saved, cancel) : makeProfile(model);
}

}  // namespace

Result<RobotProfile> profileFor(const RobotModel& model, const std::string& path, const CancelFlag* cancel) {
    auto profile = foundProfile(model, path, cancel);
    if (profile && profile->legs.empty())
        profile->legs = makeLegs(model);
    return profile;
}

}  // namespace noctule::robot
