// SPDX-License-Identifier: Apache-2.0
#include "core/processing/result_runs.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

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

nlohmann::json settingsJson(const ProcessRequest& request, const Ingredients& in,
                            const ProcessSummary& runs) {
    nlohmann::json settings{{"sensors", sensorLetters(request.tracker.sensors)},
                            {"root", request.tracker.root_given ? "given" : "free"},
                            {"estimator", estimatorName(request.tracker.estimator)},
                            {"detector", detectorName(request.detector)},
                            {"smooth", smootherName(request.tracker.smoother)},
                            {"inertial_run", runs.inertial_run},
                            {"range_run", runs.range_run}};
    if (request.tracker.estimator == EstimatorKind::kManifold) {
        const bool looks = request.tracker.sensors.gyroscopes;
        settings["ground"] = groundName(looks ? request.tracker.ground : Ground::kNone);
        settings["contacts"] = in.contacts ? kContactsEdited : kContactsDetected;
    }
    if (in.rest)
        settings["rest_end_s"] = static_cast<double>(in.rest->second) / in.decoder.train.sample_rate_hz;
    if (request.tracker.estimator == EstimatorKind::kPaper)
        settings["process_sigma_rad_per_s2"] = request.tracker.paper_process_sigma_rad_per_s2;
    return settings;
}

constexpr const char* kDecodedFromSound = R"({"from":"sound"})";

/// Readings do not depend on calibration or estimator: one run of them serves all.
int64_t earlierInertialRun(const std::vector<DerivedRun>& runs, const std::string& software) {
    for (const DerivedRun& run : runs)
        if (run.kind == "inertial" && run.settings_json == kDecodedFromSound && run.software == software)
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
    return sensorLetters(tracker.sensors) + (tracker.estimator == EstimatorKind::kPaper ? " paper" : "") +
           (tracker.smoother == Smoother::kFull    ? " smoothed"
            : tracker.smoother == Smoother::kLag   ? " lag"
            : tracker.smoother == Smoother::kBatch ? " batch"
                                                   : "");
}

Result<ResultRuns> ResultRuns::begin(const Take& take, const ProcessRequest& request, const Ingredients& in) {
    const auto earlier_runs = take.derivedRuns();
    if (!earlier_runs)
        return earlier_runs.error();
    const std::filesystem::path folder = std::filesystem::path(take.path()).parent_path();
    auto spool = ResultSpool::make(folder.empty() ? "." : folder);
    if (!spool)
        return spool.error();
    ResultRuns runs(std::move(*spool));
    runs.summary.inertial_run = earlierInertialRun(*earlier_runs, request.software);
    runs.writes_readings_ = take.level() == TakeLevel::kSignal && runs.summary.inertial_run == 0;
    runs.summary.contacts_edited = in.contacts.has_value();
    runs.summary.duration_s = static_cast<double>(in.sample_count) / in.decoder.train.sample_rate_hz;
    return runs;
}

Status ResultRuns::write(const std::vector<InertialReading>& readings) {
    for (const InertialReading& reading : readings) {
        summary.frames_seen += 1;
        summary.frames_lost += reading.corrected_bits ? 0 : 1;
    }
    if (writes_readings_)
        spool_.add(readings);
    return Done{};
}

Status ResultRuns::write(const std::vector<RangeMeasurement>& ranges) {
    for (const RangeMeasurement& range : ranges) {
        summary.ranges += 1;
        summary.ranges_used += range.fate == RangeFate::kUsed || range.fate == RangeFate::kWeighted;
        summary.ranges_gated += range.fate == RangeFate::kGated;
    }
    spool_.add(ranges);
    return Done{};
}

Status ResultRuns::write(const std::vector<FootContacts>& contacts) {
    for (const FootContacts& foot : contacts)
        summary.contacts += std::ssize(foot.contacts);
    contacts_.insert(contacts_.end(), contacts.begin(), contacts.end());
    return Done{};
}

Status ResultRuns::write(const std::vector<TimedPose>& poses) {
    for (const TimedPose& pose : poses) {
        summary.poses += 1;
        if (!pose.pose || !isUsable(*pose.pose))
            return Error{ErrorKind::kUnusable,
                         "the estimator lost its state at " +
                             std::to_string(static_cast<double>(pose.time_ns) * 1e-9) +
                             " s: the data contradict each other",
                         "Check the calibration and the actor; another choice of sensors may work"};
    }
    spool_.add(poses);
    return Done{};
}

/// The rows that name the runs, and their numbers.
Status ResultRuns::nameRuns(TakeEdit& edit, const Take& take, const ProcessRequest& request,
                            const Ingredients& in) {
    const auto earlier_runs = take.derivedRuns();
    if (!earlier_runs)
        return earlier_runs.error();
    summary.run_name = freeRunName(*earlier_runs, request);
    const auto add = [&](const char* kind, const std::string& name, const std::string& settings) {
        return edit.beginRun(
            {0, kind, name, request.created_utc, request.software, settings, in.calibration_id, in.actor_id});
    };
    // Another processing may have added one meanwhile.
    const int64_t inertial_run = earlierInertialRun(*earlier_runs, request.software);
    if (!writes_readings_ && inertial_run != summary.inertial_run)
        return unusableTake(take, "its readings were dropped while it was processed", "Process it again");
    writes_readings_ = writes_readings_ && inertial_run == 0;
    summary.inertial_run = inertial_run;
    if (writes_readings_) {
        auto run = add("inertial", "decoded", kDecodedFromSound);
        if (!run)
            return run.error();
        summary.inertial_run = *run;
    }
    auto range_run = add("range", summary.run_name, "{}");
    if (!range_run)
        return range_run.error();
    summary.range_run = *range_run;
    auto pose_run = add("pose", summary.run_name, settingsJson(request, in, summary).dump());
    if (!pose_run)
        return pose_run.error();
    summary.pose_run = *pose_run;
    return Done{};
}

namespace {

/// From beside the take into it.
class RunRows : public ResultSink {
public:
    RunRows(TakeEdit& edit, const ProcessSummary& runs, const char* detector, bool writes_readings)
        : edit_(edit), runs_(runs), detector_(detector), writes_readings_(writes_readings) {}

    Status write(const std::vector<InertialReading>& readings) override {
        if (writes_readings_)
            for (const InertialReading& reading : readings)
                if (Status done = edit_.addInertial(runs_.inertial_run, reading); !done)
                    return done;
        return Done{};
    }
    Status write(const std::vector<RangeMeasurement>& ranges) override {
        for (const RangeMeasurement& range : ranges)
            if (Status done = edit_.addRange(runs_.range_run, range, detector_); !done)
                return done;
        return Done{};
    }
    Status write(const std::vector<TimedPose>& poses) override {
        for (const TimedPose& pose : poses)
            if (Status done = edit_.addPose(runs_.pose_run, pose); !done)
                return done;
        return Done{};
    }

private:
    TakeEdit& edit_;
    const ProcessSummary& runs_;
    const char* detector_;
    bool writes_readings_;
};

}  // namespace

Status ResultRuns::store(Take& take, const ProcessRequest& request, Ingredients& in) {
    auto edit = TakeEdit::begin(take);
    if (!edit)
        return edit.error();
    if (Status added = addDocuments(*edit, request, in); !added)
        return added;
    if (Status named = nameRuns(*edit, take, request, in); !named)
        return named;
    RunRows rows(*edit, summary, detectorName(request.detector), writes_readings_);
    if (Status replayed = spool_.replay(rows); !replayed)
        return replayed;
    if (Status added = edit->addContacts(summary.pose_run, contacts_); !added)
        return added;
    return edit->commit();
}

namespace {

constexpr double kPatience_s = 3600;  ///< several processings of one take wait for each other

/// Reads and computes; nothing is written into the take.
Result<ResultRuns> compute(const Take& take, const ProcessRequest& request, Ingredients& in,
                           const FillRuns& fill) {
    const auto moment = take.snapshot();
    if (!moment)
        return moment.error();
    std::vector<std::string> warnings;
    auto gathered = gatherIngredients(take, request, warnings);
    if (!gathered)
        return gathered.error();
    in = std::move(*gathered);
    auto runs = ResultRuns::begin(take, request, in);
    if (!runs)
        return runs.error();
    runs->summary.warnings = warnings;
    if (Status filled = fill(take, in, *runs); !filled)
        return filled.error();
    if (runs->summary.poses == 0)
        return unusableTake(take, "it is too short or holds no sound: no pose came out",
                            "`noctule --batch inspect` shows what is in it");
    for (const SkippedRows& skipped : take.skippedRows())
        runs->summary.warnings.push_back(std::to_string(skipped.count) + " rows of " + skipped.table +
                                         " could not be used, first " + skipped.first + ".");
    return runs;
}

}  // namespace

Result<ProcessSummary> writeRuns(const ProcessRequest& request, const FillRuns& fill,
                                 const CancelFlag* cancel) {
    auto take = Take::open(request.take_path, Access::kReadWrite, {cancel, kPatience_s});
    if (!take)
        return take.error();
    Ingredients in;
    auto runs = compute(*take, request, in, fill);
    if (!runs)
        return runs.error();
    if (Status stored = runs->store(*take, request, in); !stored)
        return stored.error();
    return std::move(runs->summary);
}

}  // namespace noctule
