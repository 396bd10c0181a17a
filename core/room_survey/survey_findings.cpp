// SPDX-License-Identifier: Apache-2.0
#include "core/body/text.h"
#include "core/room_survey/room_survey.h"

namespace noctule::room_survey {
namespace {

constexpr double kUsable_m = 0.050;          ///< sigma of an anchor
constexpr double kUsableAgreement_m = 0.04;  ///< median residual

std::string namesOf(const std::vector<int>& anchors, const RoomSurvey& survey) {
    std::string names;
    for (const int anchor : anchors)
        names += (names.empty() ? "" : ", ") + survey.anchors[static_cast<size_t>(anchor)].id;
    return names;
}

std::string weakness(const SurveyedAnchor& anchor, const RoomSurvey& survey) {
    std::string heard = namesOf(anchor.hears, survey);
    if (anchor.ranges > 0)
        heard += (heard.empty() ? "" : ", ") + survey.performer;
    const std::string missing = namesOf(anchor.hears_not, survey);
    const std::string weak =
        "Anchor " + anchor.id + " is weak, ±" + text::number(1000 * anchor.sigma_m, 0) + " mm";
    if (missing.empty())
        return weak + ": it hears " + heard;
    return weak + ": it hears " + heard + ", but not " + missing;
}

void addAnchor(const SurveyedAnchor& anchor, const RoomSurvey& survey, std::vector<Finding>& findings) {
    const std::string walk = "Walk slowly past it, face it from several sides, and see that nothing hides it";
    if (anchor.moved)
        findings.push_back({Grade::kNotUsable, anchor.id,
                            "Anchor " + anchor.id + " was moved by " +
                                text::number(anchor.moved->distance_m, 2) + " m, " +
                                text::number(anchor.moved->time_s, 0) + " s into the take",
                            "Fasten it and record again"});
    else if (!anchor.placed)
        findings.push_back(
            {Grade::kNotUsable, anchor.id,
             anchor.ranges == 0 && anchor.hears.empty()
                 ? "Anchor " + anchor.id + " was never heard"
                 : "Anchor " + anchor.id + " was heard too rarely to be placed",
             "Check its cable and what stands in front of it, or take it out of the room's file"});
    else if (anchor.mirrored)
        findings.push_back({Grade::kNotUsable, anchor.id,
                            "Anchor " + anchor.id +
                                " may as well hang at a second place, its mirror image: the "
                                "ranges do not tell which",
                            "Walk more widely and turn, or measure heights of anchors (--height)"});
    else if (anchor.sigma_m > kGoodAnchor_m)
        findings.push_back({anchor.sigma_m > kUsable_m ? Grade::kNotUsable : Grade::kUsable, anchor.id,
                            weakness(anchor, survey), walk});
}

void addFrame(const RoomSurvey& survey, const Evidence& evidence, std::vector<Finding>& findings) {
    const RoomFrame& frame = survey.frame;
    if (!frame.of_performer)
        findings.push_back(
            {Grade::kUsable, "",
             frame.level_rad > 0 ? "Nobody walked past the anchors: place, heading and which of two mirror "
                                   "images it is are taken from the room's file"
                                 : "Nobody walked past the anchors: place, heading, level and which of two "
                                   "mirror images it is are taken from the room's file",
             "Record a take with somebody in a suit, or measure the heights of three anchors (--height)"});
    else if (frame.fixed < 6)
        findings.push_back(
            {Grade::kNotUsable, "",
             "Only " + std::to_string(frame.fixed) + " of the six freedoms of the whole room are held",
             "Stand still in the rest pose at the beginning, in sight of all anchors"});
    if (!evidence.walk.empty() && !evidence.clock_known)
        findings.push_back(
            {Grade::kUsable, "",
             "The clocks of " + survey.performer + " and the room are known from this walk alone",
             "Wear a suit whose boards and sources share housings, or join the boxes with a sync cable"});
}

}  // namespace

std::vector<Finding> findingsOf(const RoomSurvey& survey, const Evidence& evidence) {
    std::vector<Finding> findings;
    for (const SurveyedAnchor& anchor : survey.anchors)
        addAnchor(anchor, survey, findings);
    if (survey.median_m > kGoodAgreement_m)
        findings.push_back(
            {survey.median_m > kUsableAgreement_m ? Grade::kNotUsable : Grade::kUsable, "",
             "The distances disagree by " + text::number(1000 * survey.median_m, 0) + " mm in the median",
             "Calibrate the suit, and see that straps sit tight"});
    if (!survey.converged)
        findings.push_back({Grade::kNotUsable, "", "The survey did not come to an end",
                            "Record again, slowly past all anchors"});
    addFrame(survey, evidence, findings);
    return findings;
}

}  // namespace noctule::room_survey
