// SPDX-License-Identifier: Apache-2.0
#include "core/report/room_document.h"

#include <algorithm>

#include "core/body/text.h"

namespace noctule {
namespace {

using room_survey::kGoodAgreement_m;
using room_survey::kGoodAnchor_m;
using room_survey::RoomSurvey;
using room_survey::SurveyedAnchor;
using room_survey::SurveyedDistance;

std::string inMillimetres(double value_m) {
    return text::number(1000 * value_m, 1);
}

CalibrationTable anchorTable(const RoomSurvey& survey) {
    CalibrationTable table{"Anchors",
                           "Sigma is that against the other anchors, along the worst axis.",
                           {"anchor", "x, m", "height, m", "z, m", "sigma, mm", "heard", "ranges"},
                           {}};
    for (const SurveyedAnchor& anchor : survey.anchors) {
        std::vector<std::string> row{anchor.id};
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            row.push_back(anchor.isUsed() ? text::number(anchor.place_m[axis], 3) : "–");
        row.push_back(anchor.isUsed() ? inMillimetres(anchor.sigma_m) : "–");
        row.push_back(std::to_string(anchor.heard) + " of " + std::to_string(anchor.sent));
        row.push_back(std::to_string(anchor.ranges));
        table.rows.push_back(std::move(row));
    }
    return table;
}

CalibrationTable distanceTable(const RoomSurvey& survey) {
    CalibrationTable table{"Distances between anchors",
                           "From microphone and source of a housing to those of the other, middle to middle.",
                           {"from, to", "surveyed, m", "sigma, mm", "measured, m"},
                           {}};
    for (const SurveyedDistance& one : survey.distances)
        table.rows.push_back({survey.anchors[static_cast<size_t>(one.a)].id + ", " +
                                  survey.anchors[static_cast<size_t>(one.b)].id,
                              text::number(one.distance_m, 3), inMillimetres(one.sigma_m),
                              one.measured_m ? text::number(*one.measured_m, 3) : "not heard"});
    return table;
}

std::string frameSentence(const RoomSurvey& survey) {
    if (!survey.frame.of_performer)
        return "Place and heading are those of the room's file";
    return "The origin is where " + survey.performer + " stood in the rest pose, facing +z; level to " +
           text::number(degrees(survey.frame.level_rad), 2) + "°, floor to " +
           inMillimetres(survey.frame.floor_m) + " mm";
}

}  // namespace

CalibrationDocument documentOf(const RoomSurvey& survey) {
    size_t placed = 0;
    for (const SurveyedAnchor& anchor : survey.anchors)
        placed += anchor.isUsed();
    const auto left_out = std::ranges::count_if(survey.anchors, &SurveyedAnchor::left_out);
    const auto grade = [](bool good) { return good ? Grade::kGood : Grade::kUsable; };
    CalibrationDocument found;
    found.procedure = "Room";
    found.summary = std::to_string(placed) + " of " + std::to_string(survey.anchors.size()) +
                    " anchors are placed, the weakest to ±" + inMillimetres(survey.worstSigma_m()) + " mm. " +
                    frameSentence(survey);
    if (left_out > 0)
        found.summary += ". Anchors left out: " + std::to_string(left_out);
    found.findings = survey.findings;
    found.tables = {anchorTable(survey), distanceTable(survey)};
    found.numbers = {{inMillimetres(survey.worstSigma_m()) + " mm", "sigma of the weakest anchor",
                      "under " + text::number(1000 * kGoodAnchor_m, 0) + " mm",
                      grade(survey.worstSigma_m() <= kGoodAnchor_m)},
                     {inMillimetres(survey.median_m) + " mm", "agreement of the distances, median",
                      "under " + text::number(1000 * kGoodAgreement_m, 0) + " mm",
                      grade(survey.median_m <= kGoodAgreement_m)},
                     {inMillimetres(survey.rms_m) + " mm", "the same, rms without echoes", "", Grade::kGood},
                     {std::to_string(survey.frame.fixed) + " of 6",
                      "freedoms of the whole room that were measured", "6", grade(survey.frame.fixed == 6)}};
    return found;
}

nlohmann::json toJson(const RoomSurvey& survey) {
    const auto vector = [](const Vector3d& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
    const auto names = [&](const std::vector<int>& anchors) {
        nlohmann::json list = nlohmann::json::array();
        for (const int anchor : anchors)
            list.push_back(survey.anchors[static_cast<size_t>(anchor)].id);
        return list;
    };
    nlohmann::json anchors = nlohmann::json::array(), distances = nlohmann::json::array();
    for (const SurveyedAnchor& anchor : survey.anchors) {
        nlohmann::json one{
            {"id", anchor.id},
            {"placed", anchor.placed},
            {"left_out", anchor.left_out},
            {"sent", anchor.sent},
            {"heard", anchor.heard},
            {"ranges", anchor.ranges},
            {"hears", names(anchor.hears)},
            {"hears_not", names(anchor.hears_not)},
            {"mirrored", anchor.mirrored},
            {"moved_m", anchor.moved ? nlohmann::json(anchor.moved->distance_m) : nlohmann::json(nullptr)}};
        if (anchor.placed) {
            one.update({{"place_m", vector(anchor.place_m)},
                        {"microphone_m", vector(anchor.microphone_m)},
                        {"source_m", vector(anchor.source_m)},
                        {"sigma_mm", 1000 * anchor.sigma_m},
                        {"cov_m2",
                         {vector(anchor.cov_m2.row(0)), vector(anchor.cov_m2.row(1)),
                          vector(anchor.cov_m2.row(2))}}});
        }
        anchors.push_back(std::move(one));
    }
    for (const SurveyedDistance& one : survey.distances)
        distances.push_back(
            {{"a", survey.anchors[static_cast<size_t>(one.a)].id},
             {"b", survey.anchors[static_cast<size_t>(one.b)].id},
             {"distance_m", one.distance_m},
             {"sigma_mm", 1000 * one.sigma_m},
             {"measured_m", one.measured_m ? nlohmann::json(*one.measured_m) : nlohmann::json(nullptr)}});
    return {
        {"anchors", std::move(anchors)},
        {"distances", std::move(distances)},
        {"performer", survey.performer.empty() ? nlohmann::json(nullptr) : nlohmann::json(survey.performer)},
        {"frame",
         {{"of", survey.frame.of_performer ? "performer" : "file"},
          {"fixed", survey.frame.fixed},
          {"level_deg", degrees(survey.frame.level_rad)},
          {"floor_mm", 1000 * survey.frame.floor_m},
          {"heading_deg", degrees(survey.frame.heading_rad)}}},
        {"agreement", {{"median_mm", 1000 * survey.median_m}, {"rms_mm", 1000 * survey.rms_m}}},
        {"flesh_mm", 1000 * survey.flesh_m},
        {"ranges", survey.ranges},
        {"iterations", survey.iterations},
        {"converged", survey.converged}};
}

}  // namespace noctule
