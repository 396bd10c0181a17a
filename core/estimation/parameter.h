// SPDX-License-Identifier: Apache-2.0
// An estimator's tuned numbers as a table: name, unit, range, meaning, source and where the value stands in
// the settings struct. The table writes the help, checks what a user sets, and stores complete settings with
// every run. Defaults are those of the struct, so that they cannot drift.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/job/result.h"

namespace noctule {

/// What a user set, by name. A switch is 0 or 1.
using ParameterValues = std::map<std::string, double>;

/// One row as users see it.
struct ParameterDescription {
    std::string name, unit;  ///< unit "-": a pure number; "switch": 0 or 1; "count": a whole number
    double least = 0, most = 0;
    std::string meaning, source;
    double usual = 0;  ///< the default
};

/// Where a value stands.
using ParameterPlace = std::variant<double*, int*, bool*>;

template <class Settings>
struct Parameter {
    std::string name, unit;
    double least = 0, most = 0;
    std::function<ParameterPlace(Settings&)> place;
    std::string meaning, source;
};
template <class Settings>
using ParameterTable = std::vector<Parameter<Settings>>;

/// The place of a member, or of a member of a member.
template <class Settings, class Value>
std::function<ParameterPlace(Settings&)> at(Value Settings::*member) {
    return [member](Settings& settings) { return ParameterPlace(&(settings.*member)); };
}
template <class Settings, class Part, class... Rest>
std::function<ParameterPlace(Settings&)> at(Part Settings::*part, Rest... rest) {
    return [part, inner = at(rest...)](Settings& settings) { return inner(settings.*part); };
}

inline double valueAt(const ParameterPlace& place) {
    return std::visit([](const auto* value) { return static_cast<double>(*value); }, place);
}

inline void setAt(const ParameterPlace& place, double value) {
    std::visit([value](auto* into) { *into = static_cast<std::remove_reference_t<decltype(*into)>>(value); },
               place);
}

template <class Settings>
std::vector<ParameterDescription> describe(const ParameterTable<Settings>& table) {
    Settings usual;
    std::vector<ParameterDescription> rows;
    for (const Parameter<Settings>& row : table)
        rows.push_back(
            {row.name, row.unit, row.least, row.most, row.meaning, row.source, valueAt(row.place(usual))});
    return rows;
}

/// Values that checkParameters() has passed.
template <class Settings>
Settings settingsFrom(const ParameterTable<Settings>& table, const ParameterValues& values) {
    Settings settings;
    for (const Parameter<Settings>& row : table)
        if (const auto found = values.find(row.name); found != values.end())
            setAt(row.place(settings), found->second);
    return settings;
}

/// kUsage names a parameter that is unknown (and the nearest one), out of its range or not whole.
Status checkParameters(const std::vector<ParameterDescription>& known, const ParameterValues& values,
                       const std::string& estimator);

/// Every parameter: as set, else its default.
ParameterValues completeParameters(const std::vector<ParameterDescription>& known,
                                   const ParameterValues& values);

}  // namespace noctule
