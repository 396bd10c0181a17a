// SPDX-License-Identifier: Apache-2.0
// Several suits, each on its own driver box, recorded into one take of format 1.1. Each has a LiveSession of
// its own; all write into one file. Suits count from 1 in the order of the devices, and take time is that of
// suit 1. A box that is lost or restarts does not end the recording of the others.
//
// begin() and finish() belong into a job, as those of LiveSession; the others return at once.
#pragma once

#include <string>
#include <vector>

#include "devices/live/live_session.h"
#include "devices/live/suit_voices.h"

namespace noctule {

/// What is wished of one suit of a group.
struct GroupSuit {
    std::string subject;       ///< who wears it; empty: unnamed, or the room
    std::optional<Suit> suit;  ///< as it is worn, matched by serial; else as the box says
    std::optional<Calibration> calibration;
    std::optional<Actor> actor;       ///< absent: the default one; none of a room
    bool process = true;              ///< of a room nothing is processed
    std::optional<double> rest_s{};   ///< instead of that of all; none of a room
    PoseListener pose_listener = {};  ///< instead of that of all
};

struct GroupRequest {
    /// Of all suits; each has its own document instead of this one's, and no results are kept.
    StreamRequest all;
    std::vector<GroupSuit> suits;  ///< one per device
};

class LiveGroup {
public:
    /// A session that is connected already, and what errors call its suit: "Ada (NB-000123)".
    struct Connected {
        std::string name;
        std::shared_ptr<LiveSession> session;
    };

    explicit LiveGroup(std::vector<std::unique_ptr<Device>> devices);
    /// For the length of a take: connect() is not called, and nobody else begins or ends streams of these.
    explicit LiveGroup(std::vector<Connected> connected);

    size_t size() const { return members_.size(); }
    LiveSession& session(size_t index) { return *members_[index].session; }
    const LiveSession& session(size_t index) const { return *members_[index].session; }
    /// Of a device; of a session that was connected already its name.
    const std::string& address(size_t index) const { return members_[index].address; }
    /// Of the take that began last: a set of anchors that nobody wears.
    bool isRoom(size_t index) const { return members_[index].is_room; }

    /// Once, and before the rest.
    void connect();
    /// When all boxes are ready: makes the take and starts them, one right after the other. Refuses boxes
    /// that cannot be told from each other: one box twice, or two suits on one carrier. Yields whole
    /// sentences on what is allowed and does harm. On an error no take is left.
    Result<std::vector<std::string>> begin(const GroupRequest& request);
    /// Sound has come from all suits.
    bool allFlow() const;
    /// Why a suit will not flow any more that never did, if there is one.
    std::optional<Error> failedToStart() const;
    /// At least one stream is open, and the file can be written.
    bool isRecording() const;
    /// Of one suit's sound.
    double reachedOf_s(size_t index) const;
    /// Of the suits whose sound flows, the one that has least; nothing when none flows.
    std::optional<double> reached_s() const;
    /// Until the disk's reserve is reached, at the rate of all suits so far.
    std::optional<double> remaining_s() const;
    /// Asks all boxes to stop.
    void stop();
    bool hasStopped() const;
    /// Completes the take. Sound that a suit lacks at the end, and others have or would have, becomes a gap;
    /// a warning of that suit says so. `patience_s`: as for one suit, for all of them.
    std::vector<StreamResult> finish(std::optional<double> patience_s = {});
    /// After finish(): removes the take.
    void discard() const { discardTakeFile(path_); }

private:
    struct Member {
        std::string address, name;
        std::shared_ptr<LiveSession> session;
        bool is_room = false;
        bool flowed_to_the_end = false;  ///< was streaming when it was told to stop
    };
    struct Prepared {
        std::vector<StreamRequest> requests;
        std::vector<TakePlan> plans;
    };
    Result<std::vector<SuitVoice>> greetedVoices() const;
    Result<Suit> wornSuit(const GroupSuit& wish, size_t index);
    StreamRequest requestOf(const GroupRequest& request, size_t index) const;
    Result<Prepared> prepare(const GroupRequest& request, const std::vector<SuitVoice>& voices);
    const std::string& nameOf(size_t index) const { return members_[index].name; }
    /// Of suits whose sound ends before that of the others.
    void markMissing();

    std::vector<Member> members_;
    std::string path_;
};

}  // namespace noctule
