// SPDX-License-Identifier: Apache-2.0
#include <charconv>

#include "app/batch/parameters.h"
#include "app/batch/verb.h"

namespace noctule::batch {
namespace {

nlohmann::json estimatorJson(const EstimatorEntry& entry) {
    nlohmann::json rows = nlohmann::json::array();
    for (const ParameterDescription& row : entry.parameters)
        rows.push_back({{"name", row.name},
                        {"unit", row.unit},
                        {"default", row.usual},
                        {"least", row.least},
                        {"most", row.most},
                        {"meaning", row.meaning},
                        {"source", row.source}});
    return {{"name", entry.name},
            {"summary", entry.summary},
            {"detector", detectorName(entry.detector)},
            {"parameters", rows}};
}

std::string shortNumber(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    return {text, end.ptr};
}

std::string estimatorText(const EstimatorEntry& entry) {
    std::string text = entry.name + ": " + entry.summary +
                       "\n  detector unless --detector says otherwise: " + detectorName(entry.detector) +
                       "\n";
    for (const ParameterDescription& row : entry.parameters)
        text += "  " + row.name + " = " + shortNumber(row.usual) + (row.unit == "-" ? "" : " " + row.unit) +
                "  (" + shortNumber(row.least) + " to " + shortNumber(row.most) + ")\n      " + row.meaning +
                (row.source == "-" ? "" : " [" + row.source + "]") + "\n";
    return text;
}

Result<Outcome> runEstimators(const VerbContext& context) {
    const std::vector<std::string>& wanted = context.arguments.operands();
    nlohmann::json list = nlohmann::json::array();
    Outcome outcome;
    if (!wanted.empty())
        if (const auto known = estimatorNamed(wanted[0]); !known)
            return known.error();
    for (const EstimatorEntry& entry : estimators()) {
        if (!wanted.empty() && entry.name != wanted[0])
            continue;
        list.push_back(estimatorJson(entry));
        outcome.text += estimatorText(entry);
    }
    outcome.json = {{"estimators", list}};
    return outcome;
}

}  // namespace

Verb estimatorsVerb() {
    Verb verb;
    verb.name = "estimators";
    verb.summary = "list the estimators and their parameters: unit, default, range, meaning, source";
    verb.operands = "[NAME]";
    verb.max_operands = 1;
    verb.example = "noctule --batch estimators manifold";
    verb.remarks = {"`process --param NAME=VALUE` sets one; every result stores all of them."};
    verb.run = runEstimators;
    return verb;
}

}  // namespace noctule::batch
