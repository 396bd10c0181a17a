// SPDX-License-Identifier: Apache-2.0
// What a verb accepts on the command line, as a table: it checks the arguments, words the errors and writes
// the help.
#pragma once

#include <string>
#include <vector>

namespace noctule::batch {

struct Option {
    enum class Kind {
        kFlag,    ///< no value
        kText,    ///< a path or a name
        kTexts,   ///< one or more, up to the next option; may be given again
        kChoice,  ///< one of `choices`, upper and lower case alike
        kNumber,  ///< min to max, finite
        kWhole,   ///< the same without a fraction
    };
    std::string name;  ///< without the dashes
    std::string placeholder, help;
    Kind kind = Kind::kFlag;
    std::vector<std::string> choices;
    double min = 0, max = 0;
    std::string fallback;  ///< value when not given; empty: none
    bool required = false;
    bool names_input = false;  ///< of texts: a file that is read, which no output may replace

    Option&& orElse(const std::string& value) &&;
    Option&& needed() &&;
};

Option flag(const std::string& name, const std::string& help);
Option text(const std::string& name, const std::string& placeholder, const std::string& help);
Option texts(const std::string& name, const std::string& placeholder, const std::string& help);
/// The same of files that are read.
Option inputFile(const std::string& name, const std::string& placeholder, const std::string& help);
Option inputFiles(const std::string& name, const std::string& placeholder, const std::string& help);
Option choice(const std::string& name, std::vector<std::string> choices, const std::string& help);
Option number(const std::string& name, const std::string& placeholder, double min, double max,
              const std::string& help);
Option whole(const std::string& name, const std::string& placeholder, double min, double max,
             const std::string& help);

/// Accepted by every verb.
const std::vector<Option>& commonOptions();

/// "a, b or c"
std::string listed(const std::vector<std::string>& words);

}  // namespace noctule::batch
