// SPDX-License-Identifier: Apache-2.0
// A database's first page says where every table begins. Its list of tables stands at the page's end, so it
// often outlives the beginning of the file.
#pragma once

#include <string>

#include "core/job/result.h"

namespace noctule {

/// The list of a take's tables stands there although SQLite cannot read it.
bool hasRemainsOfFirstPage(const std::string& path);
/// Writes a first page anew that has the tables whose entries remain; `path` must be a copy. kUnreadable when
/// there are none, or when SQLite can read the list as it is.
Status mendFirstPage(const std::string& path);

}  // namespace noctule
