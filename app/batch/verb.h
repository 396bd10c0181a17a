// SPDX-License-Identifier: Apache-2.0
// One verb of `noctule --batch`: what it accepts, how it is explained and what it does. A new verb is one
// file and one line in verbs.cpp.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/arguments.h"
#include "app/batch/console.h"
#include "core/job/job.h"

namespace noctule::batch {

/// What a verb's work yields; printed as JSON or as text.
struct Outcome {
    nlohmann::json json;
    std::string text;
    std::optional<Error> failure;  ///< of several takes the first that failed; reported already
};

struct VerbContext {
    const Arguments& arguments;
    Console& console;
    const CancelFlag& cancel;

    JobContext job() const { return {&console, &cancel}; }
};

struct Verb {
    std::string name, summary;
    std::string operands;  ///< as in the usage line: "T.noctule..."
    size_t min_operands = 0, max_operands = 0;
    std::string example;
    std::vector<Option> options;  ///< without the common ones
    std::vector<std::string> remarks;
    std::string alone;  ///< an option with which the verb needs neither operands nor required options
    Result<Outcome> (*run)(const VerbContext&) = nullptr;  ///< null: left out of this build
};

inline constexpr size_t kAnyNumber = 1'000'000;

// app/batch/<name>.cpp each; devices, record and drive: app/batch/devices/
Verb simulateVerb();
Verb processVerb();
Verb estimatorsVerb();
Verb evaluateVerb();
Verb exportVerb();
Verb inspectVerb();
Verb attachVerb();
Verb devicesVerb();
Verb recordVerb();
Verb recoverVerb();
Verb importVerb();
Verb orientVerb();
Verb robotVerb();
Verb driveVerb();
// app/batch/calibrate.cpp
Verb calibrateSourcesVerb();
Verb calibrateAccelerometersVerb();
Verb calibrateGyroscopesVerb();
Verb calibrateMagnetometersVerb();
Verb calibrateInertialVerb();
Verb calibrateRestPoseVerb();
Verb calibrateMotionVerb();
Verb calibrateRoomVerb();
Verb checkVerb();

/// {"exit_code", "message", "remedy"}
nlohmann::json errorJson(const Error& error);

// Summaries of verbs that a build may leave out: its help names them all the same.
inline constexpr const char* kDevicesSummary = "list the driver boxes that can be reached";
inline constexpr const char* kRecordSummary = "record a take from a driver box, or from one per suit";
inline constexpr const char* kDriveSummary =
    "drive a robot's arms and trunk live, with a suit or with a take in real time";

/// What brings back verbs that were left out.
inline constexpr std::string_view kLeftOutRemedy =
    "Build all of it: cmake --preset release && cmake --build --preset release";

/// All verbs, those left out too, in the order in which they are used.
const std::vector<Verb>& verbs();

}  // namespace noctule::batch
