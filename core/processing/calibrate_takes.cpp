// SPDX-License-Identifier: Apache-2.0
#include "core/processing/calibrate_takes.h"

#include <algorithm>

#include "core/processing/calibration_observations.h"
#include "core/report/calibration_documents.h"
#include "core/suit/calibration_entries.h"

namespace noctule {
namespace {

Result<Observations> observe(const std::string& path, const CalibrateRequest& request,
                             const JobContext& job) {
    const auto take = Take::open(path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    return readObservations(*take, request.detector, job, request.base, request.actor);
}

/// With an entry for every part of the suit: so it is plain what a solver changes.
Calibration completed(Calibration base, const Suit& suit) {
    for (const Board& board : suit.boards)
        entryOf(base, board);
    for (const Source& source : suit.sources)
        entryOf(base, source);
    return base;
}

struct Evidence {
    std::vector<Observations> takes;
    Calibration base;
};

/// Each of these boards is solved for by itself: without readings nothing is found of it.
void silence(const std::vector<std::string>& boards, std::vector<Observations>& takes) {
    for (Observations& take : takes)
        for (const std::string& id : boards)
            if (const int board = take.suit.findBoard(id); board >= 0)
                take.boards[static_cast<size_t>(board)].clear();
}

Result<Evidence> gather(const CalibrateRequest& request, const JobContext& job) {
    Evidence evidence;
    CalibrateRequest with_shapes = request;
    for (const std::string& path : request.take_paths) {
        auto observations = observe(path, with_shapes, job);
        if (!observations)
            return observations.error();
        if (request.detector == Detector::kMatched)  // learnt once: an offset goes with its pulse's shape
            with_shapes.base = observations->calibration;
        evidence.takes.push_back(std::move(*observations));
    }
    require(!evidence.takes.empty(), "a calibration without takes");
    evidence.base = completed(evidence.takes[0].calibration, evidence.takes[0].suit);
    const Calibration& last = evidence.takes.back().calibration;
    for (SourceCalibration& source : evidence.base.sources)
        if (const SourceCalibration* learnt = last.findSource(source.id)) {
            source.resonance_hz = learnt->resonance_hz;
            source.q = learnt->q;
        }
    return evidence;
}

/// The worst finding that concerns the part.
Grade gradeOfPart(const std::vector<Finding>& findings, const std::string& id) {
    Grade worst = Grade::kGood;
    for (const Finding& finding : findings)
        if (finding.concerns(id))
            worst = std::max(worst, finding.grade);
    return worst;
}

/// Of the calibration's JSON: what of a list differs from the base.
bool changed(const nlohmann::json& found, const nlohmann::json& base, const char* list,
             const std::string& id) {
    const auto entryOf = [&](const nlohmann::json& calibration) {
        const auto entry =
            std::ranges::find_if(calibration.at(list), [&](const auto& part) { return part.at("id") == id; });
        return entry == calibration.at(list).end() ? nlohmann::json() : *entry;
    };
    return entryOf(found) != entryOf(base);
}

/// Whose values they are and when they were made, on every part that has changed.
class Stamp {
public:
    Stamp(const std::string& procedure, const CalibrateRequest& request, const std::vector<Finding>& findings)
        : procedure_(procedure), created_utc_(request.created_utc), findings_(findings) {}

    /// `evidence`: of the suit that was calibrated.
    void put(Calibration& found, const Calibration& base, const Observations& evidence) const {
        const Suit& suit = evidence.suit;
        const nlohmann::json now = toJson(found), before = toJson(base);
        for (BoardCalibration& board : found.boards)
            if (const int index = suit.findBoard(board.id);
                index >= 0 && changed(now, before, "boards", board.id))
                put(board, suit.boards[static_cast<size_t>(index)].serial);
        for (SourceCalibration& source : found.sources)
            if (const int index = suit.findSource(source.id);
                index >= 0 && changed(now, before, "sources", source.id))
                put(source, suit.sources[static_cast<size_t>(index)].serial);
        found.created_utc = created_utc_;
        if (!evidence.box_serial.empty() && now != before)
            found.box_serial = evidence.box_serial;
    }

private:
    template <class Part>
    void put(Part& part, const std::string& serial) const {
        part.serial = serial;
        part.made[procedure_] = {created_utc_, gradeWord(gradeOfPart(findings_, part.id))};
    }

    std::string procedure_, created_utc_;
    const std::vector<Finding>& findings_;
};

/// Boards that were skipped are not judged by what of them was recorded all the same.
void leaveOut(const CalibrateRequest& request, const Evidence& evidence, const std::string& procedure,
              std::vector<Finding>& findings, Calibration& found) {
    for (const std::string& id : request.left_out) {
        const int index = evidence.takes[0].suit.findBoard(id);
        if (index < 0)
            continue;
        std::erase_if(findings, [&](const Finding& finding) { return finding.part == id; });
        if (procedure == "check")
            continue;  // it calibrates nothing
        findings.push_back({Grade::kUsable, id, id + " was skipped and keeps what it had",
                            "Repeat its steps when it is to be calibrated"});
        const Board& board = evidence.takes[0].suit.boards[static_cast<size_t>(index)];
        Calibration before = evidence.base;
        entryOf(found, board) = entryOf(before, board);
    }
}

template <class Report>
CalibrationResult resultOf(Report report, const CalibrateRequest& request, const Evidence& evidence,
                           const std::string& procedure, Calibration found) {
    leaveOut(request, evidence, procedure, report.findings, found);
    CalibrationResult result;
    Stamp(procedure, request, report.findings).put(found, evidence.base, evidence.takes[0]);
    result.calibration = std::move(found);
    result.document = documentOf(report);
    result.document.created_utc = request.created_utc;
    for (const Observations& take : evidence.takes)
        result.document.takes.push_back(take.take);
    result.json = toJson(report);
    result.json["procedure"] = procedure;
    result.json["takes"] = result.document.takes;
    result.json.update(findingsJson(report.findings));
    return result;
}

}  // namespace

Result<CalibrationResult> calibrateSources(const CalibrateRequest& request, const KnownDistances& known,
                                           const SourceOffsetSettings& settings, const JobContext& job) {
    const auto evidence = gather(request, job);
    if (!evidence)
        return evidence.error();
    const SourceOffsetReport report = calibrateSourceOffsets(evidence->takes, known, settings);
    return resultOf(report, request, *evidence, "sources", report.applied(evidence->base));
}

Result<CalibrationResult> calibrateAccelerometers(const CalibrateRequest& request, const JobContext& job) {
    auto evidence = gather(request, job);
    if (!evidence)
        return evidence.error();
    silence(request.left_out, evidence->takes);
    const AccelerometerReport report = calibrateAccelerometers(evidence->takes);
    return resultOf(report, request, *evidence, "accelerometers", report.applied(evidence->base));
}

Result<CalibrationResult> calibrateGyroscopes(const CalibrateRequest& request, double rpm,
                                              const JobContext& job) {
    auto evidence = gather(request, job);
    if (!evidence)
        return evidence.error();
    silence(request.left_out, evidence->takes);
    // A zero wanders from each to the one that came next.
    std::ranges::stable_sort(evidence->takes, {}, &Observations::began_s);
    const GyroscopeReport report = calibrateGyroscopes(evidence->takes, rpm);
    return resultOf(report, request, *evidence, "gyroscopes", report.applied(evidence->base));
}

Result<CalibrationResult> calibrateRestPose(const CalibrateRequest& request, const JobContext& job) {
    const auto evidence = gather(request, job);
    if (!evidence)
        return evidence.error();
    const Observations& take = evidence->takes[0];
    const auto report = calibrateRestPose(take, RestPoseSettings{}, job);
    if (!report)
        return report.error();
    return resultOf(*report, request, *evidence, "rest-pose", report->applied(evidence->base, take.suit));
}

Result<CalibrationResult> calibrateMotion(const CalibrateRequest& request, const JobContext& job) {
    const auto evidence = gather(request, job);
    if (!evidence)
        return evidence.error();
    const auto report = calibrateMotion(evidence->takes, MotionSettings{}, job);
    if (!report)
        return report.error();
    const Observations& take = evidence->takes[0];
    auto result = resultOf(*report, request, *evidence, "motion", report->applied(evidence->base, take.suit));
    result.actor = report->applied(take.actor);
    return result;
}

Result<CalibrationResult> checkStill(const CalibrateRequest& request, const JobContext& job) {
    const auto evidence = gather(request, job);
    if (!evidence)
        return evidence.error();
    const StillCheckReport report = checkStill(evidence->takes[0]);
    return resultOf(report, request, *evidence, "check", evidence->base);
}

}  // namespace noctule
