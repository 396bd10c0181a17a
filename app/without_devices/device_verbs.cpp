// SPDX-License-Identifier: Apache-2.0
// Stand in for the verbs of app/batch/devices in builds without them (NOCTULE_DEVICES=OFF): help names them
// apart.
#include "app/batch/verb.h"

namespace noctule::batch {
namespace {

Verb leftOut(std::string name, std::string summary) {
    Verb verb;
    verb.name = std::move(name);
    verb.summary = std::move(summary);
    return verb;
}

}  // namespace

Verb devicesVerb() {
    return leftOut("devices", "list the driver boxes that can be reached");
}
Verb recordVerb() {
    return leftOut("record", "record a take from a driver box, or from one per suit");
}
Verb driveVerb() {
    return leftOut("drive", "drive a robot's arms and trunk live, with a suit or with a take in real time");
}

}  // namespace noctule::batch
