// SPDX-License-Identifier: Apache-2.0
// What was measured on the jig: how far each source stood from each board's microphone, in metres, placement
// by placement (Vlasic 2007, section 4.3: a contact digitizer; a tape measure does too). Pure functions of
// text; columns in any order, others are ignored; the table's looks are those of MeasuredTable. Whether the
// names are those of a suit and of a take's markers is checked by the solver. Errors are kUnreadable and name
// file, line, column and remedy.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/findings.h"
#include "core/job/result.h"

namespace noctule {

struct KnownDistance {
    std::string placement;  ///< label of the take's marker
    std::string source, board;
    double distance_m = 0;
    double sigma_m = 0;
};

struct KnownDistances {
    std::string where;  ///< file name, for messages
    std::vector<KnownDistance> distances;
    std::vector<Finding> findings = {};  ///< of the measuring itself; the solver passes them on
};

/// Of one point touched with a digitizer arm, per axis; and of a distance read from a tape.
constexpr double kDigitizerSigma_m = 1e-4, kTapeSigma_m = 1e-3;

/// Header placement,kind,id and x_m,y_m,z_m (or x_mm,y_mm,z_mm); kind is `source` or `board`, the point of a
/// board is its microphone's opening. Every source and board of a placement becomes a pair.
Result<KnownDistances> readDigitizerCsv(const std::string& text, const std::string& where);

/// Header placement,source,board and distance_m (or distance_mm).
Result<KnownDistances> readTapeMeasureCsv(const std::string& text, const std::string& where);

}  // namespace noctule
