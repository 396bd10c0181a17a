// SPDX-License-Identifier: Apache-2.0
#include "ui/models/live_steps.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "ui/language/core_words.h"
#include "ui/models/live_suit.h"

namespace noctule::ui {
namespace {

constexpr std::chrono::milliseconds kLookEvery{5};
// The link gives up by itself: 1 s for the first sound, three times for STOP. These are for devices that do
// not keep their word, and for a link that breaks right now.
constexpr std::chrono::seconds kFirstSoundTimeout{6}, kStopTimeout{6};

template <class Condition>
void waitUntil(std::chrono::seconds timeout, const JobContext& job, Condition condition) {
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (!condition() && !job.cancelled() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(kLookEvery);
}

/// The file of a take that never came to be.
void dropEmptyTake(const StreamResult& result) {
    if (result.recording && result.recording->samples == 0)
        discardTakeFile(result.recording->path);
}

/// A part that does not tell what it recorded may have recorded something.
bool isEmpty(const RecordReport& part) {
    constexpr double kLeast_s = 0.05;  // lists show it as 0.0 s
    return part.stream.recording &&
           static_cast<double>(part.stream.recording->samples) < kLeast_s * part.sample_rate_hz;
}

}  // namespace

StreamResult endStream(LiveSession& session, const JobContext& job) {
    if (session.status()->stream_is_open && !session.isInMidst()) {
        session.stop();
        waitUntil(kStopTimeout, job, [&] { return !session.status()->stream_is_open; });
    }
    return session.finish();
}

std::optional<Error> beginStream(LiveSession& session, const StreamRequest& request, const JobContext& job) {
    if (const Status begun = session.begin(request); !begun)
        return begun.error();
    waitUntil(kFirstSoundTimeout, job, [&] {
        const auto status = session.status();
        return !status->stream_is_open || status->link == LinkState::kStreaming || session.isInMidst();
    });
    const auto status = session.status();
    if (status->stream_is_open)
        return std::nullopt;
    dropEmptyTake(session.finish());
    return status->trouble.value_or(Error{ErrorKind::kDevice, "The driver box sends no sound",
                                          "Switch it off and on again, then look again"});
}

TakeEnd endOfTake(const std::vector<RecordReport>& parts, bool unasked) {
    TakeEnd end;
    std::string path;
    std::optional<Error> of_recorder, of_device;
    for (const RecordReport& part : parts) {
        if (part.stream.recording) {
            path = part.stream.recording->path;
            if (part.stream.recording->trouble)
                of_recorder = part.stream.recording->trouble;
        }
        if (unasked && !of_device)
            of_device = part.stream.trouble;
    }
    if (of_recorder || of_device)
        end.trouble = coreWords(of_recorder ? *of_recorder : *of_device);
    end.path = QString::fromStdString(path);
    if (path.empty() || !of_recorder || !std::ranges::all_of(parts, isEmpty))
        return end;
    discardTakeFile(path);
    std::error_code ignored;
    end.is_empty = !std::filesystem::exists(path, ignored);
    if (end.is_empty)
        end.trouble += QStringLiteral(". ") + LiveSuit::tr("Nothing was recorded, and the take was removed.");
    return end;
}

}  // namespace noctule::ui
