// SPDX-License-Identifier: Apache-2.0
// Completion for shells, from the tables of verbs and options: verbs, options, choices, else files.
#pragma once

#include <string>

namespace noctule::help_files {

/// For bash; it needs nothing of the package bash-completion.
std::string bashCompletion();
/// For zsh: the file _noctule.
std::string zshCompletion();

}  // namespace noctule::help_files
