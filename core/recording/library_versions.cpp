// SPDX-License-Identifier: Apache-2.0
#include "core/recording/library_versions.h"

#include <sqlite3.h>
#include <zstd.h>

namespace noctule {

std::string sqliteVersion() {
    return sqlite3_libversion();
}

std::string zstdVersion() {
    return ZSTD_versionString();
}

}  // namespace noctule
