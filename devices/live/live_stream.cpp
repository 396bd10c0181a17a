// SPDX-License-Identifier: Apache-2.0
// The beginning and the end of a LiveSession's streams.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "core/processing/write_runs.h"
#include "devices/live/live_plans.h"
#include "devices/live/live_session.h"
#include "devices/machine/clock.h"

namespace noctule {
namespace {

/// Beyond what is held for the longest pre-roll: a slow disk may need so long to make the file, and a slow
/// machine to see what arrived.
constexpr double kSpareHeld_s = 5;

}  // namespace

Result<std::shared_ptr<Recorder>> LiveSession::makeRecorder(const StreamRequest& request,
                                                            const link::Hello& hello, const Suit& suit,
                                                            int64_t pre_roll_samples, Sink into) {
    if (!into) {
        auto file = makeTakeFile(takePlanOf(request, hello, suit, pre_roll_samples));
        if (!file)
            return file.error();
        into = std::move(*file);
    }
    RecorderSettings settings;
    settings.sample_rate_hz = hello.sample_rate_hz;
    settings.reserve_bytes = request.take->reserve_bytes;
    settings.queue_s = queueLength_s(pre_roll_samples, hello.sample_rate_hz);
    return std::make_shared<Recorder>(std::move(into), settings);
}

void LiveSession::startProcessor(Stream& stream, const link::Hello& hello, const Suit& suit,
                                 int64_t pre_roll_samples) {
    const auto plan = livePlanOf(stream.request, hello, suit, pre_roll_samples);
    if (!plan) {
        stream.not_processed = plan.error();
        return;
    }
    stream.request.tracker = plan->pipeline.tracker;  // results name what they were made with
    std::optional<ResultSpool> spool;
    if (stream.request.keep_results && stream.request.take && !plan->pipeline.tracks) {
        stream.warnings.push_back(
            "The suit is not calibrated: all of its sound is kept, but no poses. Process the take with a "
            "calibration.");
    } else if (stream.request.keep_results && stream.request.take) {
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

Result<LiveSession::StreamPointer> LiveSession::makeStream(const StreamRequest& request,
                                                           const link::Hello& hello, int64_t pre_roll_samples,
                                                           Sink into) {
    const auto suit =
        request.suit ? link::placedBySerial(hello.suit, *request.suit) : Result<Suit>(hello.suit);
    if (!suit)
        return suit.error();
    auto stream = std::make_shared<Stream>();
    stream->request = request;
    if (request.take) {
        auto recorder = makeRecorder(request, hello, *suit, pre_roll_samples, std::move(into));
        if (!recorder)
            return recorder.error();
        stream->recorder = *recorder;
    }
    if (request.process)
        startProcessor(*stream, hello, *suit, pre_roll_samples);
    return stream;
}

Error LiveSession::notReady() const {
    return {ErrorKind::kDevice, device_->address() + ": is not ready to start",
            "Wait until the driver box has answered and the stream before has ended"};
}

Status LiveSession::begin(const StreamRequest& request, std::unique_ptr<TakeSink> into) {
    const std::lock_guard one_at_a_time(control_);
    const auto now = status();
    const bool flows = now->link == LinkState::kStreaming || now->link == LinkState::kStalled;
    if (now->stream_is_open && flows)
        return beginInMidst(request, *now->hello, std::move(into));
    if (now->stream_is_open || now->link != LinkState::kReady)
        return notReady();
    while (newest())
        finishNewest({});
    return beginWithDevice(request, *now->hello, std::move(into));
}

Status LiveSession::beginWithDevice(const StreamRequest& request, const link::Hello& hello, Sink into) {
    const auto made = makeStream(request, hello, 0, std::move(into));
    if (!made)
        return made.error();
    const StreamPointer& stream = *made;
    stream->feed = std::make_shared<StreamFeed>(stream->recorder, stream->processor, hello.boardCount(),
                                                StreamFeed::Clock{hello.sample_rate_hz, 0});
    {
        const std::lock_guard lock(order_);
        feeds_ = {stream->feed};
        board_count_ = hello.boardCount();
        if (!request.take)
            past_.emplace(std::llround((kLongestPreRoll_s + kSpareHeld_s) * hello.sample_rate_hz));
    }
    is_silent_ = false;
    newest_sound_ns_ = steadyNow_ns();
    change([&](SessionStatus& s) {
        stream_ = stream;
        due_sample_.reset();
        s.stream_is_open = true;
        s.link = LinkState::kStarting;
        s.trouble.reset();
    });
    device_->start();
    return Done{};
}

Status LiveSession::beginInMidst(const StreamRequest& request, const link::Hello& hello, Sink into) {
    int64_t origin = 0, pre_roll_samples = 0;
    {
        const std::lock_guard lock(order_);
        if (!request.take || !past_ || newest() != stream_)
            return notReady();
        const double pre_roll_s = std::clamp(request.take->pre_roll_s, 0.0, kLongestPreRoll_s);
        const int64_t now = past_->endSample();
        const int64_t seen = std::min(now, request.take->seen_sample.value_or(now));
        origin = past_->boundaryAt(seen - std::llround(pre_roll_s * hello.sample_rate_hz));
        pre_roll_samples = now - origin;
    }
    // The stream goes on giving its poses: those of a second pipeline would come between them.
    StreamRequest of_take = request;
    if (const auto looked_at = newest(); looked_at->processor && looked_at->request.pose_listener)
        of_take.pose_listener = {};
    const auto made = makeStream(of_take, hello, pre_roll_samples, std::move(into));
    if (!made)
        return made.error();
    const StreamPointer& stream = *made;
    stream->feed = std::make_shared<StreamFeed>(stream->recorder, stream->processor, hello.boardCount(),
                                                StreamFeed::Clock{hello.sample_rate_hz, origin});
    // The device's thread waits for this: some milliseconds, in which its link goes on buffering.
    const std::lock_guard lock(order_);
    for (const StreamEvent& event : past_->since(origin))
        stream->feed->take(event);
    feeds_.push_back(stream->feed);
    const std::lock_guard state_lock(mutex_);
    take_ = stream;
    return Done{};
}

void LiveSession::keepResults(Stream& stream, StreamResult& result) {
    std::optional<ResultSpool>& spool = stream.processor->spool();
    const RecorderState& recording = *result.recording;
    if (!spool)
        return;
    // Only what the file holds to the last sample, and nothing else, may stand in it as its result.
    if (recording.trouble || recording.queue.dropped_samples > 0 || result.frame->queue.dropped_samples > 0) {
        result.lacks_poses = true;
        return;
    }
    if (result.frame->poses == 0 && stream.request.rest_s > 0 && recording.samples > 0) {
        result.warnings.push_back(
            "The take ended before its rest pose did. All of its sound is there, but no pose.");
        return;
    }
    ProcessRequest request;
    request.take_path = recording.path;
    request.tracker = stream.request.tracker;
    request.detector = detectorOf(stream.request);
    request.software = stream.request.software;
    request.created_utc = stream.request.created_utc;
    auto written = writeRuns(request, [&](const Take&, const Ingredients&, ResultRuns& runs) {
        const Status replayed = spool->replay(runs);
        return replayed ? runs.write(stream.processor->contacts()) : replayed;
    });
    if (written)
        result.results = std::move(*written);
    else
        result.warnings.push_back("The live results are not in the take: " + written.error().text() + ".");
}

/// Nothing is fed to it any more, and nobody sees it.
LiveSession::StreamPointer LiveSession::detachNewest() {
    const std::lock_guard lock(order_);
    const StreamPointer stream = newest();
    if (!stream)
        return nullptr;
    std::erase(feeds_, stream->feed);
    stream->feed->flush();
    if (stream == stream_) {
        started_ = false;
        past_.reset();
    }
    const std::lock_guard state_lock(mutex_);
    (take_ ? take_ : stream_).reset();
    return stream;
}

/// Of a stream that is still open.
void LiveSession::stopAfterLast() {
    bool runs = false;
    change([&](SessionStatus& s) {
        runs = std::exchange(s.stream_is_open, false) && s.link != LinkState::kStopping;
        if (runs && s.link != LinkState::kLost)
            s.link = LinkState::kStopping;
    });
    if (runs)
        device_->stop();
}

StreamResult LiveSession::finish(std::optional<double> patience_s) {
    const std::lock_guard one_at_a_time(control_);
    return finishNewest(patience_s);
}

/// On the device's clock: as far as sound has come, and further while none comes that should.
int64_t LiveSession::dueSample() const {
    const auto now = status();
    const std::lock_guard lock(mutex_);
    if (!stream_ || !now->hello)
        return 0;
    const int64_t silent_ns = is_silent_ ? steadyNow_ns() - newest_sound_ns_ : 0;
    return stream_->feed->reachedSample() +
           std::llround(1e-9 * static_cast<double>(silent_ns) * now->hello->sample_rate_hz);
}

std::optional<int64_t> LiveSession::brokenOffUntil() const {
    const auto now = status();
    const StreamPointer stream = newest();
    if (!stream || !stream->request.take || !now->hello)
        return std::nullopt;
    const int64_t due_now = dueSample(), rate_hz = now->hello->sample_rate_hz;
    const int64_t reached = stream->feed->reachedSample();
    int64_t due = 0;
    {
        const std::lock_guard lock(mutex_);
        due = due_sample_.value_or(due_now) - stream->feed->origin();
    }
    if (static_cast<double>(due - reached) < kWorthMarking_s * static_cast<double>(rate_hz))
        return std::nullopt;
    if (const auto length_s = stream->request.take->length_s)
        due = std::min<int64_t>(due, std::llround(*length_s * static_cast<double>(rate_hz)));
    return due > reached ? std::optional(due) : std::nullopt;
}

std::string MissingEnd::inWords(double from_s, double missing_s) const {
    char text[160];
    if (who.empty())
        std::snprintf(text, sizeof text,
                      "The suit was lost after %.1f s and did not come back; the last %.1f s of the take are "
                      "missing and marked as a gap.",
                      from_s, missing_s);
    else if (!is_lost)
        std::snprintf(text, sizeof text,
                      " came late: when the recording was stopped, its last %.1f s were not there yet. "
                      "They are marked as a gap.",
                      missing_s);
    else if (others_went_on)
        std::snprintf(text, sizeof text,
                      " was lost after %.1f s and did not come back; the last %.1f s of it are missing "
                      "and marked as a gap. The other suits were recorded on.",
                      from_s, missing_s);
    else
        std::snprintf(text, sizeof text,
                      " was lost after %.1f s and did not come back; the last %.1f s of it are missing "
                      "and marked as a gap.",
                      from_s, missing_s);
    return who + text;
}

void LiveSession::markMissing(const MissingEnd& end) {
    if (const auto stream = newest())
        markMissing(*stream, end);
}

void LiveSession::markMissing(Stream& stream, const MissingEnd& end) {
    const auto hello = status()->hello;
    const int64_t from = stream.feed->reachedSample();
    if (end.until <= from || !hello || !stream.recorder || stream.recorder->state().ended)
        return;
    stream.feed->markMissing(end.until, status()->trouble ? kGapOfBox : kGapOfLink);
    const double rate_hz = hello->sample_rate_hz;
    stream.missing_end =
        end.inWords(static_cast<double>(from) / rate_hz, static_cast<double>(end.until - from) / rate_hz);
    if (end.broke_off)
        stream.lost =
            Error{ErrorKind::kDevice, device_->address() + ": the sound broke off before the recording ended",
                  "Check the cable and the box's battery, and record again"};
}

StreamResult LiveSession::finishNewest(std::optional<double> patience_s) {
    const auto broken_off = brokenOffUntil();
    const StreamPointer stream = detachNewest();
    if (!stream)
        return {};
    if (broken_off)
        markMissing(*stream, {*broken_off});
    StreamResult result;
    result.trouble = status()->trouble ? status()->trouble : stream->lost;
    if (!stream->missing_end.empty())
        result.warnings.push_back(stream->missing_end);
    if (!newest())
        stopAfterLast();
    std::ranges::copy(stream->warnings, std::back_inserter(result.warnings));
    std::ranges::move(stream->feed->boxWarnings(), std::back_inserter(result.warnings));
    if (stream->recorder)
        result.recording = stream->recorder->finish();
    if (result.recording)
        result.warnings.insert(result.warnings.end(), result.recording->notices.begin(),
                               result.recording->notices.end());
    if (stream->processor) {
        stream->processor->finish(patience_s);
        result.frame = stream->processor->latest();
        if (result.recording)
            keepResults(*stream, result);
    }
    if (const auto trouble = stream->processingTrouble())
        result.warnings.push_back("Nothing is processed live: " + trouble->text() + ".");
    return result;
}

}  // namespace noctule
