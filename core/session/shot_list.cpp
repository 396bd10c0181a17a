// SPDX-License-Identifier: Apache-2.0
#include "core/session/shot_list.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include "core/session/take_folder.h"

namespace noctule {
namespace {

std::string trimmed(const std::string& text) {
    const char* const kBlank = " \t\r\n";
    const size_t first = text.find_first_not_of(kBlank);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// "- ", "* ", "3. ", "3) " and a bullet.
std::string withoutBullet(const std::string& line) {
    static const std::regex kBullet(R"(^(?:[-*]|\xE2\x80\xA2|\d{1,3}[.)])\s+)");
    return std::regex_replace(line, kBullet, "");
}

/// Takes the number off the end.
int takeWanted(std::string& line) {
    static const std::regex kWanted(
        R"(^(.*\S)(?:\s+[xX]\s?(\d{1,2})|\s*\xC3\x97\s?(\d{1,2})|\s+(\d{1,2})\s?[xX]|\s+\((\d{1,2})\)|\s*[\t;]\s*(\d{1,2}))$)");
    std::smatch match;
    if (!std::regex_match(line, match, kWanted))
        return 1;
    const std::string name = match[1];
    std::string digits;
    for (size_t group = 2; group < match.size(); ++group)
        digits += match[group];
    line = name;
    return std::clamp(std::stoi(digits), 1, kMostTakesOfShot);
}

int missingOf(const Session& session, size_t shot) {
    return session.shots[shot].wanted - keptTakes(session, session.shots[shot].name);
}

}  // namespace

std::vector<Shot> shotsFromText(const std::string& text) {
    std::vector<Shot> shots;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        line = withoutBullet(trimmed(line));
        Shot shot;
        shot.wanted = takeWanted(line);
        shot.name = line;
        const bool is_new = std::none_of(shots.begin(), shots.end(),
                                         [&](const Shot& other) { return other.name == shot.name; });
        if (!shot.name.empty() && is_new)
            shots.push_back(std::move(shot));
    }
    return shots;
}

std::string textOf(const std::vector<Shot>& shots) {
    std::string text;
    for (const Shot& shot : shots)
        text += shot.name + (shot.wanted > 1 ? " x" + std::to_string(shot.wanted) : "") + "\n";
    return text;
}

std::vector<Shot> withUnknownMembers(std::vector<Shot> shots, const std::vector<Shot>& before) {
    for (Shot& shot : shots)
        for (const Shot& known : before)
            if (known.name == shot.name)
                shot.unknown = known.unknown;
    return shots;
}

int keptTakes(const Session& session, const std::string& shot) {
    return static_cast<int>(std::count_if(
        session.takes.begin(), session.takes.end(),
        [&](const SessionTake& take) { return take.shot == shot && take.state != TakeState::kDamaged; }));
}

ShotProgress progressOf(const Session& session) {
    ShotProgress progress;
    for (const Shot& shot : session.shots) {
        progress.wanted += shot.wanted;
        progress.kept += std::min(shot.wanted, keptTakes(session, shot.name));
    }
    return progress;
}

int dueShot(const Session& session, int current) {
    const int count = static_cast<int>(session.shots.size());
    const int first = current >= 0 && current < count ? current : 0;
    for (int i = 0; i < count; ++i)
        if (const int shot = (first + i) % count; missingOf(session, static_cast<size_t>(shot)) > 0)
            return shot;
    return -1;
}

std::string takeBaseOf(const Shot& shot) {
    const size_t end = shot.name.find_first_of(" ,;:.(/");
    std::string word = shot.name.substr(0, end);
    for (char& letter : word)
        letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    return takeBaseName(word);
}

}  // namespace noctule
