// SPDX-License-Identifier: Apache-2.0
#include "core/processing/result_runs.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/estimation/paper_parameters.h"
#include "core/job/text_hash.h"
#include "core/live/estimators.h"

namespace noctule {
namespace {

std::string sensorLetters(const SensorSelection& sensors) {
    return std::string(sensors.accelerometers ? "A" : "") + (sensors.gyroscopes ? "G" : "") +
           (sensors.distances ? "D" : "");
}

/// "AGD", "AGD paper", and when there is one already "AGD 2".
std::string freeRunName(const std::vector<DerivedRun>& runs, const ProcessRequest& request) {
    const std::string wanted = request.run_name.empty() ? defaultRunName(request.tracker) : request.run_name;
    const auto taken = [&](const std::string& name) {
        return std::any_of(runs.begin(), runs.end(),
                           [&](const DerivedRun& run) { return run.kind == "pose" && run.name == name; });
    };
    std::string name = wanted;
    for (int number = 2; taken(name); ++number)
        name = wanted + " " + std::to_string(number);
    return name;
}

const EstimatorEntry& estimatorOf(const ProcessRequest& request) {
    const EstimatorEntry* entry = findEstimator(request.tracker.estimator);
    require(entry != nullptr, "an estimator that was checked before");
    return *entry;
}

/// Everything that a pose run was made with; `made_by` is the hash of it all.
nlohmann::json settingsJson(const ProcessRequest& request, const Ingredients& in,
                            const ProcessSummary& runs) {
    const EstimatorEntry& estimator = estimatorOf(request);
    const ParameterValues parameters = completeParameters(estimator.parameters, request.tracker.parameters);
    nlohmann::json settings{{"sensors", sensorLetters(request.tracker.sensors)},
                            {"root", request.tracker.root_given ? "given" : "free"},
                            {"estimator", estimator.name},
                            {"detector", detectorName(in.decoder.detector)},
                            {"smooth", smootherName(request.tracker.smoother)},
                            {"program", request.software},
                            {"parameters", parameters}};
    if (estimator.finds_contacts) {
        const bool looks = request.tracker.sensors.gyroscopes;
        settings["ground"] = groundName(looks ? request.tracker.ground : Ground::kNone);
        settings["contacts"] = in.contacts ? kContactsEdited : kContactsDetected;
    }
    if (in.rest)
        settings["rest_end_s"] = static_cast<double>(in.rest->second) / in.decoder.train.sample_rate_hz;
    if (const auto sigma = parameters.find(kPaperProcessSigma); sigma != parameters.end())
        settings["process_sigma_rad_per_s2"] = sigma->second;
    settings["made_by"] = textHash(settings.dump() + toJson(in.suit).dump() + toJson(in.calibration).dump() +
                                   toJson(in.actor).dump());
    settings["inertial_run"] = runs.inertial_run;
    settings["range_run"] = runs.range_run;
    return settings;
}

/// What decoding readings depends on: the program, the wires, and which samples are there.
Result<std::string> decodedSettings(const Take& take, const ProcessRequest& request, const Ingredients& in) {
    const auto gaps = take.gaps();
    if (!gaps)
        return gaps.error();
    std::string made = request.software + " " + std::to_string(in.decoder.train.sample_rate_hz) + " " +
                       std::to_string(in.sample_count);
    for (const Board& board : in.suit.boards)
        made += " " + board.id + (board.has_magnetometer ? " imu9" : " imu6");
    for (const GapRow& gap : *gaps)
        made += " gap " + std::to_string(gap.first_sample) + " " + std::to_string(gap.sample_count) + " " +
                std::to_string(gap.board.value_or(-1));
    return nlohmann::json{{"from", "sound"}, {"made_by", textHash(made)}}.dump();
}

/// Readings do not depend on calibration or estimator: one run of them serves all that agree in the hash of
/// what made it.
int64_t earlierInertialRun(const std::vector<DerivedRun>& runs, const std::string& settings,
                           const std::string& software) {
    for (const DerivedRun& run : runs)
        if (run.kind == "inertial" && run.settings_json == settings && run.software == software)
            return run.run;
    return 0;
}

/// The calibration and the actor of the request come into force.
Status addDocuments(TakeEdit& edit, const ProcessRequest& request, Ingredients& in) {
    if (request.calibration) {
        auto id = edit.addCalibration(in.calibration);
        if (!id)
            return id.error();
        in.calibration_id = *id;
    }
    if (request.actor) {
        auto id = edit.addActor(in.actor, request.created_utc);
        if (!id)
            return id.error();
        in.actor_id = *id;
    }
    return Done{};
}

}  // namespace

std::string defaultRunName(const TrackerSettings& tracker) {
    return sensorLetters(tracker.sensors) +
           (tracker.estimator == kManifoldEstimator ? "" : " " + tracker.estimator) +
           (tracker.smoother == Smoother::kFull    ? " smoothed"
            : tracker.smoother == Smoother::kLag   ? " lag"
            : tracker.smoother == Smoother::kBatch ? " batch"
                                                   : "");
}

Result<ResultRuns> ResultRuns::begin(const Take& take, TakeEdit& edit, const ProcessRequest& request,
                                     const Ingredients& in) {
    const auto earlier_runs = take.derivedRuns();
    if (!earlier_runs)
        return earlier_runs.error();
    ResultRuns runs(edit, detectorName(in.decoder.detector));
    ProcessSummary& summary = runs.summary;
    summary.run_name = freeRunName(*earlier_runs, request);
    const auto add = [&](const char* kind, const std::string& name, const std::string& settings) {
        return edit.beginRun(
            {0, kind, name, request.created_utc, request.software, settings, in.calibration_id, in.actor_id});
    };
    const bool sound = take.level() == TakeLevel::kSignal;
    const auto decoded = decodedSettings(take, request, in);
    if (!decoded)
        return decoded.error();
    summary.inertial_run = earlierInertialRun(*earlier_runs, *decoded, request.software);
    if (sound && summary.inertial_run == 0) {
        auto run = add("inertial", "decoded", *decoded);
        if (!run)
            return run.error();
        summary.inertial_run = *run;
        runs.writes_readings_ = true;
    }
    auto range_run = add("range", summary.run_name, "{}");
    if (!range_run)
        return range_run.error();
    summary.range_run = *range_run;
    auto pose_run = add("pose", summary.run_name, settingsJson(request, in, summary).dump());
    if (!pose_run)
        return pose_run.error();
    summary.pose_run = *pose_run;
    summary.contacts_edited = in.contacts.has_value();
    summary.duration_s = static_cast<double>(in.sample_count) / in.decoder.train.sample_rate_hz;
    return runs;
}

Status ResultRuns::write(const std::vector<InertialReading>& readings) {
    for (const InertialReading& reading : readings) {
        summary.frames_seen += 1;
        summary.frames_lost += reading.corrected_bits ? 0 : 1;
        if (writes_readings_)
            if (Status done = edit_->addInertial(summary.inertial_run, reading); !done)
                return done;
    }
    return Done{};
}

Status ResultRuns::write(const std::vector<RangeMeasurement>& ranges) {
    for (const RangeMeasurement& range : ranges) {
        summary.ranges += 1;
        summary.ranges_used += range.fate == RangeFate::kUsed || range.fate == RangeFate::kWeighted;
        summary.ranges_gated += range.fate == RangeFate::kGated;
        if (Status done = edit_->addRange(summary.range_run, range, detector_); !done)
            return done;
    }
    return Done{};
}

Status ResultRuns::write(const std::vector<FootContacts>& contacts) {
    for (const FootContacts& foot : contacts)
        summary.contacts += std::ssize(foot.contacts);
    return edit_->addContacts(summary.pose_run, contacts);
}

Status ResultRuns::write(const std::vector<TimedPose>& poses) {
    for (const TimedPose& pose : poses) {
        summary.poses += 1;
        if (!pose.pose || !isUsable(*pose.pose))
            return Error{ErrorKind::kInternal,
                         "the estimator lost its state at " +
                             std::to_string(static_cast<double>(pose.time_ns) * 1e-9) + " s",
                         "Please report this take; another choice of sensors may work"};
        if (Status done = edit_->addPose(summary.pose_run, pose); !done)
            return done;
    }
    return Done{};
}

Result<ProcessSummary> writeRuns(const ProcessRequest& request, const FillRuns& fill) {
    auto take = Take::open(request.take_path, Access::kReadWrite);
    if (!take)
        return take.error();
    std::vector<std::string> warnings;
    auto in = gatherIngredients(*take, request, warnings);
    if (!in)
        return in.error();
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    if (Status added = addDocuments(*edit, request, *in); !added)
        return added.error();
    auto runs = ResultRuns::begin(*take, *edit, request, *in);
    if (!runs)
        return runs.error();
    runs->summary.warnings = warnings;
    if (Status filled = fill(*take, *in, *runs); !filled)
        return filled.error();
    if (runs->summary.poses == 0)
        return unusableTake(*take, "it is too short or holds no sound: no pose came out",
                            "`noctule --batch inspect` shows what is in it");
    for (const SkippedRows& skipped : take->skippedRows())
        runs->summary.warnings.push_back(std::to_string(skipped.count) + " rows of " + skipped.table +
                                         " could not be used, first " + skipped.first + ".");
    if (Status committed = edit->commit(); !committed)
        return committed.error();
    return std::move(runs->summary);
}

}  // namespace noctule
