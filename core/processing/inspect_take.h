// SPDX-License-Identifier: Apache-2.0
// What is in a take, what is missing, and how good it is per board and pair. Works on damaged and half takes:
// what cannot be read becomes a problem by name instead of an error.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/job/job.h"
#include "core/processing/recorded_drive.h"
#include "core/recording/take.h"
#include "core/report/report_data.h"
#include "core/suit/calibration_lack.h"

namespace noctule {

/// One board's wire, from the sound blocks.
struct WireQuality {
    std::string board;
    int64_t samples = 0, clipped = 0;
    bool silent = true;  ///< nothing but zeros
};

struct PairSummary {
    std::string source, board;
    double heard_share = 0, used_share = 0;  ///< of all pulses, 0..1
    double confidence = 0;                   ///< mean over all pulses; not heard counts as 0
};

/// What is there of one suit.
struct SuitInspection {
    double duration_s = 0;
    std::string suit_name;
    std::vector<std::string> boards, sources;
    std::string calibration, actor;  ///< in force: "2 of 2026-11-18T10:00:00Z"; empty: none
    CalibrationLack lack;            ///< of the calibration in force
    int64_t blocks = 0, block_samples = 0, hole_samples = 0, pulses = 0;
    int64_t reference_frames = 0, external_root_rows = 0;
    std::vector<GapRow> gaps;
    std::vector<MarkerRow> markers;
    std::vector<StatusRow> status;
    std::vector<WireQuality> wires;          ///< of takes with sound
    std::vector<ReportBoard> board_quality;  ///< of the last decoded readings, or the primary ones
    std::vector<PairSummary> pairs;          ///< of the last ranges, or the primary ones
};

/// One suit of several.
struct SuitSummary : SuitInspection {
    int suit = 0;         ///< counts from 1
    std::string subject;  ///< empty: nobody's
    bool room = false;
    double carrier_hz = 0;
};

/// Of several suits its own part is that of the first performer.
struct TakeInspection : SuitInspection {
    std::string path;
    TakeHeader header;
    std::string state, performer;
    TakeLevel level = TakeLevel::kSignal;
    std::string reference_kind;
    std::vector<SuitSummary> suits;  ///< of a take with several: every one
    std::vector<NoteRow> notes;
    std::vector<DerivedRun> runs;
    std::vector<DriveSummary> drives;   ///< of robots
    std::vector<std::string> missing;   ///< what a complete take would have
    std::vector<std::string> problems;  ///< whole sentences
};

/// Fails only when the file is no take, or when cancelled.
Result<TakeInspection> inspectTake(const std::string& path, const JobContext& job);

nlohmann::json toJson(const TakeInspection& inspection);

}  // namespace noctule
