// SPDX-License-Identifier: Apache-2.0
#include "core/report/joints_csv.h"

#include <nlohmann/json.hpp>

#include "core/job/csv_cell.h"

namespace noctule {
namespace {

std::string cell(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? nlohmann::json(*value).dump() : "";
}

std::string jointRow(const std::vector<std::string>& texts, const JointComparison& joint) {
    const AngleStatistics& angle = joint.angle;
    std::string csv;
    for (const std::string& text : texts)
        csv += csvCell(text) + ",";
    for (const double value : {angle.mean_deg, angle.median_deg, angle.std_deg, angle.rms_deg, angle.p95_deg,
                               angle.max_deg, angle.drift_deg_per_min, joint.position_mm})
        csv += cell(value) + ",";
    return csv + cell(joint.nees) + "\n";
}

}  // namespace

std::string jointsCsv(const std::vector<SubjectReport>& subjects) {
    std::string csv =
        "take,subject,run,sensors,estimator,smoother,joint,relative_to,mean_deg,median_deg,std_deg,rms_deg,"
        "p95_deg,max_deg,drift_deg_per_min,position_mm,nees\n";
    for (const auto& [subject, data] : subjects)
        for (const ReportRun& run : data.runs)
            if (run.comparison)
                for (const JointComparison& joint : run.comparison->joints)
                    csv += jointRow({data.take.name, subject, run.name, run.sensors, run.estimator,
                                     run.smoother, joint.name, joint.relative_to},
                                    joint);
    return csv;
}

}  // namespace noctule
