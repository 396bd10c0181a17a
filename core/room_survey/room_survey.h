// SPDX-License-Identifier: Apache-2.0
// The survey of a room: every anchor's place with its covariance, how well the distances agree, which anchor
// is weak and why, and what of the whole room's place is known at all.
//
// Distances alone leave the room's place, its heading, its level and its handedness free. With a performer
// they are those of the rest pose: the origin is below the hips, +z is where the performer faces, y = 0 is
// where the feet stand, up is what the suit's accelerometers say on the whole way. Without one they are those
// of the room's file, which is said; heights that an operator measured level the room in both cases.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "core/calibration/findings.h"
#include "core/room_survey/moved_anchor.h"

namespace noctule::room_survey {

inline constexpr double kGoodAnchor_m = 0.010;     ///< sigma of an anchor up to which it is good
inline constexpr double kGoodAgreement_m = 0.015;  ///< median residual

struct SurveyedAnchor {
    std::string id;
    bool placed = false;
    Vector3d place_m = Vector3d::Zero(), microphone_m = Vector3d::Zero(), source_m = Vector3d::Zero();
    Matrix3d cov_m2 = Matrix3d::Zero();  ///< relative to the other anchors
    double sigma_m = 0;                  ///< along its worst axis
    int sent = 0, heard = 0;
    int ranges = 0;  ///< to the performer
    std::vector<int> hears, hears_not;
    bool mirrored = false;
    std::optional<AnchorMove> moved{};
    bool left_out = false;  ///< by the operator: it is not used

    bool isUsed() const { return placed && !left_out; }
    double heardShare() const { return sent > 0 ? static_cast<double>(heard) / sent : 0; }
};

struct SurveyedDistance {
    int a = 0, b = 0;
    double distance_m = 0, sigma_m = 0;
    std::optional<double> measured_m{};  ///< none: not heard
};

/// Of place, level and heading of the whole room.
struct RoomFrame {
    bool of_performer = false;
    int fixed = 0;  ///< of six degrees of freedom, by what was measured; the others are the file's
    double floor_m = 0, level_rad = 0, heading_rad = 0;  ///< sigma; 0: not measured
};

struct RoomSurvey {
    std::vector<SurveyedAnchor> anchors;
    std::vector<SurveyedDistance> distances;  ///< of all pairs that are placed
    std::vector<Vector3d> walked_m;           ///< where the performer was, twice a second
    Eigen::MatrixXd cov_m2;                   ///< of the anchors that are placed, relative to each other
    RoomFrame frame;
    std::string performer;
    double median_m = 0, rms_m = 0;  ///< residuals
    double flesh_m = 0;              ///< error of devices on the body, as learnt
    int ranges = 0, iterations = 0;
    bool converged = false;
    std::vector<Finding> findings;

    double worstSigma_m() const;
};

/// Fails (kUnusable) when there is nothing to survey: fewer than three anchors, anchors that neither sound
/// nor were walked past, too few ranges. Whatever can be surveyed yields a result with findings.
Result<RoomSurvey> surveyRoom(const Evidence& evidence, const FitSettings& settings, const JobContext& job);

/// Whether enough anchors are used without it.
bool canLeaveOut(const RoomSurvey& survey, size_t anchor);
/// Leaves out anchors that the operator does without: what is said of them and their distances go, their
/// places stay. Fails (kUsage) when too few would be used.
Status leaveOut(RoomSurvey& survey, const std::vector<size_t>& anchors);

/// What is said of it; in survey_findings.cpp.
std::vector<Finding> findingsOf(const RoomSurvey& survey, const Evidence& evidence);

}  // namespace noctule::room_survey
