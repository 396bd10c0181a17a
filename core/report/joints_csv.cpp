// SPDX-License-Identifier: Apache-2.0
#include "core/report/joints_csv.h"

#include <nlohmann/json.hpp>

#include "core/job/csv_cell.h"

namespace noctule {
namespace {

std::string cell(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? nlohmann::json(*value).dump() : "";
}

}  // namespace

std::string jointsCsv(const ReportData& data) {
    std::string csv =
        "take,run,sensors,estimator,smoother,joint,relative_to,mean_deg,median_deg,std_deg,rms_deg,p95_deg,"
        "max_deg,drift_deg_per_min,position_mm,nees\n";
    for (const ReportRun& run : data.runs) {
        if (!run.comparison)
            continue;
        for (const JointComparison& joint : run.comparison->joints) {
            const AngleStatistics& angle = joint.angle;
            for (const std::string& text : {data.take.name, run.name, run.sensors, run.estimator,
                                            run.smoother, joint.name, joint.relative_to})
                csv += csvCell(text) + ",";
            for (const double value :
                 {angle.mean_deg, angle.median_deg, angle.std_deg, angle.rms_deg, angle.p95_deg,
                  angle.max_deg, angle.drift_deg_per_min, joint.position_mm})
                csv += cell(value) + ",";
            csv += cell(joint.nees) + "\n";
        }
    }
    return csv;
}

}  // namespace noctule
