// SPDX-License-Identifier: Apache-2.0
// The kinds of recordings, one file each.
#pragma once

#include "core/import/import_format.h"

namespace noctule {

const ImportFormat& matFormat();        ///< mat_recording.cpp
const ImportFormat& mvnxFormat();       ///< mvnx.cpp
const ImportFormat& xsensTextFormat();  ///< xsens_text.cpp
const ImportFormat& ximu3Format();      ///< ximu3.cpp
const ImportFormat& stoFormat();        ///< sto.cpp
const ImportFormat& csvFormat();        ///< column_map.cpp

}  // namespace noctule
