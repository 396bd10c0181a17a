// SPDX-License-Identifier: Apache-2.0
#include "core/processing/result_runs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/estimation/paper_parameters.h"
#include "core/job/text_hash.h"
#include "core/live/estimators.h"
#include "core/math/json.h"

namespace noctule {
namespace {

/// "AGD", "AGD paper", and when there is one already "AGD 2".
std::string freeRunName(const std::vector<DerivedRun>& runs, const ProcessRequest& request) {
    const std::string wanted = request.run_name.empty() ? defaultRunName(request.tracker) : request.run_name;
    const auto isTaken = [&](const std::string& name) {
        return std::any_of(runs.begin(), runs.end(),
                           [&](const DerivedRun& run) { return run.kind == "pose" && run.name == name; });
    };
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = wanted + " " + std::to_string(number);
    return name;
}

const EstimatorEntry& estimatorOf(const ProcessRequest& request) {
    const EstimatorEntry* entry = findEstimator(request.tracker.estimator);
    require(entry != nullptr, "an estimator that was checked before");
    return *entry;
}

/// Everything that a pose run was made with; `made_by` is the hash of it all.
nlohmann::json settingsJson(const ProcessRequest& request, const std::vector<Ingredients>& subjects,
                            const ProcessSummary& runs) {
    const Ingredients& in = subjects.front();
    const EstimatorEntry& estimator = estimatorOf(request);
    const ParameterValues parameters = completeParameters(estimator.parameters, request.tracker.parameters);
    nlohmann::json settings{{"sensors", sensorLetters(request.tracker)},
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
    if (runs.together) {
        settings["between"] = runs.together->between;
        settings["room"] = runs.together->room;
        settings["select"] = request.select;
        if (!runs.together->unjoined.empty())
            settings["unjoined"] = runs.together->unjoined;
    }
    std::string made = settings.dump();
    nlohmann::json list = nlohmann::json::array();
    for (const Ingredients& of : subjects) {
        made += toJson(of.suit).dump() + toJson(of.calibration).dump() + toJson(of.actor).dump();
        list.push_back({{"name", of.subject.name},
                        {"suit", of.subject.suit()},
                        {"calibration_id", json::orNull(of.calibration_id)},
                        {"actor_id", json::orNull(of.actor_id)}});
    }
    settings["made_by"] = textHash(made);
    if (subjects.size() > 1 || in.subject.suit() != 1)
        settings["subjects"] = list;
    settings["inertial_run"] = runs.inertial_run;
    settings["range_run"] = runs.range_run;
    return settings;
}

/// What decoding readings depends on: the program, the wires, and which samples are there.
Result<std::string> decodedSettings(Take& take, const ProcessRequest& request,
                                    const std::vector<Ingredients>& subjects) {
    std::string made = request.software;
    for (const Ingredients& in : subjects) {
        take.view(in.subject.suit());
        const auto gaps = take.gaps();
        if (!gaps)
            return gaps.error();
        made += " suit " + std::to_string(in.subject.suit()) + " " +
                std::to_string(in.decoder.train.sample_rate_hz) + " " + std::to_string(in.sample_count);
        for (const Board& board : in.suit.boards)
            made += " " + board.id + (board.has_magnetometer ? " imu9" : " imu6");
        for (const GapRow& gap : *gaps)
            made += " gap " + std::to_string(gap.first_sample) + " " + std::to_string(gap.sample_count) +
                    " " + std::to_string(gap.board.value_or(-1));
    }
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

TimedPose onTakeTime(TimedPose pose, const SuitClock& clock) {
    if (!clock.isTakeTime())
        pose.time_ns = std::llround(clock.offset_ns + clock.rate * static_cast<double>(pose.time_ns));
    return pose;
}

/// The calibration and the actor of the request come into force.
Status addDocuments(TakeEdit& edit, const ProcessRequest& request, Ingredients& in) {
    if (request.calibration) {
        auto id = edit.addCalibration(in.calibration);
        if (!id)
            return id.error();
        in.calibration_id = *id;
    }
    // The actor that stood in for a missing one is what the poses are of.
    if (request.actor || !in.actor_id) {
        auto id = edit.addActor(in.actor, request.created_utc);
        if (!id)
            return id.error();
        in.actor_id = *id;
    }
    return Done{};
}

}  // namespace

std::string sensorLetters(const TrackerSettings& tracker) {
    const SensorSelection& sensors = tracker.sensors;
    const bool distances = sensors.distances && tracker.estimator != kOrientationEstimator;
    return std::string(sensors.accelerometers ? "A" : "") + (sensors.gyroscopes ? "G" : "") +
           (distances ? "D" : "");
}

std::string defaultRunName(const TrackerSettings& tracker) {
    return sensorLetters(tracker) + (tracker.estimator == kManifoldEstimator ? "" : " " + tracker.estimator) +
           (tracker.smoother == Smoother::kFull    ? " smoothed"
            : tracker.smoother == Smoother::kLag   ? " lag"
            : tracker.smoother == Smoother::kBatch ? " batch"
                                                   : "");
}

Result<ResultRuns> ResultRuns::begin(Take& take, const ProcessRequest& request,
                                     const std::vector<Ingredients>& subjects) {
    const Ingredients& in = subjects.front();
    const auto earlier_runs = take.derivedRuns();
    if (!earlier_runs)
        return earlier_runs.error();
    const auto decoded = decodedSettings(take, request, subjects);
    if (!decoded)
        return decoded.error();
    ResultRuns runs(take.path());
    runs.summary.inertial_run = earlierInertialRun(*earlier_runs, *decoded, request.software);
    runs.writes_readings_ = take.level() == TakeLevel::kSignal && runs.summary.inertial_run == 0;
    runs.summary.contacts_edited = in.contacts.has_value();
    runs.summary.duration_s = static_cast<double>(in.sample_count) / in.decoder.train.sample_rate_hz;
    return runs;
}

Status ResultRuns::beginSubject(const Ingredients& in) {
    const std::filesystem::path folder = std::filesystem::path(take_path_).parent_path();
    auto spool = ResultSpool::make(folder.empty() ? "." : folder);
    if (!spool)
        return spool.error();
    parts_.push_back({in.subject.suit(), in.clock, std::move(*spool), {}});
    part_ = parts_.size() - 1;
    summary.subjects.push_back({in.subject.name, in.subject.suit(), 0, {}});
    return Done{};
}

Status ResultRuns::beginRoom(const TakeSubject& room) {
    const std::filesystem::path folder = std::filesystem::path(take_path_).parent_path();
    auto spool = ResultSpool::make(folder.empty() ? "." : folder);
    if (!spool)
        return spool.error();
    parts_.push_back({room.suit(), {}, std::move(*spool), {}});
    part_ = parts_.size() - 1;
    return Done{};
}

void ResultRuns::writeCross(const std::vector<RangeMeasurement>& ranges) {
    for (const RangeMeasurement& range : ranges) {
        summary.together->ranges.add(range.fate);
    }
    parts_[part_].spool.add(ranges);
}

/// The rows that name the runs, and their numbers.
Status ResultRuns::nameRuns(TakeEdit& edit, Take& take, const ProcessRequest& request,
                            const std::vector<Ingredients>& subjects) {
    const Ingredients& in = subjects.front();
    const auto earlier_runs = take.derivedRuns();
    if (!earlier_runs)
        return earlier_runs.error();
    summary.run_name = freeRunName(*earlier_runs, request);
    const auto add = [&](const char* kind, const std::string& name, const std::string& settings) {
        return edit.beginRun(
            {0, kind, name, request.created_utc, request.software, settings, in.calibration_id, in.actor_id});
    };
    const auto decoded = decodedSettings(take, request, subjects);
    if (!decoded)
        return decoded.error();
    // Another processing may have added one meanwhile.
    const int64_t inertial_run = earlierInertialRun(*earlier_runs, *decoded, request.software);
    if (!writes_readings_ && inertial_run != summary.inertial_run)
        return unusableTake(take, "its readings were dropped while it was processed", "Process it again");
    writes_readings_ = writes_readings_ && inertial_run == 0;
    summary.inertial_run = inertial_run;
    if (writes_readings_) {
        auto run = add("inertial", "decoded", *decoded);
        if (!run)
            return run.error();
        summary.inertial_run = *run;
    }
    if (!clocks.tracks.empty()) {
        auto clock_run = add("clock", summary.run_name, "{}");
        if (!clock_run)
            return clock_run.error();
        clock_run_ = *clock_run;
    }
    const nlohmann::json of_ranges =
        summary.together ? nlohmann::json{{"clock_run", clock_run_}} : nlohmann::json::object();
    auto range_run = add("range", summary.run_name, of_ranges.dump());
    if (!range_run)
        return range_run.error();
    summary.range_run = *range_run;
    auto pose_run = add("pose", summary.run_name, settingsJson(request, subjects, summary).dump());
    if (!pose_run)
        return pose_run.error();
    summary.pose_run = *pose_run;
    return Done{};
}

Status ResultRuns::write(const std::vector<InertialReading>& readings) {
    for (const InertialReading& reading : readings) {
        summary.frames_seen += 1;
        summary.frames_lost += reading.corrected_bits ? 0 : 1;
    }
    if (writes_readings_)
        parts_[part_].spool.add(readings);
    return Done{};
}

Status ResultRuns::write(const std::vector<RangeMeasurement>& ranges) {
    for (const RangeMeasurement& range : ranges) {
        summary.ranges.add(range.fate);
        summary.subjects[part_].ranges.add(range.fate);
    }
    parts_[part_].spool.add(ranges);
    return Done{};
}

Status ResultRuns::write(const std::vector<FootContacts>& contacts) {
    const SuitClock& clock = parts_[part_].clock;
    for (FootContacts foot : contacts) {
        summary.contacts += std::ssize(foot.contacts);
        for (FootContact& contact : foot.contacts) {
            contact.from_s = clock.takeTime_s(contact.from_s);
            contact.to_s = clock.takeTime_s(contact.to_s);
        }
        parts_[part_].contacts.push_back(std::move(foot));
    }
    return Done{};
}

Status ResultRuns::write(const std::vector<TimedPose>& poses) {
    std::vector<TimedPose> on_take_time;
    for (const TimedPose& pose : poses) {
        summary.poses += 1;
        summary.subjects[part_].poses += 1;
        if (!pose.pose || !isUsable(*pose.pose))
            return Error{ErrorKind::kUnusable,
                         "the estimator lost its state at " +
                             std::to_string(static_cast<double>(pose.time_ns) * 1e-9) +
                             " s: the data contradict each other",
                         "Check the calibration and the actor; another choice of sensors may work"};
        on_take_time.push_back(onTakeTime(pose, parts_[part_].clock));
    }
    parts_[part_].spool.add(on_take_time);
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

Status ResultRuns::storeClocks(TakeEdit& edit) const {
    for (const auto& [suit, track] : clocks.tracks)
        for (const ClockRow& row : clockRows(track))
            if (Status added = edit.addClock(clock_run_, row, suit); !added)
                return added;
    return Done{};
}

Status ResultRuns::store(Take& take, const ProcessRequest& request, std::vector<Ingredients>& subjects) {
    auto edit = TakeEdit::begin(take);
    if (!edit)
        return edit.error();
    for (Ingredients& in : subjects) {
        edit->view(in.subject.suit());
        if (Status added = addDocuments(*edit, request, in); !added)
            return added;
    }
    edit->view(subjects.front().subject.suit());
    if (Status named = nameRuns(*edit, take, request, subjects); !named)
        return named;
    RunRows rows(*edit, summary, detectorName(subjects.front().decoder.detector), writes_readings_);
    for (Part& part : parts_) {
        edit->view(part.suit);
        if (Status replayed = part.spool.replay(rows); !replayed)
            return replayed;
        if (Status added = edit->addContacts(summary.pose_run, part.contacts); !added)
            return added;
    }
    if (Status stored = storeClocks(*edit); !stored)
        return stored;
    for (const auto& [suit, row] : relatives)
        if (Status added = edit->addRelative(summary.pose_run, row, suit); !added)
            return added;
    return edit->commit();
}

}  // namespace noctule
