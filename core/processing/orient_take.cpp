// SPDX-License-Identifier: Apache-2.0
#include "core/processing/orient_take.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/body/text.h"
#include "core/processing/board_readings.h"
#include "core/recording/take_edit.h"

namespace noctule {

namespace {

constexpr const char* kOrientationKind = "orientation";

Error orientationError(const Take& take, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnusable, take.path() + ": " + what, remedy};
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

/// What of a board's clock a user should know.
void warnOfClock(const std::string& id, const BoardReadings& readings, std::vector<std::string>& warnings) {
    double paused_s = 0, begin_s = 0;
    size_t pauses = 0;
    for (size_t i = 1; i < readings.samples.size(); ++i)
        if (const double pause_s = readings.samples.pause_s(i); pause_s > 0) {
            if (++pauses == 1)
                begin_s = double(readings.time_ns[i - 1]) * 1e-9;
            paused_s += pause_s;
        }
    if (pauses > 0)
        warnings.push_back("Board " + id + " paused for " + text::number(paused_s, 2) +
                           " s in all, first at " + text::number(begin_s, 2) +
                           " s. How it turned meanwhile is a guess from the readings around");
    if (readings.left_out > 0)
        warnings.push_back("Board " + id + ": the clock stands still or jumps back at " +
                           std::to_string(readings.left_out) + " readings, which were left out");
}

std::string settingsText(const OrientRequest& request) {
    nlohmann::json settings{{"estimator", request.estimator->name},
                            {"smooth", request.choice.smooth ? "full" : "none"},
                            {"level_reading", request.choice.level_reading}};
    if (request.calibration)
        settings["calibration_of"] = request.calibration->created_utc;
    if (request.choice.gain_per_s)
        settings["gain_per_s"] = *request.choice.gain_per_s;
    return settings.dump();
}

/// Its readings are decoded together with the distances.
Error boxTake(const Take& take) {
    return orientationError(
        take,
        "holds the sound of a driver box; the orientation of each sensor needs a take of inertial sensors",
        "Run `noctule --batch process " + take.path() +
            "`: it decodes the sound and gives the motion of the whole body");
}

/// `begun`: the run that would hold the result.
Error withoutReadings(const Take& take, int64_t begun) {
    const auto runs = take.derivedRuns();
    const bool has_attitudes = runs && std::ranges::any_of(*runs, [begun](const DerivedRun& run) {
                                   return run.kind == std::string(kOrientationKind) && run.run != begun;
                               });
    if (has_attitudes)
        return orientationError(take,
                                "holds attitudes that came with it; the orientation of each sensor needs "
                                "readings of gyroscope and accelerometer",
                                "Run `noctule --batch process " + take.path() +
                                    " --estimator orientation`: it gives the motion of the body from them");
    return orientationError(take,
                            "no board has readings of gyroscope and accelerometer, which the orientation of "
                            "each sensor needs",
                            "Run `noctule --batch inspect " + take.path() + "` to see what it holds");
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
        warnOfClock(suit.boards[b].id, *readings, summary.warnings);
        job.progress(double(b) / double(suit.boards.size()), "Orientation of " + suit.boards[b].id);
        auto result = request.estimator->run(readings->samples, request.choice, {nullptr, job.cancel});
        if (!result)
            return result.error();
        if (Status written = writeRows(edit, summary.run, int(b), *readings, *result); !written)
            return written;
        summary.boards.push_back(describe(suit.boards[b].id, *readings, *result));
    }
    return summary.boards.empty() ? Status(withoutReadings(take, summary.run)) : Status(Done{});
}

bool knowsAnyBoard(const Calibration& calibration, const Suit& suit) {
    return std::any_of(suit.boards.begin(), suit.boards.end(),
                       [&](const Board& board) { return calibration.findBoard(board.id) != nullptr; });
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
    if (take->level() == TakeLevel::kSignal)
        return boxTake(*take);
    const auto suit = take->suit();
    if (!suit)
        return suit.error();
    const auto rate = take->sampleRate_hz();
    if (!rate)
        return rate.error();
    if (request.calibration && !knowsAnyBoard(*request.calibration, *suit))
        return orientationError(
            *take, "the calibration knows none of its boards",
            "Choose one that was made of this suit; its boards begin with " + suit->boards.front().id);
    const Calibration calibration = request.calibration ? completedCalibration(*suit, *request.calibration)
                                                        : completedCalibration(*suit, *take);
    ReadingsOfBoards boards(*suit, calibration, double(*rate));
    if (Status read = boards.gather(*take, job); !read)
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
        return orientationError(*take, "no instant of the result has a reference",
                                "Look at the take with inspect");
    return Nothing{evaluation};
}

}  // namespace noctule
