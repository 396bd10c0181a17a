// SPDX-License-Identifier: Apache-2.0
#include "core/processing/calibrate_sensors.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/recording/take_edit.h"
#include "core/report/calibration_documents.h"
#include "core/sensor_calibration/field_turn.h"
#include "core/sensor_calibration/hand_calibration.h"
#include "core/suit/calibration_entries.h"

namespace noctule {

namespace {

/// Counts of one board, take after take.
struct BoardCounts {
    std::string id, serial;
    bool has_magnetometer = false;
    ImuSamples samples;  ///< raw
};

struct SensorEvidence {
    Calibration base;
    std::vector<BoardCounts> boards;
    double g_m_per_s2 = kStandardGravity_m_per_s2;
};

Vector3d countsOf(const std::optional<double>* counts) {
    Vector3d v;
    for (size_t axis = 0; axis < 3; ++axis)
        v[Eigen::Index(axis)] = counts[axis].value_or(std::numeric_limits<double>::quiet_NaN());
    return v;
}

Status addCounts(const Take& take, SensorEvidence& evidence, const JobContext& job) {
    auto cursor = take.readings(kPrimaryRun);
    if (!cursor)
        return cursor.error();
    const auto rate = take.sampleRate_hz();
    if (!rate)
        return rate.error();
    std::vector<std::pair<double, double>> first(evidence.boards.size(), {-1, 0}), last = first;
    for (size_t n = 0;; ++n) {
        auto next = cursor->next();
        if (!next)
            return next.error();
        if (!*next)
            break;
        const InertialReading& row = **next;
        const auto b = size_t(row.board);
        ImuSamples& samples = evidence.boards[b].samples;
        samples.gyro_rad_per_s.push_back(countsOf(row.counts.data()));
        samples.accel_m_per_s2.push_back(countsOf(row.counts.data() + 3));
        samples.mag.push_back(countsOf(row.magnetometer_counts.data()));
        if (first[b].first < 0)
            first[b] = {double(row.frame), row.sample};
        last[b] = {double(row.frame), row.sample};
        if (n % 4096 == 0 && job.cancelled())
            return JobContext::cancelledError();
    }
    for (size_t b = 0; b < evidence.boards.size(); ++b)
        if (last[b].second > first[b].second)
            evidence.boards[b].samples.rate_hz =
                double(*rate) * (last[b].first - first[b].first) / (last[b].second - first[b].second);
    return Done{};
}

Result<SensorEvidence> sensorEvidence(const CalibrateRequest& request, const JobContext& job) {
    SensorEvidence evidence;
    for (const std::string& path : request.take_paths) {
        const auto take = Take::open(path);
        if (!take)
            return take.error();
        const auto suit = take->suit();
        if (!suit)
            return suit.error();
        if (evidence.boards.empty()) {
            evidence.g_m_per_s2 = take->header().g_m_per_s2;
            evidence.base = nominalCalibration(*suit);
            const auto stored = take->calibrationInForce();
            for (BoardCalibration& board : evidence.base.boards)
                for (const Calibration* known :
                     {stored ? &stored->value : nullptr, request.base ? &*request.base : nullptr})
                    if (const BoardCalibration* values = known ? known->findBoard(board.id) : nullptr)
                        board = *values;
            if (request.base)
                evidence.base.sources = request.base->sources;
            for (const Board& board : suit->boards)
                evidence.boards.push_back({board.id, board.serial, board.has_magnetometer, {}});
        }
        const bool same = suit->boards.size() == evidence.boards.size() &&
                          std::equal(suit->boards.begin(), suit->boards.end(), evidence.boards.begin(),
                                     [](const Board& a, const BoardCounts& b) { return a.id == b.id; });
        if (!same)
            return Error{ErrorKind::kUnusable, path + ": has other boards than " + request.take_paths.front(),
                         "Calibrate takes of one suit at a time"};
        if (Status added = addCounts(*take, evidence, job); !added)
            return added.error();
    }
    return evidence;
}

template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments) {
    char text[160];
    std::snprintf(text, sizeof text, format, arguments...);
    return text;
}

void markMade(BoardCalibration& board, const std::string& procedure, const CalibrateRequest& request,
              Grade grade) {
    board.made[procedure] = {request.created_utc, gradeWord(grade)};
}

CalibrationResult emptyResult(const std::string& procedure, const CalibrateRequest& request,
                              const SensorEvidence& evidence) {
    CalibrationResult result;
    result.calibration = evidence.base;
    result.calibration.created_utc = request.created_utc;
    result.document.procedure = procedure;
    result.document.created_utc = request.created_utc;
    result.document.takes = request.take_paths;
    result.json = {{"takes", request.take_paths}, {"boards", nlohmann::json::array()}};
    return result;
}

void finishResult(CalibrationResult& result, const std::string& procedure) {
    result.json["procedure"] = procedure;
    result.json.update(findingsJson(result.document.findings));
}

void addProblem(CalibrationResult& result, const std::string& board, const std::string& problem,
                const std::string& remedy) {
    result.document.findings.push_back({Grade::kNotUsable, board, board + ": " + problem, remedy});
}

void addField(CalibrationResult& result, const BoardCounts& board, const AxisCalibration& mag,
              const BoardCalibration& values, nlohmann::json& json) {
    ImuSamples samples = board.samples;
    for (size_t i = 0; i < samples.size(); ++i) {
        samples.gyro_rad_per_s[i] = values.gyro.apply(samples.gyro_rad_per_s[i]);
        samples.accel_m_per_s2[i] = values.accel.apply(samples.accel_m_per_s2[i]);
        samples.mag[i] = mag.apply(samples.mag[i]);
    }
    const FieldCheck check = checkField(samples);
    json["field"] = {{"bent_percent", check.bent_percent}, {"stretches", nlohmann::json::array()}};
    for (const BentField& bent : check.stretches)
        json["field"]["stretches"].push_back({{"from_s", bent.from_s},
                                              {"to_s", bent.to_s},
                                              {"strength_off_percent", bent.strength_off_percent},
                                              {"dip_off_deg", bent.dip_off_deg}});
    if (check.bent_percent > 10)
        result.document.findings.push_back(
            {Grade::kUsable, board.id,
             board.id + ": the field is bent for " + formatted("%.0f %%", check.bent_percent) +
                 " of the time",
             "Keep away from iron, magnets and cables, or expect a worse heading there"});
}

AxisCalibration axesOfFit(const EllipsoidFit& fit) {
    AxisCalibration axes;
    axes.zero_counts = fit.zero;
    axes.matrix = fit.matrix;
    axes.sigma_zero_counts = fit.sigma_zero;
    return axes;
}

/// A fit made on values becomes one on counts: matrix (M (c - z) - zero).
AxisCalibration onTopOf(const AxisCalibration& below, const Vector3d& zero, const Vector3d& sigma,
                        const Matrix3d& matrix) {
    AxisCalibration axes;
    const Matrix3d back = below.matrix.inverse();
    axes.zero_counts = below.zero_counts + back * zero;
    axes.matrix = matrix * below.matrix;
    axes.sigma_zero_counts = (back * sigma).cwiseAbs();
    return axes;
}

}  // namespace

Result<CalibrationResult> calibrateMagnetometers(const CalibrateRequest& request,
                                                 std::optional<double> strength_ut, const JobContext& job) {
    const auto evidence = sensorEvidence(request, job);
    if (!evidence)
        return evidence.error();
    CalibrationResult result = emptyResult("Magnetometers", request, *evidence);
    CalibrationTable table{
        "Magnetometers",
        "Spread: how much the field's strength differs between directions.",
        {"board", "strength uT", "spread before %", "spread after %", "residual uT", "directions of 26"},
        {}};
    for (const BoardCounts& board : evidence->boards) {
        if (!board.has_magnetometer)
            continue;
        const MagnetometerFit fit = fitMagnetometer(board.samples.mag, strength_ut);
        nlohmann::json json = {{"id", board.id},
                               {"strength_ut", fit.strength_ut},
                               {"spread_before_percent", fit.before_percent},
                               {"spread_after_percent", fit.after_percent},
                               {"residual_ut", fit.ellipsoid.residual},
                               {"condition", fit.ellipsoid.condition},
                               {"directions_covered", fit.coverage.covered},
                               {"directions_missing", fit.coverage.missing},
                               {"usable", fit.problem.empty()}};
        table.rows.push_back({board.id, formatted("%.1f", fit.strength_ut),
                              formatted("%.1f", fit.before_percent), formatted("%.2f", fit.after_percent),
                              formatted("%.2f", fit.ellipsoid.residual),
                              std::to_string(fit.coverage.covered)});
        if (fit.problem.empty()) {
            for (BoardCalibration& values : result.calibration.boards)
                if (values.id == board.id) {
                    values.mag = axesOfFit(fit.ellipsoid);
                    values.serial = board.serial;
                    markMade(values, "magnetometers", request, Grade::kGood);
                    addField(result, board, *values.mag, values, json);
                }
        } else {
            addProblem(result, board.id, fit.problem, fit.remedy);
        }
        result.json["boards"].push_back(std::move(json));
        job.progress(double(table.rows.size()) / double(evidence->boards.size()),
                     "Magnetometer of " + board.id);
    }
    if (table.rows.empty())
        return Error{ErrorKind::kUnusable, request.take_paths.front() + ": no board has a magnetometer",
                     "Record with magnetometers switched on"};
    result.document.summary = "Hard and soft iron of " + std::to_string(table.rows.size()) + " magnetometers";
    result.document.tables.push_back(std::move(table));
    finishResult(result, "magnetometers");
    return result;
}

Result<CalibrationResult> calibrateMagnetometers(const Suit& suit, const CalibrateRequest& request,
                                                 const std::vector<MagnetometerReadings>& turned,
                                                 const JobContext& job) {
    SensorEvidence evidence;
    evidence.base = request.base.value_or(nominalCalibration(suit));
    CalibrationResult result = emptyResult("Magnetometers", request, evidence);
    CalibrationTable table{
        "Magnetometers",
        "Spread: how much the field's strength differs between directions.",
        {"board", "strength uT", "spread before %", "spread after %", "zero +- uT", "directions of 100"},
        {}};
    for (const MagnetometerReadings& one : turned) {
        const int index = suit.findBoard(one.board);
        if (index < 0 || one.readings_ut.empty())
            continue;
        if (job.cancelled())
            return JobContext::cancelledError();
        const Board& board = suit.boards[static_cast<size_t>(index)];
        FieldTurn turn;
        for (const Vector3d& reading : one.readings_ut)
            turn.add(reading);
        turn.judge();
        const MagnetometerFit& fit = turn.fit();
        const bool done = turn.state() == FieldTurnState::kDone;
        const double sigma_ut = (fit.ellipsoid.matrix * fit.ellipsoid.sigma_zero).norm();
        table.rows.push_back({board.id, formatted("%.1f", fit.strength_ut),
                              formatted("%.1f", fit.before_percent), formatted("%.2f", fit.after_percent),
                              formatted("%.2f", sigma_ut), std::to_string(turn.sphere().seen())});
        result.json["boards"].push_back({{"id", board.id},
                                         {"strength_ut", fit.strength_ut},
                                         {"spread_before_percent", fit.before_percent},
                                         {"spread_after_percent", fit.after_percent},
                                         {"sigma_zero_ut", sigma_ut},
                                         {"condition", fit.ellipsoid.condition},
                                         {"directions_seen_percent", 100 * turn.sphere().share()},
                                         {"usable", fit.problem.empty()}});
        if (!fit.problem.empty() || turn.state() == FieldTurnState::kClipped ||
            turn.state() == FieldTurnState::kNoField) {
            addProblem(result, board.id, fit.problem.empty() ? "its field cannot be measured" : fit.problem,
                       fit.remedy.empty() ? "Move it away from magnets and turn it again" : fit.remedy);
            continue;
        }
        BoardCalibration& values = entryOf(result.calibration, board);
        values.mag = onTopOf(AxisCalibration::nominal(FieldTurnLimits::kFullScale_ut), fit.ellipsoid.zero,
                             fit.ellipsoid.sigma_zero, fit.ellipsoid.matrix);
        values.serial = board.serial;
        markMade(values, "magnetometers", request, done ? Grade::kGood : Grade::kUsable);
        if (!done)
            result.document.findings.push_back(
                {Grade::kUsable, board.id,
                 board.id + ": the field's strength differs by " + formatted("%.1f %%", fit.after_percent),
                 "Turn it again through all directions, away from iron"});
        job.progress(double(table.rows.size()) / double(turned.size()), "Magnetometer of " + board.id);
    }
    if (table.rows.empty())
        return Error{ErrorKind::kUnusable, "no board has readings of its magnetometer",
                     "Turn the suit through all directions first"};
    result.document.summary = "Hard and soft iron of " + std::to_string(table.rows.size()) + " magnetometers";
    result.document.tables.push_back(std::move(table));
    finishResult(result, "magnetometers");
    return result;
}

Result<CalibrationResult> calibrateInertial(const CalibrateRequest& request, const JobContext& job) {
    const auto evidence = sensorEvidence(request, job);
    if (!evidence)
        return evidence.error();
    CalibrationResult result = emptyResult("Inertial sensors by hand", request, *evidence);
    CalibrationTable table{
        "Sensors laid down and turned by hand",
        "Gravity: rms error of its length at rest. Turns: rms angle between gravity carried by "
        "the gyroscope and gravity seen.",
        {"board", "positions", "gravity before m/s^2", "after", "turns before deg", "after"},
        {}};
    for (size_t b = 0; b < evidence->boards.size(); ++b) {
        const BoardCounts& board = evidence->boards[b];
        BoardCalibration& values = result.calibration.boards[b];
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(double(b) / double(evidence->boards.size()), "Sensor " + board.id);
        ImuSamples samples = board.samples;
        for (size_t i = 0; i < samples.size(); ++i) {
            samples.gyro_rad_per_s[i] = values.gyro.apply(samples.gyro_rad_per_s[i]);
            samples.accel_m_per_s2[i] = values.accel.apply(samples.accel_m_per_s2[i]);
        }
        const HandFit fit = samples.rate_hz > 0 ? calibrateByHand(samples, evidence->g_m_per_s2) : HandFit{};
        const std::string problem = samples.rate_hz > 0 ? fit.problem : "it has no readings";
        table.rows.push_back({board.id, std::to_string(fit.positions), formatted("%.3f", fit.before_m_per_s2),
                              formatted("%.3f", fit.accel.residual), formatted("%.2f", fit.gyro.before_deg),
                              formatted("%.2f", fit.gyro.residual_deg)});
        result.json["boards"].push_back({{"id", board.id},
                                         {"positions", fit.positions},
                                         {"gravity_before_m_per_s2", fit.before_m_per_s2},
                                         {"gravity_after_m_per_s2", fit.accel.residual},
                                         {"turns_before_deg", fit.gyro.before_deg},
                                         {"turns_after_deg", fit.gyro.residual_deg},
                                         {"condition_accelerometer", fit.accel.condition},
                                         {"condition_gyroscope", fit.gyro.condition},
                                         {"directions_missing", fit.coverage.missing},
                                         {"usable", problem.empty()}});
        if (!problem.empty()) {
            addProblem(result, board.id, problem, fit.remedy.empty() ? "Record it again" : fit.remedy);
            continue;
        }
        values.accel = onTopOf(values.accel, fit.accel.zero, fit.accel.sigma_zero, fit.accel.matrix);
        values.gyro = onTopOf(values.gyro, fit.gyro.zero, fit.gyro.sigma_zero, fit.gyro.matrix);
        values.serial = board.serial;
        markMade(values, "inertial", request, Grade::kGood);
    }
    result.document.summary =
        "Accelerometers and gyroscopes of " + std::to_string(table.rows.size()) + " boards";
    result.document.tables.push_back(std::move(table));
    finishResult(result, "inertial");
    return result;
}

Status storeCalibration(const std::vector<std::string>& take_paths, const Calibration& calibration) {
    for (const std::string& path : take_paths) {
        auto take = Take::open(path, Access::kReadWrite);
        if (!take)
            return take.error();
        auto edit = TakeEdit::begin(*take);
        if (!edit)
            return edit.error();
        if (auto added = edit->addCalibration(calibration); !added)
            return added.error();
        if (Status committed = edit->commit(); !committed)
            return committed;
    }
    return Done{};
}

}  // namespace noctule
