// SPDX-License-Identifier: Apache-2.0
#include "app/batch/verb.h"

namespace noctule::batch {

nlohmann::json errorJson(const Error& error) {
    return {
        {"exit_code", static_cast<int>(error.kind)}, {"message", error.message}, {"remedy", error.remedy}};
}

const std::vector<Verb>& verbs() {
    static const std::vector<Verb> all = {simulateVerb(),
                                          processVerb(),
                                          estimatorsVerb(),
                                          evaluateVerb(),
                                          exportVerb(),
                                          inspectVerb(),
                                          attachVerb(),
                                          devicesVerb(),
                                          recordVerb(),
                                          recoverVerb(),
                                          importVerb(),
                                          orientVerb(),
                                          robotVerb(),
                                          driveVerb(),
                                          calibrateSourcesVerb(),
                                          calibrateAccelerometersVerb(),
                                          calibrateGyroscopesVerb(),
                                          calibrateMagnetometersVerb(),
                                          calibrateInertialVerb(),
                                          calibrateRestPoseVerb(),
                                          calibrateMotionVerb(),
                                          calibrateRoomVerb(),
                                          checkVerb()};
    return all;
}

}  // namespace noctule::batch
