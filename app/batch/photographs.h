// SPDX-License-Identifier: Apache-2.0
// Photographs of the jig on the command line: the options of `calibrate sources` that belong to them, and the
// sheet of markers.
#pragma once

#include "app/batch/verb.h"
#include "core/vision/jig_photographs.h"

namespace noctule::batch {

/// --photos, --marker-mm, --print-markers, --suit
std::vector<Option> photographOptions();
/// How to do it, for the help.
std::vector<std::string> photographRemarks();
/// kUsage when options are given that go with others.
Status checkPhotographOptions(const Arguments& arguments);

Result<PhotographedDistances> measurePhotographs(const Arguments& arguments, const JobContext& job);
nlohmann::json photographsJson(const PhotographedDistances& found);

/// `--print-markers SHEET.svg`: the sheet, pages behind the first as SHEET_2.svg ...
Result<Outcome> printMarkers(const VerbContext& context);

}  // namespace noctule::batch
