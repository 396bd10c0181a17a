// SPDX-License-Identifier: Apache-2.0
#include "ui/models/live_steps.h"

#include <chrono>
#include <thread>

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
    std::error_code ignored;
    if (result.recording && result.recording->samples == 0)
        std::filesystem::remove(result.recording->path, ignored);
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

}  // namespace noctule::ui
