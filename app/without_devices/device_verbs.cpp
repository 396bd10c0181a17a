// SPDX-License-Identifier: Apache-2.0
// Stand-ins for the verbs of app/batch/devices, linked where NOCTULE_DEVICES is OFF. Help lists them as left
// out.
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
    return leftOut("devices", kDevicesSummary);
}
Verb recordVerb() {
    return leftOut("record", kRecordSummary);
}
Verb driveVerb() {
    return leftOut("drive", kDriveSummary);
}

}  // namespace noctule::batch
