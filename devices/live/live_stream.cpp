// SPDX-License-Identifier: Apache-2.0
// The beginning and the end of a LiveSession's stream.
#include <cmath>

#include "devices/live/live_session.h"

namespace noctule {
namespace {

std::optional<std::pair<int64_t, int64_t>> restOf(const StreamRequest& request, int sample_rate_hz) {
    const int64_t samples = std::llround(request.rest_s * sample_rate_hz);
    return samples > 0 ? std::optional(std::pair<int64_t, int64_t>{0, samples - 1}) : std::nullopt;
}

TakePlan planOf(const StreamRequest& request, const link::Hello& hello, const Suit& suit) {
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
    if (const auto rest = restOf(request, hello.sample_rate_hz))
        plan.markers = {{rest->first, "rest", "begin"}, {rest->second, "rest", "end"}};
    return plan;
}

/// As the take's file will give it back, to the last bit.
template <class Document>
Result<Document> asStored(const Document& document,
                          Result<Document> (*fromJson)(const nlohmann::json&, const std::string&)) {
    return fromJson(toJson(document), "the live view");
}

Result<LivePlan> livePlanOf(const StreamRequest& request, const link::Hello& hello, const Suit& worn) {
    const auto suit = asStored<Suit>(worn, suitFromJson);
    if (!suit)
        return suit.error();
    const auto actor =
        request.actor ? asStored<Actor>(*request.actor, actorFromJson) : Result<Actor>(defaultActor());
    if (!actor)
        return actor.error();
    const auto calibration = request.calibration
                                 ? asStored<Calibration>(*request.calibration, calibrationFromJson)
                                 : Result<Calibration>(nominalCalibration(*suit));
    if (!calibration)
        return calibration.error();
    PipelineSettings pipeline;
    pipeline.decoder = {{static_cast<double>(hello.sample_rate_hz), hello.pulse_interval_samples,
                         hello.drive_hz, hello.pulse_cycles},
                        request.detector};
    pipeline.tracker = request.tracker;
    pipeline.rest = restOf(request, hello.sample_rate_hz);
    return LivePlan{*suit, *calibration, *actor, pipeline};
}

}  // namespace

Result<std::shared_ptr<Recorder>> LiveSession::makeRecorder(const StreamRequest& request,
                                                            const link::Hello& hello, const Suit& suit) {
    auto file = makeTakeFile(planOf(request, hello, suit));
    if (!file)
        return file.error();
    RecorderSettings settings;
    settings.sample_rate_hz = hello.sample_rate_hz;
    settings.reserve_bytes = request.take->reserve_bytes;
    return std::make_shared<Recorder>(std::move(*file), settings);
}

void LiveSession::startProcessor(Stream& stream, const link::Hello& hello, const Suit& suit) {
    const auto plan = livePlanOf(stream.request, hello, suit);
    if (!plan) {
        stream.not_processed = plan.error();
        return;
    }
    std::optional<ResultSpool> spool;
    if (stream.request.keep_results && stream.request.take) {
        auto made = ResultSpool::make(stream.request.take->folder);
        if (made)
            spool = std::move(*made);
        else
            stream.warnings.push_back(made.error().text() + ".");
    }
    auto started = LiveProcessor::start(*plan, std::move(spool));
    if (started)
        stream.processor = std::move(*started);
    else
        stream.not_processed = started.error();
}

Status LiveSession::begin(const StreamRequest& request) {
    const auto now = status();
    if (now->link != LinkState::kReady || now->stream_is_open || !now->hello)
        return Error{ErrorKind::kDevice, device_->address() + ": is not ready to start",
                     "Wait until the driver box has answered and the stream before has ended"};
    finish();
    const link::Hello& hello = *now->hello;
    const auto suit =
        request.suit ? link::placedBySerial(hello.suit, *request.suit) : Result<Suit>(hello.suit);
    if (!suit)
        return suit.error();
    auto stream = std::make_shared<Stream>();
    stream->request = request;
    if (request.take) {
        auto recorder = makeRecorder(request, hello, *suit);
        if (!recorder)
            return recorder.error();
        stream->recorder = *recorder;
    }
    if (request.process)
        startProcessor(*stream, hello, *suit);
    stream->feed = std::make_shared<StreamFeed>(stream->recorder, stream->processor, hello.boardCount(),
                                                hello.sample_rate_hz);
    change([&](SessionStatus& s) {
        stream_ = stream;
        started_ = false;
        s.stream_is_open = true;
        s.link = LinkState::kStarting;
        s.trouble.reset();
    });
    device_->start();
    return Done{};
}

void LiveSession::keepResults(Stream& stream, StreamResult& result) {
    std::optional<ResultSpool>& spool = stream.processor->spool();
    const RecorderState& recording = *result.recording;
    if (!spool)
        return;
    // Only what the file holds to the last sample, and nothing else, may stand in it as its result.
    if (recording.trouble || recording.queue.dropped_samples > 0 || result.frame->queue.dropped_samples > 0) {
        result.warnings.push_back(
            "The live results are not those of the take, which lacks some of the sound "
            "or has more of it; process it.");
        return;
    }
    ProcessRequest request;
    request.take_path = recording.path;
    request.tracker = stream.request.tracker;
    request.detector = stream.request.detector;
    request.software = stream.request.software;
    request.created_utc = stream.request.created_utc;
    auto written = writeRuns(
        request, [&](const Take&, const Ingredients&, ResultRuns& runs) { return spool->replay(runs); });
    if (written)
        result.results = std::move(*written);
    else
        result.warnings.push_back("The live results are not in the take: " + written.error().text() + ".");
}

StreamResult LiveSession::finish() {
    std::shared_ptr<Stream> stream;
    StreamResult result;
    if (const auto open = feed())
        open->flush();
    change([&](SessionStatus& s) {
        stream.swap(stream_);
        s.stream_is_open = false;
        started_ = false;
        if (stream && s.link != LinkState::kRefused && s.link != LinkState::kClosed &&
            s.link != LinkState::kLost)
            s.link = LinkState::kReady;
        result.trouble = stream ? s.trouble : std::nullopt;
    });
    if (!stream)
        return result;
    result.warnings = stream->warnings;
    if (stream->recorder)
        result.recording = stream->recorder->finish();
    if (stream->processor) {
        stream->processor->finish();
        result.frame = stream->processor->latest();
        if (result.recording)
            keepResults(*stream, result);
    }
    if (const auto trouble = stream->processingTrouble())
        result.warnings.push_back("Nothing is processed live: " + trouble->text() + ".");
    return result;
}

}  // namespace noctule
