// SPDX-License-Identifier: Apache-2.0
// The calibrations from file to file: takes in, a calibration and what is to be said about it out. The same
// jobs for the command line and the studio.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/acoustics/pulse_detector.h"
#include "core/calibration/observations.h"
#include "core/calibration/source_offsets/known_distances.h"
#include "core/calibration/source_offsets/source_offsets.h"
#include "core/job/job.h"
#include "core/report/calibration_document.h"

namespace noctule {

struct CalibrateRequest {
    std::vector<std::string> take_paths;  ///< of one suit
    Detector detector = Detector::kInflection;
    /// Values stay where nothing new is found; none: the one in force in the first take, nominal where it
    /// has none.
    std::optional<Calibration> base;
    std::optional<Actor> actor;  ///< none: the one in force in the take
    std::string created_utc;
    std::vector<std::string>
        left_out{};  ///< ids of boards that the operator skipped: they keep what they had
};

struct CalibrationResult {
    /// The base with what was found, named after the box of the first take. Parts whose values changed carry
    /// their serial number and when and how well they were calibrated.
    Calibration calibration;
    CalibrationDocument document;         ///< for people
    nlohmann::json json;                  ///< values, sigmas, residuals, verdict, reasons: for machines
    std::optional<Actor> actor{};         ///< with new measures, where a procedure finds any
    std::optional<Suit> room{};           ///< of a survey: the room's file, which is its result
    std::vector<std::string> warnings{};  ///< whole sentences

    Grade grade() const { return gradeOf(document.findings); }
};

Result<CalibrationResult> calibrateSources(const CalibrateRequest& request, const KnownDistances& known,
                                           const SourceOffsetSettings& settings, const JobContext& job);
Result<CalibrationResult> calibrateAccelerometers(const CalibrateRequest& request, const JobContext& job);
/// `rpm` 0: as the takes state it.
Result<CalibrationResult> calibrateGyroscopes(const CalibrateRequest& request, double rpm,
                                              const JobContext& job);
/// Of one take.
Result<CalibrationResult> calibrateRestPose(const CalibrateRequest& request, const JobContext& job);
/// Of takes of one performer; the result's actor has the bones found.
Result<CalibrationResult> calibrateMotion(const CalibrateRequest& request, const JobContext& job);
/// A still pose against the request's calibration; the result's calibration is that one.
Result<CalibrationResult> checkStill(const CalibrateRequest& request, const JobContext& job);

}  // namespace noctule
