// SPDX-License-Identifier: Apache-2.0
#include "app/help_files/completion.h"

#include <utility>
#include <vector>

#include "app/batch/verb.h"
#include "app/virtual_robot/options.h"
#include "app/virtual_suit/options.h"

namespace noctule::help_files {
namespace {

using batch::Option;

/// A program or a verb as completion knows it.
struct Command {
    std::string name;  ///< "simulate", "calibrate sources"; "suit", "stand_in_robot": the virtual ones
    std::string summary;
    std::vector<Option> options;
};

std::vector<Command> verbCommands() {
    std::vector<Command> commands;
    for (const batch::Verb& verb : batch::verbs()) {
        if (!verb.run)
            continue;
        Command command{verb.name, verb.summary, verb.options};
        command.options.insert(command.options.end(), batch::commonOptions().begin(),
                               batch::commonOptions().end());
        commands.push_back(command);
    }
    return commands;
}

Command suitCommand() {
    return {"suit", "a driver box without hardware", virtual_suit::optionTable()};
}

Command robotCommand() {
    return {"stand_in_robot", "a robot without hardware", virtual_robot::optionTable()};
}

std::vector<Command> allCommands() {
    std::vector<Command> commands = verbCommands();
    commands.push_back(suitCommand());
    commands.push_back(robotCommand());
    return commands;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

/// First words of all verbs, each once.
std::string firstWords() {
    std::vector<std::string> words;
    for (const Command& command : verbCommands()) {
        const std::string first = command.name.substr(0, command.name.find(' '));
        if (words.empty() || words.back() != first)
            words.push_back(first);
    }
    return joined(words);
}

std::string secondWords() {
    std::vector<std::string> words;
    for (const Command& command : verbCommands())
        if (const size_t space = command.name.find(' '); space != std::string::npos)
            words.push_back(command.name.substr(space + 1));
    return joined(words);
}

bool isNumber(const Option& option) {
    return option.kind == Option::Kind::kNumber || option.kind == Option::Kind::kWhole;
}

std::string bashOptionCases() {
    std::string cases;
    for (const Command& command : allCommands()) {
        std::vector<std::string> names;
        for (const Option& option : command.options)
            names.push_back("--" + option.name);
        cases += "        \"" + command.name + "\") echo \"" + joined(names) + "\" ;;\n";
    }
    return cases;
}

/// What follows an option: words to choose from, nothing behind flags, a number that nobody can complete.
std::string bashValueCases() {
    std::string cases;
    for (const Command& command : allCommands())
        for (const Option& option : command.options) {
            const std::string line = "        \"" + command.name + " --" + option.name + "\") ";
            if (option.kind == Option::Kind::kChoice)
                cases += line + "echo \"" + joined(option.choices) + "\" ;;\n";
            else if (option.kind == Option::Kind::kFlag)
                cases += line + "echo \":flag\" ;;\n";
            else if (isNumber(option))
                cases += line + "echo \":number\" ;;\n";
        }
    return cases;
}

/// Text within single quotes of zsh and brackets of _arguments.
std::string zshWords(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\'')
            out += "'\\'";
        else if (c == '[' || c == ']' || c == ':' || c == '\\')
            out += '\\';
        out += c;
    }
    return out;
}

std::string zshOption(const Option& option) {
    std::string line = "        '--" + option.name + "[" + zshWords(option.help) + "]";
    if (option.kind == Option::Kind::kChoice)
        line += ":" + zshWords(option.name) + ":(" + joined(option.choices) + ")";
    else if (isNumber(option))
        line += ":" + zshWords(option.placeholder) + ": ";
    else if (option.kind != Option::Kind::kFlag)
        line += ":" + zshWords(option.placeholder) + ":_files";
    return line + "' \\\n";
}

std::string zshFunction(const Command& command) {
    std::string name = command.name;
    if (const size_t space = name.find(' '); space != std::string::npos)
        name[space] = '_';
    std::string text = "_noctule_" + name + "() {\n    _arguments \\\n";
    for (const Option& option : command.options)
        text += zshOption(option);
    return text + "        '*:file:_files'\n}\n\n";
}

constexpr const char* kBashHead =
    R"(# Completion of noctule, noctule-virtual-suit and noctule-virtual-robot for bash, made from the tables behind --help.

_noctule_options() {
    case "$1" in
)";

constexpr const char* kBashMiddle = R"(    esac
}

_noctule_values() {
    case "$1" in
)";

constexpr const char* kBashTail = R"sh(
_noctule_words() {
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
}

_noctule_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$1")
}

# $1: the verb, $2: the word before, $3: the word that is being written
_noctule_of_verb() {
    local values
    values=$(_noctule_values "$1 $2")
    case $3 in -*) [ -n "$values" ] && [ "$values" != ":flag" ] || values=:option ;; esac
    case $values in
        :option) _noctule_words "$(_noctule_options "$1")" "$3" ;;
        :number) COMPREPLY=() ;;
        ""|:flag) _noctule_files "$3" ;;
        *) _noctule_words "$values" "$3" ;;
    esac
}

_noctule() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} verb=${COMP_WORDS[2]-}
    if [ "$COMP_CWORD" -gt 1 ] && [ "${COMP_WORDS[1]}" = --batch ]; then
        if [ "$COMP_CWORD" -eq 2 ]; then
            _noctule_words "$_noctule_verbs --help" "$word"
        elif [ "$verb" = calibrate ] && [ "$COMP_CWORD" -eq 3 ]; then
            _noctule_words "$_noctule_calibrations" "$word"
        else
            [ "$verb" != calibrate ] || verb="calibrate ${COMP_WORDS[3]}"
            _noctule_of_verb "$verb" "$before" "$word"
        fi
    elif [[ $word == -* ]]; then
        _noctule_words "--batch --help --version" "$word"
    else
        _noctule_files "$word"
    fi
}

_noctule_virtual_suit() {
    _noctule_of_verb suit "${COMP_WORDS[COMP_CWORD-1]}" "${COMP_WORDS[COMP_CWORD]}"
}

_noctule_virtual_robot() {
    _noctule_of_verb stand_in_robot "${COMP_WORDS[COMP_CWORD-1]}" "${COMP_WORDS[COMP_CWORD]}"
}

complete -F _noctule noctule
complete -F _noctule_virtual_suit noctule-virtual-suit
complete -F _noctule_virtual_robot noctule-virtual-robot
)sh";

constexpr const char* kZshTail = R"sh(_noctule() {
    if [[ $service == noctule-virtual-suit ]]; then
        _noctule_suit
        return
    fi
    if [[ $service == noctule-virtual-robot ]]; then
        _noctule_stand_in_robot
        return
    fi
    if [[ $CURRENT -eq 2 || $words[2] != --batch ]]; then
        _arguments '--batch[run one job without a display]' '--help[verbs and exit codes]' \
            '--version[the version of this program]' '*:session or take:_files'
        return
    fi
    if [[ $CURRENT -eq 3 ]]; then
        _describe verb _noctule_verbs
        return
    fi
    local verb=$words[3]
    if [[ $verb == calibrate ]]; then
        if [[ $CURRENT -eq 4 ]]; then
            _describe calibration _noctule_calibrations
            return
        fi
        verb=calibrate_$words[4]
        shift words
        (( CURRENT-- ))
    fi
    shift 2 words
    (( CURRENT -= 2 ))
    (( $+functions[_noctule_$verb] )) && _noctule_$verb
}

_noctule "$@"
)sh";

/// Words with their explanations, as _describe takes them; of `calibrate` one word stands for all.
std::string zshVerbList(bool calibrations) {
    std::string list = calibrations ? "_noctule_calibrations=(\n" : "_noctule_verbs=(\n";
    bool calibrate_said = false;
    for (const Command& command : verbCommands()) {
        const size_t space = command.name.find(' ');
        if (calibrations && space != std::string::npos)
            list += "    '" + command.name.substr(space + 1) + ":" + zshWords(command.summary) + "'\n";
        if (!calibrations && space == std::string::npos)
            list += "    '" + command.name + ":" + zshWords(command.summary) + "'\n";
        if (!calibrations && space != std::string::npos && !std::exchange(calibrate_said, true))
            list += "    '" + command.name.substr(0, space) + ":calibrate a part of the suit'\n";
    }
    return list + ")\n\n";
}

}  // namespace

std::string bashCompletion() {
    return std::string(kBashHead) + bashOptionCases() + kBashMiddle + bashValueCases() + "        *) ;;\n" +
           "    esac\n}\n\n_noctule_verbs=\"" + firstWords() + "\"\n_noctule_calibrations=\"" +
           secondWords() + "\"\n" + kBashTail;
}

std::string zshCompletion() {
    std::string text =
        "#compdef noctule noctule-virtual-suit noctule-virtual-robot\n"
        "# Completion for zsh, made from the tables behind --help.\n\n"
        "typeset -a _noctule_verbs _noctule_calibrations\n" +
        zshVerbList(false) + zshVerbList(true);
    for (const Command& command : allCommands())
        text += zshFunction(command);
    return text + kZshTail;
}

}  // namespace noctule::help_files
