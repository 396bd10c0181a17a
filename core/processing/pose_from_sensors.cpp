// SPDX-License-Identifier: Apache-2.0
#include "core/processing/pose_from_sensors.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"
#include "core/posing/pose_body.h"
#include "core/posing/still_bias.h"
#include "core/processing/board_readings.h"

namespace noctule {

namespace {

constexpr double kFewestPoses_hz = 25, kMostPoses_hz = 120;
constexpr int64_t kBridged_ns = 300'000'000;  ///< shorter gaps of one sensor are interpolated
constexpr double kMakersHeading_rad = 0.1;    ///< attitudes of a maker's method whose heading is not said
constexpr double kNoNorth_rad = std::numbers::pi;
constexpr double kHeldRest_rad = 0.1;  ///< how exactly a rest pose is held
/// Boards of which no mounting's sigma is stated. ManifoldParameters::unstated_mounting_rad is smaller: there
/// a rest pose was evaluated, here the suit's design may be all that is known of the straps.
constexpr double kNominalMounting_rad = 0.2;

/// One sensor at its own rate.
struct OwnTrack {
    std::string id, segment;
    std::optional<posing::StatedMounting> mounting;
    std::vector<int64_t> time_ns;
    std::vector<Quaterniond> q_world_sensor;
    std::vector<Vector3d> rate_rad_per_s, accel_m_per_s2;
    std::vector<double> heading_sigma_rad;
};

Vector3d unknown() {
    return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

/// Rates of turn from attitudes, where no gyroscope told.
void completeRates(OwnTrack& track) {
    for (size_t i = 0; i + 1 < track.time_ns.size(); ++i) {
        const double dt_s = double(track.time_ns[i + 1] - track.time_ns[i]) * 1e-9;
        if (!track.rate_rad_per_s[i].allFinite() && dt_s > 0 && dt_s < 0.1)
            track.rate_rad_per_s[i] =
                logQuaternion(track.q_world_sensor[i].conjugate() * track.q_world_sensor[i + 1]) / dt_s;
    }
}

class TrackReader {
public:
    TrackReader(const Take& take, const Ingredients& in, bool smooth, const JobContext& job)
        : take_(take),
          in_(in),
          smooth_(smooth),
          job_(job),
          calibration_(completedCalibration(in.suit, in.calibration)),
          boards_(in.suit, calibration_, in.decoder.train.sample_rate_hz) {}

    Result<std::vector<OwnTrack>> all(std::vector<std::string>& warnings) {
        if (Status read = boards_.gather(take_, job_); !read)
            return read.error();
        auto attitudes = makersRun();
        if (!attitudes)
            return attitudes.error();
        std::vector<OwnTrack> tracks;
        for (size_t b = 0; b < in_.suit.boards.size(); ++b) {
            auto track = of(b, *attitudes);
            if (!track)
                return track.error();
            if (track->time_ns.size() >= 2)
                tracks.push_back(std::move(*track));
            else
                warnings.push_back("Sensor " + in_.suit.boards[b].id +
                                   " has neither readings nor attitudes and is left out.");
            job_.progress(0.5 * double(b + 1) / double(in_.suit.boards.size()), "Orientation of each sensor");
        }
        return tracks;
    }

private:
    /// The run of attitudes that came with the recording; 0: there is none.
    Result<int64_t> makersRun() const {
        const auto runs = take_.derivedRuns();
        if (!runs)
            return runs.error();
        for (const DerivedRun& run : *runs)
            if (run.kind == "orientation")
                return run.run;
        return int64_t{0};
    }

    Result<OwnTrack> of(size_t b, int64_t attitudes) {
        auto readings = boards_.of(b, take_);
        if (!readings)
            return readings.error();
        const Board& board = in_.suit.boards[b];
        OwnTrack track{board.id, board.segment, mountingOf(b), {}, {}, {}, {}, {}};
        const size_t rows = readings->samples.size();
        if (rows > 0 && double(readings->missing) < 0.5 * double(rows))
            return estimated(std::move(track), *readings);
        if (attitudes == 0)
            return track;
        const auto told = take_.orientations(attitudes, int(b));
        if (!told)
            return told.error();
        return fromAttitudes(std::move(track), *told, *readings);
    }

    /// An import leaves places and turns of all its boards at zero: it knows none.
    bool suitStatesMountings() const {
        return std::ranges::any_of(in_.suit.boards, [](const Board& board) {
            return !board.p_segment_board_m.isZero() || std::abs(board.q_segment_board.w()) < 1;
        });
    }

    std::optional<posing::StatedMounting> mountingOf(size_t b) const {
        const BoardCalibration& board = calibration_.boards[b];
        if (!board.q_segment_board && !suitStatesMountings())
            return std::nullopt;
        const double sigma_rad =
            board.sigma_mounting_rad ? board.sigma_mounting_rad->maxCoeff() : kNominalMounting_rad;
        return posing::StatedMounting{board.q_segment_board.value_or(in_.suit.boards[b].q_segment_board),
                                      std::hypot(kHeldRest_rad, sigma_rad)};
    }

    Result<OwnTrack> estimated(OwnTrack track, BoardReadings& readings) {
        auto run = posing::wornOrientation(readings.samples, smooth_, {nullptr, job_.cancel});
        if (!run)
            return run.error();
        for (size_t i = 0; i < readings.samples.size(); ++i) {
            const ImuSamples& samples = readings.samples;
            if (!samples.gyro_rad_per_s[i].allFinite() || !samples.accel_m_per_s2[i].allFinite())
                continue;
            track.time_ns.push_back(readings.time_ns[i]);
            track.q_world_sensor.push_back(run->q_world_sensor[i]);
            track.rate_rad_per_s.push_back(samples.gyro_rad_per_s[i]);
            track.accel_m_per_s2.push_back(samples.accel_m_per_s2[i]);
            track.heading_sigma_rad.push_back(samples.mag.empty() || i >= run->heading_sigma_rad.size()
                                                  ? kNoNorth_rad
                                                  : run->heading_sigma_rad[i]);
        }
        return track;
    }

    /// Accelerations stand beside attitudes where the recording has them.
    static OwnTrack fromAttitudes(OwnTrack track, const std::vector<OrientationRow>& told,
                                  const BoardReadings& readings) {
        size_t near = 0;
        for (const OrientationRow& row : told) {
            track.time_ns.push_back(row.time_ns);
            track.q_world_sensor.push_back(row.q_world_board);
            track.rate_rad_per_s.push_back(unknown());
            track.heading_sigma_rad.push_back(row.heading_sigma_rad > 0 ? row.heading_sigma_rad
                                                                        : kMakersHeading_rad);
            while (near + 1 < readings.time_ns.size() && readings.time_ns[near] + 500'000 < row.time_ns)
                ++near;
            const bool beside =
                near < readings.time_ns.size() && std::abs(readings.time_ns[near] - row.time_ns) <= 500'000;
            track.accel_m_per_s2.push_back(beside ? readings.samples.accel_m_per_s2[near] : unknown());
        }
        completeRates(track);
        return track;
    }

    const Take& take_;
    const Ingredients& in_;
    bool smooth_;
    const JobContext& job_;
    Calibration calibration_;
    ReadingsOfBoards boards_;
};

double rateOf(const OwnTrack& track) {
    std::vector<int64_t> steps;
    for (size_t i = 1; i < track.time_ns.size(); ++i)
        steps.push_back(track.time_ns[i] - track.time_ns[i - 1]);
    std::nth_element(steps.begin(), steps.begin() + std::ssize(steps) / 2, steps.end());
    return 1e9 / double(std::max<int64_t>(1, steps[steps.size() / 2]));
}

/// Readings that are faster than the grid are averaged over one of its steps.
Vector3d meanAround(const std::vector<Vector3d>& values, const OwnTrack& track, size_t near,
                    int64_t half_ns) {
    Vector3d sum = values[near];
    double count = 1;
    for (size_t i = near; i-- > 0 && track.time_ns[near] - track.time_ns[i] < half_ns;) {
        sum += values[i];
        count += 1;
    }
    for (size_t i = near + 1; i < values.size() && track.time_ns[i] - track.time_ns[near] < half_ns; ++i) {
        sum += values[i];
        count += 1;
    }
    return sum / count;
}

posing::SensorTrack onGrid(const OwnTrack& track, int64_t first_ns, double rate_hz, size_t rows) {
    posing::SensorTrack out;
    out.id = track.id;
    out.segment = track.segment;
    out.mounting = track.mounting;
    const auto half_ns = int64_t(0.5e9 / rate_hz);
    size_t after = 0;
    for (size_t row = 0; row < rows; ++row) {
        const int64_t now = first_ns + std::llround(double(row) * 1e9 / rate_hz);
        while (after < track.time_ns.size() && track.time_ns[after] < now)
            ++after;
        const bool on = after < track.time_ns.size() && track.time_ns[after] == now;
        const bool inside = after > 0 && after < track.time_ns.size() &&
                            track.time_ns[after] - track.time_ns[after - 1] <= kBridged_ns;
        if (!on && !inside) {
            const double nan = std::numeric_limits<double>::quiet_NaN();
            out.q_world_sensor.emplace_back(nan, nan, nan, nan);
            out.rate_rad_per_s.push_back(unknown());
            out.accel_m_per_s2.push_back(unknown());
            out.heading_sigma_rad.push_back(kNoNorth_rad);
            continue;
        }
        const size_t before = on ? after : after - 1;
        const double part =
            on ? 0
               : double(now - track.time_ns[before]) / double(track.time_ns[after] - track.time_ns[before]);
        const size_t near = part > 0.5 ? after : before;
        out.q_world_sensor.push_back(track.q_world_sensor[before].slerp(part, track.q_world_sensor[after]));
        out.rate_rad_per_s.push_back(meanAround(track.rate_rad_per_s, track, near, half_ns));
        out.accel_m_per_s2.push_back(meanAround(track.accel_m_per_s2, track, near, half_ns));
        out.heading_sigma_rad.push_back(track.heading_sigma_rad[near]);
    }
    return out;
}

posing::SensorTracks gridOf(const std::vector<OwnTrack>& own) {
    posing::SensorTracks tracks;
    int64_t first = std::numeric_limits<int64_t>::max(), last = std::numeric_limits<int64_t>::min();
    for (const OwnTrack& track : own) {
        first = std::min(first, track.time_ns.front());
        last = std::max(last, track.time_ns.back());
        tracks.rate_hz = std::max(tracks.rate_hz, rateOf(track));
    }
    tracks.rate_hz = std::clamp(tracks.rate_hz, kFewestPoses_hz, kMostPoses_hz);
    tracks.first_ns = first;
    const auto rows = size_t(std::floor(double(last - first) * 1e-9 * tracks.rate_hz + 1e-3)) + 1;
    for (const OwnTrack& track : own)
        tracks.sensors.push_back(onGrid(track, first, tracks.rate_hz, rows));
    return tracks;
}

std::optional<std::pair<size_t, size_t>> restRows(const Ingredients& in, const posing::SensorTracks& tracks) {
    if (!in.rest)
        return std::nullopt;
    const auto row = [&](int64_t sample) {
        const double time_s =
            double(sample) / in.decoder.train.sample_rate_hz - double(tracks.first_ns) * 1e-9;
        return size_t(std::clamp(time_s * tracks.rate_hz, 0.0, double(tracks.size() - 1)));
    };
    return std::pair{row(in.rest->first), row(in.rest->second)};
}

}  // namespace

Status poseFromSensors(const Take& take, const Ingredients& in, const TrackerSettings& tracker,
                       ResultRuns& results, const JobContext& job) {
    auto own = TrackReader(take, in, tracker.smoother == Smoother::kFull, job).all(results.summary.warnings);
    if (!own)
        return own.error();
    if (own->empty())
        return unusableTake(take, "no sensor has readings or attitudes",
                            "Look at the take with inspect; a take of sound is processed by the others");
    const posing::SensorTracks tracks = gridOf(*own);
    auto motion = posing::poseBody(in.actor, tracks, restRows(in, tracks), {}, job);
    if (!motion) {
        Error error = motion.error();
        return error.kind == ErrorKind::kUnusable ? unusableTake(take, error.message, error.remedy) : error;
    }
    for (const std::string& warning : motion->warnings)
        results.summary.warnings.push_back(warning);
    for (size_t b = 0; b < tracks.sensors.size(); ++b)
        results.summary.frames_seen += std::ssize(tracks.sensors[b].q_world_sensor);
    const TimedMotion whole{in.actor.skeleton, motion->poses};
    if (Status written = results.write(findFootContacts(whole)); !written)
        return written;
    return results.write(whole.frames);
}

}  // namespace noctule
