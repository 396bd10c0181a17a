// SPDX-License-Identifier: Apache-2.0
// A motion file as it is understood: which joint is which, its unit and up axis from the body that it shows,
// lost tracking bridged, sides set right. Everything that was decided is said, with the option that corrects
// it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/body/actor.h"
#include "core/figure/joint_mapping.h"
#include "core/figure/lost_tracking.h"
#include "core/figure/up_axis.h"
#include "core/formats/bvh.h"

namespace noctule::figure {

/// What somebody knows better than the file shows.
struct MotionHints {
    BvhUnit unit = BvhUnit::kAuto;
    UpAxis up = UpAxis::kAuto;
    double height_m = 0;  ///< of the person; 0: as the file shows. Goes before the unit
    JointsByHand joints{};
};

struct UnderstoodMotion {
    MotionClip clip;  ///< metres, Y up, lost frames bridged
    JointMapping joints;
    std::vector<std::string> by_shape, by_hand;  ///< canonical joints that the names did not give
    BvhUnit unit = BvhUnit::kCentimetre;
    double metres_per_unit = 0.01;
    UpAxis up = UpAxis::kY;
    std::string rest_pose;  ///< in words: "T pose"
    BodyMeasures measures;
    LostTracking lost;
    std::vector<std::string> notes;     ///< what was done, one sentence each
    std::vector<std::string> warnings;  ///< what may be wrong, and the option that helps
};

/// kUnusable when there is no person in it, with the joints that are missing.
Result<UnderstoodMotion> understandMotion(BvhDocument document, const MotionHints& hints = {});

/// One line for people: frames, figure, unit, up axis, joints, zero pose.
std::string describe(const UnderstoodMotion& motion);
nlohmann::json toJson(const UnderstoodMotion& motion);

}  // namespace noctule::figure
