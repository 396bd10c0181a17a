// SPDX-License-Identifier: Apache-2.0
#include "core/processing/process_take.h"

#include <algorithm>
#include <filesystem>

#include "core/live/live_pipeline.h"
#include "core/processing/feed_tracker.h"
#include "core/processing/pose_from_sensors.h"
#include "core/processing/process_together.h"
#include "core/processing/pulse_shapes.h"
#include "core/processing/sound_log.h"
#include "core/processing/write_runs.h"

namespace noctule {
namespace {

std::vector<RootMeasurement> rootMeasurements(const Ingredients& in) {
    std::vector<RootMeasurement> roots;
    for (const ExternalRootRow& row : in.roots)
        roots.push_back({in.clock.suitTime_s(static_cast<double>(row.time_ns) * 1e-9), row.p_world_root,
                         row.q_world_root, std::max(row.sigma_p_m, 1e-5), std::max(row.sigma_q_rad, 1e-5)});
    return roots;
}

template <class Tracked>
Status writeTracked(Tracked& from, ResultRuns& results) {
    if (Status done = results.write(from.takeRanges()); !done)
        return done;
    return results.write(from.takePoses());
}

/// Of the pass over the take's data in all work: smoothing the whole take goes back over it.
double forwardShare(const TrackerSettings& settings) {
    return settings.smoother == Smoother::kFull ? 0.4 : settings.smoother == Smoother::kBatch ? 0.1 : 1;
}

double shareDone(int64_t sample, const Ingredients& in, const TrackerSettings& settings) {
    return forwardShare(settings) * static_cast<double>(sample) /
           static_cast<double>(std::max<int64_t>(1, in.sample_count));
}

template <class Tracked>
Status writeWaiting(Tracked& from, const TrackerSettings& settings, ResultRuns& results,
                    const JobContext& job) {
    const int all = from.portionsLeft();
    while (from.portionsLeft() > 0) {
        job.progress(1 - (1 - forwardShare(settings)) * from.portionsLeft() / all, "Smoothing");
        if (Status done = from.finishPortion(job); !done)
            return done;
        if (Status done = writeTracked(from, results); !done)
            return done;
    }
    return Done{};
}

/// What is said of the whole take when it has been gone through.
Status writeSummary(const MotionTracker& tracker, const Ingredients& in, ResultRuns& results) {
    for (size_t b = 0; b < in.suit.boards.size(); ++b)
        results.summary.clipped_readings += tracker.clippedReadings(static_cast<int>(b));
    results.summary.resets = tracker.resets();
    return results.write(tracker.contacts());
}

Status processSound(const Take& take, const Ingredients& in, const TrackerSettings& tracker,
                    ResultRuns& results, const JobContext& job) {
    const auto log = readSoundLog(take);
    if (!log)
        return log.error();
    Ingredients with_shapes = in;
    if (Status done = completeShapes(take, *log, with_shapes, results.summary.warnings, job); !done)
        return done;
    auto created =
        LivePipeline::create(in.suit, with_shapes.calibration, in.actor, {in.decoder, tracker, in.rest});
    if (!created)
        return created.error();
    LivePipeline& pipeline = **created;
    for (const Pulse& pulse : log->pulses)
        pipeline.pushPulse(pulse);
    for (const TemperatureStatus& status : log->statuses)
        pipeline.pushStatus(status);
    for (const GapRow& gap : log->gaps)
        pipeline.pushGap(gap.first_sample, gap.sample_count, gap.board);
    for (const RootMeasurement& root : rootMeasurements(in))
        pipeline.pushRoot(root);
    Status state = Done{};
    Status read = take.forEachBlock(kSuitInView, [&](const AdcBlock& block) {
        if (job.cancelled())
            state = JobContext::cancelledError();
        else
            pipeline.pushBlock(block.first_sample, block.values);
        if (state)
            state = results.write(pipeline.takeReadings());
        if (state)
            state = writeTracked(pipeline, results);
        job.progress(shareDone(block.first_sample, in, tracker), "Processing sound");
        return state.ok();
    });
    if (!state)
        return state;
    if (!read)
        return read;
    pipeline.finish();
    if (Status done = writeSummary(pipeline.tracker(), in, results); !done)
        return done;
    for (const SourceProblem& problem : pipeline.decoder().sourceProblems())
        results.summary.warnings.push_back("No distances from a source: " + problem.reason + ".");
    if (Status done = results.write(pipeline.takeReadings()); !done)
        return done;
    if (Status done = writeTracked(pipeline, results); !done)
        return done;
    return writeWaiting(pipeline, tracker, results, job);
}

Status processReadings(const Take& take, const Ingredients& in, const TrackerSettings& settings,
                       ResultRuns& results, const JobContext& job) {
    auto created = MotionTracker::create(in.suit, in.calibration, in.actor, in.decoder.train.sample_rate_hz,
                                         in.restOrBegin(), settings);
    if (!created)
        return created.error();
    MotionTracker& tracker = **created;
    for (const RootMeasurement& root : rootMeasurements(in))
        tracker.add(root);
    const auto frames = feedTracker(
        take, in, tracker,
        [&](int64_t reached) {
            job.progress(shareDone(reached, in, settings), "Processing readings");
            return writeTracked(tracker, results);
        },
        job);
    if (!frames)
        return frames.error();
    results.summary.frames_seen += frames->seen;
    results.summary.frames_lost += frames->lost;
    if (Status done = writeSummary(tracker, in, results); !done)
        return done;
    return writeWaiting(tracker, settings, results, job);
}

}  // namespace

Result<ProcessSummary> processTake(const ProcessRequest& request, const JobContext& job) {
    const auto settings = [&](const Take& take) {
        TrackerSettings tracker = request.tracker;
        tracker.g_m_per_s2 = take.header().g_m_per_s2;
        const std::filesystem::path folder = std::filesystem::path(request.take_path).parent_path();
        tracker.spool_folder = folder.empty() ? "." : folder.string();
        return tracker;
    };
    return writeRuns(
        request,
        [&](const Take& take, const Ingredients& in, ResultRuns& results) {
            TrackerSettings tracker = settings(take);
            tracker.contacts = in.contacts;
            if (tracker.estimator == kOrientationEstimator)
                return poseFromSensors(take, in, tracker, results, job);
            return take.level() == TakeLevel::kSignal ? processSound(take, in, tracker, results, job)
                                                      : processReadings(take, in, tracker, results, job);
        },
        job.cancel,
        [&](Take& take, std::vector<Ingredients>& subjects, ResultRuns& results) {
            return processTogether(take, request, settings(take), subjects, results, job);
        });
}

}  // namespace noctule
