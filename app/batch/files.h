// SPDX-License-Identifier: Apache-2.0
// What verbs read and write beside takes: JSON documents; motions: motion_file.h.
#pragma once

#include <set>
#include <string>

#include "app/batch/arguments.h"
#include "core/body/actor.h"
#include "core/suit/calibration.h"
#include "core/suit/suit.h"

namespace noctule::batch {

/// "--bvh-unit", for verbs that read BVH files.
Option bvhUnitOption();

/// kUnreadable when it is no JSON.
Result<nlohmann::json> readJson(const std::string& path);
Result<Suit> readSuit(const std::string& path);
Result<Actor> readActor(const std::string& path);
Result<Calibration> readCalibration(const std::string& path);

/// Reads the file that an option names into `into`, which stays as it is when the option was not given.
template <class Value, class Into>
Status readGiven(const Arguments& arguments, const char* option, Result<Value> (*read)(const std::string&),
                 Into& into) {
    if (!arguments.given(option))
        return Done{};
    Result<Value> value = read(arguments.text(option));
    if (!value)
        return value.error();
    into = std::move(*value);
    return Done{};
}

/// Refuses, before long work begins, an output that stands in the way, that is another output too, or that is
/// one of the inputs, which --overwrite must not cost; an empty path is none.
Status checkOutputs(const std::vector<std::string>& paths, bool overwrite,
                    const std::vector<std::string>& inputs = {});
/// The same of these options, with all that is read. `updated` may be outputs too: they are made anew.
Status checkOutputs(const Arguments& arguments, const std::vector<std::string>& outputs,
                    const std::set<std::string>& updated = {});
Status writeJson(const std::string& path, const nlohmann::json& json, bool overwrite);

/// "walk_001" of "takes/walk_001.noctule".
std::string takeName(const std::string& path);

}  // namespace noctule::batch
