// SPDX-License-Identifier: Apache-2.0
#include "core/processing/pose_runs.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "core/live/estimators.h"
#include "core/math/json.h"

namespace noctule {
namespace {

std::optional<int64_t> runNumber(const json::Json& settings, const char* member) {
    const auto found = settings.is_object() ? settings.find(member) : settings.end();
    return found == settings.end() || !found->is_number_integer() ? std::nullopt
                                                                  : std::optional(found->get<int64_t>());
}

/// The last run of a kind made before the pose run; of readings takes the primary rows.
std::optional<int64_t> likelyRun(const char* kind, const DerivedRun& pose_run,
                                 const std::vector<DerivedRun>& runs, TakeLevel level) {
    std::optional<int64_t> likely;
    if (level == TakeLevel::kReadings)
        likely = kPrimaryRun;
    for (const DerivedRun& run : runs)
        if (run.kind == kind && (!likely || run.run < pose_run.run))
            likely = run.run;
    return likely;
}

}  // namespace

bool RunSettings::joins(int suit, int other_suit) const {
    return !people_apart &&
           std::ranges::count(unjoined, suit) + std::ranges::count(unjoined, other_suit) == 0;
}

RunSettings runSettings(const DerivedRun& pose_run, const std::vector<DerivedRun>& runs, TakeLevel level) {
    const json::Json read = json::parse(pose_run.settings_json);
    RunSettings settings;
    settings.sensors = json::text(read, "sensors").value_or(settings.sensors);
    settings.estimator = json::text(read, "estimator").value_or("");
    settings.smoother = json::text(read, "smooth").value_or(settings.smoother);
    settings.detector = json::text(read, "detector").value_or("");
    settings.ground = json::text(read, "ground").value_or("");
    settings.contacts_edited = json::text(read, "contacts").value_or("") == kContactsEdited;
    settings.root_given = json::text(read, "root") == "given";
    const auto says = [&read](const char* member) {
        return read.is_object() && read.value(member, json::Json()) == true;
    };
    settings.uses_room = says("room");
    settings.between = says("between");
    settings.people_apart =
        subjectsOf(pose_run).size() > 1 && !settings.root_given && !settings.uses_room && !settings.between;
    if (const auto list = read.is_object() ? read.find("unjoined") : read.end();
        list != read.end() && list->is_array())
        for (const json::Json& suit : *list)
            if (suit.is_number_integer())
                settings.unjoined.push_back(suit.get<int>());
    settings.process_sigma_rad_per_s2 = json::number(read, "process_sigma_rad_per_s2");
    settings.inertial_run = runNumber(read, "inertial_run");
    if (!settings.inertial_run)
        settings.inertial_run = likelyRun("inertial", pose_run, runs, level);
    settings.range_run = runNumber(read, "range_run");
    if (!settings.range_run)
        settings.range_run = likelyRun("range", pose_run, runs, level);
    return settings;
}

std::vector<TakeSubject> subjectsOf(const DerivedRun& pose_run) {
    std::vector<TakeSubject> subjects;
    const json::Json settings = json::parse(pose_run.settings_json);
    const auto list = settings.is_object() ? settings.find("subjects") : settings.end();
    if (list != settings.end() && list->is_array())
        for (const json::Json& entry : *list)
            if (const auto suit = json::number(entry, "suit"); suit && *suit >= 1)
                subjects.push_back(
                    {json::text(entry, "name").value_or(""), {static_cast<int>(*suit)}, false});
    if (subjects.empty())
        subjects.push_back({"", {1}, false});
    return subjects;
}

std::string driftWarning(const std::string& estimator, const std::string& sensors, bool root_given,
                         double after_rest_s) {
    constexpr double kSeen_s = 60;  // drift of 1 to 3 degrees
    const EstimatorEntry* entry = findEstimator(estimator);
    const bool drifts = entry && entry->keeps_zeros && !root_given && sensors.find('G') != std::string::npos;
    if (!drifts || after_rest_s < kSeen_s)
        return "";
    char minutes[32];
    std::snprintf(minutes, sizeof minutes, "%.1f", after_rest_s / 60);
    return "Nothing corrected the heading in the " + std::string(minutes) +
           " minutes after the rest pose: estimator " + estimator +
           " keeps the gyroscopes' zeros of then. The heading drifts by 1 to 3° a minute, and so do joints "
           "that ranges do not back. Estimator manifold follows the zeros.";
}

std::vector<DerivedRun> poseRuns(const std::vector<DerivedRun>& runs) {
    std::vector<DerivedRun> poses;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(poses),
                 [](const DerivedRun& run) { return run.kind == "pose"; });
    return poses;
}

int resultNumber(const Take& take, const std::vector<DerivedRun>& runs, const DerivedRun& pose_run) {
    const std::string prefix = kDroppedResultKey;
    const auto is_earlier = [&](const DerivedRun& run) {
        return run.kind == "pose" && run.run < pose_run.run;
    };
    const auto was_earlier = [&](const auto& entry) {
        int64_t run = 0;
        const char* const end = entry.first.data() + entry.first.size();
        return entry.first.starts_with(prefix) &&
               std::from_chars(entry.first.data() + prefix.size(), end, run).ptr == end && run < pose_run.run;
    };
    return 1 + static_cast<int>(std::ranges::count_if(runs, is_earlier) +
                                std::ranges::count_if(take.meta(), was_earlier));
}

Result<DerivedRun> choosePoseRun(const Take& take, const std::string& name) {
    const auto runs = take.derivedRuns();
    if (!runs)
        return runs.error();
    const std::vector<DerivedRun> poses = poseRuns(*runs);
    if (poses.empty())
        return Error{ErrorKind::kUnusable, take.path() + ": has not been processed, there is no result",
                     "Run `noctule --batch process " + take.path() + "` first"};
    const auto found = std::find_if(poses.rbegin(), poses.rend(),
                                    [&](const DerivedRun& run) { return name.empty() || run.name == name; });
    if (found != poses.rend())
        return *found;
    std::string names;
    for (const DerivedRun& run : poses)
        names += (names.empty() ? "'" : ", '") + run.name + "'";
    return Error{ErrorKind::kUnusable, take.path() + ": has no result '" + name + "'",
                 "Its results are " + names};
}

Result<DerivedRun> poseRun(const Take& take, int64_t number) {
    const auto runs = take.derivedRuns();
    if (!runs)
        return runs.error();
    for (const DerivedRun& run : poseRuns(*runs))
        if (run.run == number)
            return run;
    return Error{ErrorKind::kUnusable, take.path() + ": has no result " + std::to_string(number),
                 "Open the take again to see its results"};
}

}  // namespace noctule
