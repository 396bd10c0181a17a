// SPDX-License-Identifier: Apache-2.0
#include "app/batch/program.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "app/batch/help.h"
#include "app/batch/version.h"
#include "core/job/nearest_word.h"

namespace noctule::batch {
namespace {

int exitCode(const Error& error) {
    return static_cast<int>(error.kind);
}

/// File names need not be UTF-8, JSON has to be.
std::string textOf(const nlohmann::json& json) {
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// The result of a whole run: the outcome, or the error as JSON too when that was asked for.
int report(const Result<Outcome>& result, Console& console) {
    console.endProgress();
    if (!result) {
        const Error& error = result.error();
        console.error(error);
        if (console.wantsJson())
            console.printJson(textOf({{"error", errorJson(error)}}));
        return exitCode(error);
    }
    const bool written =
        console.wantsJson() ? console.printJson(textOf(result->json)) : console.print(result->text);
    if (!written) {
        const Error error{ErrorKind::kDisk, "standard output cannot be written", "Check where it leads to"};
        console.error(error);
        return exitCode(error);
    }
    return result->failure ? exitCode(*result->failure) : 0;
}

const Verb* findVerb(const std::string& name) {
    const auto found = std::ranges::find(verbs(), name, &Verb::name);
    return found == verbs().end() ? nullptr : &*found;
}

/// The longest name that the words begin with; empty: there is no word.
std::string verbName(const std::vector<std::string>& words) {
    if (words.size() > 1 && findVerb(words[0] + " " + words[1]))
        return words[0] + " " + words[1];
    return words.empty() ? "" : words[0];
}

/// Second words of the verbs that begin with this one.
std::vector<std::string> kindsOf(const std::string& group) {
    std::vector<std::string> kinds;
    for (const Verb& verb : verbs())
        if (verb.run && verb.name.starts_with(group + " "))
            kinds.push_back(verb.name.substr(group.size() + 1));
    return kinds;
}

Error unknownVerb(const std::string& name) {
    if (const auto kinds = kindsOf(name); !name.empty() && !kinds.empty())
        return {ErrorKind::kUsage, name + " needs what to " + name, "Choose " + listed(kinds)};
    std::vector<std::string> names;
    for (const Verb& verb : verbs())
        if (verb.run)
            names.push_back(verb.name);
    if (name.empty())
        return {ErrorKind::kUsage, "no verb is given", "Choose " + listed(names)};
    const std::string near = nearestWord(name, names);
    return {ErrorKind::kUsage, "unknown verb " + name,
            near.empty() ? "Choose " + listed(names) : "Did you mean " + near + "?"};
}

Status checkArguments(const Verb& verb, const Arguments& arguments) {
    const bool alone = !verb.alone.empty() && arguments.given(verb.alone);
    for (const Option& option : verb.options)
        if (option.required && !alone && !arguments.given(option.name))
            return Error{ErrorKind::kUsage, verb.name + " needs --" + option.name + " " + option.placeholder,
                         "For example: " + verb.example};
    const size_t count = arguments.operands().size();
    if (alone && count > 0)
        return Error{ErrorKind::kUsage,
                     verb.name + " --" + verb.alone + " does not take '" + arguments.operands()[0] + "'",
                     "Leave it out"};
    if (count < verb.min_operands && !alone)
        return Error{ErrorKind::kUsage, verb.name + " needs " + verb.operands,
                     "For example: " + verb.example};
    if (count > verb.max_operands)
        return Error{ErrorKind::kUsage,
                     verb.name + " does not take '" + arguments.operands()[verb.max_operands] + "'",
                     "For example: " + verb.example};
    return Done{};
}

/// The length of the UTF-8 character that begins there; 0 when none does.
size_t characterLength(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const size_t length = byte(0) < 0x80                      ? 1
                          : byte(0) >= 0xC2 && byte(0) < 0xE0 ? 2
                          : byte(0) >= 0xE0 && byte(0) < 0xF0 ? 3
                          : byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4
                                                              : 0;
    if (length > text.size())
        return 0;
    for (size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80)
            return 0;
    return length;
}

/// Takes, JSON and the screen hold names as UTF-8; another name could not be written down.
Status checkUtf8(const std::string& word) {
    std::string shown;
    bool right = true;
    for (std::string_view rest = word; !rest.empty();) {
        const size_t length = characterLength(rest);
        char code[8];
        std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(rest[0]));
        shown += length > 0 ? std::string(rest.substr(0, length)) : code;
        right = right && length > 0;
        rest.remove_prefix(std::max<size_t>(length, 1));
    }
    if (right)
        return Done{};
    return Error{ErrorKind::kUsage, "'" + shown + "' is not UTF-8",
                 "Rename the file or folder, or give a symbolic link with a plain name"};
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

Result<Outcome> runVerb(const Verb& verb, const std::vector<std::string>& words, Console& console,
                        const CancelFlag& cancel) {
    for (const std::string& word : words)
        if (Status right = checkUtf8(word); !right)
            return right.error();
    std::vector<Option> options = verb.options;
    options.insert(options.end(), commonOptions().begin(), commonOptions().end());
    const auto arguments = Arguments::parse(words, options);
    if (!arguments)
        return arguments.error();
    if (Status right = checkArguments(verb, *arguments); !right)
        return right.error();
    return verb.run({*arguments, console, cancel});
}

}  // namespace

int runBatch(const std::vector<std::string>& words, const CancelFlag& cancel) {
    const std::string name = verbName(words);
    const bool help = contains(words, "--help");
    Console console(!help && contains(words, "--quiet"), contains(words, "--json"));
    const Verb* verb = findVerb(name);
    if (name == "--version")
        return report(Outcome{{{"version", softwareName()}}, softwareName() + "\n", std::nullopt}, console);
    if (name == "help" || (help && (verb || name.starts_with("--") || !kindsOf(name).empty()))) {
        const std::string text = verb                    ? verbHelp(*verb)
                                 : kindsOf(name).empty() ? programHelp()
                                                         : groupHelp(name);
        return report(Outcome{{{"help", text}}, text, std::nullopt}, console);
    }
    if (!verb)
        return report(unknownVerb(name), console);
    if (!verb->run)
        return report(Error{ErrorKind::kUsage, name + " was left out of this build of noctule",
                            std::string(kLeftOutRemedy)},
                      console);
    try {
        const ptrdiff_t own_words = 1 + std::ranges::count(name, ' ');
        return report(runVerb(*verb, {words.begin() + own_words, words.end()}, console, cancel), console);
    } catch (const std::exception& mistake) {
        return report(Error{ErrorKind::kInternal, std::string("internal error: ") + mistake.what(),
                            "Report it with the command line and the input"},
                      console);
    }
}

std::string softwareName() {
    return std::string("noctule ") + softwareVersion();
}

}  // namespace noctule::batch
