// SPDX-License-Identifier: Apache-2.0
#include "core/processing/run_subjects.h"

#include "core/math/json.h"
#include "core/processing/pose_runs.h"

namespace noctule {

Result<std::vector<TakeSubject>> subjectsOfRun(const std::string& take_path, const std::string& run) {
    const auto take = Take::open(take_path);
    if (!take)
        return take.error();
    const auto chosen = choosePoseRun(*take, run);
    if (!chosen)
        return chosen.error();
    std::vector<TakeSubject> subjects;
    const json::Json settings = json::Json::parse(chosen->settings_json, nullptr, false);
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
