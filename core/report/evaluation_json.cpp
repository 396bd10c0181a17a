// SPDX-License-Identifier: Apache-2.0
#include "core/report/evaluation_json.h"

#include "core/math/json.h"
#include "core/report/range_statistics.h"
#include "core/report/verdict.h"

namespace noctule {
namespace {

using Json = nlohmann::json;

using json::orNull;

Json jointJson(const JointComparison& joint) {
    return {{"name", joint.name},
            {"mean_deg", orNull(joint.angle.mean_deg)},
            {"std_deg", orNull(joint.angle.std_deg)},
            {"rms_deg", orNull(joint.angle.rms_deg)},
            {"median_deg", orNull(joint.angle.median_deg)},
            {"p95_deg", orNull(joint.angle.p95_deg)},
            {"max_deg", orNull(joint.angle.max_deg)},
            {"drift_deg_per_min", orNull(joint.angle.drift_deg_per_min)},
            {"position_mm", orNull(joint.position_mm)},
            {"nees", orNull(joint.nees)},
            {"relative_to", joint.relative_to}};
}

void addComparison(Json& out, const Comparison& c) {
    for (const JointComparison& joint : c.joints)
        out["joints"].push_back(jointJson(joint));
    out["mean_deg"] = orNull(c.mean_deg);
    out["end_effector_mm"] = orNull(c.end_effector_mm);
    out["root"] = {{"yaw_deg", orNull(c.root.yaw_deg)},
                   {"tilt_deg", orNull(c.root.tilt_deg)},
                   {"position_m", orNull(c.root.position_m)}};
    out["nees"] = orNull(c.nees);
    out["duration_s"] = orNull(c.duration_s);
    out["frames"] = {{"compared", c.frames},
                     {"estimate_missing", c.estimate_missing},
                     {"reference_missing", c.reference_missing},
                     {"unmatched", c.unmatched}};
    out["reference_offset_s"] = static_cast<double>(c.offset.add_to_reference_ns) * 1e-9;
    out["reference_correlation"] = orNull(c.offset.correlation);
}

Json rangesJson(const RangeStatistics& r) {
    const std::optional<double> residual_m = r.residualRms_m();
    return {{"pulses", r.pulses()},
            {"heard", r.heard()},
            {"used", r.of(PulseFate::kUsed)},
            {"rejected", r.of(PulseFate::kRejected)},
            {"unused", r.of(PulseFate::kUnused)},
            {"occluded", r.of(PulseFate::kOccluded)},
            {"missing", r.of(PulseFate::kMissing)},
            {"residual_rms_mm", residual_m ? orNull(1000 * *residual_m) : Json(nullptr)}};
}

Json boardJson(const ReportBoard& board) {
    return {{"id", board.id},
            {"frames_expected", board.frames_expected},
            {"frames_lost", board.frames_lost},
            {"joined_s", orNull(board.joined_s)},
            {"left_s", orNull(board.left_s)},
            {"readings_expected", board.readings_expected},
            {"readings_present", board.readings_present},
            {"clipped_gyro", board.clipped_gyro},
            {"clipped_accel", board.clipped_accel},
            {"corrected_bits", board.corrected_bits}};
}

}  // namespace

Json evaluationJson(const ReportData& data, const ReportRun& run) {
    Json out = {{"take", data.take.name},
                {"run", run.name},
                {"sensors", run.sensors},
                {"joints", Json::array()},
                {"mean_deg", nullptr},
                {"end_effector_mm", nullptr},
                {"root", {{"yaw_deg", nullptr}, {"tilt_deg", nullptr}, {"position_m", nullptr}}},
                {"nees", nullptr},
                {"duration_s", nullptr},
                {"estimator", run.estimator},
                {"smoother", run.smoother},
                {"root_given", run.root_given},
                {"rest_s", orNull(data.take.rest_s)},
                {"reference_kind", data.take.reference_kind}};
    if (run.comparison)
        addComparison(out, *run.comparison);
    if (&run == data.shownRun()) {  // pulses and boards are those of the shown run
        const Verdict verdict = judge(data);
        out["verdict"] = gradeName(verdict.grade);
        out["reasons"] = verdict.reasons;
        out["ranges"] = rangesJson(rangeStatistics(data.pairs));
        out["boards"] = Json::array();
        for (const ReportBoard& board : data.boards)
            out["boards"].push_back(boardJson(board));
    }
    return out;
}

}  // namespace noctule
