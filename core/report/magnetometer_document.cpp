// SPDX-License-Identifier: Apache-2.0
#include "core/report/magnetometer_document.h"

#include <algorithm>
#include <limits>

#include "core/body/text.h"
#include "core/sensor_calibration/field_turn.h"

namespace noctule {
namespace {

using Limits = FieldTurnLimits;

/// Of the boards that were used.
struct WorstOfField {
    double uneven_percent = 0, sigma_ut = 0;
    int seen = FieldSphere::kCells, used = 0;
    double least_ut = std::numeric_limits<double>::infinity(), most_ut = 0, sum_ut = 0;
    bool in_microtesla = true;
};

WorstOfField worstOfField(const MagnetometerReport& report) {
    WorstOfField worst;
    for (const TurnedMagnetometer& board : report.boards) {
        if (!board.used)
            continue;
        ++worst.used;
        worst.uneven_percent = std::max(worst.uneven_percent, board.fit.after_percent);
        worst.sigma_ut = std::max(worst.sigma_ut, board.sigma_zero_ut);
        worst.seen = std::min(worst.seen, board.seen.seen());
        worst.least_ut = std::min(worst.least_ut, board.fit.strength_ut);
        worst.most_ut = std::max(worst.most_ut, board.fit.strength_ut);
        worst.sum_ut += board.fit.strength_ut;
        worst.in_microtesla = worst.in_microtesla && board.in_microtesla;
    }
    return worst;
}

std::vector<CalibrationNumber> numbersOf(const WorstOfField& worst) {
    if (worst.used == 0)
        return {};
    const auto grade = [](bool good) { return good ? Grade::kGood : Grade::kUsable; };
    constexpr double kMost = Limits::kMostUneven_percent;
    static_assert(FieldSphere::kCells == 100, "a cell is one per cent");
    constexpr int kEnough = static_cast<int>(Limits::kEnoughShare * FieldSphere::kCells);
    std::vector<CalibrationNumber> numbers = {
        {text::number(worst.uneven_percent, 2) + " %",
         "standard deviation of the field's strength over the directions, worst sensor",
         "under " + text::number(kMost, 0) + " %", grade(worst.uneven_percent <= kMost)},
        {std::to_string(worst.seen) + " %", "of all directions, the sensor that has seen least",
         "at least " + std::to_string(kEnough) + " %", grade(worst.seen >= kEnough)}};
    if (!worst.in_microtesla)
        return numbers;
    numbers.push_back({text::number(worst.sigma_ut, 2) + " µT", "zero known to, worst sensor",
                       "under " + text::number(Limits::kGoodZero_ut, 1) + " µT",
                       grade(worst.sigma_ut <= Limits::kGoodZero_ut)});
    numbers.push_back(
        {text::number(worst.sum_ut / worst.used, 1) + " µT", "strength of the field, mean",
         "between " + text::number(Limits::kLeastEarth_ut, 0) + " and " +
             text::number(Limits::kMostEarth_ut, 0) + " µT",
         grade(worst.least_ut >= Limits::kLeastEarth_ut && worst.most_ut <= Limits::kMostEarth_ut)});
    return numbers;
}

}  // namespace

CalibrationDocument documentOf(const MagnetometerReport& report) {
    CalibrationTable table{
        "Sensors",
        "Change: standard deviation of the field's strength over the directions, in percent of its mean.",
        {"board", "field's strength, µT", "change before, %", "change now, %", "zero, sigma, µT",
         "directions of 100"},
        {}};
    // One direction may be twice as far off as all of them in the mean square.
    CalibrationErrors errors{"Difference of the field's strength from its mean, a dot per direction",
                             "%",
                             2 * Limits::kMostUneven_percent,
                             {}};
    for (const TurnedMagnetometer& board : report.boards) {
        const bool fitted = board.fit.strength_ut > 0;
        table.rows.push_back({board.board, fitted ? text::number(board.fit.strength_ut, 1) : "–",
                              fitted ? text::number(board.spread_before_percent, 2) : "–",
                              fitted ? text::number(board.fit.after_percent, 2) : "–",
                              fitted ? text::number(board.sigma_zero_ut, 2) : "–",
                              board.seen.seen() > 0 ? std::to_string(board.seen.seen()) : "–"});
        if (board.used)
            errors.rows.push_back({board.board, board.before_percent, board.after_percent});
    }
    const WorstOfField worst = worstOfField(report);
    CalibrationDocument found;
    found.procedure = "Magnetometers";
    found.summary = worst.used > 0
                        ? std::to_string(worst.used) + " of " + std::to_string(report.boards.size()) +
                              " magnetometers calibrated; the field's strength is even to " +
                              text::number(worst.uneven_percent, 2) + " %"
                        : "None of the magnetometers could be calibrated";
    found.findings = report.findings;
    found.tables = {std::move(table)};
    found.numbers = numbersOf(worst);
    found.errors = std::move(errors);
    return found;
}

nlohmann::json toJson(const MagnetometerReport& report) {
    nlohmann::json boards = nlohmann::json::array();
    std::optional<FieldSphere> least;
    for (const TurnedMagnetometer& board : report.boards) {
        const MagnetometerFit& fit = board.fit;
        boards.push_back({{"id", board.board},
                          {"strength_ut", fit.strength_ut},
                          {"spread_before_percent", board.spread_before_percent},
                          {"spread_after_percent", fit.after_percent},
                          {"residual_ut", fit.ellipsoid.residual},
                          {"sigma_zero_ut", board.sigma_zero_ut},
                          {"condition", fit.ellipsoid.condition},
                          {"directions_covered", fit.coverage.covered},
                          {"directions_missing", fit.coverage.missing},
                          {"directions_seen", board.seen.seen()},
                          {"usable", board.used}});
        if (!board.used)
            continue;
        if (least)
            least->keepLesser(board.seen);
        else
            least = board.seen;
    }
    nlohmann::json json = {{"boards", std::move(boards)}};
    if (least)
        for (int cell = 0; cell < FieldSphere::kCells; ++cell)
            json["sphere"].push_back(least->count(cell));
    return json;
}

}  // namespace noctule
