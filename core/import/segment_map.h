// SPDX-License-Identifier: Apache-2.0
// A map made by hand: which sensor of a recording sits on which segment. The same file as the map of a table
// (column_map.cpp), without its columns: {"format": "noctule-import-map", "version": 1, "sensors": [{"id":
// "42268", "segment": "Chest"}]}.
#pragma once

#include <nlohmann/json.hpp>

#include "core/import/recording.h"
#include "core/job/job.h"

namespace noctule {

/// Whether the map says which columns of a table are what: it is then read with the kind `csv`.
bool describesColumns(const nlohmann::json& map);

/// Puts sensors where the map says, whatever their names mean; a segment of null or "" leaves one without.
/// Sensors that the map does not name keep their segment, unless the map puts another one there. kUsage: a
/// sensor that the recording lacks, a segment that a body lacks, or two sensors on one segment.
Status applySegmentMap(const nlohmann::json& map, ImportedRecording& recording);

/// The recording's sensors as a map to be filled in: segments as they are known, else null, and beside them
/// the names that may be written.
nlohmann::json segmentMapTemplate(const ImportedRecording& recording);

/// The ids of sensors that have no segment.
std::vector<std::string> sensorsWithoutSegment(const ImportedRecording& recording);

}  // namespace noctule
