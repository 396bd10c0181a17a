// SPDX-License-Identifier: Apache-2.0
// Where the joints of a figure are, found in its surface: ends of the limbs, rings around them, the heights
// at which legs and trunk meet, and proportions (Winter, "Biomechanics and Motor Control of Human Movement",
// 4th ed., figure 4.1) where nothing shows. Corrected by hand in the studio.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/job/result.h"
#include "core/mesh/triangle_mesh.h"

namespace noctule {

/// Place in metres by canonical joint name; the tips of head, hands and toes as "HeadEnd", "LeftHandEnd",
/// "LeftToeBaseEnd".
using Landmarks = std::map<std::string, Vector3d>;

/// Names of all that findLandmarks() gives.
std::vector<std::string> landmarkNames();

/// Those that a bone joins: a joint and the one above it, a joint and its tip.
std::vector<std::pair<std::string, std::string>> landmarkBones();

/// Of a figure that stands upright (Y up, Z forward) with its arms away from its body, T or A pose. Other
/// pieces than the largest (eyes, clothes) are not looked at. kUnusable with what was not found; `where`
/// names the mesh.
Result<Landmarks> findLandmarks(const TriangleMesh& figure, const std::string& where);

/// Those of the default actor at that height, soles on y = 0 above the origin, arms stretched out: to begin
/// with where nothing is found.
Landmarks typicalLandmarks(double height_m);

/// "LeftHand" -> "RightHand"; empty for one in the middle.
std::string otherSideOf(const std::string& landmark);
/// Puts a landmark, which must be there, at a place. `both_sides_alike`: the one of the other side goes to
/// the mirrored place, in the plane x = const of the hips, and one in the middle keeps its x.
void putLandmark(Landmarks& landmarks, const std::string& name, const Vector3d& p_m, bool both_sides_alike);

nlohmann::json toJson(const Landmarks& landmarks);
/// kUnreadable when a landmark is missing or no place.
Result<Landmarks> landmarksFromJson(const nlohmann::json& json, const std::string& where);

}  // namespace noctule
