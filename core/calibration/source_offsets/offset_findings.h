// SPDX-License-Identifier: Apache-2.0
// What calibrateSourceOffsets says about its own result.
#pragma once

#include "core/calibration/source_offsets/jig_labels.h"
#include "core/calibration/source_offsets/offset_fit.h"

namespace noctule {

struct OffsetJudgement {
    const JigData& jig;
    const SourceOffsetSettings& settings;
    const OffsetFit& fit;
};

Finding findingOf(const UnitMistake& mistake, const std::string& where);
Finding findingOf(const SwappedLabels& swap, const Suit& suit);

/// Adds to report.findings; all values of the report stand already.
void judgeOffsets(const OffsetJudgement& judgement, SourceOffsetReport& report);

}  // namespace noctule
