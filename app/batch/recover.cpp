// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "app/batch/verb.h"
#include "core/recording/recover_take.h"
#include "core/recording/take.h"
#include "core/session/take_folder.h"

namespace noctule::batch {
namespace {

namespace fs = std::filesystem;

enum class Condition { kFinished, kBrokeOff, kBeingRecorded, kDamaged, kUnreadable };

struct Candidate {
    std::string path;
    bool is_named = false;  ///< on the command line, not found in a folder
    Condition condition = Condition::kFinished;
    std::optional<Error> error{};  ///< why it is unreadable or damaged
};

bool isRecording(const Take& take) {
    const auto state = take.meta().find("state");
    return state != take.meta().end() && state->second == "recording";
}

Result<Candidate> lookAt(const std::string& path, bool is_named, const JobContext& job) {
    Candidate candidate{path, is_named};
    {
        const Result<Take> take = Take::open(path);
        if (take && !isRecording(*take)) {
            // It may be damaged where nothing was read to open it. Of folders that would take long.
            const Status sound = is_named ? checkIntegrity(path, job) : Status(Done{});
            if (!sound && sound.error().kind == ErrorKind::kCancelled)
                return sound.error();
            if (!sound && sound.error().is_damage) {
                candidate.condition = Condition::kDamaged;
                candidate.error = sound.error();
            }
            return candidate;
        }
        if (!take && !isThere(path + "-wal")) {
            candidate.condition = take.error().is_damage ? Condition::kDamaged : Condition::kUnreadable;
            candidate.error = take.error();
            return candidate;
        }
    }
    candidate.condition = isBeingWritten(path) ? Condition::kBeingRecorded : Condition::kBrokeOff;
    return candidate;
}

/// "takes/walk_001_recovered.noctule"
std::string recoveredPath(const std::string& path) {
    const fs::path take(path);
    return (take.parent_path() / (take.stem().string() + "_recovered" + kTakeExtension)).string();
}

/// All that are named; of folders, also in takes/ of a session's folder, those that are not finished.
Result<std::vector<Candidate>> candidates(const std::vector<std::string>& operands, const JobContext& job) {
    std::vector<Candidate> found;
    for (const std::string& operand : operands) {
        std::error_code ignored;
        if (!fs::is_directory(operand, ignored)) {
            if (!isThere(operand))
                return Error{ErrorKind::kUnreadable, operand + ": there is no such file or folder",
                             "Check the path"};
            Result<Candidate> named = lookAt(operand, true, job);
            if (!named)
                return named.error();
            found.push_back(std::move(*named));
            continue;
        }
        for (const fs::path& folder : {fs::path(operand), fs::path(operand) / "takes"})
            for (const std::string& file : takeFilesIn(folder))
                if (Result<Candidate> take = lookAt((folder / file).string(), false, job);
                    take &&
                    (take->condition == Condition::kBrokeOff || take->condition == Condition::kBeingRecorded))
                    found.push_back(std::move(*take));
    }
    return found;
}

Outcome leftAlone(const Candidate& take, const std::string& state, const std::string& why) {
    return {{{"take", take.path}, {"state", state}}, take.path + ": " + why + "\n", std::nullopt};
}

nlohmann::json lossesJson(const TakeLosses& losses) {
    nlohmann::json tables = nlohmann::json::object();
    for (const TableLoss& loss : losses.tables) {
        tables[loss.table] = {{"saved_rows", loss.saved}, {"lost_rows", nullptr}};
        if (loss.lost)
            tables[loss.table]["lost_rows"] = *loss.lost;
    }
    nlohmann::json all{{"tables", tables},
                       {"list_of_tables_damaged", losses.may_have_had_more},
                       {"mended_texts", losses.mended_texts}};
    if (losses.sound_s)
        all["sound"] = {{"saved_s", *losses.sound_s}, {"whole_s", losses.whole_sound_s}};
    return all;
}

Result<Outcome> recoverNow(const Candidate& take, const std::string& target, const JobContext& job) {
    const std::string& path = take.path;
    const Result<Recovery> recovered = recoverTake(path, target, job, take.error);
    if (!recovered)
        return recovered.error();
    nlohmann::json duration_s;
    char seconds[32] = "";
    if (const Result<Take> saved = Take::open(target); saved && saved->duration_s()) {
        duration_s = *saved->duration_s();
        if (*saved->duration_s() > 0)
            std::snprintf(seconds, sizeof seconds, "%.2f s ", *saved->duration_s());
    }
    Outcome outcome{
        {{"take", path}, {"state", "recovered"}, {"recovered", target}, {"duration_s", duration_s}},
        path + ": " + seconds + "recovered into " + target + "; the recording is as it was\n",
        std::nullopt};
    if (const Recovery& losses = *recovered) {
        outcome.json["lost"] = lossesJson(*losses);
        outcome.text += path + ": was damaged. " + savedText(*losses) + ".\n";
    }
    return outcome;
}

Result<Outcome> recoverOne(const Candidate& take, const JobContext& job) {
    const std::string target = recoveredPath(take.path);
    switch (take.condition) {
        case Condition::kFinished:
            return leftAlone(take, "finished", "is finished, there is nothing to recover");
        case Condition::kUnreadable:
            return *take.error;
        case Condition::kBeingRecorded:
            if (take.is_named)
                return Error{ErrorKind::kUsage, take.path + ": is being recorded right now",
                             "Stop the recording first, then there is nothing to recover"};
            return leftAlone(take, "being recorded", "is being recorded right now and was left alone");
        case Condition::kDamaged:
        case Condition::kBrokeOff:
            break;
    }
    if (take.is_named || !isThere(target))
        return recoverNow(take, target, job);
    Outcome before = leftAlone(take, "recovered before", "was recovered before, see " + target);
    before.json["recovered"] = target;
    return before;
}

Result<Outcome> runRecover(const VerbContext& context) {
    const auto takes = candidates(context.arguments.operands(), context.job());
    if (!takes)
        return takes.error();
    Outcome all{{{"takes", nlohmann::json::array()}}, "", std::nullopt};
    for (const Candidate& take : *takes) {
        const Result<Outcome> one = recoverOne(take, context.job());
        if (one) {
            all.json["takes"].push_back(one->json);
            all.text += one->text;
            continue;
        }
        if (takes->size() == 1 || one.error().kind == ErrorKind::kCancelled)
            return one.error();
        context.console.error(one.error());
        all.json["takes"].push_back({{"take", take.path}, {"error", errorJson(one.error())}});
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
    verb.summary = "make a finished take of a recording that broke off or of a damaged take";
    verb.operands = "FILE|FOLDER...";
    verb.min_operands = 1;
    verb.max_operands = kAnyNumber;
    verb.example = "noctule --batch recover session/takes/walk_003.noctule";
    verb.remarks = {
        "The result is NAME_recovered.noctule beside the recording, which stays as it is with its -wal.",
        "Of a folder all recordings that broke off are recovered, also those in its takes/. One that is "
        "being recorded is left alone, and so are finished takes: name a damaged one.",
        "Of a damaged one all rows that can be read are saved, and it is said how much that is. Lost rows "
        "are an estimate from the pages that hold them."};
    verb.run = runRecover;
    return verb;
}

}  // namespace noctule::batch
