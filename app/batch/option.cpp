// SPDX-License-Identifier: Apache-2.0
#include "app/batch/option.h"

#include <algorithm>
#include <utility>

namespace noctule::batch {
namespace {

Option make(Option::Kind kind, const std::string& name, const std::string& placeholder,
            const std::string& help) {
    Option option;
    option.kind = kind;
    option.name = name;
    option.placeholder = placeholder;
    option.help = help;
    return option;
}

}  // namespace

Option&& Option::orElse(const std::string& value) && {
    fallback = value;
    return std::move(*this);
}

Option&& Option::needed() && {
    required = true;
    return std::move(*this);
}

Option flag(const std::string& name, const std::string& help) {
    return make(Option::Kind::kFlag, name, "", help);
}

Option text(const std::string& name, const std::string& placeholder, const std::string& help) {
    return make(Option::Kind::kText, name, placeholder, help);
}

Option texts(const std::string& name, const std::string& placeholder, const std::string& help) {
    return make(Option::Kind::kTexts, name, placeholder, help);
}

Option inputFile(const std::string& name, const std::string& placeholder, const std::string& help) {
    Option option = text(name, placeholder, help);
    option.names_input = true;
    return option;
}

Option inputFiles(const std::string& name, const std::string& placeholder, const std::string& help) {
    Option option = texts(name, placeholder, help);
    option.names_input = true;
    return option;
}

Option choice(const std::string& name, std::vector<std::string> choices, const std::string& help) {
    std::string placeholder;
    for (const std::string& value : choices)
        placeholder += (placeholder.empty() ? "" : "|") + value;
    Option option = make(Option::Kind::kChoice, name, placeholder, help);
    option.choices = std::move(choices);
    return option;
}

Option number(const std::string& name, const std::string& placeholder, double min, double max,
              const std::string& help) {
    Option option = make(Option::Kind::kNumber, name, placeholder, help);
    option.min = min;
    option.max = max;
    return option;
}

Option whole(const std::string& name, const std::string& placeholder, double min, double max,
             const std::string& help) {
    Option option = number(name, placeholder, min, max, help);
    option.kind = Option::Kind::kWhole;
    return option;
}

const std::vector<Option>& commonOptions() {
    static const std::vector<Option> options = {
        flag("json", "one JSON object on standard output, messages on standard error"),
        flag("quiet", "errors only"),
        whole("seed", "N", 0, 9007199254740991, "seed of everything random (simulate)").orElse("1"),
        whole("jobs", "N", 1, 256, "takes at a time (process); all cores when not given"),
        flag("overwrite", "replace outputs that exist; else that is an error"),
        flag("help", "this text")};
    return options;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return text;
}

}  // namespace noctule::batch
