// SPDX-License-Identifier: Apache-2.0
#include "core/processing/cross_ranges.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/processing/cross_clocks.h"

namespace noctule {
namespace {

constexpr double kOneCarrier_hz = 1000;     ///< nearer ones cannot be told apart
constexpr double kCarriersApart_hz = 5000;  ///< what the format asks for
constexpr double kUnstated_m = 0.0025;
constexpr size_t kMostDistances = 8'000'000;  ///< 1.2 GB; two suits with four anchors for half an hour

std::string kilohertz(double hz) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g kHz", hz / 1000);
    return text;
}

/// What is in the way of estimating subjects together; empty: nothing.
std::string obstacle(const ProcessRequest& request) {
    const TrackerSettings& tracker = request.tracker;
    if (tracker.estimator != kManifoldEstimator)
        return "estimator " + tracker.estimator + " knows one body only";
    if (tracker.smoother != Smoother::kNone)
        return std::string("--smooth ") + smootherName(tracker.smoother) + " goes over one body only";
    if (tracker.root_given)
        return "with --root given another system says where everybody is";
    if (!tracker.sensors.distances)
        return "--sensors leaves distances out";
    return "";
}

/// Where sources and boards are while a body stands, in one frame; without a body, in the room.
void addPlaces(SoundOfSuit& suit, const Actor* actor) {
    const GlobalPose standing = actor ? globalPose(actor->skeleton, actor->restPose()) : GlobalPose{};
    const auto placed = [&](const std::string& segment, const Vector3d& p_segment) -> Vector3d {
        if (!actor)
            return p_segment;
        const auto joint = static_cast<size_t>(std::max(0, actor->skeleton.find(segment)));
        return standing.p_world_joint[joint] + standing.q_world_joint[joint] * p_segment;
    };
    for (const Source& source : suit.described.sources) {
        const SourceCalibration* known = suit.calibration.findSource(source.id);
        suit.source_places_m.push_back(
            placed(source.segment, known ? known->p_segment_source_m.value_or(source.p_segment_source_m)
                                         : source.p_segment_source_m));
    }
    for (const Board& board : suit.described.boards) {
        const BoardCalibration* known = suit.calibration.findBoard(board.id);
        suit.board_places_m.push_back(
            placed(board.segment, known ? known->p_segment_board_m.value_or(board.p_segment_board_m)
                                        : board.p_segment_board_m));
    }
}

class Joiner {
public:
    Joiner(Take& take, const ProcessRequest& request, std::vector<Ingredients>& subjects, TakeClocks& clocks,
           std::vector<std::string>& warnings)
        : take_(take), request_(request), subjects_(subjects), clocks_(clocks), warnings_(warnings) {}

    Result<Joining> join(const std::string& folder, const JobContext& job) {
        joining_.between = request_.between != Wanted::kOff && subjects_.size() > 1;
        if (request_.between == Wanted::kOn && subjects_.size() < 2)
            return Error{ErrorKind::kUsage, take_.path() + ": --between on needs two subjects, there is one",
                         "Leave out --between, or name more of them with --subjects"};
        if (Status found = findRoom(); !found)
            return found.error();
        if (!joining_.between && !joining_.room)
            return std::move(joining_);
        if (const std::string what = obstacle(request_); !what.empty())
            return giveUp(what, "Leave out --between on and --room on, or what stands in their way");
        if (Status told_apart = checkCarriers(); !told_apart)
            return told_apart.error();
        if (!joining_.between && !joining_.room)
            return std::move(joining_);
        if (take_.level() == TakeLevel::kSignal)
            if (Status measured = measure(folder, job); !measured)
                return measured.error();
        addClocks();
        if (Status read = readDistances(); !read)
            return read.error();
        if (Status heard = leaveOutTheUnheard(); !heard)
            return heard.error();
        if (!joining_.joins() && take_.level() == TakeLevel::kSignal)
            return giveUp(
                "no distances between its suits are known, since their clocks cannot be found from their "
                "sound",
                "Stand still in the rest pose first, in sight of the others. Anchors that hang in a square "
                "look alike from four sides: hang one of them half a metre lower");
        if (!joining_.joins())
            return giveUp("the take holds no distances between its suits",
                          "Check that the suits heard each other");
        return std::move(joining_);
    }

private:
    bool isWanted() const { return request_.between == Wanted::kOn || request_.room == Wanted::kOn; }

    Result<Joining> giveUp(const std::string& why, const std::string& remedy) {
        if (isWanted())
            return Error{ErrorKind::kUnusable,
                         take_.path() + ": subjects cannot be estimated together: " + why, remedy};
        warnings_.push_back("Distances between suits are not used, each one's poses are its own: " + why +
                            ". " + remedy + ".");
        return Joining{};
    }

    Status findRoom() {
        const auto all = take_.subjects();
        if (!all)
            return all.error();
        const auto found = std::ranges::find_if(*all, [](const TakeSubject& one) { return one.room; });
        if (found == all->end()) {
            if (request_.room == Wanted::kOn)
                return Error{ErrorKind::kUsage, take_.path() + ": --room on needs anchors, the take has none",
                             "Leave out --room"};
            return Done{};
        }
        if (request_.room == Wanted::kOff)
            return Done{};
        RoomOfTake room{*found, {}, {}, take_.suitClock(found->suit())};
        auto suit = take_.suit(found->suit());
        if (!suit)
            return suit.error();
        room.suit = std::move(*suit);
        auto calibration = take_.calibrationInForce(found->suit());
        room.calibration = calibration ? std::move(calibration->value) : nominalCalibration(room.suit);
        if (!calibration)
            warnings_.push_back(
                "The room has no calibration: its anchors are believed to hang where the "
                "suit's file says.");
        joining_.room = std::move(room);
        return Done{};
    }

    double carrierOf(const Suit& suit) const {
        if (suit.carrier_hz)
            return *suit.carrier_hz;
        const auto stated = take_.meta().find("drive_hz");
        const double hz = stated == take_.meta().end() ? 0 : std::strtod(stated->second.c_str(), nullptr);
        return hz > 0 ? hz : take_.header().drive_hz;
    }

    /// Suits on one carrier: nobody can tell whose pulse it was.
    Status checkCarriers() {
        struct Voice {
            std::string who;
            double hz;
        };
        std::vector<Voice> voices;
        for (const Ingredients& in : subjects_)
            if (!in.suit.sources.empty())
                voices.push_back({in.subject.name + " (suit " + std::to_string(in.subject.suit()) + ")",
                                  in.decoder.train.drive_hz});
        if (joining_.room && !joining_.room->suit.sources.empty())
            voices.push_back({"the room (suit " + std::to_string(joining_.room->subject.suit()) + ")",
                              carrierOf(joining_.room->suit)});
        for (size_t i = 0; i < voices.size(); ++i)
            for (size_t k = 0; k < i; ++k) {
                const double apart_hz = std::abs(voices[i].hz - voices[k].hz);
                const std::string both = voices[k].who + " and " + voices[i].who + " sound on ";
                if (apart_hz < kOneCarrier_hz) {
                    const auto given_up =
                        giveUp(both + "one carrier, " + kilohertz(voices[i].hz) +
                                   ": nobody can tell whose pulse was heard",
                               "Record again with carriers at least 5 kHz apart (carrier_hz in the suits' "
                               "files), or process with --between off --room off");
                    if (!given_up)
                        return given_up.error();
                    joining_ = Joining{};
                    return Done{};
                }
                if (apart_hz < kCarriersApart_hz)
                    warnings_.push_back(both + "carriers only " + kilohertz(apart_hz) +
                                        " apart: their pulses disturb each other. 5 kHz are needed.");
            }
        return Done{};
    }

    Status measure(const std::string& folder, const JobContext& job) {
        std::vector<SoundOfSuit> suits;
        for (const Ingredients& in : subjects_) {
            suits.push_back({in.subject.suit(), in.suit, in.calibration, in.decoder, {}, {}, false});
            addPlaces(suits.back(), &in.actor);
        }
        if (joining_.room) {
            take_.view(joining_.room->subject.suit());
            const TakeHeader& of_room = take_.header();
            const DecoderSettings decoder{{subjects_.front().decoder.train.sample_rate_hz,
                                           static_cast<int>(of_room.pulse_interval_samples), of_room.drive_hz,
                                           static_cast<int>(of_room.pulse_cycles)},
                                          subjects_.front().decoder.detector};
            suits.push_back({joining_.room->subject.suit(),
                             joining_.room->suit,
                             joining_.room->calibration,
                             decoder,
                             {},
                             {},
                             true});
            addPlaces(suits.back(), nullptr);
        }
        auto measured = measureSound(take_, std::move(suits), folder, warnings_, job);
        if (!measured)
            return measured.error();
        joining_.measured = std::move(*measured);
        auto clocks = joinClocks(*joining_.measured, job);
        if (!clocks)
            return clocks.error();
        clocks_ = std::move(*clocks);
        for (Ingredients& in : subjects_)
            in.clock = clocks_.best(in.subject.suit(), in.clock);
        return Done{};
    }

    void addClock(int suit) {
        const SuitClock guess = take_.suitClock(suit), best = clocks_.best(suit, guess);
        joining_.guesses.push_back(guess);
        joining_.clocks.push_back({best.offset_ns * 1e-9, best.rate});
        const bool known = clocks_.knows(suit);
        // Against the first subject, whose clock is the common one.
        first_known_ = joining_.clock_known.empty() ? known : first_known_;
        joining_.clock_known.push_back(known && first_known_);
    }
    void addClocks() {
        for (const Ingredients& in : subjects_)
            addClock(in.subject.suit());
        if (joining_.room)
            addClock(joining_.room->subject.suit());
        else
            joining_.clocks.push_back({}), joining_.clock_known.push_back(false);
        joining_.clocks_shared = clocksAreShared(take_);
    }

    /// Member of a suit; -1: none.
    int memberOf(int suit) const {
        for (size_t i = 0; i < subjects_.size(); ++i)
            if (subjects_[i].subject.suit() == suit)
                return static_cast<int>(i);
        return joining_.room && joining_.room->subject.suit() == suit ? static_cast<int>(subjects_.size())
                                                                      : -1;
    }

    /// Anchors that nobody hears and that hear nobody join nothing; nor do people who do not hear each other.
    /// Fails where that was asked for; otherwise it is said, unless nothing at all is joined.
    Status leaveOutTheUnheard() {
        if (!joining_.joins())
            return Done{};
        const auto concerns_room = [room = static_cast<int>(subjects_.size())](const JointDistance& one) {
            return one.from == room || one.to == room;
        };
        const bool room_is_heard = std::ranges::any_of(joining_.distances, concerns_room);
        const bool people_are_heard = !std::ranges::all_of(joining_.distances, concerns_room);
        if (joining_.room && !room_is_heard) {
            if (request_.room == Wanted::kOn)
                return unheard("no distances to its room", "--room off");
            if (people_are_heard)
                warnings_.push_back(
                    "Nobody hears the anchors of the room, and they hear nobody: where people are in the "
                    "room is not known. Check that the room's box sounded and has a calibration.");
            joining_.room.reset();
            joining_.guesses.pop_back();
            joining_.clocks.back() = {};
            joining_.clock_known.back() = false;
        }
        if (joining_.between && !people_are_heard) {
            if (request_.between == Wanted::kOn)
                return unheard("no distances between its subjects", "--between off");
            if (room_is_heard)
                warnings_.push_back(
                    "The performers do not hear each other: where they stand to each other comes from the "
                    "room alone.");
            joining_.between = false;
        }
        return Done{};
    }

    Error unheard(const std::string& what, const std::string& option) const {
        return {ErrorKind::kUnusable, take_.path() + ": the take holds " + what,
                "Check that they heard each other, or process with " + option};
    }

    const Take& data() const { return joining_.dataOf(take_); }

    Status readDistances() {
        const int room = static_cast<int>(subjects_.size());
        auto clocks = CrossClocks::of(data(), clocks_);
        if (!clocks)
            return clocks.error();
        made_by_ = std::move(*clocks);
        addSound();
        for (size_t member = 0; member < subjects_.size() + (joining_.room ? 1 : 0); ++member)
            rates_hz_.push_back(sampleRateOf(take_, joining_.suitOf(member, subjects_)));
        for (int to = 0; to <= room; ++to) {
            if (to == room && !joining_.room)
                break;
            const int suit = joining_.suitOf(static_cast<size_t>(to), subjects_);
            const Status walked =
                data().forEachCrossRange(kPrimaryRun, suit, [&](const Take::CrossRange& cross) {
                    const int from = memberOf(cross.from_suit);
                    const bool concerns_room = from == room || to == room;
                    if (from >= 0 && (concerns_room || joining_.between))
                        add(from, to, cross.range);
                    return joining_.distances.size() < kMostDistances;
                });
            if (!walked)
                return walked;
        }
        if (joining_.distances.size() >= kMostDistances)
            return Error{ErrorKind::kUnusable,
                         take_.path() + ": it holds more distances between suits than fit into memory",
                         "Process a part of the take, or with --between off"};
        return Done{};
    }

    void add(int from, int to, const RangeMeasurement& range) {
        const SuitClock &sent = joining_.guesses[static_cast<size_t>(from)],
                        &heard = joining_.guesses[static_cast<size_t>(to)];
        JointDistance distance;
        distance.from = from;
        distance.to = to;
        distance.source = range.source;
        distance.board = range.board;
        distance.emission_s = static_cast<double>(range.pulse_sample) / rates_hz_[static_cast<size_t>(from)];
        distance.arrival_s = range.arrival_sample / rates_hz_[static_cast<size_t>(to)];
        distance.c_m_per_s = sound_[static_cast<size_t>(from)].at(range.pulse_sample);
        const double by_guess_m = made_by_.byGuess_m(joining_.suitOf(static_cast<size_t>(from), subjects_),
                                                     joining_.suitOf(static_cast<size_t>(to), subjects_),
                                                     range, distance.c_m_per_s);
        distance.beyond_m = by_guess_m - distance.c_m_per_s * (heard.takeTime_s(distance.arrival_s) -
                                                               sent.takeTime_s(distance.emission_s));
        distance.sigma_m = range.sigma_m > 0 ? range.sigma_m : kUnstated_m;
        distance.confidence = range.w_s * range.w_t;
        joining_.distances.push_back(distance);
        joining_.ranges.push_back(range);
    }

    /// Per member.
    void addSound() {
        for (const Ingredients& in : subjects_)
            sound_.push_back(soundOf(take_, in.calibration));
        sound_.push_back(
            soundOf(take_, joining_.room ? joining_.room->calibration : subjects_.front().calibration));
    }

    Take& take_;
    const ProcessRequest& request_;
    std::vector<Ingredients>& subjects_;
    TakeClocks& clocks_;
    std::vector<std::string>& warnings_;
    Joining joining_;
    std::vector<SpeedOfSound> sound_;
    std::vector<double> rates_hz_;
    CrossClocks made_by_;
    bool first_known_ = false;
};

}  // namespace

std::string anchorContradicts(const Suit& room, int anchor) {
    return "Anchor " + room.boards[static_cast<size_t>(anchor)].id +
           " contradicts the other anchors: it was moved, or its place was surveyed wrongly. Survey the room "
           "again.";
}

bool Joining::roomHoldsWorld() const {
    if (!room)
        return false;
    const auto member = static_cast<int>(guesses.size()) - 1;
    const std::vector<int> housings = room->suit.housings();
    std::set<std::pair<bool, int>> heard;  ///< a source without a housing, else a board
    for (const JointDistance& one : distances) {
        if (one.to == member)
            heard.emplace(false, one.board);
        if (one.from != member)
            continue;
        const int housing = housings[static_cast<size_t>(one.source)];
        heard.emplace(housing < 0, housing < 0 ? one.source : housing);
    }
    return heard.size() > 1;
}

Result<Joining> joinSubjects(Take& take, const ProcessRequest& request, std::vector<Ingredients>& subjects,
                             TakeClocks& clocks, const std::string& folder,
                             std::vector<std::string>& warnings, const JobContext& job) {
    return Joiner(take, request, subjects, clocks, warnings).join(folder, job);
}

}  // namespace noctule
