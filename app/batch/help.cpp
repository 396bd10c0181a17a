// SPDX-License-Identifier: Apache-2.0
#include "app/batch/help.h"

#include <algorithm>

namespace noctule::batch {
namespace {

constexpr size_t kColumn = 30, kWidth = 100;

/// Words in lines of at most kWidth, from the current column on; further lines begin at `indent`.
std::string wrapped(const std::string& words, size_t indent) {
    std::string text;
    size_t column = indent;
    for (size_t begin = 0; begin < words.size();) {
        const size_t end = std::min(words.find(' ', begin), words.size());
        const std::string word = words.substr(begin, end - begin);
        if (column > indent && column + 1 + word.size() > kWidth) {
            text += "\n" + std::string(indent, ' ');
            column = indent;
        }
        text += (column > indent ? " " : "") + word;
        column += word.size() + (column > indent ? 1 : 0);
        begin = end + 1;
    }
    return text + "\n";
}

std::string entry(const std::string& head, const std::string& words) {
    const std::string start = "  " + head;
    if (start.size() + 2 > kColumn)
        return start + "\n" + std::string(kColumn, ' ') + wrapped(words, kColumn);
    return start + std::string(kColumn - start.size(), ' ') + wrapped(words, kColumn);
}

std::string optionEntry(const Option& option) {
    std::string head = "--" + option.name;
    if (!option.placeholder.empty())
        head += " " + option.placeholder;
    std::string words = option.help;
    if (option.required)
        words += " (required)";
    if (!option.fallback.empty())
        words += " (default " + option.fallback + ")";
    return entry(head, words);
}

std::string verbList(bool left_out) {
    std::string text;
    for (const Verb& verb : verbs())
        if ((verb.run == nullptr) == left_out)
            text += entry(verb.name, verb.summary);
    return text;
}

std::string verbsLeftOut() {
    const std::string verbs = verbList(true);
    return verbs.empty() ? "" : "\nnot in this build:\n" + verbs + std::string(kLeftOutRemedy) + "\n";
}

}  // namespace

std::string exitCodeLine(const std::vector<ExitCode>& codes) {
    std::string words = "exit codes:";
    for (const ExitCode& code : codes)
        words += (words.back() == ':' ? " " : ", ") + std::to_string(code.code) + " " + code.meaning;
    return wrapped(words + ".", 0);
}

const std::vector<ExitCode>& standInExitCodes() {
    static const std::vector<ExitCode> codes = {{0, "ended by quit"},
                                                {1, "internal error"},
                                                {2, "usage"},
                                                {3, "input unreadable"},
                                                {4, "input readable but not usable"},
                                                {5, "a port cannot be had"},
                                                {130, "ended by Ctrl-C"}};
    return codes;
}

const std::vector<ExitCode>& exitCodes() {
    static const std::vector<ExitCode> codes = {{0, "done"},
                                                {1, "internal error"},
                                                {2, "usage"},
                                                {3, "input unreadable or not what it should be"},
                                                {4, "input readable but not usable"},
                                                {5, "device"},
                                                {6, "disk"},
                                                {130, "cancelled"}};
    return codes;
}

std::string optionList(const std::vector<Option>& options) {
    std::string text;
    for (const Option& option : options)
        text += optionEntry(option);
    return text;
}

std::string programHelp() {
    return "Noctule: motion capture with a suit of gyroscopes, accelerometers and ultrasound.\n\n"
           "usage: noctule [SESSION|TAKE]      the studio; it needs a display\n"
           "       noctule --batch VERB [ARGUMENTS]\n"
           "       noctule --batch VERB --help\n"
           "       noctule --help | --version\n\nverbs:\n" +
           verbList(false) + verbsLeftOut() + "\nafter every verb:\n" + optionList(commonOptions()) + "\n" +
           exitCodeLine(exitCodes()) + "\nexample: " + verbs().front().example + "\n";
}

std::string groupHelp(const std::string& group) {
    std::string text =
        "noctule --batch " + group + " WHAT: `noctule --batch " + group + " WHAT --help` explains each.\n\n";
    for (const Verb& verb : verbs())
        if (verb.run && verb.name.starts_with(group + " "))
            text += entry(verb.name, verb.summary);
    return text;
}

std::string verbHelp(const Verb& verb) {
    std::string text = "noctule --batch " + verb.name + ": " + verb.summary + ".\n";
    if (!verb.run)
        return text + "\nNot in this build. " + std::string(kLeftOutRemedy) + "\n";
    text += "\nusage: noctule --batch " + verb.name + (verb.operands.empty() ? "" : " " + verb.operands) +
            " [OPTIONS]\n";
    for (const Option& option : verb.options)
        if (option.name == verb.alone)
            text += "       noctule --batch " + verb.name + " --" + option.name + " " + option.placeholder +
                    " [OPTIONS]\n";
    if (!verb.options.empty())
        text += "\noptions:\n" + optionList(verb.options);
    text += "\nafter every verb:\n" + optionList(commonOptions());
    for (const std::string& remark : verb.remarks)
        text += "\n" + wrapped(remark, 0);
    return text + "\nexample: " + verb.example + "\n";
}

}  // namespace noctule::batch
