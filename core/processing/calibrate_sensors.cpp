// SPDX-License-Identifier: Apache-2.0
#include "core/processing/calibrate_sensors.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/calibration/worn_part_names.h"
#include "core/recording/take_edit.h"
#include "core/report/calibration_documents.h"
#include "core/report/magnetometer_document.h"
#include "core/sensor_calibration/field_turn.h"
#include "core/sensor_calibration/hand_calibration.h"

namespace noctule {

namespace {

/// Counts of one board, take after take.
struct BoardCounts {
    std::string id, serial, words;  ///< "Board 7, left forearm"
    bool has_magnetometer = false;
    bool is_nominal = true;  ///< counts of our boards; else the unit of whoever made the readings
    ImuSamples samples;      ///< raw
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
    struct Stretch {
        double first = -1, last = 0;
        size_t rows = 0;
    };
    std::vector<Stretch> stretches(evidence.boards.size());
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
        Stretch& stretch = stretches[b];
        if (stretch.rows++ == 0)
            stretch.first = row.sample;
        stretch.last = row.sample;
        if (n % 4096 == 0 && job.cancelled())
            return JobContext::cancelledError();
    }
    for (size_t b = 0; b < evidence.boards.size(); ++b)
        if (const Stretch& stretch = stretches[b]; stretch.last > stretch.first)
            evidence.boards[b].samples.rate_hz =
                double(*rate) * double(stretch.rows - 1) / (stretch.last - stretch.first);
    return Done{};
}

/// In the order of the suit's boards; what `known` has besides them stays.
Calibration baseOf(const Suit& suit, const Calibration* stored, const Calibration* given) {
    Calibration base = nominalCalibration(suit);
    for (const Calibration* known : {stored, given}) {
        if (!known)
            continue;
        base.sound = known->sound;
        base.sources = known->sources;
        for (const BoardCalibration& values : known->boards) {
            const auto entry = std::ranges::find(base.boards, values.id, &BoardCalibration::id);
            if (entry != base.boards.end())
                *entry = values;
            else
                base.boards.push_back(values);
        }
    }
    return base;
}

/// Readings that were imported have SI values and no counts: their zero is 0.
bool areCounts(const Calibration* stored, const std::string& board) {
    const BoardCalibration* values = stored ? stored->findBoard(board) : nullptr;
    return !values || !values->gyro.zero_counts.isZero();
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
            const auto in_force = take->calibrationInForce();
            const Calibration* stored = in_force ? &in_force->value : nullptr;
            evidence.base = baseOf(*suit, stored, request.base ? &*request.base : nullptr);
            for (size_t b = 0; b < suit->boards.size(); ++b) {
                const Board& board = suit->boards[b];
                evidence.boards.push_back({board.id,
                                           board.serial,
                                           boardName(*suit, int(b)),
                                           board.has_magnetometer,
                                           areCounts(stored, board.id),
                                           {}});
            }
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

void addProblem(CalibrationResult& result, const BoardCounts& board, const std::string& problem,
                const std::string& remedy) {
    result.document.findings.push_back({Grade::kNotUsable, board.id, board.words + ": " + problem, remedy});
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
             board.words + ": the field is bent for " + formatted("%.0f %%", check.bent_percent) +
                 " of the time",
             "Keep away from iron, magnets and cables, or expect a worse heading there"});
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

struct TurnedBoard {
    TurnedMagnetometer found;
    FieldTurnState state = FieldTurnState::kGoing;
    AxisCalibration scale, axes;  ///< of counts: as they are read, and as calibrated
};

/// Mean strength of the field in each cell of the sphere, relative to the mean of all, in percent.
std::vector<double> offInEveryDirection(const std::vector<Vector3d>& counts, const AxisCalibration& axes,
                                        const AxisCalibration& directions) {
    std::vector<std::pair<double, int>> cells(FieldSphere::kCells);
    for (const Vector3d& reading : counts)
        if (reading.allFinite()) {
            auto& [sum, count] = cells[size_t(FieldSphere::cellOf(directions.apply(reading)))];
            sum += axes.apply(reading).norm();
            ++count;
        }
    std::vector<double> means;
    double all = 0;
    for (const auto& [sum, count] : cells)
        if (count > 0) {
            means.push_back(sum / count);
            all += means.back();
        }
    for (double& mean : means)
        mean = 100 * std::abs(mean * double(means.size()) / all - 1);
    return means;
}

/// With the calibration before, by the measure of the new one. `readings`: counts as `scale` has them.
double spreadBefore_percent(const std::vector<Vector3d>& readings, const AxisCalibration& scale,
                            const AxisCalibration& before) {
    return fieldSpread_percent(readings, scale.apply(before.zero_counts),
                               before.matrix * scale.matrix.inverse());
}

bool isOfTheEarth(double strength_ut) {
    return strength_ut >= FieldTurnLimits::kLeastEarth_ut && strength_ut <= FieldTurnLimits::kMostEarth_ut;
}

TurnedBoard turnedBoard(const BoardCounts& board, const BoardCalibration& before,
                        std::optional<double> strength_ut) {
    TurnedBoard turned;
    turned.found.board = board.id;
    turned.scale.zero_counts.setZero();
    if (board.is_nominal)
        turned.scale = AxisCalibration::nominal(FieldTurnLimits::kFullScale_ut);
    MagnetometerFit& fit = turned.found.fit;
    std::vector<Vector3d> readings = board.samples.mag;
    if (board.is_nominal) {
        FieldTurn turn;
        for (const Vector3d& counts : board.samples.mag)
            turn.add(turned.scale.apply(counts));
        turn.judge(strength_ut);
        readings = turn.readings();
        fit = turn.fit();
        turned.found.seen = turn.sphere();
        turned.state = turn.state();
    } else {
        fit = fitMagnetometer(board.samples.mag, strength_ut);
        if (fit.problem.empty())
            for (const Vector3d& reading : board.samples.mag)
                if (reading.allFinite() && !reading.isZero())
                    turned.found.seen.add(fit.ellipsoid.matrix * (reading - fit.ellipsoid.zero));
        turned.state = fit.problem.empty() ? FieldTurnState::kDone : FieldTurnState::kGoing;
    }
    turned.found.in_microtesla = board.is_nominal || strength_ut.has_value() || isOfTheEarth(fit.strength_ut);
    turned.found.spread_before_percent =
        spreadBefore_percent(readings, turned.scale, before.mag.value_or(turned.scale));
    turned.found.sigma_zero_ut = (fit.ellipsoid.matrix * fit.ellipsoid.sigma_zero).norm();
    if (!fit.problem.empty())
        return turned;
    turned.axes = onTopOf(turned.scale, fit.ellipsoid.zero, fit.ellipsoid.sigma_zero, fit.ellipsoid.matrix);
    turned.found.after_percent = offInEveryDirection(board.samples.mag, turned.axes, turned.axes);
    turned.found.before_percent =
        offInEveryDirection(board.samples.mag, before.mag.value_or(turned.scale), turned.axes);
    return turned;
}

/// Why its values must not be used; empty: they are.
std::pair<std::string, std::string> whyNotUsed(const TurnedBoard& turned) {
    const MagnetometerFit& fit = turned.found.fit;
    if (turned.state == FieldTurnState::kClipped)
        return {"its field is beyond its range",
                "Take away the magnet that lies beside it and turn it again"};
    if (turned.state == FieldTurnState::kNoField)
        return {"it reads no field", "Its magnetometer may be broken or shielded; skip it"};
    return {fit.problem, fit.remedy};
}

/// By the same numbers and bounds as the document shows. Returns what they make of the board.
Grade addDoubts(CalibrationResult& result, const BoardCounts& board, const TurnedMagnetometer& found) {
    using Limits = FieldTurnLimits;
    Grade grade = Grade::kGood;
    const auto doubt = [&](bool doubted, const std::string& what, const std::string& remedy) {
        if (!doubted)
            return;
        grade = Grade::kUsable;
        result.document.findings.push_back({Grade::kUsable, found.board, board.words + ": " + what, remedy});
    };
    doubt(found.fit.after_percent > Limits::kMostUneven_percent,
          "the field's strength differs by " + formatted("%.2f %%", found.fit.after_percent) +
              " between directions",
          "Turn it again through all directions, away from iron");
    doubt(found.seen.share() < Limits::kEnoughShare,
          std::to_string(found.seen.seen()) + " of 100 directions were seen",
          "Turn it again until 90 were seen");
    doubt(found.in_microtesla && found.sigma_zero_ut > Limits::kGoodZero_ut,
          "the standard deviation of its zero is " + formatted("%.2f", found.sigma_zero_ut) + " µT",
          "Turn it again, slowly and through all directions");
    doubt(found.in_microtesla && !isOfTheEarth(found.fit.strength_ut),
          "the field has " + formatted("%.1f", found.fit.strength_ut) +
              " µT there, which the Earth's has nowhere",
          "Turn it again away from magnets and steel");
    return grade;
}

bool wasTurned(const BoardCounts& board) {
    return board.has_magnetometer &&
           std::ranges::any_of(board.samples.mag, [](const Vector3d& counts) { return counts.allFinite(); });
}

}  // namespace

Result<CalibrationResult> calibrateMagnetometers(const CalibrateRequest& request,
                                                 std::optional<double> strength_ut, const JobContext& job) {
    const auto evidence = sensorEvidence(request, job);
    if (!evidence)
        return evidence.error();
    CalibrationResult result = emptyResult("Magnetometers", request, *evidence);
    MagnetometerReport report;
    std::map<std::string, nlohmann::json> fields;
    for (size_t b = 0; b < evidence->boards.size(); ++b) {
        const BoardCounts& board = evidence->boards[b];
        if (!wasTurned(board))
            continue;
        if (job.cancelled())
            return JobContext::cancelledError();
        BoardCalibration& values = result.calibration.boards[b];
        TurnedBoard turned = turnedBoard(board, values, strength_ut);
        if (const auto [problem, remedy] = whyNotUsed(turned); !problem.empty()) {
            addProblem(result, board, problem, remedy);
        } else {
            turned.found.used = true;
            values.mag = turned.axes;
            values.serial = board.serial;
            markMade(values, "magnetometers", request, addDoubts(result, board, turned.found));
            addField(result, board, turned.axes, values, fields[board.id]);
        }
        report.boards.push_back(std::move(turned.found));
        job.progress(double(b + 1) / double(evidence->boards.size()), "Magnetometer of " + board.id);
    }
    if (report.boards.empty())
        return Error{ErrorKind::kUnusable,
                     request.take_paths.front() + ": no board has readings of a magnetometer",
                     "Record with magnetometers switched on"};
    report.findings = std::move(result.document.findings);
    result.document = documentOf(report);
    result.document.created_utc = request.created_utc;
    result.document.takes = request.take_paths;
    result.json.update(toJson(report));
    for (nlohmann::json& board : result.json["boards"])
        if (const auto field = fields.find(board["id"].get<std::string>()); field != fields.end())
            board.update(field->second);
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
            addProblem(result, board, problem, fit.remedy.empty() ? "Record it again" : fit.remedy);
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
