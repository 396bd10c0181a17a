// SPDX-License-Identifier: Apache-2.0
#include "core/processing/run_subjects.h"

#include <algorithm>
#include <filesystem>

#include "core/math/json.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

std::string pathOfSubject(const std::string& path, const std::string& subject) {
    std::string name = subject;
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '\\' || c == ':' || c == ' '; }, '_');
    const std::filesystem::path whole(path);
    return (whole.parent_path() / (whole.stem().string() + "_" + name + whole.extension().string())).string();
}

}  // namespace

Result<std::vector<ExportRequest>> requestsOfSubjects(const ExportRequest& request) {
    const auto subjects = subjectsOfRun(request.take_path, request.run);
    if (!subjects)
        return subjects.error();
    std::vector<ExportRequest> requests;
    for (const TakeSubject& subject : *subjects) {
        ExportRequest own = request;
        own.suit = subject.suit();
        for (const ExportFormatEntry& format : exportFormats())
            if (std::string& path = own.*format.path; subjects->size() > 1 && !path.empty())
                path = pathOfSubject(path, subject.name);
        requests.push_back(std::move(own));
    }
    return requests;
}

Result<std::vector<TakeSubject>> subjectsOfRun(const std::string& take_path, const std::string& run) {
    const auto take = Take::open(take_path);
    if (!take)
        return take.error();
    const auto chosen = choosePoseRun(*take, run);
    if (!chosen)
        return chosen.error();
    std::vector<TakeSubject> subjects;
    const json::Json settings = json::parse(chosen->settings_json);
    const auto list = settings.is_object() ? settings.find("subjects") : settings.end();
    if (list != settings.end() && list->is_array())
        for (const json::Json& entry : *list)
            if (const auto suit = json::number(entry, "suit"); suit && *suit >= 1)
                subjects.push_back(
                    {json::text(entry, "name").value_or(""), {static_cast<int>(*suit)}, false});
    if (subjects.empty())
        subjects.push_back({"", {1}, false});
    return subjects;
}

}  // namespace noctule
