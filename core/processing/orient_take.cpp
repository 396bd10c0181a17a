// SPDX-License-Identifier: Apache-2.0
#include "core/processing/orient_take.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/recording/take_edit.h"

namespace noctule {

namespace {

constexpr const char* kOrientationKind = "orientation";
constexpr double kLowestRate_hz = 10, kHighestRate_hz = 10'000;

Error orientationError(const Take& take, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnusable, take.path() + ": " + what, remedy};
}

/// Readings of one board on an even grid: a lost frame is a row of NaN.
struct BoardReadings {
    ImuSamples samples;
    std::vector<int64_t> time_ns;
    size_t missing = 0;
};

Vector3d calibrated(const InertialReading& reading, size_t at, const AxisCalibration& calibration) {
    Vector3d counts;
    for (size_t axis = 0; axis < 3; ++axis)
        counts[Eigen::Index(axis)] =
            reading.counts[at + axis].value_or(std::numeric_limits<double>::quiet_NaN());
    return calibration.apply(counts);
}

class ReadingsOfBoards {
public:
    ReadingsOfBoards(const Suit& suit, const Calibration& calibration, double sample_rate_hz)
        : suit_(suit),
          calibration_(calibration),
          sample_rate_hz_(sample_rate_hz),
          rows_(suit.boards.size()) {}

    void add(const InertialReading& reading) { rows_[size_t(reading.board)].push_back(reading); }

    Result<BoardReadings> of(size_t board, const Take& take) const {
        const auto& rows = rows_[board];
        BoardReadings out;
        if (rows.size() < 2)
            return out;
        const double step =
            double(rows.back().sample - rows.front().sample) / double(rows.back().frame - rows.front().frame);
        out.samples.rate_hz = sample_rate_hz_ / step;
        if (!(out.samples.rate_hz >= kLowestRate_hz && out.samples.rate_hz <= kHighestRate_hz))
            return orientationError(take,
                                    "board " + suit_.boards[board].id + " reads at " +
                                        std::to_string(out.samples.rate_hz) + " Hz",
                                    "Orientation needs 10 to 10000 readings a second");
        fill(rows, board, step, out);
        return out;
    }

private:
    void fill(const std::vector<InertialReading>& rows, size_t board, double step, BoardReadings& out) const {
        const Vector3d nothing = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
        const auto count = static_cast<size_t>(rows.back().frame - rows.front().frame + 1);
        ImuSamples& samples = out.samples;
        samples.gyro_rad_per_s.assign(count, nothing);
        samples.accel_m_per_s2.assign(count, nothing);
        if (suit_.boards[board].has_magnetometer)
            samples.mag.assign(count, nothing);
        const BoardCalibration* values = calibration_.findBoard(suit_.boards[board].id);
        for (const InertialReading& row : rows) {
            const auto i = static_cast<size_t>(row.frame - rows.front().frame);
            samples.gyro_rad_per_s[i] = calibrated(row, 0, values->gyro);
            samples.accel_m_per_s2[i] = calibrated(row, 3, values->accel);
            for (Eigen::Index axis = 0; axis < 3 && !samples.mag.empty(); ++axis)
                if (row.magnetometer_counts[size_t(axis)])
                    samples.mag[i][axis] = *row.magnetometer_counts[size_t(axis)];
            if (values->mag && !samples.mag.empty())
                samples.mag[i] = values->mag->apply(samples.mag[i]);
        }
        for (size_t i = 0; i < count; ++i) {
            out.missing += !samples.gyro_rad_per_s[i].allFinite() || !samples.accel_m_per_s2[i].allFinite();
            out.time_ns.push_back(
                std::llround((rows.front().sample + double(i) * step) * 1e9 / sample_rate_hz_));
        }
    }

    const Suit& suit_;
    const Calibration& calibration_;
    double sample_rate_hz_;
    std::vector<std::vector<InertialReading>> rows_;
};

Status gather(const Take& take, ReadingsOfBoards& boards, const JobContext& job) {
    auto cursor = take.readings(kPrimaryRun);
    if (!cursor)
        return cursor.error();
    for (size_t n = 0;; ++n) {
        auto next = cursor->next();
        if (!next)
            return next.error();
        if (!*next)
            return Done{};
        boards.add(**next);
        if (n % 4096 == 0 && job.cancelled())
            return JobContext::cancelledError();
    }
}

/// Board by board; a calibration that names not all boards is completed by nominal values.
Result<Calibration> calibrationOf(const Take& take, const Suit& suit) {
    Calibration all = nominalCalibration(suit);
    auto stored = take.calibrationInForce();
    if (!stored)
        return all;
    for (BoardCalibration& board : all.boards)
        if (const BoardCalibration* known = stored->value.findBoard(board.id))
            board = *known;
    return all;
}

Status writeRows(TakeEdit& edit, int64_t run, int board, const BoardReadings& readings,
                 const OrientationRun& result) {
    for (size_t i = 0; i < result.q_world_sensor.size(); ++i) {
        const double sigma = i < result.heading_sigma_rad.size() ? result.heading_sigma_rad[i] : 0;
        if (Status added =
                edit.addOrientation(run, {board, readings.time_ns[i], result.q_world_sensor[i], sigma});
            !added)
            return added;
    }
    return Done{};
}

OrientedBoard describe(const std::string& id, const BoardReadings& readings, const OrientationRun& result) {
    OrientedBoard board;
    board.id = id;
    board.readings = readings.samples.size();
    board.missing = readings.missing;
    board.has_magnetometer = !readings.samples.mag.empty();
    board.mag_lag_ms = 1000 * result.mag_lag_s;
    board.mag_lag_sigma_ms = 1000 * result.mag_lag_sigma_s;
    if (!result.heading_sigma_rad.empty())
        board.heading_sigma_deg = degrees(result.heading_sigma_rad.back());
    return board;
}

std::string settingsText(const OrientRequest& request) {
    nlohmann::json settings{{"estimator", request.estimator->name},
                            {"smooth", request.choice.smooth ? "full" : "none"},
                            {"level_reading", request.choice.level_reading}};
    if (request.choice.gain_per_s)
        settings["gain_per_s"] = *request.choice.gain_per_s;
    return settings.dump();
}

Status orientAll(const Take& take, const Suit& suit, const ReadingsOfBoards& boards,
                 const OrientRequest& request, TakeEdit& edit, OrientSummary& summary,
                 const JobContext& job) {
    for (size_t b = 0; b < suit.boards.size(); ++b) {
        auto readings = boards.of(b, take);
        if (!readings)
            return readings.error();
        if (readings->samples.size() == 0) {
            summary.warnings.push_back("Board " + suit.boards[b].id + " has no readings and was left out");
            continue;
        }
        if (readings->missing == readings->samples.size()) {
            summary.warnings.push_back("Board " + suit.boards[b].id +
                                       " has no row with both gyroscope and accelerometer and was left out");
            continue;
        }
        job.progress(double(b) / double(suit.boards.size()), "Orientation of " + suit.boards[b].id);
        auto result = request.estimator->run(readings->samples, request.choice, {nullptr, job.cancel});
        if (!result)
            return result.error();
        if (Status written = writeRows(edit, summary.run, int(b), *readings, *result); !written)
            return written;
        summary.boards.push_back(describe(suit.boards[b].id, *readings, *result));
    }
    if (summary.boards.empty())
        return orientationError(take, "no board has readings of gyroscope and accelerometer",
                                "Process the take's sound first, or record both; attitudes that came with a "
                                "recording are a run already");
    return Done{};
}

std::vector<char> movementOf(const std::vector<MarkerRow>& markers, const std::vector<OrientationRow>& rows,
                             double sample_rate_hz) {
    std::vector<std::pair<double, double>> phases;
    for (const MarkerRow& marker : markers) {
        if (marker.kind != "movement")
            continue;
        const double time_ns = double(marker.sample) * 1e9 / sample_rate_hz;
        if (marker.label == "begin")
            phases.push_back({time_ns, std::numeric_limits<double>::infinity()});
        else if (!phases.empty())
            phases.back().second = time_ns;
    }
    std::vector<char> counts;
    if (phases.empty())
        return counts;
    constexpr double kRounding_ns = 2000;
    for (const OrientationRow& row : rows)
        counts.push_back(std::any_of(phases.begin(), phases.end(), [&](const auto& phase) {
            return double(row.time_ns) >= phase.first - kRounding_ns &&
                   double(row.time_ns) <= phase.second + kRounding_ns;
        }));
    return counts;
}

}  // namespace

Result<OrientSummary> orientTake(const OrientRequest& request, const JobContext& job) {
    auto take = Take::open(request.take_path, Access::kReadWrite);
    if (!take)
        return take.error();
    const auto suit = take->suit();
    if (!suit)
        return suit.error();
    const auto rate = take->sampleRate_hz();
    if (!rate)
        return rate.error();
    const auto calibration = calibrationOf(*take, *suit);
    ReadingsOfBoards boards(*suit, *calibration, double(*rate));
    if (Status read = gather(*take, boards, job); !read)
        return read.error();
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    OrientSummary summary;
    summary.run_name = request.run_name;
    auto run = edit->beginRun({0, kOrientationKind, request.run_name, request.created_utc, request.software,
                               settingsText(request), std::nullopt, std::nullopt});
    if (!run)
        return run.error();
    summary.run = *run;
    if (Status done = orientAll(*take, *suit, boards, request, *edit, summary, job); !done)
        return done.error();
    if (Status committed = edit->commit(); !committed)
        return committed.error();
    return summary;
}

Result<std::optional<OrientationEvaluation>> evaluateOrientation(const std::string& take_path,
                                                                 const std::string& name) {
    using Nothing = std::optional<OrientationEvaluation>;
    const auto take = Take::open(take_path);
    if (!take)
        return take.error();
    const auto runs = take->derivedRuns();
    if (!runs)
        return runs.error();
    const auto chosen = std::find_if(runs->rbegin(), runs->rend(), [&](const DerivedRun& run) {
        return name.empty() ? run.kind == "pose" || run.kind == kOrientationKind : run.name == name;
    });
    if (chosen == runs->rend() || chosen->kind != kOrientationKind)
        return Nothing{};
    const auto suit = take->suit();
    const auto rate = take->sampleRate_hz();
    const auto reference = take->reference();
    const auto markers = take->markers();
    if (!suit || !rate || !markers || !reference || reference->frames.empty() ||
        reference->skeleton.joints().size() != 1)
        return orientationError(*take, "there is no reference of a single sensor to compare with",
                                "Import a recording that brings one, as BROAD's trials do");
    const auto rows = take->orientations(chosen->run, 0);
    if (!rows)
        return rows.error();
    std::vector<Quaterniond> estimate, truth;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const int64_t gap_ns = bridgeableGap_ns(*reference);
    PoseSampler sampler(*reference, gap_ns);
    for (const OrientationRow& row : *rows) {
        const auto pose = sampler.at(row.time_ns);
        estimate.push_back(row.q_world_board);
        truth.push_back(pose ? pose->q_parent_joint[0] : Quaterniond(nan, nan, nan, nan));
    }
    OrientationEvaluation evaluation{chosen->name, suit->boards[0].id, {}};
    evaluation.score = scoreOrientation(estimate, truth, movementOf(*markers, *rows, double(*rate)));
    if (evaluation.score.samples == 0)
        return orientationError(*take, "no instant of the run has a reference",
                                "Look at the take with inspect");
    return Nothing{evaluation};
}

}  // namespace noctule
