// SPDX-License-Identifier: Apache-2.0
#include "core/processing/process_take.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/live/live_pipeline.h"
#include "core/processing/ingredients.h"
#include "core/recording/take_edit.h"

namespace noctule {
namespace {

/// Where results go while the data are still being read; one transaction.
class ResultWriter {
public:
    ResultWriter(TakeEdit& edit, const char* detector) : edit_(edit), detector_(detector) {}

    int64_t inertial_run = 0, range_run = 0, pose_run = 0;
    ProcessSummary summary;

    Status write(const std::vector<InertialReading>& readings) {
        for (const InertialReading& reading : readings) {
            summary.frames_seen += 1;
            summary.frames_lost += reading.corrected_bits ? 0 : 1;
            if (inertial_run > 0)
                if (Status done = edit_.addInertial(inertial_run, reading); !done)
                    return done;
        }
        return Done{};
    }
    Status write(const std::vector<RangeMeasurement>& ranges) {
        for (const RangeMeasurement& range : ranges) {
            summary.ranges += 1;
            summary.ranges_used += range.fate == RangeFate::kUsed || range.fate == RangeFate::kWeighted;
            summary.ranges_gated += range.fate == RangeFate::kGated;
            if (Status done = edit_.addRange(range_run, range, detector_); !done)
                return done;
        }
        return Done{};
    }
    Status write(const std::vector<TimedPose>& poses) {
        for (const TimedPose& pose : poses) {
            summary.poses += 1;
            if (!pose.pose || !isUsable(*pose.pose))
                return Error{ErrorKind::kInternal,
                             "the estimator lost its state at " +
                                 std::to_string(static_cast<double>(pose.time_ns) * 1e-9) + " s",
                             "Please report this take; another choice of sensors may work"};
            if (Status done = edit_.addPose(pose_run, pose); !done)
                return done;
        }
        return Done{};
    }

private:
    TakeEdit& edit_;
    const char* detector_;
};

std::vector<RootMeasurement> rootMeasurements(const std::vector<ExternalRootRow>& rows) {
    std::vector<RootMeasurement> roots;
    for (const ExternalRootRow& row : rows)
        roots.push_back({static_cast<double>(row.time_ns) * 1e-9, row.p_world_root, row.q_world_root,
                         std::max(row.sigma_p_m, 1e-5), std::max(row.sigma_q_rad, 1e-5)});
    return roots;
}

template <class Tracked>
Status writeTracked(Tracked& from, ResultWriter& results) {
    if (Status done = results.write(from.takeRanges()); !done)
        return done;
    return results.write(from.takePoses());
}

Status processSound(const Take& take, const Ingredients& in, const TrackerSettings& tracker,
                    ResultWriter& results, const JobContext& job) {
    auto created = LivePipeline::create(in.suit, in.calibration, in.actor, {in.decoder, tracker, in.rest});
    if (!created)
        return created.error();
    LivePipeline& pipeline = **created;
    const auto pulses = take.pulses();
    const auto statuses = take.statusRows();
    const auto gaps = take.gaps();
    for (const auto* failed :
         {pulses.ok() ? nullptr : &pulses.error(), statuses.ok() ? nullptr : &statuses.error(),
          gaps.ok() ? nullptr : &gaps.error()})
        if (failed)
            return *failed;
    for (const Pulse& pulse : *pulses)
        pipeline.pushPulse(pulse);
    for (const StatusRow& row : *statuses)
        pipeline.pushStatus({row.sample, row.temperature_c, row.humidity_percent});
    for (const GapRow& gap : *gaps)
        pipeline.pushGap(gap.first_sample, gap.sample_count, gap.board);
    for (const RootMeasurement& root : rootMeasurements(in.roots))
        pipeline.pushRoot(root);
    Status state = Done{};
    Status read = take.forEachBlock(1, [&](const AdcBlock& block) {
        if (job.cancelled())
            state = JobContext::cancelledError();
        else
            pipeline.pushBlock(block.first_sample, block.values);
        if (state)
            state = results.write(pipeline.takeReadings());
        if (state)
            state = writeTracked(pipeline, results);
        job.progress(static_cast<double>(block.first_sample) /
                         static_cast<double>(std::max<int64_t>(1, in.sample_count)),
                     "Processing sound");
        return state.ok();
    });
    if (!state)
        return state;
    if (!read)
        return read;
    pipeline.finish();
    for (size_t b = 0; b < in.suit.boards.size(); ++b)
        results.summary.clipped_readings += pipeline.tracker().clippedReadings(static_cast<int>(b));
    results.summary.resets = pipeline.tracker().resets();
    for (const SourceProblem& problem : pipeline.decoder().sourceProblems())
        results.summary.warnings.push_back("No distances from a source: " + problem.reason + ".");
    if (Status done = results.write(pipeline.takeReadings()); !done)
        return done;
    return writeTracked(pipeline, results);
}

/// Primary readings and ranges, merged by time.
Status processReadings(const Take& take, const Ingredients& in, const TrackerSettings& settings,
                       ResultWriter& results, const JobContext& job) {
    auto created = MotionTracker::create(in.suit, in.calibration, in.actor, in.decoder.train.sample_rate_hz,
                                         in.rest, settings);
    if (!created)
        return created.error();
    MotionTracker& tracker = **created;
    auto readings = take.readings(kPrimaryRun);
    if (!readings)
        return readings.error();
    auto ranges = take.ranges(kPrimaryRun);
    if (!ranges)
        return ranges.error();
    for (const RootMeasurement& root : rootMeasurements(in.roots))
        tracker.add(root);
    auto range = ranges->next();
    if (!range)
        return range.error();
    constexpr int64_t kPortions_per_s = 10;
    const auto portion = static_cast<int64_t>(in.decoder.train.sample_rate_hz) / kPortions_per_s;
    int64_t watermark = 0;
    while (true) {
        auto reading = readings->next();
        if (!reading)
            return reading.error();
        const bool ended = !reading->has_value();
        const double sample = ended ? 0 : (*reading)->sample;
        if (ended || sample >= static_cast<double>(watermark + portion)) {
            watermark = ended ? std::max(in.sample_count, watermark) : static_cast<int64_t>(sample);
            // Ranges go with their arrival, which lies after the pulse: none that belongs before is still to
            // come.
            while (*range && (ended || (*range)->pulse_sample < watermark)) {
                tracker.add(**range);
                range = ranges->next();
                if (!range)
                    return range.error();
            }
            tracker.advanceTo(watermark);
            if (Status done = writeTracked(tracker, results); !done)
                return done;
            if (job.cancelled())
                return JobContext::cancelledError();
            job.progress(
                static_cast<double>(watermark) / static_cast<double>(std::max<int64_t>(1, in.sample_count)),
                "Processing readings");
        }
        if (ended)
            break;
        results.summary.frames_seen += 1;
        results.summary.frames_lost += (*reading)->corrected_bits ? 0 : 1;
        tracker.add(**reading);
    }
    for (size_t b = 0; b < in.suit.boards.size(); ++b)
        results.summary.clipped_readings += tracker.clippedReadings(static_cast<int>(b));
    results.summary.resets = tracker.resets();
    return Done{};
}

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
                            const ResultWriter& results) {
    nlohmann::json settings{{"sensors", sensorLetters(request.tracker.sensors)},
                            {"root", request.tracker.root_given ? "given" : "free"},
                            {"estimator", estimatorName(request.tracker.estimator)},
                            {"detector", detectorName(request.detector)},
                            {"smooth", "none"},
                            {"inertial_run", results.inertial_run},
                            {"range_run", results.range_run}};
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

}  // namespace

std::string defaultRunName(const TrackerSettings& tracker) {
    return sensorLetters(tracker.sensors) + (tracker.estimator == EstimatorKind::kPaper ? " paper" : "");
}

Result<ProcessSummary> processTake(const ProcessRequest& request, const JobContext& job) {
    auto opened = Take::open(request.take_path, Access::kReadWrite);
    if (!opened)
        return opened.error();
    Take& take = *opened;
    std::vector<std::string> warnings;
    auto gathered = gatherIngredients(take, request, warnings);
    if (!gathered)
        return gathered.error();
    Ingredients& in = *gathered;
    const auto runs = take.derivedRuns();
    if (!runs)
        return runs.error();
    const std::string name = freeRunName(*runs, request);

    auto edit = TakeEdit::begin(take);
    if (!edit)
        return edit.error();
    if (request.calibration) {
        auto id = edit->addCalibration(in.calibration);
        if (!id)
            return id.error();
        in.calibration_id = *id;
    }
    if (request.actor) {
        auto id = edit->addActor(in.actor, request.created_utc);
        if (!id)
            return id.error();
        in.actor_id = *id;
    }
    ResultWriter results(*edit, detectorName(request.detector));
    results.summary.warnings = warnings;
    const auto begin = [&](const char* kind, const std::string& run_name, const std::string& settings) {
        return edit->beginRun({0, kind, run_name, request.created_utc, request.software, settings,
                               in.calibration_id, in.actor_id});
    };
    const bool sound = take.level() == TakeLevel::kSignal;
    const int64_t earlier = earlierInertialRun(*runs, request.software);
    if (sound && earlier == 0) {
        auto run = begin("inertial", "decoded", kDecodedFromSound);
        if (!run)
            return run.error();
        results.inertial_run = *run;
    }
    auto range_run = begin("range", name, "{}");
    if (!range_run)
        return range_run.error();
    results.range_run = *range_run;
    const int64_t new_inertial = results.inertial_run;
    results.inertial_run = earlier > 0 ? earlier : new_inertial;  // what the pose run names
    auto pose_run = begin("pose", name, settingsJson(request, in, results).dump());
    if (!pose_run)
        return pose_run.error();
    results.pose_run = *pose_run;
    results.inertial_run = new_inertial;  // what is written

    Status done = sound ? processSound(take, in, request.tracker, results, job)
                        : processReadings(take, in, request.tracker, results, job);
    if (!done)
        return done.error();
    if (results.summary.poses == 0)
        return unusableTake(take, "it is too short or holds no sound: no pose came out",
                            "`noctule --batch inspect` shows what is in it");
    for (const SkippedRows& skipped : take.skippedRows())
        results.summary.warnings.push_back(std::to_string(skipped.count) + " rows of " + skipped.table +
                                           " could not be used, first " + skipped.first + ".");
    if (Status committed = edit->commit(); !committed)
        return committed.error();

    ProcessSummary summary = std::move(results.summary);
    summary.run_name = name;
    summary.pose_run = results.pose_run;
    summary.range_run = results.range_run;
    summary.inertial_run = earlier > 0 ? earlier : new_inertial;
    summary.duration_s = static_cast<double>(in.sample_count) / in.decoder.train.sample_rate_hz;
    return summary;
}

}  // namespace noctule
