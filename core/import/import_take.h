// SPDX-License-Identifier: Apache-2.0
// Writes a recording of other sensors as a take of readings (core/recording/README.md, "Level"): one board
// for each sensor, counts in SI with zero 0 and the identity, a clock of one sample per microsecond.
#pragma once

#include "core/import/recording.h"
#include "core/job/job.h"

namespace noctule {

struct ImportRequest {
    std::string out_path, take_name, created_utc, software, uuid;
    bool overwrite = false;
    std::string performer{};  ///< who wore the sensors; empty: not known
};

struct ImportSummary {
    size_t sensors = 0, readings = 0, missing = 0;
    double duration_s = 0, rate_hz = 0;
    bool has_magnetometer = false, has_reference = false, has_attitudes = false;
};

/// The run of kind `orientation` that holds the maker's own attitudes.
inline constexpr const char* kMakersRun = "orientation of the recording";

/// Nothing is left behind when it fails or is cancelled.
Result<ImportSummary> writeImportedTake(const ImportedRecording& recording, const ImportRequest& request,
                                        const JobContext& job);

/// The skeleton of a reference that is one rigid sensor.
inline constexpr const char* kSensorJoint = "sensor";
/// Markers of this kind, `begin` and `end`, bound the phases that count when orientation is scored.
inline constexpr const char* kMovementMarker = "movement";

}  // namespace noctule
