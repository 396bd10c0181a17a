// SPDX-License-Identifier: Apache-2.0
#include "core/processing/evaluate_take.h"

#include <algorithm>
#include <cstdio>

#include "core/body/bone_names.h"
#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/live/estimators.h"
#include "core/math/json.h"
#include "core/math/rotation.h"
#include "core/processing/ingredients.h"
#include "core/processing/pose_runs.h"
#include "core/processing/run_command.h"
#include "core/processing/take_quality.h"
#include "core/report/joint_support.h"

namespace noctule {
namespace {

constexpr size_t kMostRunsBeside = 7;  // as many as the report draws

/// What all runs are compared with.
struct Reference {
    TimedMotion motion;
    std::map<std::string, std::string> names;  ///< our joint, the file's joint
    ComparisonOptions options;
    bool there = false;
};

std::string metaText(const Take& take, const char* key) {
    const auto found = take.meta().find(key);
    return found == take.meta().end() ? "" : found->second;
}

std::string shortNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

Result<ReportTake> describeTake(const Take& take) {
    const TakeHeader& header = take.header();
    ReportTake described;
    described.name = header.name;
    described.file = take.path();
    described.uuid = header.uuid;
    described.created_utc = header.created_utc;
    described.performer = metaText(take, "performer");
    described.actor_name = metaText(take, "actor_name");
    described.software = header.software;
    described.level = take.level() == TakeLevel::kReadings ? "readings" : "signal";
    const auto rate = take.sampleRate_hz();
    if (!rate)
        return rate.error();
    described.sample_rate_hz = static_cast<double>(*rate);
    const auto samples = take.sampleCount();
    if (!samples)
        return samples.error();
    described.duration_s = static_cast<double>(*samples) / described.sample_rate_hz;
    described.begin_s = take.suitClock().takeTime_s(0);
    const auto rest = take.restInterval();
    if (!rest)
        return rest.error();
    if (*rest) {
        described.rest_s =
            take.suitClock().takeTime_s(static_cast<double>((*rest)->last) / described.sample_rate_hz);
        described.ends_in_rest = endsInRest(*samples, (*rest)->last);
    }
    const auto notes = take.notes();
    if (!notes)
        return notes.error();
    for (const NoteRow& note : *notes)
        described.notes.push_back(note.text);
    return described;
}

/// Names of a stored reference's joints in its file; none when they are not known.
std::map<std::string, std::string> storedNames(const Take& take) {
    std::map<std::string, std::string> names;
    const nlohmann::json stored = json::parse(metaText(take, "reference_joints"));
    if (stored.is_object())
        for (const auto& [joint, name] : stored.items())
            if (name.is_string())
                names[joint] = name.get<std::string>();
    return names;
}

/// `target`: of the shown run.
Result<Reference> chooseReference(const Take& take, const EvaluateRequest& request, const Skeleton& target,
                                  ReportData& data) {
    Reference reference;
    reference.options.from_ns = std::llround(data.take.rest_s * 1e9);
    if (request.reference) {
        ReferenceMotion outside = referenceFrom(*request.reference, target);
        reference.motion = std::move(outside.motion);
        reference.names = std::move(outside.names);
        reference.options.match_segments = !outside.in_our_frames;
        reference.options.align_time = true;
        data.take.reference_kind = "file";
        data.take.reference_name = request.reference_name;
    } else {
        auto stored = take.reference();
        if (!stored)
            return stored.error();
        reference.motion = std::move(*stored);
        if (!reference.motion.frames.empty()) {
            const std::string kind = shortText(metaText(take, "reference_kind"), limits::kName);
            data.take.reference_kind = kind.empty() ? "unnamed" : kind;
            reference.names = storedNames(take);
            // A take's own reference has frames that are parallel in the zero pose, whatever its bones
            // measure.
            // Imports of MVNX did not say at first that theirs are not.
            const std::string frames = metaText(take, "reference_frames");
            reference.options.match_segments = frames == "own" || (frames.empty() && kind == "mvnx");
        }
    }
    reference.there = !reference.motion.frames.empty();
    if (!reference.there)
        data.warnings.push_back("There is no reference: how far the angles are off cannot be said.");
    return reference;
}

/// Constant differences that the comparison cannot count are said, with the joints by name.
void warnOfMatchedSegments(const Comparison& comparison, const Skeleton& skeleton, ReportData& data) {
    std::string joints;
    size_t count = 0;
    for (const MatchedJoint& joint : comparison.matched)
        if (joint.moves && joint.segment.from == FrameFrom::kMotion) {
            joints += (joints.empty() ? "" : ", ") + joint.name;
            ++count;
        }
    if (count > 0)
        data.warnings.push_back(
            "The reference has other axes or another rest pose, and its bones do not show how " +
            std::to_string(count) +
            " segments are turned. That was taken from the result: constant errors of these are not "
            "counted: " +
            joints + ".");
    const size_t moving = static_cast<size_t>(
        std::ranges::count_if(comparison.matched, [](const MatchedJoint& joint) { return joint.moves; }));
    const auto main_joints =
        static_cast<size_t>(std::ranges::count_if(mainJoints(), [&](const std::string& name) {
            const int joint = skeleton.find(name);
            return joint >= 0 && skeleton.joint(joint).type != JointType::kFixed;
        }));
    if (moving < main_joints)
        data.warnings.push_back("Only " + std::to_string(moving) +
                                " joints of the reference were recognised by their names.");
}

std::string calibrationName(const Take& take, const DerivedRun& run) {
    if (!run.calibration_id)
        return "nominal";
    std::string name = std::to_string(*run.calibration_id);
    if (const auto calibration = take.calibration(*run.calibration_id); calibration.ok())
        if (!calibration->created_utc.empty())
            name += " (" + calibration->created_utc + ")";
    return name;
}

/// Without the gyroscopes that were asked for where a filter had to go on without. Attitudes of other makers'
/// sensors (whole_take) were made with theirs.
std::string sensorsUsed(const Take& take, const RunSettings& settings) {
    std::string sensors = settings.sensors;
    const EstimatorEntry* estimator = findEstimator(settings.estimator);
    if (take.level() != TakeLevel::kReadings || take.suitIds().size() > 1 || !estimator ||
        estimator->whole_take)
        return sensors;
    if (const auto measured = take.measured(); measured && !measured->gyroscopes)
        std::erase(sensors, 'G');
    return sensors;
}

ReportRun describeRun(const Take& take, const DerivedRun& run, const RunSettings& settings) {
    ReportRun described;
    described.name = run.name;
    described.sensors = sensorsUsed(take, settings);
    described.estimator = settings.estimator.empty() ? "unknown" : settings.estimator;
    described.smoother = settings.smoother;
    described.root_given = settings.root_given;
    described.created_utc = run.created_utc;
    described.software = run.software;
    described.calibration = calibrationName(take, run);
    if (!settings.detector.empty())
        described.settings.emplace_back("Detector", settings.detector);
    if (settings.process_sigma_rad_per_s2)
        described.settings.emplace_back("Process sigma",
                                        shortNumber(*settings.process_sigma_rad_per_s2) + " rad/s²");
    if (const std::string command = commandOfRun(run, take.path()); !command.empty())
        described.settings.emplace_back("Made again by", command);
    return described;
}

std::string soundText(const SoundModel& sound) {
    std::string text = sound.kind == SoundModel::Kind::kCramer   ? "Cramer 1993"
                       : sound.kind == SoundModel::Kind::kLinear ? "linear in temperature"
                                                                 : shortNumber(sound.c_m_per_s) + " m/s";
    return sound.scale == 1 ? text : text + " times " + shortNumber(sound.scale);
}

void describeProvenance(const Take& take, const Calibration& calibration, const DerivedRun& run,
                        ReportData& data) {
    data.provenance.emplace_back("Calibration",
                                 NamedValues{{"In the take", calibrationName(take, run)},
                                             {"Speed of sound", soundText(calibration.sound)},
                                             {"Boards", std::to_string(calibration.boards.size())},
                                             {"Sources", std::to_string(calibration.sources.size())}});
    NamedValues simulated;
    for (const auto& [key, words] : {std::pair("x_scenario", "Scenario"), std::pair("x_seed", "Seed")})
        if (const std::string value = shortText(metaText(take, key), limits::kName); !value.empty())
            simulated.emplace_back(words, value);
    if (!simulated.empty())
        data.provenance.emplace_back("Simulation", simulated);
}

/// What the run was made with; a take that lost it is still judged as far as possible.
struct RunParts {
    Suit suit;
    Calibration calibration;
    Actor actor;
};

Result<RunParts> partsOf(const Take& take, const DerivedRun& run) {
    RunParts parts;
    auto suit = take.suit();
    if (!suit)
        return suit.error();
    parts.suit = std::move(*suit);
    auto calibration = run.calibration_id ? take.calibration(*run.calibration_id)
                                          : Result<Calibration>(nominalCalibration(parts.suit));
    parts.calibration = calibration ? std::move(*calibration) : nominalCalibration(parts.suit);
    if (run.actor_id) {
        auto actor = take.actor(*run.actor_id);
        if (!actor)
            return actor.error();
        parts.actor = std::move(*actor);
    } else if (auto in_force = take.actorInForce(); in_force) {
        parts.actor = std::move(in_force->value);
    } else {
        parts.actor = defaultActor();
    }
    return parts;
}

/// How many distances the take was given with, and how many of them cannot be.
Status countDistances(const Take& take, ReportData& data, const JobContext& job) {
    auto ranges = take.ranges(kPrimaryRun);
    if (!ranges)
        return ranges.error();
    while (true) {
        const auto range = ranges->next();
        if (!range)
            return range.error();
        if (!*range)
            break;
        if (++data.distances_given % 4096 == 0 && job.cancelled())
            return JobContext::cancelledError();
    }
    for (const SkippedRows& skipped : take.skippedRows())
        if (skipped.table == rowsOfSuit("range", take.viewed()))
            data.distances_refused = skipped.count;
    data.distances_given += data.distances_refused;
    return Done{};
}

/// Boards, pulses and what each joint rested on, for the shown run.
Status addQuality(const Take& take, const DerivedRun& run, const RunSettings& settings, ReportData& data,
                  const JobContext& job) {
    const auto motion = take.poseSource(run.run);
    if (!motion)
        return motion.error();
    const auto parts = partsOf(take, run);
    if (!parts)
        return parts.error();
    describeProvenance(take, parts->calibration, run, data);
    data.lack = lackOfTake(take, parts->suit, parts->calibration);
    for (const Source& source : parts->suit.sources)
        data.sources.push_back({source.id, source.segment});
    if (settings.inertial_run) {
        auto boards = boardQuality(take, parts->suit, parts->calibration, *settings.inertial_run);
        if (!boards)
            return boards.error();
        data.boards = std::move(*boards);
    }
    const auto gaps = take.gaps();
    if (!gaps)
        return gaps.error();
    const auto takeTime_s = [&](int64_t sample) {
        return take.suitClock().takeTime_s(static_cast<double>(sample) / data.take.sample_rate_hz);
    };
    for (const GapRow& gap : *gaps)
        if (!gap.board)
            data.gaps_s.emplace_back(takeTime_s(gap.first_sample),
                                     takeTime_s(gap.first_sample + gap.sample_count));
    job.progress(0.5, "Counting pulses");
    LineOfSight sight(parts->suit, parts->calibration, parts->actor);
    auto pairs = pairQuality(take, parts->suit, settings.range_run, &*motion, &sight, job);
    if (!pairs)
        return pairs.error();
    data.pairs = std::move(*pairs);
    if (take.level() == TakeLevel::kReadings && settings.sensors.find('D') != std::string::npos)
        if (Status counted = countDistances(take, data, job); !counted)
            return counted;
    if (data.boards.empty())
        return Done{};
    const bool has_inertia = settings.sensors.find_first_of("AG") != std::string::npos;
    std::vector<double> board_share;
    for (const ReportBoard& board : data.boards)
        board_share.push_back(board.frames_expected == 0 || !has_inertia ? 0 : 1 - board.lostShare());
    data.support = jointSupport(parts->actor.skeleton, parts->suit, data.pairs, board_share, data.take);
    return Done{};
}

/// Runs but the shown one may be of somebody else: they stay without a comparison.
Status compareRun(const Take& take, int64_t run, const Reference& reference, ReportRun& described,
                  ReportData& data) {
    const auto motion = take.poseSource(run);
    if (!motion)
        return motion.error();
    if (!reference.there || data.take.ends_in_rest)
        return Done{};
    ComparisonOptions options = reference.options;
    options.curves = described.is_shown;
    auto comparison = compareMotions(*motion, reference.motion, options);
    if (!comparison && described.is_shown)
        return comparison.error();
    if (!comparison)
        return Done{};
    for (MatchedJoint& joint : comparison->matched)
        if (const auto name = reference.names.find(joint.reference_name); name != reference.names.end())
            joint.reference_name = name->second;
    if (data.runs.empty())
        warnOfMatchedSegments(*comparison, motion->skeleton, data);
    described.comparison = std::move(*comparison);
    return Done{};
}

/// Whose poses come from one joint estimate; of a single performer there is nothing to say.
Status addPeople(const Take& take, const DerivedRun& shown, const RunSettings& settings, ReportData& data) {
    auto people = take.subjects();
    if (!people)
        return people.error();
    std::erase_if(*people, [](const TakeSubject& subject) { return subject.room; });
    if (people->size() < 2)
        return Done{};
    const auto of_run = subjectsOf(shown);
    std::erase_if(*people, [&](const TakeSubject& subject) {
        return std::ranges::count(of_run, subject.suit(), &TakeSubject::suit) == 0;
    });
    const auto isJoined = [&](const TakeSubject& subject) {
        return !settings.root_given && (settings.between || settings.uses_room) &&
               std::ranges::count(settings.unjoined, subject.suit()) == 0;
    };
    const bool joint = std::ranges::count_if(*people, isJoined) > 1;
    for (const TakeSubject& subject : *people)
        (joint && isJoined(subject) ? data.together : data.alone).push_back(subject.name);
    return Done{};
}

/// How far each of the newest other runs is from the shown one, which needs no reference.
Status addDistances(const Take& take, const std::vector<DerivedRun>& runs, const DerivedRun& shown,
                    const JobContext& job, ReportData& data) {
    const auto motion = take.poses(shown.run);
    if (!motion)
        return motion.error();
    ComparisonOptions options;
    options.from_ns = std::llround(data.take.rest_s * 1e9);
    options.match_segments = false;
    options.curves = false;
    for (size_t i = runs.size() - std::min(runs.size(), kMostRunsBeside); i < runs.size(); ++i) {
        if (runs[i].run == shown.run)
            continue;
        if (job.cancelled())
            return JobContext::cancelledError();
        const auto other = take.poseSource(runs[i].run);
        if (!other)
            return other.error();
        if (auto apart = compareMotions(*other, *motion, options))
            data.runs[i].from_shown = std::move(*apart);
    }
    return Done{};
}

}  // namespace

Result<ReportData> evaluateTake(const EvaluateRequest& request, const JobContext& job) {
    auto opened = Take::open(request.take_path, Access::kRead, {job.cancel});
    if (!opened)
        return opened.error();
    if (request.suit)
        opened->view(*request.suit);
    const Take& take = *opened;
    const auto shown =
        request.run_number ? poseRun(take, *request.run_number) : choosePoseRun(take, request.run);
    if (!shown)
        return shown.error();
    const auto all_runs = take.derivedRuns();
    if (!all_runs)
        return all_runs.error();

    ReportData data;
    auto described = describeTake(take);
    if (!described)
        return described.error();
    data.take = std::move(*described);
    const auto shown_motion = take.poseSource(shown->run);
    if (!shown_motion)
        return shown_motion.error();
    auto reference = chooseReference(take, request, shown_motion->skeleton, data);
    if (!reference)
        return reference.error();

    std::vector<DerivedRun> runs = request.all_runs ? poseRuns(*all_runs) : std::vector<DerivedRun>{*shown};
    for (size_t i = 0; i < runs.size(); ++i) {
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(0.5 * static_cast<double>(i) / static_cast<double>(runs.size()), "Comparing results");
        ReportRun run = describeRun(take, runs[i], runSettings(runs[i], *all_runs, take.level()));
        run.number = resultNumber(take, *all_runs, runs[i]);
        run.is_shown = runs[i].run == shown->run;
        if (Status compared = compareRun(take, runs[i].run, *reference, run, data); !compared)
            return compared.error();
        data.runs.push_back(std::move(run));
    }
    reference->motion = {};  // not needed any more; an hour of it is some 500 MB
    if (runs.size() > 1)
        if (Status added = addDistances(take, runs, *shown, job, data); !added)
            return added.error();
    const RunSettings settings = runSettings(*shown, *all_runs, take.level());
    if (Status added = addQuality(take, *shown, settings, data, job); !added)
        return added.error();
    if (Status added = addPeople(take, *shown, settings, data); !added)
        return added.error();
    data.people_apart = settings.people_apart || !settings.unjoined.empty();
    for (const TakeSubject& subject : subjectsOf(*shown))
        if (std::ranges::count(settings.unjoined, subject.suit()) > 0)
            data.unjoined.push_back(subject.name);
    if (std::string drift = driftWarning(settings.estimator, sensorsUsed(take, settings), settings.root_given,
                                         data.take.afterRest_s());
        !drift.empty())
        data.warnings.push_back(std::move(drift));
    for (const SkippedRows& skipped : take.skippedRows())
        data.warnings.push_back(std::to_string(skipped.count) + " rows of " + skipped.table +
                                " could not be used, first " + skipped.first + ".");
    return data;
}

}  // namespace noctule
