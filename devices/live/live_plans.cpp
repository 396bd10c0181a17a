// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_plans.h"

#include <algorithm>
#include <cmath>

#include "core/acoustics/range_finder.h"
#include "core/live/estimators.h"
#include "core/suit/calibration_entries.h"
#include "core/suit/calibration_lack.h"

namespace noctule {
namespace {

/// Of sound that may wait for the disk or the pipeline, without the pre-roll, which comes all at once.
constexpr double kQueue_s = 2;
/// The pipeline needs as long to find the body again after the link was lost (relocation.h).
constexpr double kRelocation_s = 2;

/// The performer holds the rest pose from the moment on at which the recording was asked for.
std::optional<std::pair<int64_t, int64_t>> restOf(const StreamRequest& request, int sample_rate_hz,
                                                  int64_t pre_roll_samples) {
    const int64_t samples = std::llround(request.rest_s * sample_rate_hz);
    return samples > 0
               ? std::optional(std::pair<int64_t, int64_t>{pre_roll_samples, pre_roll_samples + samples - 1})
               : std::nullopt;
}

std::vector<MarkerRow> markersOf(const StreamRequest& request, int sample_rate_hz, int64_t pre_roll_samples) {
    std::vector<MarkerRow> markers;
    if (pre_roll_samples > 0)
        markers.push_back({pre_roll_samples, "start", "Start"});
    if (const auto rest = restOf(request, sample_rate_hz, pre_roll_samples)) {
        markers.push_back({rest->first, "rest", "begin"});
        markers.push_back({rest->second, "rest", "end"});
    }
    return markers;
}

/// As the take's file will give it back, to the last bit.
template <class Document>
Result<Document> asStored(const Document& document,
                          Result<Document> (*fromJson)(const nlohmann::json&, const std::string&)) {
    return fromJson(toJson(document), "the live view");
}

/// From the start of a pulse to the inflection of its power, 17 to 20 samples (design, section 4).
constexpr double kUsualOffset_s = 1.3e-4;

bool knowsSources(const Calibration& calibration, Detector detector) {
    return std::ranges::any_of(calibration.sources, [&](const SourceCalibration& source) {
        return source.offsets_s.contains(detectorName(detector)) || source.offsets_s.contains("start") ||
               (shapeOf(source) && !source.offsets_s.empty());
    });
}

/// A suit whose sources were never calibrated is heard all the same: its distances are some centimetres off,
/// good for its health and for the jig's wizard, and for no pose.
void addUsualOffsets(const Suit& suit, Detector detector, Calibration& calibration) {
    for (const Source& source : suit.sources)
        entryOf(calibration, source).offsets_s[detectorName(detector)] = kUsualOffset_s;
}

/// Sound is heard once only: nothing can be learnt from it beforehand.
bool knowsPulses(const Calibration& calibration) {
    return !calibration.sources.empty() &&
           std::ranges::all_of(calibration.sources, [](const SourceCalibration& source) {
               return shapeOf(source) && !source.offsets_s.empty();
           });
}

}  // namespace

Detector detectorOf(const StreamRequest& request) {
    if (request.detector)
        return *request.detector;
    const EstimatorEntry* estimator = findEstimator(request.tracker.estimator);
    const bool matched = estimator && estimator->detector == Detector::kMatched && request.calibration &&
                         knowsPulses(*request.calibration);
    return matched ? Detector::kMatched : Detector::kInflection;
}

double queueLength_s(int64_t pre_roll_samples, int sample_rate_hz) {
    return kQueue_s + static_cast<double>(pre_roll_samples) / sample_rate_hz;
}

TakePlan takePlanOf(const StreamRequest& request, const link::Hello& hello, const Suit& suit,
                    int64_t pre_roll_samples) {
    TakePlan plan;
    plan.folder = request.take->folder;
    plan.name = request.take->name;
    plan.compress = request.take->compress;
    plan.suit = suit;
    plan.calibration = request.calibration;
    plan.actor = request.actor;
    plan.meta = request.take->meta;
    plan.meta["box_serial"] = hello.serial;
    TakeHeader& header = plan.header;
    header.created_utc = request.created_utc;
    header.software = request.software;
    header.sample_rate_hz = hello.sample_rate_hz;
    header.board_count = hello.boardCount();
    header.source_count = static_cast<int>(suit.sources.size());
    header.pulse_interval_samples = hello.pulse_interval_samples;
    header.pulse_cycles = hello.pulse_cycles;
    header.drive_hz = hello.drive_hz;
    header.take_kind = request.take->take_kind;
    plan.markers = markersOf(request, hello.sample_rate_hz, pre_roll_samples);
    return plan;
}

Result<LivePlan> livePlanOf(const StreamRequest& request, const link::Hello& hello, const Suit& worn,
                            int64_t pre_roll_samples) {
    const auto suit = asStored<Suit>(worn, suitFromJson);
    if (!suit)
        return suit.error();
    const auto actor =
        request.actor ? asStored<Actor>(*request.actor, actorFromJson) : Result<Actor>(defaultActor());
    if (!actor)
        return actor.error();
    auto calibration = request.calibration ? asStored<Calibration>(*request.calibration, calibrationFromJson)
                                           : Result<Calibration>(nominalCalibration(*suit));
    if (!calibration)
        return calibration.error();
    PipelineSettings pipeline;
    // Without gyroscopes' calibration a body would drift by tens of degrees a second: it is not shown, and
    // the time that the filter takes is left to the calibration.
    pipeline.tracks = !lackOf(*suit, *calibration).ofMostGyroscopes();
    const Detector detector = detectorOf(request);
    pipeline.decoder = {{static_cast<double>(hello.sample_rate_hz), hello.pulse_interval_samples,
                         hello.drive_hz, hello.pulse_cycles},
                        detector};
    pipeline.tracker = request.tracker;
    if (!knowsSources(*calibration, detector)) {
        addUsualOffsets(*suit, detector, *calibration);
        pipeline.tracker.sensors.distances = false;
    }
    pipeline.rest = restOf(request, hello.sample_rate_hz, pre_roll_samples);
    return LivePlan{*suit,
                    *calibration,
                    *actor,
                    pipeline,
                    queueLength_s(pre_roll_samples, hello.sample_rate_hz) + kRelocation_s,
                    request.pose_listener};
}

}  // namespace noctule
