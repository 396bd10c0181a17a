// SPDX-License-Identifier: Apache-2.0
#include "core/processing/run_command.h"

#include <cmath>
#include <filesystem>

#include "core/live/estimators.h"
#include "core/math/json.h"

namespace noctule {
namespace {

/// For a shell: in quotes where it needs them.
std::string word(const std::string& text) {
    if (!text.empty() && text.find_first_of(" \t\n\"'$`\\&|;<>()*?#~!") == std::string::npos)
        return text;
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string changedParameters(const json::Json& settings, const EstimatorEntry& estimator) {
    const auto stored = settings.find("parameters");
    if (stored == settings.end() || !stored->is_object())
        return "";
    std::string options;
    for (const ParameterDescription& parameter : estimator.parameters) {
        const auto value = json::number(*stored, parameter.name.c_str());
        if (value && std::abs(*value - parameter.usual) > 1e-12 * std::abs(parameter.usual))
            options += " --param " + word(parameter.name + "=" + json::Json(*value).dump());
    }
    return options;
}

/// Of runs in which the ranges between suits were used.
std::string togetherOptions(const json::Json& settings) {
    std::string options;
    for (const char* option : {"between", "room"})
        if (const auto used = settings.find(option); used != settings.end() && used->is_boolean())
            options += " --" + std::string(option) + (used->get<bool>() ? " on" : " off");
    if (const auto share = json::number(settings, "select"); share && *share < 1)
        options += " --select " + json::Json(*share).dump();
    return options;
}

}  // namespace

std::string commandOfRun(const DerivedRun& run, const std::string& take_path) {
    const json::Json settings = json::parse(run.settings_json);
    const auto estimator = json::text(settings, "estimator");
    const EstimatorEntry* known = estimator ? findEstimator(*estimator) : nullptr;
    if (!known)
        return "";
    std::string command =
        "noctule --batch process " + word(std::filesystem::path(take_path).filename().string());
    for (const char* option : {"sensors", "root", "estimator", "smooth", "detector", "ground"})
        if (const auto value = json::text(settings, option); value && !value->empty())
            command += " --" + std::string(option) + " " + word(*value);
    return command + togetherOptions(settings) + changedParameters(settings, *known) + " --run-name " +
           word(run.name);
}

}  // namespace noctule
