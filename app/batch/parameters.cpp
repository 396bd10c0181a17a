// SPDX-License-Identifier: Apache-2.0
#include "app/batch/parameters.h"

#include <charconv>

#include "app/batch/files.h"
#include "core/math/json.h"

namespace noctule::batch {

std::vector<std::string> estimatorNames() {
    std::vector<std::string> names;
    for (const EstimatorEntry& entry : estimators())
        names.push_back(entry.name);
    return names;
}

Status addParameter(const std::string& setting, ParameterValues& values) {
    const size_t equals = setting.find('=');
    const std::string text = equals == std::string::npos ? "" : setting.substr(equals + 1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (equals == 0 || text.empty() || error != std::errc() || end != text.data() + text.size())
        return Error{ErrorKind::kUsage, "--param cannot be '" + setting + "'",
                     "Write NAME=VALUE with a number, such as range.gate=4; switches are 0 or 1"};
    const std::string name = setting.substr(0, equals);
    if (!values.emplace(name, value).second)
        values[name] = value;
    return Done{};
}

Status addParameterFile(const std::string& path, const EstimatorEntry& estimator, ParameterValues& values) {
    const auto json = readJson(path);
    if (!json)
        return json.error();
    const bool settings = json->is_object() && json->contains("parameters");
    if (const auto other = json::text(*json, "estimator"); settings && other && *other != estimator.name)
        return Error{ErrorKind::kUsage, path + ": its parameters are those of estimator " + *other,
                     "Add --estimator " + *other + ", or give parameters of " + estimator.name};
    const nlohmann::json& members = settings ? (*json)["parameters"] : *json;
    if (!members.is_object())
        return Error{ErrorKind::kUnreadable, path + ": holds no object of parameters",
                     "Write {\"NAME\": VALUE, ...}; `noctule --batch estimators` lists the names"};
    for (const auto& [name, value] : members.items()) {
        if (!value.is_number() && !value.is_boolean())
            return Error{ErrorKind::kUnreadable, path + ": parameter '" + name + "' is not a number",
                         "Give it a number, or true or false"};
        values[name] = value.is_boolean() ? (value.get<bool>() ? 1 : 0) : value.get<double>();
    }
    return Done{};
}

}  // namespace noctule::batch
