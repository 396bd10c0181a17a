// SPDX-License-Identifier: Apache-2.0
#include "app/batch/verb.h"

namespace noctule::batch {
namespace {

Verb laterVerb(const std::string& name, const std::string& summary) {
    Verb verb;
    verb.name = name;
    verb.summary = summary;
    return verb;
}

}  // namespace
nlohmann::json errorJson(const Error& error) {
    return {
        {"exit_code", static_cast<int>(error.kind)}, {"message", error.message}, {"remedy", error.remedy}};
}

const std::vector<Verb>& verbs() {
    static const std::vector<Verb> all = {
        simulateVerb(),
        processVerb(),
        evaluateVerb(),
        exportVerb(),
        inspectVerb(),
        attachVerb(),
        devicesVerb(),
        recordVerb(),
        recoverVerb(),
        calibrateSourcesVerb(),
        calibrateAccelerometersVerb(),
        calibrateGyroscopesVerb(),
        calibrateRestPoseVerb(),
        laterVerb("calibrate motion", "find mounting, bones and sources from movement"),
        checkVerb()};
    return all;
}

}  // namespace noctule::batch
