// SPDX-License-Identifier: Apache-2.0
#include "app/batch/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "core/job/nearest_word.h"

namespace noctule::batch {
namespace {

std::optional<double> readNumber(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole_text = error == std::errc() && end == text.data() + text.size();
    return whole_text && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string plainNumber(double value) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
    return {buffer, end.ptr};
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

/// The value in the form that verbs see.
Result<std::string> checkedChoice(const Option& option, const std::string& value) {
    for (const std::string& choice : option.choices)
        if (lowerCase(choice) == lowerCase(value))
            return choice;
    return Error{ErrorKind::kUsage, "--" + option.name + " cannot be '" + value + "'",
                 "Choose " + listed(option.choices)};
}

Result<std::string> checkedNumber(const Option& option, const std::string& value) {
    const auto number = readNumber(value);
    const bool whole = option.kind == Option::Kind::kWhole;
    const bool fits = number && *number >= option.min && *number <= option.max &&
                      (!whole || *number == std::floor(*number));
    if (fits)
        return value;
    return Error{ErrorKind::kUsage, "--" + option.name + " cannot be '" + value + "'",
                 std::string("Give a ") + (whole ? "whole number" : "number") + " from " +
                     plainNumber(option.min) + " to " + plainNumber(option.max)};
}

Result<std::string> checkedValue(const Option& option, const std::string& value) {
    switch (option.kind) {
        case Option::Kind::kChoice:
            return checkedChoice(option, value);
        case Option::Kind::kNumber:
        case Option::Kind::kWhole:
            return checkedNumber(option, value);
        default:
            break;
    }
    if (value.empty())
        return Error{ErrorKind::kUsage, "--" + option.name + " is empty", "Give " + option.placeholder};
    return value;
}

}  // namespace

Result<Arguments> Arguments::parse(const std::vector<std::string>& words,
                                   const std::vector<Option>& options) {
    Arguments arguments(options);
    bool only_operands = false;
    for (size_t i = 0; i < words.size(); ++i) {
        if (!only_operands && words[i] == "--") {
            only_operands = true;
        } else if (!only_operands && words[i].size() > 1 && words[i][0] == '-') {
            if (Status added = arguments.addOption(words, i); !added)
                return added.error();
        } else {
            arguments.operands_.push_back(words[i]);
        }
    }
    return arguments;
}

std::vector<std::string> Arguments::inputFiles(const std::set<std::string>& but) const {
    std::vector<std::string> found = operands_;
    for (const Option& option : options_) {
        if (!option.names_input || but.contains(option.name))
            continue;
        if (option.kind == Option::Kind::kText && given(option.name))
            found.push_back(text(option.name));
        else if (option.kind == Option::Kind::kTexts)
            std::ranges::copy(texts(option.name), std::back_inserter(found));
    }
    return found;
}

Status Arguments::addOption(const std::vector<std::string>& words, size_t& index) {
    const std::string& word = words[index];
    const size_t equals = word.find('=');
    const std::string name = word.starts_with("--") ? word.substr(2, equals - 2) : word;
    const Option* option = find(name);
    if (!option)
        return unknownOption(word.substr(0, equals));
    if (values_.contains(name) && option->kind != Option::Kind::kTexts)
        return Error{ErrorKind::kUsage, "--" + name + " is given twice", "Give it once"};
    if (option->kind == Option::Kind::kFlag) {
        if (equals != std::string::npos)
            return Error{ErrorKind::kUsage, "--" + name + " takes no value", "Write --" + name};
        values_[name] = "yes";
        return Done{};
    }
    std::string value;
    if (equals != std::string::npos) {
        value = word.substr(equals + 1);
    } else {
        if (index + 1 >= words.size() || words[index + 1].starts_with("--"))
            return Error{ErrorKind::kUsage, "--" + name + " has no value",
                         "Write --" + name + " " + option->placeholder};
        value = words[++index];
    }
    const auto checked = checkedValue(*option, value);
    if (!checked)
        return checked.error();
    values_[name] = *checked;
    if (option->kind == Option::Kind::kTexts) {
        lists_[name].push_back(*checked);
        while (index + 1 < words.size() && !words[index + 1].starts_with("--"))
            lists_[name].push_back(words[++index]);
    }
    return Done{};
}

Error Arguments::unknownOption(const std::string& name) const {
    std::vector<std::string> names;
    for (const Option& option : options_)
        names.push_back(option.name);
    const std::string near =
        nearestWord(name.substr(std::min(name.find_first_not_of('-'), name.size())), names);
    return {ErrorKind::kUsage, "unknown option " + name,
            near.empty() ? "--help shows all" : "Did you mean --" + near + "? --help shows all"};
}

const Option* Arguments::find(const std::string& name) const {
    const auto found =
        std::find_if(options_.begin(), options_.end(), [&](const Option& o) { return o.name == name; });
    return found == options_.end() ? nullptr : &*found;
}

const Option& Arguments::known(const std::string& name) const {
    const Option* option = find(name);
    require(option != nullptr, "a verb asks only for options of its own table");
    return *option;
}

bool Arguments::given(const std::string& name) const {
    return values_.contains(known(name).name);
}

std::string Arguments::text(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? known(name).fallback : found->second;
}

std::vector<std::string> Arguments::texts(const std::string& name) const {
    const auto found = lists_.find(known(name).name);
    return found == lists_.end() ? std::vector<std::string>() : found->second;
}

std::optional<double> Arguments::number(const std::string& name) const {
    return readNumber(text(name));
}

std::optional<int64_t> Arguments::whole(const std::string& name) const {
    const auto value = number(name);
    return value ? std::optional(static_cast<int64_t>(*value)) : std::nullopt;
}

}  // namespace noctule::batch
