// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "app/batch/verb.h"
#include "core/recording/recover_take.h"
#include "core/recording/take.h"
#include "core/session/take_folder.h"

namespace noctule::batch {
namespace {

namespace fs = std::filesystem;

struct BrokenTake {
    std::string path;
    bool named = false;  ///< on the command line, not found in a folder
};

bool brokeOff(const std::string& path) {
    const Result<Take> take = Take::open(path);
    if (!take)
        return isThere(path + "-wal");
    const auto state = take->meta().find("state");
    return state != take->meta().end() && state->second == "recording";
}

/// "takes/walk_001_recovered.noctule"
std::string recoveredPath(const std::string& path) {
    const fs::path take(path);
    return (take.parent_path() / (take.stem().string() + "_recovered" + kTakeExtension)).string();
}

/// Of folders the takes that broke off, also those in takes/ of a session's folder.
Result<std::vector<BrokenTake>> brokenTakes(const std::vector<std::string>& operands) {
    std::vector<BrokenTake> found;
    for (const std::string& operand : operands) {
        std::error_code ignored;
        if (!fs::is_directory(operand, ignored)) {
            if (!isThere(operand))
                return Error{ErrorKind::kUnreadable, operand + ": there is no such file or folder",
                             "Check the path"};
            found.push_back({operand, true});
            continue;
        }
        for (const fs::path& folder : {fs::path(operand), fs::path(operand) / "takes"})
            for (const std::string& file : takeFilesIn(folder))
                if (brokeOff((folder / file).string()))
                    found.push_back({(folder / file).string(), false});
    }
    return found;
}

nlohmann::json lengthOf(const std::string& path) {
    const Result<Take> take = Take::open(path);
    const auto samples = take.ok() ? take->sampleCount() : Result<int64_t>(take.error());
    const auto rate_hz = take.ok() ? take->sampleRate_hz() : Result<int64_t>(take.error());
    if (!samples || !rate_hz)
        return nullptr;
    return static_cast<double>(*samples) / static_cast<double>(*rate_hz);
}

Result<Outcome> recoverOne(const BrokenTake& broken, const JobContext& job) {
    const std::string& path = broken.path;
    const std::string target = recoveredPath(path);
    if (!brokeOff(path)) {
        if (const Result<Take> take = Take::open(path); !take)
            return take.error();
        return Outcome{{{"take", path}, {"state", "finished"}},
                       path + ": is finished, there is nothing to recover\n",
                       std::nullopt};
    }
    if (!broken.named && isThere(target))
        return Outcome{{{"take", path}, {"state", "recovered before"}, {"recovered", target}},
                       path + ": was recovered before, see " + target + "\n",
                       std::nullopt};
    if (isBeingWritten(path))
        return Error{ErrorKind::kUsage, path + ": is being recorded right now",
                     "Stop the recording first, then there is nothing to recover"};
    if (const Status recovered = recoverTake(path, target, job); !recovered)
        return recovered.error();
    const nlohmann::json duration_s = lengthOf(target);
    char seconds[32] = "";
    if (duration_s.is_number())
        std::snprintf(seconds, sizeof seconds, "%.2f s", duration_s.get<double>());
    return Outcome{
        {{"take", path}, {"state", "recovered"}, {"recovered", target}, {"duration_s", duration_s}},
        path + ": " + seconds + " recovered into " + target + "; the recording is as it was\n",
        std::nullopt};
}

Result<Outcome> runRecover(const VerbContext& context) {
    const auto takes = brokenTakes(context.arguments.operands());
    if (!takes)
        return takes.error();
    Outcome all{{{"takes", nlohmann::json::array()}}, "", std::nullopt};
    for (const BrokenTake& broken : *takes) {
        const Result<Outcome> one = recoverOne(broken, context.job());
        if (one) {
            all.json["takes"].push_back(one->json);
            all.text += one->text;
            continue;
        }
        if (takes->size() == 1 || one.error().kind == ErrorKind::kCancelled)
            return one.error();
        context.console.error(one.error());
        all.json["takes"].push_back({{"take", broken.path}, {"error", errorJson(one.error())}});
        if (!all.failure)
            all.failure = one.error();
    }
    if (takes->empty())
        all.text = "No recording there broke off.\n";
    return all;
}

}  // namespace

Verb recoverVerb() {
    Verb verb;
    verb.name = "recover";
    verb.summary = "make a finished take of a recording that broke off";
    verb.operands = "FILE|FOLDER...";
    verb.min_operands = 1;
    verb.max_operands = kAnyNumber;
    verb.example = "noctule --batch recover session/takes/walk_003.noctule";
    verb.remarks = {
        "The result is NAME_recovered.noctule beside the recording, which stays as it is with its -wal. Of a "
        "folder all recordings that broke off are recovered, also those in its takes/."};
    verb.run = runRecover;
    return verb;
}

}  // namespace noctule::batch
