// SPDX-License-Identifier: Apache-2.0
#include "core/processing/write_runs.h"

#include <algorithm>

#include "core/live/estimators.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

std::string namesOf(const std::vector<TakeSubject>& subjects) {
    std::string names;
    for (const TakeSubject& subject : subjects)
        if (!subject.room)
            names += (names.empty() ? "" : ", ") + subject.name;
    return names;
}

/// Those that poses are made of. Says in `warnings` what is left out.
Result<std::vector<TakeSubject>> chooseSubjects(const Take& take, const ProcessRequest& request,
                                                std::vector<std::string>& warnings) {
    const auto all = take.subjects();
    if (!all)
        return all.error();
    for (const std::string& name : request.subjects)
        if (std::ranges::none_of(*all, [&](const auto& one) { return !one.room && one.name == name; }))
            return Error{ErrorKind::kUsage, take.path() + ": has no subject '" + name + "'",
                         namesOf(*all).empty() ? "It is of one performer: leave out the subjects"
                                               : "Its subjects are " + namesOf(*all)};
    for (const int suit : take.suitIds())
        if (take.actorInForce(suit) && std::ranges::none_of(*all, [suit](const TakeSubject& one) {
                return std::ranges::count(one.suits, suit) > 0;
            }))
            warnings.push_back("Suit " + std::to_string(suit) +
                               " has an actor, but the take's subjects do not name it: it is left out.");
    std::vector<TakeSubject> chosen;
    for (const TakeSubject& subject : *all) {
        if (!subject.room &&
            (request.subjects.empty() || std::ranges::count(request.subjects, subject.name) > 0))
            chosen.push_back(subject);
        if (!subject.room && subject.suits.size() > 1)
            warnings.push_back(subject.name + " wears several suits: only suit " +
                               std::to_string(subject.suit()) + " is used yet.");
    }
    if (chosen.size() > 1 && (request.calibration || request.actor))
        return Error{ErrorKind::kUsage, "one calibration or actor cannot be that of several subjects",
                     "Choose one of " + namesOf(*all) + " (--subjects NAME)"};
    return chosen;
}

Result<std::vector<Ingredients>> gatherAll(Take& take, const ProcessRequest& request,
                                           std::vector<std::string>& warnings) {
    const auto subjects = chooseSubjects(take, request, warnings);
    if (!subjects)
        return subjects.error();
    std::vector<Ingredients> all;
    for (const TakeSubject& subject : *subjects) {
        take.view(subject.suit());
        std::vector<std::string> own;
        auto in = gatherIngredients(take, request, own);
        if (!in)
            return in.error();
        if (!findEstimator(request.tracker.estimator)->whole_take)
            if (Status enough = checkSensors(take, request.tracker, in->suit, own); !enough)
                return enough.error();
        if (!in->actor_id && !request.actor)
            own.push_back("The default actor is kept in the take, with the poses.");
        for (const std::string& warning : own)
            warnings.push_back((subjects->size() > 1 ? subject.name + ": " : "") + warning);
        in->subject = subject;
        all.push_back(std::move(*in));
    }
    return all;
}

constexpr double kPatience_s = 3600;  ///< several processings of one take wait for each other

struct SubjectWork {
    const ProcessRequest& request;
    const FillRuns& fill;
    const FillTogether& together;
};

/// Whether the calibration is good enough for the sensors asked for.
void gradeSubject(const Ingredients& in, const std::string& who, const ProcessRequest& request, bool first,
                  ProcessSummary& summary) {
    const Grade calibrated = gradeOf(in.lack, sensorLetters(request.tracker));
    if (calibrated > summary.calibrated || first) {
        summary.lack = in.lack;
        summary.calibrated = calibrated;
    }
    if (calibrated != Grade::kGood)
        summary.warnings.push_back(who + (calibrated == Grade::kNotUsable
                                              ? "Not usable: " + lackClause(in.lack)
                                              : lackSentence(in.lack)));
}

/// All of them at once, where something joins them; false: nothing does.
Result<bool> fillTogether(Take& take, std::vector<Ingredients>& subjects, const SubjectWork& work,
                          ResultRuns& runs) {
    if (!work.together)
        return false;
    auto filled = work.together(take, subjects, runs);
    if (!filled || !*filled)
        return filled;
    for (const Ingredients& in : subjects)
        gradeSubject(in, subjects.size() > 1 ? in.subject.name + ": " : "", work.request,
                     &in == &subjects.front(), runs.summary);
    for (const ProcessSummary::Subject& subject : runs.summary.subjects)
        if (subject.poses == 0)
            return unusableTake(take, subject.name + ": it is too short or holds no sound: no pose came out",
                                "`noctule --batch inspect` shows what is in it");
    return true;
}

/// `who`: "Anna: " when there are several subjects.
Status fillSubject(const Take& take, const Ingredients& in, const std::string& who, const SubjectWork& work,
                   ResultRuns& runs) {
    if (Status begun = runs.beginSubject(in); !begun)
        return begun;
    gradeSubject(in, who, work.request, runs.summary.subjects.size() == 1, runs.summary);
    if (Status filled = work.fill(take, in, runs); !filled)
        return filled;
    if (runs.summary.subjects.back().poses == 0)
        return unusableTake(take, who + "it is too short or holds no sound: no pose came out",
                            "`noctule --batch inspect` shows what is in it");
    const TrackerSettings& tracker = work.request.tracker;
    const int64_t after_rest = in.sample_count - (in.rest ? in.rest->second : 0);
    if (const std::string drift =
            driftWarning(tracker.estimator, sensorLetters(tracker), tracker.root_given,
                         static_cast<double>(after_rest) / in.decoder.train.sample_rate_hz);
        !drift.empty())
        runs.summary.warnings.push_back(who + drift);
    return Done{};
}

/// Those whose box was lost while the rest pose was held: poses need all of it. Where nobody remains, they
/// stay, and the caller says so.
void leaveOutShort(std::vector<Ingredients>& subjects, std::vector<std::string>& warnings) {
    const auto is_short = [](const Ingredients& in) {
        return in.rest && endsInRest(in.sample_count, in.rest->second);
    };
    if (std::ranges::all_of(subjects, is_short))
        return;
    for (const Ingredients& in : subjects)
        if (is_short(in))
            warnings.push_back(in.subject.name +
                               ": the recording ends before the rest pose does. There are no poses of it.");
    std::erase_if(subjects, is_short);
}

/// Reads and computes; nothing is written into the take.
Result<ResultRuns> compute(Take& take, const ProcessRequest& request, std::vector<Ingredients>& subjects,
                           const SubjectWork& work, const CancelFlag* cancel) {
    const auto moment = take.snapshot();
    if (!moment)
        return moment.error();
    std::vector<std::string> warnings;
    auto all = gatherAll(take, request, warnings);
    if (!all)
        return all.error();
    leaveOutShort(*all, warnings);
    auto clocks = joinClocks(take, {nullptr, cancel});
    if (!clocks)
        return clocks.error();
    for (Ingredients& in : *all)
        in.clock = clocks->best(in.subject.suit(), in.clock);
    subjects = std::move(*all);
    auto runs = ResultRuns::begin(take, request, subjects);
    if (!runs)
        return runs.error();
    runs->summary.warnings = warnings;
    runs->clocks = std::move(*clocks);
    const auto together = fillTogether(take, subjects, work, *runs);
    if (!together)
        return together.error();
    if (!*together)
        runs->summary.warnings.insert(runs->summary.warnings.end(), runs->clocks.warnings.begin(),
                                      runs->clocks.warnings.end());
    for (const Ingredients& in : subjects) {
        if (*together)
            break;
        take.view(in.subject.suit());
        const std::string who = subjects.size() > 1 ? in.subject.name + ": " : "";
        if (Status filled = fillSubject(take, in, who, work, *runs); !filled)
            return filled.error();
    }
    for (const SkippedRows& skipped : take.skippedRows())
        runs->summary.warnings.push_back(std::to_string(skipped.count) + " rows of " + skipped.table +
                                         " could not be used, first " + skipped.first + ".");
    return runs;
}

}  // namespace

Result<ProcessSummary> writeRuns(const ProcessRequest& request, const FillRuns& fill,
                                 const CancelFlag* cancel, const FillTogether& together) {
    auto take = Take::open(request.take_path, Access::kReadWrite, {cancel, kPatience_s});
    if (!take)
        return take.error();
    std::vector<Ingredients> subjects;
    auto runs = compute(*take, request, subjects, {request, fill, together}, cancel);
    if (!runs)
        return runs.error();
    if (Status stored = runs->store(*take, request, subjects); !stored)
        return stored.error();
    return std::move(runs->summary);
}

}  // namespace noctule
