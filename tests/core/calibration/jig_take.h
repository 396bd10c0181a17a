// SPDX-License-Identifier: Apache-2.0
// A simulated take on the jig and what a digitizer measured there.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <sstream>

#include "core/calibration/source_offsets/source_offsets.h"
#include "core/simulation/random.h"
#include "tests/support/observed_take.h"

namespace noctule::test {

constexpr double kJigSound_m_per_s = 343;  // only to show offsets as lengths
constexpr double kMeasuring_m = 5e-5;      // the digitizer's sigma per axis, as in the scenarios

struct JigTake {
    std::shared_ptr<const simulation::Stage> stage;  ///< the truth
    Observations observations;
    std::string csv;

    KnownDistances known() const { return readDigitizerCsv(csv, "jig.csv").value(); }
    SourceOffsetReport solve(const SourceOffsetSettings& settings = {}) const {
        return calibrateSourceOffsets({observations}, known(), settings);
    }
    SourceOffsetReport solveWith(const std::string& other_csv) const {
        return calibrateSourceOffsets({observations}, readDigitizerCsv(other_csv, "jig.csv").value());
    }
    /// Of a source's offset, as a length.
    double error_m(const SourceOffsetReport& report, size_t source) const {
        return kJigSound_m_per_s *
               (report.sources[source].offset_s - stage->truth.inflection_offset_s[source]);
    }
    double worstError_m(const SourceOffsetReport& report) const {
        double worst_m = 0;
        for (size_t s = 0; s < report.sources.size(); ++s)
            worst_m = std::max(worst_m, report.sources[s].calibrated ? std::abs(error_m(report, s)) : 1);
        return worst_m;
    }
};

inline JigTake jigTake(const simulation::StageRequest& request,
                       simulation::Level level = simulation::Level::kReadings) {
    auto observed = observe(request, level);
    EXPECT_TRUE(observed) << observed.error().text();
    std::string csv =
        simulation::digitizerCsv(*observed->stage.rig, request.suit, kMeasuring_m, request.seed);
    // What the simulation writes into its takes knows the microphones' delays already.
    observed->observations.calibration = nominalCalibration(request.suit);
    return {std::make_shared<const simulation::Stage>(std::move(observed->stage)),
            std::move(observed->observations), std::move(csv)};
}

/// The nominal one; made once per program and seed.
inline const JigTake& nominalJig(uint64_t seed = 1) {
    static std::map<uint64_t, JigTake> made;
    if (!made.contains(seed))
        made.emplace(seed, jigTake(stageOf(simulation::RigKind::kJig, seed)));
    return made.at(seed);
}

using CsvCells = std::vector<std::string>;

/// Every row of a table in turn, the header left out.
inline std::string withRows(const std::string& csv, const std::function<void(CsvCells&)>& change) {
    std::istringstream lines(csv);
    std::string line, changed;
    for (bool header = true; std::getline(lines, line); header = false) {
        CsvCells cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');)
            cells.push_back(cell);
        if (!header)
            change(cells);
        for (size_t i = 0; i < cells.size(); ++i)
            changed += (i ? "," : "") + cells[i];
        changed += cells.empty() ? "" : "\n";
    }
    return changed;
}

/// Two labels of a digitizer's table, exchanged in one placement or, `placement` empty, in all.
inline std::string withSwapped(const std::string& csv, const std::string& kind, const std::string& a,
                               const std::string& b, const std::string& placement = "") {
    return withRows(csv, [&](CsvCells& cells) {
        if (cells[1] == kind && (placement.empty() || cells[0] == placement) &&
            (cells[2] == a || cells[2] == b))
            cells[2] = cells[2] == a ? b : a;
    });
}

inline std::string findingsText(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings)
        text += std::string("  [") + gradeWord(finding.grade) + "] " + finding.part + " | " + finding.what +
                " | " + finding.remedy + "\n";
    return text;
}

/// One whose sentence holds all of these words.
inline const Finding* findingWith(const std::vector<Finding>& findings,
                                  const std::vector<std::string>& words) {
    for (const Finding& finding : findings)
        if (std::ranges::all_of(
                words, [&](const std::string& word) { return finding.what.find(word) != std::string::npos; }))
            return &finding;
    return nullptr;
}

}  // namespace noctule::test
