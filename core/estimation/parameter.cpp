// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/job/nearest_word.h"

namespace noctule {
namespace {

std::string shortest(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    return {text, end.ptr};
}

Error unknownParameter(const std::vector<ParameterDescription>& known, const std::string& name,
                       const std::string& estimator) {
    std::vector<std::string> names;
    for (const ParameterDescription& row : known)
        names.push_back(row.name);
    const std::string near = nearestWord(name, names);
    return {ErrorKind::kUsage, "estimator " + estimator + " has no parameter '" + name + "'",
            (near.empty() ? "" : "Did you mean " + near + "? ") + "`noctule --batch estimators " + estimator +
                "` lists all"};
}

}  // namespace

Status checkParameters(const std::vector<ParameterDescription>& known, const ParameterValues& values,
                       const std::string& estimator) {
    for (const auto& [name, value] : values) {
        const auto row = std::ranges::find(known, name, &ParameterDescription::name);
        if (row == known.end())
            return unknownParameter(known, name, estimator);
        const bool whole = row->unit == "count" || row->unit == "switch";
        if (std::isfinite(value) && value >= row->least && value <= row->most &&
            (!whole || value == std::floor(value)))
            continue;
        return Error{ErrorKind::kUsage, "parameter " + name + " cannot be " + shortest(value),
                     std::string("Give a ") + (whole ? "whole number" : "number") + " from " +
                         shortest(row->least) + " to " + shortest(row->most) + " (" + row->unit +
                         "); the default is " + shortest(row->usual)};
    }
    return Done{};
}

ParameterValues completeParameters(const std::vector<ParameterDescription>& known,
                                   const ParameterValues& values) {
    ParameterValues all;
    for (const ParameterDescription& row : known) {
        const auto found = values.find(row.name);
        all[row.name] = found == values.end() ? row.usual : found->second;
    }
    return all;
}

}  // namespace noctule
