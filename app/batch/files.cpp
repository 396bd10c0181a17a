// SPDX-License-Identifier: Apache-2.0
#include "app/batch/files.h"

#include <filesystem>
#include <set>

#include "app/batch/option.h"
#include "app/batch/signals.h"
#include "core/formats/text_file.h"
#include "core/job/atomic_file.h"
#include "core/math/json.h"

namespace noctule::batch {
namespace {

template <class T>
Result<T> readDocument(const std::string& path,
                       Result<T> (*fromJson)(const nlohmann::json&, const std::string&)) {
    const auto json = readJson(path);
    return json ? fromJson(*json, path) : Result<T>(json.error());
}

}  // namespace

Result<nlohmann::json> readJson(const std::string& path) {
    const auto text = readTextFile(path, &signalFlag());
    if (!text)
        return text.error();
    nlohmann::json json = noctule::json::parse(*text);
    if (json.is_discarded())
        return Error{ErrorKind::kUnreadable, path + ": is not JSON", "Check that it is the right file"};
    return json;
}

Option bvhUnitOption() {
    return choice("bvh-unit", {"m", "cm", "mm", "inch", "cmu", "dm", "auto"},
                  "unit of lengths in BVH files; auto: from the figure's height")
        .orElse("auto");
}

Result<Suit> readSuit(const std::string& path) {
    return readDocument<Suit>(path, suitFromJson);
}

Result<Actor> readActor(const std::string& path) {
    return readDocument<Actor>(path, actorFromJson);
}

Result<Calibration> readCalibration(const std::string& path) {
    return readDocument<Calibration>(path, calibrationFromJson);
}

Status checkOutputs(const std::vector<std::string>& paths, bool overwrite,
                    const std::vector<std::string>& inputs) {
    const auto placeOf = [](const std::string& path) {
        std::error_code none;
        return std::filesystem::weakly_canonical(path, none).string();
    };
    std::set<std::string> reads, writes;
    for (const std::string& input : inputs)
        reads.insert(placeOf(input));
    for (const std::string& path : paths) {
        if (path.empty())
            continue;
        if (reads.contains(placeOf(path)))
            return Error{ErrorKind::kUsage, path + " is read and would be written", "Give another path"};
        if (!writes.insert(placeOf(path)).second)
            return Error{ErrorKind::kUsage, "two outputs would be " + path, "Give different paths"};
        if (Status free = checkOutputPath(path, overwrite); !free)
            return free;
    }
    return Done{};
}

Status checkOutputs(const Arguments& arguments, const std::vector<std::string>& outputs,
                    const std::set<std::string>& updated) {
    std::vector<std::string> paths;
    for (const std::string& option : outputs)
        paths.push_back(arguments.text(option));
    return checkOutputs(paths, arguments.given("overwrite"), arguments.inputFiles(updated));
}

Status writeJson(const std::string& path, const nlohmann::json& json, bool overwrite) {
    return writeFileAtomically(path, json.dump(2) + "\n", overwrite);
}

std::string takeName(const std::string& path) {
    return std::filesystem::path(path).stem().string();
}

}  // namespace noctule::batch
