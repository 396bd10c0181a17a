// SPDX-License-Identifier: Apache-2.0
// What a calibration found, for people: one page of HTML that needs nothing else, and the same as plain text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibration/findings.h"

namespace noctule {

struct CalibrationTable {
    std::string title, lead;  ///< the lead says how to read it, a whole sentence
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;  ///< the first cell names the row, the others are numbers
};

/// One of the few numbers that a result is judged by.
struct CalibrationNumber {
    std::string value;  ///< "2.1 mm"
    std::string what;   ///< "error of a distance left out, mean"
    std::string good;   ///< "under 2.35 mm"; empty: there is no such limit
    Grade grade = Grade::kGood;
};

/// The errors behind a result, a row per part: magnitudes in `unit`, with this calibration and with the one
/// before.
struct CalibrationErrors {
    struct Row {
        std::string name;
        std::vector<double> before, after;
    };
    std::string title, unit;
    double good = 0;  ///< up to here
    std::vector<Row> rows;
};

struct CalibrationDocument {
    std::string procedure;    ///< "Gyroscopes"
    std::string summary;      ///< a sentence without its full stop: what was found
    std::string created_utc;  ///< ISO 8601, Z
    std::vector<std::string> takes;
    std::vector<Finding> findings;
    std::vector<CalibrationTable> tables;
    std::vector<CalibrationNumber> numbers = {};
    std::optional<CalibrationErrors> errors = {};
};

/// "What. Remedy."
std::string sentenceOf(const Finding& finding);

std::string calibrationHtml(const CalibrationDocument& document);
std::string calibrationText(const CalibrationDocument& document);

}  // namespace noctule
