// SPDX-License-Identifier: Apache-2.0
// Help as text, made from the tables of verbs and options.
#pragma once

#include <string>

#include "app/batch/verb.h"

namespace noctule::batch {

std::string programHelp();
std::string verbHelp(const Verb& verb);
/// One entry an option.
std::string optionList(const std::vector<Option>& options);

}  // namespace noctule::batch
