// SPDX-License-Identifier: Apache-2.0
// What SQLite's result codes mean to somebody with a take.
#pragma once

#include <string>

#include "core/job/result.h"

struct sqlite3;

namespace noctule {

/// The last failure of a connection; `name` is the file's name in the message.
Error sqliteError(sqlite3* handle, const std::string& name);

}  // namespace noctule
