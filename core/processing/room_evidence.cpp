// SPDX-License-Identifier: Apache-2.0
#include "core/processing/room_evidence.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/estimation/suit_model.h"
#include "core/processing/cross_clocks.h"
#include "core/processing/feed_tracker.h"
#include "core/suit/placed_suit.h"

namespace noctule {
namespace {

using room_survey::Anchor;
using room_survey::AnchorRange;
using room_survey::WalkRange;

constexpr double kSurveyConfidence = 0.5;
constexpr double kUnstatedAnchorSigma_m = 0.0025;
constexpr int64_t kPoseGap_ns = 50'000'000;  ///< between two poses

/// Where a performer's devices are by the poses.
class Devices {
public:
    Devices(const Ingredients& in, SuitModel suit, TimedMotion motion)
        : suit_(std::move(suit)),
          motion_(std::move(motion)),
          tree_(motion_.skeleton, BallCoordinates::kManifold) {
        for (const int board : in.suit.housings())
            housing_.push_back(board >= 0 ? board : std::ssize(suit_.boards) + std::ssize(housing_));
    }

    int count() const { return static_cast<int>(suit_.boards.size() + suit_.sources.size()); }

    /// False: there is no pose at that time, or the device is not worn.
    bool place(double suit_s, bool is_source, int index, WalkRange& range) const {
        const auto pose = poseAt(motion_, static_cast<int64_t>(suit_s * 1e9), kPoseGap_ns);
        const auto i = static_cast<size_t>(index);
        const int link = is_source ? suit_.sources[i].link : suit_.boards[i].link;
        if (!pose || link < 0)
            return false;
        const MotionState state = tree_.stateFromPose(*pose);
        ChainMotion chain;
        chain.evaluate(tree_, state, link, 0);
        range.device = is_source ? static_cast<int>(housing_[i]) : index;
        range.p_m = chain
                        .point(is_source ? suit_.sources[i].p_link_source
                                         : placeBoard(suit_.boards[i], tree_, state, 0).p_mic_m)
                        .p_m;
        range.R_world_segment = chain.end().R_world_link;
        return true;
    }

private:
    SuitModel suit_;
    TimedMotion motion_;
    KinematicTree tree_;
    std::vector<std::ptrdiff_t> housing_;  ///< per source: the device that it is
};

/// Poses of one body by its own readings and ranges.
Result<Devices> devicesOf(const Take& data, const Ingredients& in, const JobContext& job) {
    TrackerSettings settings;
    settings.g_m_per_s2 = data.header().g_m_per_s2;
    settings.contacts = in.contacts;
    auto tracker = MotionTracker::create(in.suit, in.calibration, in.actor, in.decoder.train.sample_rate_hz,
                                         in.restOrBegin(), settings);
    if (!tracker)
        return tracker.error();
    TimedMotion motion{in.actor.skeleton, {}};
    const double all = static_cast<double>(std::max<int64_t>(1, in.sample_count));
    const auto fed = feedTracker(
        data, in, **tracker,
        [&](int64_t reached) -> Status {
            for (TimedPose& pose : (*tracker)->takePoses())
                motion.frames.push_back(std::move(pose));
            (*tracker)->takeRanges();
            job.progress(static_cast<double>(reached) / all, "Following " + in.subject.name);
            return Done{};
        },
        job);
    if (!fed)
        return fed.error();
    auto suit = mountSuit(in.suit, in.calibration, in.actor,
                          KinematicTree(in.actor.skeleton, BallCoordinates::kManifold));
    if (!suit)
        return suit.error();
    return Devices(in, std::move(*suit), std::move(motion));
}

class Gatherer {
public:
    Gatherer(Take& take, const JobContext& job) : take_(take), job_(job) {}

    Result<RoomEvidence> gather(const std::string& performer) {
        auto room = roomOfTake(take_);
        if (!room)
            return room.error();
        found_.room = std::move(*room);
        describeAnchors();
        auto subject = choose(performer);
        if (!subject)
            return subject.error();
        if (*subject)
            if (Status walked = addWalk(**subject); !walked)
                return walked.error();
        if (!*subject && take_.level() == TakeLevel::kSignal)
            return Error{ErrorKind::kUnusable,
                         take_.path() + ": holds the sound of anchors alone, whose clocks nobody joins",
                         "Record somebody in a suit who walks past them"};
        if (Status between = addBetween(); !between)
            return between.error();
        if (Status counted = countPulses(); !counted)
            return counted.error();
        return std::move(found_);
    }

private:
    int roomSuit() const { return found_.room.subject.suit(); }
    /// With ranges: those of a take of sound have been measured.
    const Take& data() const { return joining_.dataOf(take_); }

    void describeAnchors() {
        const Suit placed = placedSuit(found_.room.suit, found_.room.calibration);
        found_.parts = anchorParts(placed);
        anchor_of_board_.assign(placed.boards.size(), -1);
        anchor_of_source_.assign(placed.sources.size(), -1);
        for (size_t a = 0; a < found_.parts.size(); ++a) {
            const auto [b, s] = found_.parts[a];
            Anchor anchor;
            anchor.hears = b >= 0, anchor.sounds = s >= 0;
            Vector3d microphone_m = Vector3d::Zero(), source_m = Vector3d::Zero();
            if (anchor.hears) {
                const Board& board = placed.boards[static_cast<size_t>(b)];
                anchor_of_board_[static_cast<size_t>(b)] = static_cast<int>(a);
                anchor.id = board.id;
                microphone_m = board.p_segment_board_m + board.q_segment_board * board.p_board_mic_m;
            }
            if (anchor.sounds) {
                const Source& source = placed.sources[static_cast<size_t>(s)];
                anchor_of_source_[static_cast<size_t>(s)] = static_cast<int>(a);
                anchor.id = anchor.hears ? anchor.id : source.id;
                source_m = source.p_segment_source_m;
            }
            anchor.rough_m = !anchor.hears    ? source_m
                             : !anchor.sounds ? microphone_m
                                              : Vector3d((microphone_m + source_m) / 2);
            anchor.apart_m = anchor.hears && anchor.sounds ? (source_m - microphone_m).norm() : 0;
            found_.evidence.anchors.push_back(std::move(anchor));
        }
    }

    /// Nobody: of an empty stage.
    Result<std::optional<TakeSubject>> choose(const std::string& name) const {
        const auto subjects = take_.subjects();
        if (!subjects)
            return subjects.error();
        std::optional<TakeSubject> chosen;
        std::string names;
        int64_t most = -1;
        for (const TakeSubject& one : *subjects) {
            if (one.room)
                continue;
            names += (names.empty() ? "" : ", ") + one.name;
            if (!name.empty() && one.name != name)
                continue;
            if (const int64_t count = name.empty() ? rangesWith(one.suit()) : 0; count > most)
                most = count, chosen = one;
        }
        if (!chosen && !name.empty())
            return Error{ErrorKind::kUsage, take_.path() + ": has no subject '" + name + "'",
                         names.empty() ? "It holds anchors alone" : "Its subjects are " + names};
        return chosen;
    }

    int64_t rangesWith(int suit) const {
        int64_t count = 0;
        const auto add = [&](int listener, int from) {
            return take_.forEachCrossRange(kPrimaryRun, listener, [&](const Take::CrossRange& range) {
                count += range.from_suit == from;
                return true;
            });
        };
        const bool read = add(suit, roomSuit()).ok() && add(roomSuit(), suit).ok();
        return read ? count : 0;
    }

    Status addWalk(const TakeSubject& subject) {
        ProcessRequest request;
        request.take_path = take_.path();
        request.between = Wanted::kOff;
        take_.view(subject.suit());
        auto in = gatherIngredients(take_, request, found_.warnings);
        if (!in)
            return in.error();
        in->subject = subject;
        std::vector<Ingredients> subjects{std::move(*in)};
        auto clocks = joinClocks(take_, job_);
        if (!clocks)
            return clocks.error();
        const std::filesystem::path folder = std::filesystem::path(take_.path()).parent_path();
        auto joining = joinSubjects(take_, request, subjects, *clocks, folder.empty() ? "." : folder.string(),
                                    found_.warnings, job_);
        if (!joining)
            return joining.error();
        joining_ = std::move(*joining);
        if (!joining_.joins() || !joining_.room)
            return take_.level() == TakeLevel::kSignal ? unknownClock(subject.name) : Status(Done{});
        const auto devices = devicesOf(data(), subjects.front(), job_);
        if (!devices)
            return devices.error();
        found_.evidence.performer = subject.name;
        found_.evidence.devices = devices->count();
        found_.evidence.clock_known = joining_.clock_known.front() && joining_.clock_known.back();
        addWalkRanges(*devices, *clocks, subject);
        return Done{};
    }

    /// Which pulse an arrival belongs to is told by about how far the anchors are.
    Error unknownClock(const std::string& performer) const {
        return {ErrorKind::kUnusable,
                take_.path() + ": the clocks of " + performer +
                    " and of the room cannot be found from their sound",
                "Stand still in sight of the anchors first, and see that the room's file has each of them "
                "right to 0.2 m: without that, their pulses cannot be told apart"};
    }

    void addWalkRanges(const Devices& devices, const TakeClocks& clocks, const TakeSubject& subject) {
        const auto time_s = [&](size_t member, double suit_s) {
            const auto track = clocks.tracks.find(member == 0 ? subject.suit() : roomSuit());
            return track != clocks.tracks.end() ? cooperative::takeTime_s(track->second, suit_s)
                                                : joining_.clocks[member].common_s(suit_s);
        };
        for (const JointDistance& distance : joining_.distances) {
            WalkRange range;
            range.anchor_hears = distance.to == 1;
            range.anchor = range.anchor_hears ? anchor_of_board_[static_cast<size_t>(distance.board)]
                                              : anchor_of_source_[static_cast<size_t>(distance.source)];
            if (distance.confidence < kSurveyConfidence || range.anchor < 0)
                continue;
            const double emission_s = time_s(static_cast<size_t>(distance.from), distance.emission_s),
                         arrival_s = time_s(static_cast<size_t>(distance.to), distance.arrival_s);
            range.time_s = emission_s;
            range.distance_m = distance.beyond_m + distance.c_m_per_s * (arrival_s - emission_s);
            range.sigma_m = distance.sigma_m / distance.confidence;
            if (devices.place(range.anchor_hears ? distance.emission_s : distance.arrival_s,
                              range.anchor_hears, range.anchor_hears ? distance.source : distance.board,
                              range))
                found_.evidence.walk.push_back(range);
        }
        std::ranges::stable_sort(found_.evidence.walk, {}, &WalkRange::time_s);
    }

    Status addBetween() {
        auto ranges = data().ranges(kPrimaryRun, roomSuit());
        if (!ranges)
            return ranges.error();
        const double rate_hz = sampleRateOf(take_, roomSuit());
        while (true) {
            const auto range = ranges->next();
            if (!range)
                return range.error();
            if (!*range)
                return Done{};
            const int from = anchor_of_source_[static_cast<size_t>((*range)->source)],
                      to = anchor_of_board_[static_cast<size_t>((*range)->board)];
            heard_.insert((*range)->pulse);
            const double confidence = (*range)->w_s * (*range)->w_t;
            if (from >= 0 && to >= 0 && from != to && confidence >= kSurveyConfidence)
                found_.evidence.between.push_back(
                    {from, to, static_cast<double>((*range)->pulse_sample) / rate_hz, (*range)->distance_m,
                     ((*range)->sigma_m > 0 ? (*range)->sigma_m : kUnstatedAnchorSigma_m) / confidence});
        }
    }

    /// Of an anchor that only hears: the share of the performer's pulses that it heard.
    Status countPulses() {
        std::vector<std::set<int64_t>> heard_by(found_.evidence.anchors.size());
        for (size_t i = 0; i < joining_.distances.size(); ++i)
            if (joining_.distances[i].to == 1)
                heard_by[static_cast<size_t>(
                             anchor_of_board_[static_cast<size_t>(joining_.distances[i].board)])]
                    .insert(joining_.ranges[i].pulse);
            else
                heard_.insert(joining_.ranges[i].pulse);
        const auto pulses = take_.pulses(roomSuit());
        if (!pulses)
            return pulses.error();
        for (const Pulse& pulse : *pulses)
            if (const int anchor = anchor_of_source_[static_cast<size_t>(pulse.source)]; anchor >= 0) {
                Anchor& of = found_.evidence.anchors[static_cast<size_t>(anchor)];
                ++of.sent;
                of.heard += heard_.contains(pulse.id);
            }
        std::set<int64_t> performers;
        for (const std::set<int64_t>& heard : heard_by)
            performers.insert(heard.begin(), heard.end());
        for (size_t a = 0; a < heard_by.size(); ++a)
            if (Anchor& anchor = found_.evidence.anchors[a]; !anchor.sounds) {
                anchor.sent = static_cast<int>(performers.size());
                anchor.heard = static_cast<int>(heard_by[a].size());
            }
        return Done{};
    }

    Take& take_;
    const JobContext& job_;
    RoomEvidence found_;
    Joining joining_;
    std::vector<int> anchor_of_board_, anchor_of_source_;
    std::set<int64_t> heard_;  ///< pulses of the room, by id
};

}  // namespace

Result<RoomOfTake> roomOfTake(const Take& take) {
    const auto subjects = take.subjects();
    if (!subjects)
        return subjects.error();
    for (const TakeSubject& one : *subjects)
        if (one.room) {
            auto suit = take.suit(one.suit());
            if (!suit)
                return suit.error();
            auto calibration = take.calibrationInForce(one.suit());
            Calibration values = calibration ? std::move(calibration->value) : nominalCalibration(*suit);
            return RoomOfTake{one, std::move(*suit), std::move(values), take.suitClock(one.suit())};
        }
    return Error{ErrorKind::kUsage, take.path() + ": has no room: none of its suits is made of anchors alone",
                 "Record the anchors' box as a device of its own, with a suit whose segments are null"};
}

std::vector<std::pair<int, int>> anchorParts(const Suit& room) {
    std::vector<std::pair<int, int>> parts;
    for (size_t b = 0; b < room.boards.size(); ++b)
        parts.emplace_back(static_cast<int>(b), -1);
    const std::vector<int> housings = room.housings();
    for (size_t s = 0; s < housings.size(); ++s)
        if (housings[s] >= 0)
            parts[static_cast<size_t>(housings[s])].second = static_cast<int>(s);
        else
            parts.emplace_back(-1, static_cast<int>(s));
    return parts;
}

Result<RoomEvidence> gatherRoom(Take& take, const std::string& performer, const JobContext& job) {
    return Gatherer(take, job).gather(performer);
}

}  // namespace noctule
