// SPDX-License-Identifier: Apache-2.0
// Names of exported files, made from a pattern such as "{take}_{fps}".
#pragma once

#include <set>
#include <string>

#include "core/job/result.h"

namespace noctule {

struct ExportNameFields {
    std::string take, performer, run;
    std::string date;  ///< "2026-11-21"
    double frames_per_second = 120;
};

/// The name without folder and extension. Places are {take}, {performer}, {run}, {date} and {fps}; another
/// one is kUsage. What file systems refuse becomes a hyphen.
Result<std::string> exportFileName(const std::string& pattern, const ExportNameFields& fields);

/// folder/name.extension, or with _2, _3, ... when that is there already or in `taken`, which gets it.
std::string freeFilePath(const std::string& folder, const std::string& name, const std::string& extension,
                         std::set<std::string>& taken);

}  // namespace noctule
