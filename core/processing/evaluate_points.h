// SPDX-License-Identifier: Apache-2.0
// How well a table of points agrees with the reference in the take: the true place of each device follows
// from the reference's pose and where the suit's description and calibration say that the device sits. An
// error of that mounting and soft tissue count as error of the point.
#pragma once

#include "core/processing/points_table.h"

namespace noctule {

struct PointEvaluation {
    std::string subject, device;
    double rms_mm = 0;
};

struct PointsEvaluation {
    std::vector<PointEvaluation> points;
    double rms_mm = 0;                          ///< over all points and instants after the rest poses
    std::optional<double> between_rms_mm;       ///< of the vectors between points of two subjects
    std::optional<double> between_near_rms_mm;  ///< while nearer than 0.3 m
    /// Mean of |error|^2 / (3 sigma^2); 1 is honest. None without anchors: nothing measured the common place
    /// and turn of all points then.
    std::optional<double> nees;
    int64_t instants = 0;
    /// Over time, for figures: rms error and rms sigma of all points, m; nearest pair between subjects, m.
    std::vector<double> time_s, error_m, sigma_m, nearest_m, nearest_error_m;
};

/// kUnusable when the take has no reference of a subject in the table, or the table knows devices that the
/// take does not.
Result<PointsEvaluation> evaluatePoints(const std::string& take_path, const PointsTable& table,
                                        const JobContext& job);

/// Figures 3 and 4 of Welch 2018, of one table each: `names` one per evaluation.
std::string pointsReport(const std::string& take_name, const std::vector<std::string>& names,
                         const std::vector<PointsEvaluation>& evaluations);

}  // namespace noctule
