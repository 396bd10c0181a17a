// SPDX-License-Identifier: Apache-2.0
// What the survey of a room found, for people and for machines.
#pragma once

#include <nlohmann/json.hpp>

#include "core/report/calibration_document.h"
#include "core/room_survey/room_survey.h"

namespace noctule {

/// Without date and takes.
CalibrationDocument documentOf(const room_survey::RoomSurvey& survey);
/// Members of this procedure alone.
nlohmann::json toJson(const room_survey::RoomSurvey& survey);

}  // namespace noctule
