// SPDX-License-Identifier: Apache-2.0
#include "core/import/import_take.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/job/atomic_file.h"
#include "core/job/limits.h"
#include "core/recording/take_edit.h"
#include "core/recording/take_writer.h"

namespace noctule {

namespace {

constexpr int64_t kClock_hz = 1'000'000;

Suit suitOf(const ImportedRecording& recording) {
    Suit suit;
    suit.name = recording.name;
    for (const ImportedSensor& sensor : recording.sensors) {
        Board board;
        board.id = sensor.id;
        board.segment = sensor.segment;
        board.has_magnetometer = !sensor.samples.mag.empty();
        board.rate_hz = std::clamp(sensor.samples.rate_hz, kLeastBoardRate_hz, kMostBoardRate_hz);
        suit.boards.push_back(board);
    }
    return suit;
}

Calibration inSi(const ImportedRecording& recording, const std::string& created_utc) {
    Calibration calibration;
    calibration.created_utc = created_utc;
    for (const ImportedSensor& sensor : recording.sensors) {
        BoardCalibration board;
        board.id = sensor.id;
        board.gyro.zero_counts = board.accel.zero_counts = Vector3d::Zero();
        calibration.boards.push_back(board);
    }
    return calibration;
}

Actor sensorActor() {
    Joint root;
    root.name = kSensorJoint;
    root.type = JointType::kFree;
    Actor actor;
    actor.name = "one sensor";
    actor.skeleton = Skeleton::make({root}).value();
    actor.rest_q_parent_joint = {Quaterniond::Identity()};
    return actor;
}

template <size_t N>
bool put(const Vector3d& reading, size_t at, std::array<std::optional<double>, N>& counts) {
    for (size_t axis = 0; axis < 3; ++axis)
        if (std::isfinite(reading[Eigen::Index(axis)]))
            counts[at + axis] = reading[Eigen::Index(axis)];
    return reading.allFinite();
}

class TakeOfImport {
public:
    TakeOfImport(const ImportedRecording& recording, TakeWriter& take, const JobContext& job)
        : recording_(recording), take_(take), job_(job) {}

    Status readings(ImportSummary& summary) {
        for (size_t s = 0; s < recording_.sensors.size(); ++s) {
            const ImuSamples& samples = recording_.sensors[s].samples;
            for (size_t i = 0; i < samples.size(); ++i) {
                InertialReading reading;
                reading.board = static_cast<int>(s);
                reading.frame = static_cast<int64_t>(i);
                reading.sample = (sensor_offset_s(s) + double(i) / samples.rate_hz) * double(kClock_hz);
                const bool turned = put(samples.gyro_rad_per_s[i], 0, reading.counts);
                const bool pushed = put(samples.accel_m_per_s2[i], 3, reading.counts);
                if (i < samples.mag.size())
                    put(samples.mag[i], 0, reading.magnetometer_counts);
                if (hasAny(reading))
                    reading.corrected_bits = 0;
                summary.missing += !turned || !pushed;
                if (Status added = take_.addInertial(kPrimaryRun, reading); !added)
                    return added;
                if (i % 4096 == 0 && job_.cancelled())
                    return JobContext::cancelledError();
            }
            summary.readings += samples.size();
            job_.progress(double(s + 1) / double(recording_.sensors.size()), "Readings");
        }
        return Done{};
    }

    Status bodyReference() {
        for (const TimedPose& timed : recording_.reference->frames)
            if (Status added = take_.addReference(timed); !added)
                return added;
        return Done{};
    }

    /// The optical system saw the only sensor at some time.
    bool seesSensor() const {
        for (size_t i = 0; i < recording_.q_world_sensor.size(); ++i)
            if (seesSensorAt(i))
                return true;
        return false;
    }

    Status reference(double rate_hz) {
        for (size_t i = 0; i < recording_.q_world_sensor.size(); ++i) {
            TimedPose timed;
            timed.time_ns = std::llround(double(i) / rate_hz * 1e9);
            if (seesSensorAt(i))
                timed.pose =
                    Pose{recording_.p_world_sensor_m[i], {recording_.q_world_sensor[i].normalized()}};
            if (Status added = take_.addReference(timed); !added)
                return added;
        }
        return movement(rate_hz);
    }

private:
    bool seesSensorAt(size_t i) const {
        return recording_.q_world_sensor[i].coeffs().allFinite() &&
               recording_.p_world_sensor_m[i].allFinite();
    }
    double sensor_offset_s(size_t sensor) const { return recording_.sensors[sensor].offset_s; }

    static bool hasAny(const InertialReading& reading) {
        const auto given = [](const std::optional<double>& count) { return count.has_value(); };
        return std::any_of(reading.counts.begin(), reading.counts.end(), given) ||
               std::any_of(reading.magnetometer_counts.begin(), reading.magnetometer_counts.end(), given);
    }

    Status movement(double rate_hz) {
        const auto mark = [&](size_t row, const char* label) {
            return take_.addMarker(
                {std::llround(double(row) / rate_hz * double(kClock_hz)), kMovementMarker, label});
        };
        const std::vector<char>& moves = recording_.moves;
        for (size_t i = 0; i < moves.size(); ++i) {
            if (moves[i] && (i == 0 || !moves[i - 1]))
                if (Status begun = mark(i, "begin"); !begun)
                    return begun;
            if (moves[i] && (i + 1 == moves.size() || !moves[i + 1]))
                if (Status ended = mark(i, "end"); !ended)
                    return ended;
        }
        return Done{};
    }

    const ImportedRecording& recording_;
    TakeWriter& take_;
    const JobContext& job_;
};

nlohmann::json importJson(const ImportedRecording& recording) {
    return {{"format", recording.format}, {"notes", recording.notes}, {"warnings", recording.warnings}};
}

bool bringsAttitudes(const ImportedRecording& recording) {
    return std::any_of(recording.sensors.begin(), recording.sensors.end(),
                       [](const ImportedSensor& sensor) { return !sensor.q_world_sensor.empty(); });
}

/// The maker's attitudes as a run beside which ours can stand.
Status writeAttitudes(const ImportedRecording& recording, const std::string& path,
                      const ImportRequest& request, const JobContext& job) {
    auto take = Take::open(path, Access::kReadWrite);
    if (!take)
        return take.error();
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    const auto run = edit->beginRun({0, "orientation", kMakersRun, request.created_utc, request.software,
                                     importJson(recording).dump(), std::nullopt, std::nullopt});
    if (!run)
        return run.error();
    for (size_t s = 0; s < recording.sensors.size(); ++s) {
        const ImportedSensor& sensor = recording.sensors[s];
        for (size_t i = 0; i < sensor.q_world_sensor.size(); ++i) {
            if (i % 4096 == 0 && job.cancelled())
                return JobContext::cancelledError();
            const Quaterniond& q = sensor.q_world_sensor[i];
            const double time_s = sensor.offset_s + double(i) / sensor.samples.rate_hz;
            if (!q.coeffs().allFinite())
                continue;
            if (Status added = edit->addOrientation(*run, {int(s), std::llround(time_s * 1e9), q, 0}); !added)
                return added;
        }
    }
    return edit->commit();
}

Status writeAll(const ImportedRecording& recording, TakeWriter& take, const ImportRequest& request,
                const JobContext& job, ImportSummary& summary) {
    if (auto added = take.addSuit(suitOf(recording)); !added)
        return added.error();
    if (auto added = take.addCalibration(inSi(recording, request.created_utc)); !added)
        return added.error();
    if (Status set = take.setMeta("level", "readings"); !set)
        return set;
    TakeOfImport writer(recording, take, job);
    if (Status written = writer.readings(summary); !written)
        return written;
    if (Status set = take.setMeta("x_import", importJson(recording).dump()); !set)
        return set;
    if (recording.reference && std::ranges::any_of(recording.reference->frames, [](const TimedPose& timed) {
            return timed.pose.has_value();
        })) {
        summary.has_reference = true;
        if (Status set = take.setMeta("reference_kind", recording.format); !set)
            return set;
        Actor actor;
        actor.name = recording.name;
        actor.skeleton = recording.reference->skeleton;
        actor.rest_q_parent_joint = actor.skeleton.zeroPose().q_parent_joint;
        for (const auto& [key, value] :
             {std::pair{"reference_actor", toJson(actor).dump()}, {"reference_frames", std::string("own")}})
            if (Status set = take.setMeta(key, value); !set)
                return set;
        return writer.bodyReference();
    }
    if (!writer.seesSensor())
        return Done{};
    summary.has_reference = true;
    if (Status set = take.setMeta("reference_kind", "optical"); !set)
        return set;
    if (Status set = take.setMeta("reference_actor", toJson(sensorActor()).dump()); !set)
        return set;
    return writer.reference(summary.rate_hz);
}

Result<ImportSummary> summaryOf(const ImportedRecording& recording) {
    if (recording.sensors.size() > Suit::kMaxPerSuit || recording.sensors.empty())
        return Error{ErrorKind::kUnusable,
                     recording.name + ": has " + std::to_string(recording.sensors.size()) + " sensors",
                     "A take holds 1 to 32 in one suit; import fewer at a time"};
    ImportSummary summary;
    summary.sensors = recording.sensors.size();
    summary.rate_hz = recording.sensors.front().samples.rate_hz;
    summary.has_attitudes = bringsAttitudes(recording);
    for (const ImportedSensor& sensor : recording.sensors) {
        summary.duration_s = std::max(
            summary.duration_s, sensor.offset_s + double(sensor.samples.size()) / sensor.samples.rate_hz);
        summary.has_magnetometer |= !sensor.samples.mag.empty();
    }
    if (!(summary.duration_s <= double(limits::kLongestTake_s)))
        return Error{ErrorKind::kUnusable,
                     recording.name + ": lasts " + std::to_string(summary.duration_s) + " s",
                     "A take lasts a week at most; check the rate"};
    return summary;
}

Status writeTake(const ImportedRecording& recording, const std::string& path, const ImportRequest& request,
                 const JobContext& job, ImportSummary& summary) {
    TakeHeader header;
    header.uuid = request.uuid;
    header.name = request.take_name;
    header.created_utc = request.created_utc;
    header.software = request.software;
    header.sample_rate_hz = kClock_hz;
    header.board_count = static_cast<int>(recording.sensors.size());
    TakeWriter::Options options;
    options.overwrite = request.overwrite;
    auto take = TakeWriter::create(path, header, options);
    if (!take)
        return take.error();
    if (Status written = writeAll(recording, *take, request, job, summary); !written)
        return written;
    if (Status counted = take->setMeta("sample_count",
                                       std::to_string(std::llround(summary.duration_s * double(kClock_hz))));
        !counted)
        return counted;
    if (!request.performer.empty())
        if (Status named = take->setMeta("performer", request.performer); !named)
            return named;
    return take->finish();
}

/// A take that is written aside, completed there and only then named.
Status writeWithAttitudes(const ImportedRecording& recording, const ImportRequest& request,
                          const JobContext& job, ImportSummary& summary) {
    const std::string aside = asidePath(request.out_path);
    Status done = writeTake(recording, aside, request, job, summary);
    if (done)
        done = writeAttitudes(recording, aside, request, job);
    if (done)
        done = publishFile(aside, request.out_path, request.overwrite);
    if (done)
        return done;
    std::remove(aside.c_str());
    return namedAs(done.error(), aside, request.out_path);
}

}  // namespace

Result<ImportSummary> writeImportedTake(const ImportedRecording& recording, const ImportRequest& request,
                                        const JobContext& job) {
    auto summary = summaryOf(recording);
    if (!summary)
        return summary.error();
    if (Status free = checkOutputPath(request.out_path, request.overwrite); !free)
        return free.error();
    const Status written = summary->has_attitudes
                               ? writeWithAttitudes(recording, request, job, *summary)
                               : writeTake(recording, request.out_path, request, job, *summary);
    if (!written)
        return written.error();
    return summary;
}

}  // namespace noctule
