// SPDX-License-Identifier: Apache-2.0
// Help as text, made from the tables of verbs and options.
#pragma once

#include <string>

#include "app/batch/verb.h"

namespace noctule::batch {

struct ExitCode {
    int code;
    std::string meaning;
};

/// Of `noctule --batch`.
const std::vector<ExitCode>& exitCodes();
/// Of the programs that stand in for hardware: the virtual suit and the virtual robot.
const std::vector<ExitCode>& standInExitCodes();
/// "exit codes: 0 done, 1 ...", in lines.
std::string exitCodeLine(const std::vector<ExitCode>& codes);

std::string programHelp();
std::string verbHelp(const Verb& verb);
/// Of the verbs whose first word is `group`: "calibrate".
std::string groupHelp(const std::string& group);
/// One entry an option.
std::string optionList(const std::vector<Option>& options);

}  // namespace noctule::batch
