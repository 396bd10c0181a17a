// SPDX-License-Identifier: Apache-2.0
#include "devices/live/record_take.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <thread>

namespace noctule {
namespace {

constexpr std::chrono::milliseconds kLook{20};
// The link gives up by itself after 3 s (greeting) and 1 s (STOP, three times); these are for devices that do
// not keep their word.
constexpr std::chrono::seconds kGreetingTimeout{10}, kStartTimeout{10}, kStopTimeout{6};
constexpr std::chrono::milliseconds kStopTimeoutOnceCancelled{500};  // a cancelled job ends within a second
constexpr double kPatienceOnceCancelled_s = 2;

/// False when the time was over.
template <class Condition>
bool waitUntil(std::chrono::milliseconds timeout, Condition condition) {
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (!condition()) {
        if (std::chrono::steady_clock::now() >= end)
            return false;
        std::this_thread::sleep_for(kLook);
    }
    return true;
}

/// After connect().
Status greet(const LiveSession& session, const std::string& address, const JobContext& job) {
    waitUntil(kGreetingTimeout, [&] {
        const LinkState link = session.status()->link;
        return job.cancelled() || link == LinkState::kReady || link == LinkState::kRefused;
    });
    const auto status = session.status();
    if (job.cancelled())
        return JobContext::cancelledError();
    if (status->link == LinkState::kReady)
        return Done{};
    return status->trouble.value_or(Error{ErrorKind::kDevice, address + ": no driver box answers",
                                          "Check that it is switched on and that the address is right"});
}

std::string progressText(const LiveSession& session, double reached_s) {
    const auto recording = session.recording();
    char text[160];
    std::snprintf(text, sizeof text, "Recording %.1f s, %.2f s missing, disk for %.0f min", reached_s,
                  static_cast<double>(recording->lost_samples) /
                      static_cast<double>(session.status()->hello->sample_rate_hz),
                  recording->remaining_s.value_or(0) / 60);
    return text +
           std::string(recording->is_locked ? "; another program holds the take, what comes waits" : "");
}

/// A box that is gone counts no samples: then the time of day ends a take. It begins where the samples ended,
/// and with some patience: a busy computer may begin late.
class EndOfTake {
public:
    explicit EndOfTake(std::optional<double> seconds) : seconds_(seconds) {}

    bool isReached(double reached_s) {
        if (reached_s > reached_s_) {
            reached_s_ = reached_s;
            since_ = Clock::now();
        }
        const double still_s = std::chrono::duration<double>(Clock::now() - since_).count();
        return seconds_ && (reached_s >= *seconds_ || reached_s + still_s >= *seconds_ + kPatience_s);
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr double kPatience_s = 5;

    std::optional<double> seconds_;
    double reached_s_ = 0;
    Clock::time_point since_ = Clock::now();
};

/// Until the time is over, somebody stops it or ends it from elsewhere, or it ends by itself.
template <class Ended>
bool watch(LiveSession& session, std::optional<double> seconds, const JobContext& job,
           Ended ended_elsewhere) {
    const double rate_hz = session.status()->hello->sample_rate_hz;
    EndOfTake end(seconds);
    while (session.status()->stream_is_open && !session.recording()->ended && !ended_elsewhere()) {
        const double reached_s = static_cast<double>(session.reachedSample()) / rate_hz;
        if (end.isReached(reached_s))
            return false;
        if (job.cancelled())
            return true;
        job.progress(seconds ? reached_s / *seconds : 0, progressText(session, reached_s));
        std::this_thread::sleep_for(kLook);
    }
    return false;
}

/// Until all has come that the box still held; not for long, once it is cancelled.
void stopAndWait(LiveSession& session, const JobContext& job) {
    const auto ended = [&] { return !session.status()->stream_is_open; };
    if (ended())
        return;
    session.stop();
    waitUntil(kStopTimeout, [&] { return ended() || job.cancelled(); });
    if (!ended() && (!job.cancelled() || !waitUntil(kStopTimeoutOnceCancelled, ended)))
        session.addNote("The driver box did not confirm that it had sent everything.");
}

/// Once cancelled, nobody waits longer for the poses of what was recorded last.
std::optional<double> patienceOf(const JobContext& job) {
    return job.cancelled() ? std::optional(kPatienceOnceCancelled_s) : std::nullopt;
}

/// What another program wishes, from its thread to ours.
class CaptureWishes {
public:
    void hear(const CaptureMessage& message) {
        const std::lock_guard lock(mutex_);
        if (message.kind == CaptureMessage::Kind::kStop)
            ended_ = begun_.has_value();
        else if (!begun_)
            begun_ = message;
    }
    std::optional<CaptureMessage> begun() const {
        const std::lock_guard lock(mutex_);
        return begun_;
    }
    bool ended() const {
        const std::lock_guard lock(mutex_);
        return ended_;
    }

private:
    mutable std::mutex mutex_;
    std::optional<CaptureMessage> begun_;
    bool ended_ = false;
};

/// Streams and looks on; fails when the wish does not come.
Result<CaptureMessage> waitForWish(LiveSession& session, const CaptureWishes& wishes, uint16_t port,
                                   const JobContext& job) {
    StreamRequest look;
    look.process = false;
    if (const Status begun = session.begin(look); !begun)
        return begun.error();
    while (session.status()->stream_is_open) {
        const auto wish = wishes.begun();
        if (wish && session.status()->link == LinkState::kStreaming)
            return *wish;
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(0, "Waiting for CaptureStart on UDP port " + std::to_string(port));
        std::this_thread::sleep_for(kLook);
    }
    return session.status()->trouble.value_or(
        Error{ErrorKind::kDevice, "The device stopped before a recording was begun",
              "Begin while it streams; a take that is played again has an end"});
}

StreamRequest asWished(StreamRequest request, const CaptureMessage& wish) {
    if (!wish.name.empty()) {
        request.take->name = wish.name;
        request.take->meta["x_trigger_name"] = wish.name;
    }
    return request;
}

/// Names all boxes that do not answer.
Status greetAll(LiveGroup& group, const JobContext& job) {
    group.connect();
    std::optional<Error> silent;
    for (size_t i = 0; i < group.size(); ++i) {
        const Status greeted = greet(group.session(i), group.address(i), job);
        if (greeted)
            continue;
        if (greeted.error().kind == ErrorKind::kCancelled)
            return greeted;
        if (silent)
            silent->message += "; " + greeted.error().message;
        else
            silent = greeted.error();
    }
    return silent ? Status(*silent) : Status(Done{});
}

Status waitForAll(const LiveGroup& group, const JobContext& job) {
    std::optional<Error> failed;
    const bool decided = waitUntil(kStartTimeout, [&] {
        failed = group.failedToStart();
        return failed || group.allFlow() || job.cancelled();
    });
    if (failed)
        return *failed;
    if (!group.allFlow() && job.cancelled())
        return JobContext::cancelledError();
    if (decided)
        return Done{};
    for (size_t i = 0; i < group.size(); ++i)
        if (group.session(i).reachedSample() == 0)
            return Error{ErrorKind::kDevice, group.address(i) + ": sends no sound",
                         "Switch the driver box off and on, and record again"};
    return Done{};
}

std::string groupProgress(const LiveGroup& group, double reached_s) {
    char text[160];
    std::snprintf(text, sizeof text, "Recording %zu suits %.1f s, disk for %.0f min", group.size(), reached_s,
                  group.remaining_s().value_or(0) / 60);
    std::string all = text;
    for (size_t i = 0; i < group.size(); ++i)
        if (const auto now = group.session(i).status(); !now->stream_is_open || now->link == LinkState::kLost)
            all += "; suit " + std::to_string(i + 1) + " is lost";
    return all;
}

/// As watch(), until the slowest suit that flows has come so far.
bool watchAll(const LiveGroup& group, std::optional<double> seconds, const JobContext& job) {
    double shown_s = 0;
    EndOfTake end(seconds);
    while (group.isRecording()) {
        const auto reached_s = group.reached_s();
        if (end.isReached(reached_s.value_or(shown_s)))
            return false;
        if (job.cancelled())
            return true;
        shown_s = std::max(shown_s, reached_s.value_or(0));
        job.progress(seconds ? shown_s / *seconds : 0, groupProgress(group, shown_s));
        std::this_thread::sleep_for(kLook);
    }
    return false;
}

void stopAndWaitForAll(LiveGroup& group, const JobContext& job) {
    group.stop();
    waitUntil(kStopTimeout, [&] { return group.hasStopped() || job.cancelled(); });
    if (job.cancelled())
        waitUntil(kStopTimeoutOnceCancelled, [&] { return group.hasStopped(); });
    for (size_t i = 0; i < group.size(); ++i)
        if (group.session(i).status()->stream_is_open)
            group.session(i).addNote("The driver box did not confirm that it had sent everything.");
}

GroupReport finishedReport(LiveGroup& group, const JobContext& job) {
    GroupReport report;
    std::vector<StreamResult> results = group.finish(patienceOf(job));
    for (size_t i = 0; i < group.size(); ++i) {
        SuitReport suit;
        const link::Hello& hello = *group.session(i).status()->hello;
        suit.stream = std::move(results[i]);
        suit.link = group.session(i).linkStatistics();
        suit.sample_rate_hz = hello.sample_rate_hz;
        suit.address = group.address(i);
        suit.serial = hello.serial;
        suit.is_room = group.isRoom(i);
        report.suits.push_back(std::move(suit));
    }
    return report;
}

}  // namespace

Result<RecordReport> recordTake(std::unique_ptr<Device> device, StreamRequest request,
                                std::optional<double> seconds, const JobContext& job) {
    require(request.take.has_value(), "a recording needs a take");
    request.take->length_s = seconds;
    const std::string address = device->address();
    LiveSession session(std::move(device));
    session.connect();
    if (const Status greeted = greet(session, address, job); !greeted)
        return greeted.error();
    if (const Status begun = session.begin(request); !begun)
        return begun.error();
    RecordReport report;
    report.sample_rate_hz = session.status()->hello->sample_rate_hz;
    report.interrupted = watch(session, seconds, job, [] { return false; }) && seconds.has_value();
    stopAndWait(session, job);
    report.stream = session.finish(patienceOf(job));
    report.link = session.linkStatistics();
    return report;
}

Result<RecordReport> recordWhenTriggered(std::unique_ptr<Device> device, StreamRequest request,
                                         const RemoteTriggerOptions& options, std::optional<double> seconds,
                                         const JobContext& job) {
    require(request.take.has_value(), "a recording needs a take");
    request.take->length_s = seconds;
    CaptureWishes wishes;
    const auto trigger =
        RemoteTrigger::listen(options, [&](const CaptureMessage& message) { wishes.hear(message); });
    if (!trigger)
        return trigger.error();
    const std::string address = device->address();
    LiveSession session(std::move(device));
    session.connect();
    if (const Status greeted = greet(session, address, job); !greeted)
        return greeted.error();
    const auto wish = waitForWish(session, wishes, (*trigger)->port(), job);
    if (!wish)
        return wish.error();
    if (const Status begun = session.begin(asWished(request, *wish)); !begun)
        return begun.error();
    for (const std::string& text : {wish->notes, wish->description})
        if (!text.empty())
            session.addNote(text);
    RecordReport report;
    report.sample_rate_hz = session.status()->hello->sample_rate_hz;
    report.interrupted = watch(session, seconds, job, [&] { return wishes.ended(); }) && seconds.has_value();
    report.stream = session.finish(patienceOf(job));
    stopAndWait(session, job);
    report.link = session.linkStatistics();
    return report;
}

Result<std::vector<std::string>> beginTogether(LiveGroup& group, const GroupRequest& request,
                                               const JobContext& job) {
    auto warnings = group.begin(request);
    if (!warnings)
        return warnings;
    if (const Status flow = waitForAll(group, job); !flow) {
        stopAndWaitForAll(group, job);
        group.finish();
        group.discard();
        return flow.error();
    }
    return warnings;
}

GroupReport endTogether(LiveGroup& group, const JobContext& job) {
    stopAndWaitForAll(group, job);
    return finishedReport(group, job);
}

Result<GroupReport> recordTogether(std::vector<std::unique_ptr<Device>> devices, GroupRequest request,
                                   std::optional<double> seconds, const JobContext& job) {
    require(request.all.take.has_value(), "a recording needs a take");
    request.all.take->length_s = seconds;
    LiveGroup group(std::move(devices));
    if (const Status greeted = greetAll(group, job); !greeted)
        return greeted.error();
    auto warnings = beginTogether(group, request, job);
    if (!warnings)
        return warnings.error();
    const bool cancelled = watchAll(group, seconds, job);
    GroupReport report = endTogether(group, job);
    report.warnings = std::move(*warnings);
    report.interrupted = cancelled && seconds.has_value();
    return report;
}

}  // namespace noctule
