// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_names.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

namespace noctule {
namespace {

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

/// Fit for every file system that takes travel to (Windows is the strictest), and never hidden.
std::string fileNameOf(const std::string& words) {
    std::string name;
    for (const char c : words) {
        const bool refused = static_cast<unsigned char>(c) < 0x20 ||
                             std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
        name += refused ? '-' : c;
    }
    const size_t first = name.find_first_not_of(" ."), last = name.find_last_not_of(" .");
    return first == std::string::npos ? "" : name.substr(first, last - first + 1);
}

}  // namespace

Result<std::string> exportFileName(const std::string& pattern, const ExportNameFields& fields) {
    const std::map<std::string, std::string> places = {{"take", fields.take},
                                                       {"performer", fields.performer},
                                                       {"run", fields.run},
                                                       {"date", fields.date},
                                                       {"fps", numberText(fields.frames_per_second)}};
    std::string words;
    for (size_t at = 0; at < pattern.size();) {
        const size_t end = pattern[at] == '{' ? pattern.find('}', at) : std::string::npos;
        if (end == std::string::npos) {
            words += pattern[at++];
            continue;
        }
        const auto place = places.find(pattern.substr(at + 1, end - at - 1));
        if (place == places.end())
            return Error{
                ErrorKind::kUsage,
                "The file name asks for " + pattern.substr(at, end - at + 1) + ", which is not known",
                "Use {take}, {performer}, {run}, {date} and {fps}"};
        words += place->second;
        at = end + 1;
    }
    const std::string name = fileNameOf(words);
    if (name.empty())
        return Error{ErrorKind::kUsage, "The file name is empty", "Write {take}, which is the take's name"};
    return name;
}

std::string freeFilePath(const std::string& folder, const std::string& name, const std::string& extension,
                         std::set<std::string>& taken) {
    for (int number = 1;; ++number) {
        const std::string counted = number == 1 ? name : name + "_" + std::to_string(number);
        const std::string path = (std::filesystem::path(folder) / (counted + "." + extension)).string();
        std::error_code ignored;
        if (!std::filesystem::exists(std::filesystem::symlink_status(path, ignored)) &&
            taken.insert(path).second)
            return path;
    }
}

}  // namespace noctule
