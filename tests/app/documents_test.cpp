// SPDX-License-Identifier: Apache-2.0
// The documents beside the program: a command that stands in them can be typed, and no option is left out.
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/files.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

using Names = std::set<std::string>;

std::string sourceFile(const std::string& path) {
    return readBytes(NOCTULE_SOURCE_DIR "/" + path);
}

/// What each verb's help lists, those of every verb included.
std::map<std::string, Names> optionsOfVerbs() {
    std::map<std::string, Names> options;
    std::istringstream lines(batch({"--help"}).out);
    static const std::regex verb_line("  ([a-z][a-z-]*( [a-z-]+)?)  +.*"), option_line("  --([a-z-]+).*");
    std::smatch found;
    for (std::string line; std::getline(lines, line) && !line.starts_with("after every verb");) {
        if (!std::regex_match(line, found, verb_line))
            continue;
        const std::string verb = found[1];
        std::istringstream words(verb), help;
        std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
        arguments.emplace_back("--help");
        help.str(batch(arguments).out);
        for (std::string entry; std::getline(help, entry);)
            if (std::regex_match(entry, found, option_line))
                options[verb].insert(found[1]);
    }
    return options;
}

/// From its heading to the next one.
std::string chapter(const std::string& text, const std::string& title) {
    const size_t begin = text.find("\n## " + title + "\n");
    return begin == std::string::npos ? std::string()
                                      : text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

void checkCommand(const std::string& command, const std::map<std::string, Names>& options) {
    std::istringstream words(command);
    std::string verb, word;
    words >> verb;
    if (verb == "calibrate" && words >> word)
        verb += " " + word;
    if (verb == "VERB")
        return;
    const auto known = options.find(verb);
    ASSERT_NE(known, options.end()) << command;
    while (words >> word)
        if (word.starts_with("--"))
            EXPECT_TRUE(known->second.contains(word.substr(2))) << command;
}

TEST(Documents, EveryCommandCanBeTyped) {
    const auto options = optionsOfVerbs();
    ASSERT_GT(options.size(), 20u);
    static const std::regex command_form("noctule --batch +([^`\n#(]+)");
    size_t commands = 0;
    for (const char* file :
         {"README.md", "app/README.md", "resources/docs/tutorial.md", "resources/docs/guide.md",
          "resources/docs/robots.md", "resources/docs/formats.md", "resources/docs/how_it_works.md",
          "resources/docs/orientation.md", "resources/docs/security.md"}) {
        SCOPED_TRACE(file);
        const std::string text = std::regex_replace(sourceFile(file), std::regex(" *\\\\\n *"), " ");
        for (std::sregex_iterator found(text.begin(), text.end(), command_form), end; found != end; ++found) {
            checkCommand((*found)[1], options);
            ++commands;
        }
    }
    EXPECT_GT(commands, 40u);
}

TEST(Documents, EveryOptionIsDescribed) {
    const std::string text = sourceFile("app/README.md");
    for (const auto& [verb, names] : optionsOfVerbs()) {
        std::string description = chapter(text, verb);
        if (verb == "check" || verb.starts_with("calibrate "))
            description += chapter(text, "calibrate and check");
        EXPECT_FALSE(description.empty()) << verb;
        description += text.substr(0, text.find("\n## "));  // options of every verb
        for (const std::string& name : names)
            EXPECT_TRUE(std::regex_search(description, std::regex("--" + name + "(?![a-z-])")))
                << verb << " --" << name;
    }
}

TEST(Documents, HelpHasNoHeadingWithoutOptions) {
    EXPECT_EQ(batch({"inspect", "--help"}).out.find("options:\n\n"), std::string::npos);
    EXPECT_NE(batch({"process", "--help"}).out.find("options:\n  --"), std::string::npos);
}

}  // namespace
}  // namespace noctule::test
