// SPDX-License-Identifier: Apache-2.0
// Manual pages (roff, man(7)) from the tables of verbs and options.
#pragma once

#include <string>

namespace noctule::help_files {

/// noctule(1): the studio and every verb.
std::string noctuleManual();
/// noctule-virtual-suit(1).
std::string virtualSuitManual();
/// noctule-virtual-robot(1).
std::string virtualRobotManual();

}  // namespace noctule::help_files
