// SPDX-License-Identifier: Apache-2.0
// What a calibration found, for people: one page of HTML that needs nothing else, and the same as plain text.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/findings.h"

namespace noctule {

struct CalibrationTable {
    std::string title, lead;  ///< the lead says how to read it, a whole sentence
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;  ///< the first cell names the row, the others are numbers
};

struct CalibrationDocument {
    std::string procedure;    ///< "Gyroscopes"
    std::string summary;      ///< a sentence without its full stop: what was found
    std::string created_utc;  ///< ISO 8601, Z
    std::vector<std::string> takes;
    std::vector<Finding> findings;
    std::vector<CalibrationTable> tables;
};

/// "What. Remedy."
std::string sentenceOf(const Finding& finding);

std::string calibrationHtml(const CalibrationDocument& document);
std::string calibrationText(const CalibrationDocument& document);

}  // namespace noctule
