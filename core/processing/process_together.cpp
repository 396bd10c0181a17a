// SPDX-License-Identifier: Apache-2.0
#include "core/processing/process_together.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/live/estimators.h"
#include "core/processing/cross_ranges.h"
#include "core/processing/evaluate_between.h"

namespace noctule {
namespace {

constexpr double kPortion_s = 0.1;
constexpr double kClockEvery_s = 1;
constexpr double kLost_s = 5;      ///< without any distance: a box is out of reach or lost
constexpr double kSilent_s = 0.5;  ///< without readings of any board

/// One body of the joint filter, for a pipeline that knows of its own suit only.
class BodyOfJoint : public Estimator {
public:
    BodyOfJoint(JointFilter& joint, size_t body) : joint_(joint), body_(body) {}

    void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement*) override {
        joint_.start(body_, rest_pose, rest);
    }
    void add(const InertialMeasurement& measurement) override { joint_.filter(body_).add(measurement); }
    void add(const DistanceMeasurement& measurement) override { joint_.filter(body_).add(measurement); }
    void add(const RootMeasurement&) override {}
    void advanceTo(double time_s) override { joint_.promise(body_, time_s); }
    std::vector<TimedPose> takePoses() override { return joint_.takePoses(body_); }
    std::vector<DistanceDecision> takeDecisions() override { return joint_.filter(body_).takeDecisions(); }
    std::vector<FootContacts> contacts() const override { return joint_.filter(body_).contacts(); }
    int resets() const override { return joint_.filter(body_).resets(); }

private:
    JointFilter& joint_;
    size_t body_;
};

TrackerSettings settingsOf(TrackerSettings settings, const Ingredients& in) {
    settings.contacts = in.contacts;
    return settings;
}

Result<JointBody> bodyOf(const Ingredients& in, const TrackerSettings& settings, bool clock_known) {
    const KinematicTree tree(in.actor.skeleton, BallCoordinates::kManifold);
    auto mounted = mountSuit(in.suit, in.calibration, in.actor, tree);
    if (!mounted)
        return mounted.error();
    return JointBody{in.actor.skeleton, std::move(*mounted), filterParameters(settingsOf(settings, in)),
                     clock_known};
}

Result<JointFilter::Room> roomOf(const RoomOfTake& room, const Ingredients& any, bool clock_known) {
    const KinematicTree tree(any.actor.skeleton, BallCoordinates::kManifold);
    auto mounted = mountSuit(room.suit, room.calibration, any.actor, tree);
    if (!mounted)
        return mounted.error();
    return JointFilter::Room{std::move(*mounted), room.suit.housings(), clock_known};
}

/// Everything that one subject's data go through.
struct Line {
    const Ingredients* in = nullptr;
    std::unique_ptr<MotionTracker> tracker{};
    std::optional<ReadingCursor> readings{};
    std::optional<RangeCursor> ranges{};
    std::optional<InertialReading> reading{};
    std::optional<RangeMeasurement> range{};
    int64_t watermark = 0;
    bool ended = false;
    double heard_s = 0;  ///< until then there are readings; suit time
    std::vector<std::pair<double, double>> silences{};
};

class Together {
public:
    Together(const Take& take, const TrackerSettings& settings, const std::vector<Ingredients>& subjects,
             Joining joining, ResultRuns& results)
        : take_(take),
          settings_(settings),
          subjects_(subjects),
          joining_(std::move(joining)),
          results_(results) {}

    Status run(double share, const JobContext& job) {
        if (Status made = make(share); !made)
            return made;
        double end_s = 0;
        for (const Ingredients& in : subjects_)
            end_s = std::max(end_s, clockOf(in).takeTime_s(duration_s(in)));
        double time_s = 0;
        for (const Ingredients& in : subjects_)
            time_s = std::min(time_s, clockOf(in).takeTime_s(0));
        while (!std::ranges::all_of(lines_, &Line::ended)) {
            time_s += kPortion_s;
            for (Line& line : lines_)
                if (Status fed = feed(line, time_s); !fed)
                    return fed;
            joint_->advance();
            if (Status written = write(); !written)
                return written;
            noteClocks(time_s);
            noteRelatives();
            if (job.cancelled())
                return JobContext::cancelledError();
            job.progress(std::clamp(time_s / std::max(end_s, kPortion_s), 0.0, 1.0), "Processing together");
        }
        joint_->advance(true);
        if (!joint_->hasBegun())
            return Error{ErrorKind::kUnusable,
                         take_.path() + ": the recording of a subject ends before the rest pose does",
                         "Leave it out with --subjects, or record again"};
        for (Line& line : lines_)
            line.tracker->advanceTo(line.watermark);  // decisions of the last steps
        if (Status written = write(); !written)
            return written;
        for (size_t i = 0; i < lines_.size(); ++i) {
            results_.goOn(i);
            for (size_t b = 0; b < lines_[i].in->suit.boards.size(); ++b)
                results_.summary.clipped_readings += lines_[i].tracker->clippedReadings(static_cast<int>(b));
            results_.summary.resets += lines_[i].tracker->resets();
            if (Status done = results_.write(lines_[i].tracker->contacts()); !done)
                return done;
        }
        keepClocks();
        return warn(end_s);
    }

private:
    static double duration_s(const Ingredients& in) {
        return static_cast<double>(in.sample_count) / in.decoder.train.sample_rate_hz;
    }
    const SuitClock& clockOf(const Ingredients& in) const { return in.clock; }

    Status make(double share) {
        std::vector<JointBody> bodies;
        for (size_t i = 0; i < subjects_.size(); ++i) {
            auto body = bodyOf(subjects_[i], settings_, joining_.clock_known[i]);
            if (!body)
                return body.error();
            bodies.push_back(std::move(*body));
        }
        std::optional<JointFilter::Room> room;
        if (joining_.room) {
            auto made = roomOf(*joining_.room, subjects_.front(), joining_.clock_known.back());
            if (!made)
                return made.error();
            room = std::move(*made);
        }
        JointParameters parameters;
        parameters.share = share;
        parameters.clocks_shared = joining_.clocks_shared;
        joint_ = std::make_unique<JointFilter>(std::move(bodies), std::move(room), joining_.clocks,
                                               joining_.distances, parameters);
        for (size_t i = 0; i < subjects_.size(); ++i)
            if (Status added = addLine(i); !added)
                return added;
        if (joining_.room)
            return results_.beginRoom(joining_.room->subject);
        return Done{};
    }

    Status addLine(size_t index) {
        const Ingredients& in = subjects_[index];
        if (Status begun = results_.beginSubject(in); !begun)
            return begun;
        TrackerSettings settings = settingsOf(settings_, in);
        settings.make = [this, index](const EstimatorWorld&) -> Result<std::unique_ptr<Estimator>> {
            return std::unique_ptr<Estimator>(std::make_unique<BodyOfJoint>(*joint_, index));
        };
        Line line{&in};
        auto tracker = MotionTracker::create(in.suit, in.calibration, in.actor,
                                             in.decoder.train.sample_rate_hz, in.restOrBegin(), settings);
        if (!tracker)
            return tracker.error();
        line.tracker = std::move(*tracker);
        auto readings = data().readings(kPrimaryRun, in.subject.suit());
        if (!readings)
            return readings.error();
        auto ranges = data().ranges(kPrimaryRun, in.subject.suit());
        if (!ranges)
            return ranges.error();
        line.readings = std::move(*readings);
        line.ranges = std::move(*ranges);
        lines_.push_back(std::move(line));
        Status first = nextReading(lines_.back());
        return first ? nextRange(lines_.back()) : first;
    }

    const Take& data() const { return joining_.dataOf(take_); }
    size_t indexOf(const Line& line) const { return static_cast<size_t>(&line - lines_.data()); }

    static Status nextReading(Line& line) {
        auto reading = line.readings->next();
        if (!reading)
            return reading.error();
        line.reading = std::move(*reading);
        return Done{};
    }
    static Status nextRange(Line& line) {
        auto range = line.ranges->next();
        if (!range)
            return range.error();
        line.range = std::move(*range);
        return Done{};
    }

    static void noteReading(Line& line, double suit_s) {
        if (suit_s - line.heard_s > kSilent_s)
            line.silences.emplace_back(line.heard_s, suit_s);
        line.heard_s = suit_s;
    }

    /// Gives a subject's readings and own ranges up to an instant.
    Status feed(Line& line, double time_s) {
        if (line.ended)
            return Done{};
        const double rate_hz = line.in->decoder.train.sample_rate_hz;
        auto watermark = static_cast<int64_t>(std::floor(clockOf(*line.in).suitTime_s(time_s) * rate_hz));
        while (line.reading && line.reading->sample < static_cast<double>(watermark)) {
            results_.summary.frames_seen += 1;
            results_.summary.frames_lost += line.reading->corrected_bits ? 0 : 1;
            if (line.reading->corrected_bits)
                noteReading(line, line.reading->sample / rate_hz);
            line.tracker->add(*line.reading);
            if (joining_.measured) {
                results_.goOn(indexOf(line));
                if (Status kept = results_.write(std::vector{*line.reading}); !kept)
                    return kept;
            }
            if (Status next = nextReading(line); !next)
                return next;
        }
        line.ended = !line.reading && watermark >= line.in->sample_count;
        if (line.ended)
            watermark = std::max(line.in->sample_count, line.watermark);
        while (line.range && (line.ended || line.range->pulse_sample < watermark)) {
            line.tracker->add(*line.range);
            if (Status next = nextRange(line); !next)
                return next;
        }
        line.watermark = std::max(line.watermark, watermark);
        if (line.watermark > 0)
            line.tracker->advanceTo(line.watermark);
        if (line.ended)
            joint_->end(indexOf(line));
        return Done{};
    }

    Status write() {
        for (size_t i = 0; i < lines_.size(); ++i) {
            results_.goOn(i);
            if (joint_->hasBegun())
                results_.useClock(onTakeTime(joint_->clocks()[i], joint_->clocks()));
            if (Status done = results_.write(lines_[i].tracker->takeRanges()); !done)
                return done;
            if (Status done = results_.write(lines_[i].tracker->takePoses()); !done)
                return done;
        }
        for (const JointDecision& decision : joint_->takeDecisions()) {
            const JointDistance& distance = joining_.distances[decision.distance];
            RangeMeasurement range = joining_.ranges[decision.distance];
            range.fate = decision.fate;
            range.w_a = decision.w_a;
            range.innovation_m = decision.innovation_m;
            range.distance_m = distance.distance_m(joint_->clocks());
            results_.goOn(static_cast<size_t>(distance.to));
            results_.writeCross({range});
        }
        return Done{};
    }

    /// The member whose clock is take time; none: the first one's clock stands for it.
    std::optional<size_t> timekeeper() const {
        for (size_t member = 0; member < members(); ++member)
            if (joining_.suitOf(member, subjects_) == kTakeTimeSuit)
                return member;
        return std::nullopt;
    }
    SuitClock onTakeTime(const ClockLine& line, const std::vector<ClockLine>& all) const {
        const auto keeper = timekeeper();
        const ClockLine take = keeper ? all[*keeper] : ClockLine{};
        return {take.suit_s(line.offset_s) * 1e9, line.rate / take.rate};
    }

    size_t members() const { return subjects_.size() + (joining_.room ? 1 : 0); }

    void noteClocks(double time_s) {
        if (!joint_->hasBegun() || time_s < next_clock_s_ || joining_.clocks_shared)
            return;
        next_clock_s_ = time_s + kClockEvery_s;
        const auto keeper = timekeeper();
        const ClockLine take = keeper ? joint_->clockNow(*keeper) : ClockLine{};
        for (size_t member = 0; member < members(); ++member) {
            if (member == keeper || (member == 0 && !keeper))
                continue;
            const ClockLine line = joint_->clockNow(member);
            const double suit_s = line.suit_s(time_s);
            const double sigma_s =
                std::hypot(joint_->clockSigma_s(member), keeper ? joint_->clockSigma_s(*keeper) : 0);
            tracks_[joining_.suitOf(member, subjects_)].points.push_back(
                {suit_s, take.suit_s(time_s) - suit_s, line.rate / take.rate, sigma_s});
        }
    }
    /// What evaluateBetween() compares, ten times a second.
    void noteRelatives() {
        if (!joint_->hasBegun() || joint_->reached_s() <= reached_s_)
            return;
        reached_s_ = joint_->reached_s();
        const auto time_ns =
            static_cast<int64_t>(std::llround(onTakeTime({reached_s_, 1}, joint_->clocks()).offset_ns));
        for (size_t a = 0; a < subjects_.size(); ++a)
            for (size_t b = a + 1; b < subjects_.size(); ++b) {
                if (!isPlaced(a) || !isPlaced(b))
                    continue;  // nothing measures this vector, so that no covariance of it means anything
                for (const auto& [from, to] : kComparedEnds) {
                    const int joint = subjects_[a].actor.skeleton.find(from),
                              other = subjects_[b].actor.skeleton.find(to);
                    if (joint >= 0 && other >= 0)
                        results_.relatives.push_back({subjects_[a].subject.suit(),
                                                      {subjects_[b].subject.suit(), from, to, time_ns,
                                                       joint_->relativeCovariance(a, joint, b, other)}});
                }
            }
    }
    bool isPlaced(size_t subject) const { return joint_->alignment().places[subject].placed; }
    /// Clocks that no transceivers join are known by the bodies' poses all the same.
    void keepClocks() {
        for (auto& [suit, track] : tracks_)
            if (!results_.clocks.tracks.contains(suit) && timekeeper()) {
                track.joined = true;
                results_.clocks.tracks[suit] = std::move(track);
            }
    }

    Status warn(double end_s) {
        std::vector<std::string>& warnings = results_.summary.warnings;
        for (size_t i = 0; i < subjects_.size(); ++i)
            if (!isPlaced(i)) {
                results_.summary.together->unjoined.push_back(subjects_[i].subject.suit());
                warnings.push_back(subjects_[i].subject.name +
                                   " cannot be joined to the others: while the rest pose was held, too few "
                                   "distances to them or to the room fit. These poses are their own.");
            }
        if (joining_.room && !joining_.roomHoldsWorld())
            warnings.push_back(
                "One anchor alone does not tell how everybody is turned about it: places and headings in the "
                "room are guesses, those of people to each other are not. Hang up two more anchors.");
        if (joining_.room && joint_->roomContradicts())
            warnings.push_back(kRoomContradicts);
        else if (joining_.room)
            for (const int anchor : joint_->movedAnchors())
                warnings.push_back(anchorContradicts(joining_.room->suit, anchor));
        for (Line& line : lines_)
            warnOfSilence(line);
        warnOfLost(end_s);
        return Done{};
    }

    /// A box from which no readings come.
    void warnOfSilence(Line& line) {
        if (line.heard_s == 0)
            return;  // it has ranges alone
        noteReading(line, duration_s(*line.in));
        if (!line.silences.empty() && line.silences.front().first == 0)
            line.silences.erase(line.silences.begin());  // before its box began there are no poses
        for (const auto& [from_s, to_s] : line.silences) {
            char when[80];
            std::snprintf(when, sizeof when, "from %.1f s to %.1f s of %.1f s",
                          clockOf(*line.in).takeTime_s(from_s), clockOf(*line.in).takeTime_s(to_s),
                          clockOf(*line.in).takeTime_s(duration_s(*line.in)));
            results_.summary.warnings.push_back(line.in->subject.name + " sent no readings " + when +
                                                ": the box was lost. The poses there are guesses; the others "
                                                "go on without it.");
        }
    }

    /// A box that neither hears anybody nor is heard.
    void warnOfLost(double end_s) {
        std::vector<double> last_s(subjects_.size() + 1, 0);
        const auto note = [&](int member, double time_s) {
            auto& last = last_s[static_cast<size_t>(member)];
            last = std::max(last, joint_->clocks()[static_cast<size_t>(member)].common_s(time_s));
        };
        for (const JointDistance& distance : joining_.distances)
            note(distance.from, distance.emission_s), note(distance.to, distance.arrival_s);
        const auto is_silent = [&](size_t member) {
            return member < lines_.size() && !lines_[member].silences.empty();
        };
        for (size_t member = 0; member < members(); ++member)
            if (last_s[member] > 0 && last_s[member] + kLost_s < end_s && !is_silent(member)) {
                char when[64];
                std::snprintf(when, sizeof when, "%.1f s of %.1f s", last_s[member], end_s);
                results_.summary.warnings.push_back(
                    (member < subjects_.size() ? subjects_[member].subject.name : std::string("The room")) +
                    " neither hears anybody nor is heard after " + when +
                    ": out of reach, or its box was lost. From there on the others are estimated without "
                    "it.");
            }
    }

    const Take& take_;
    const TrackerSettings settings_;
    const std::vector<Ingredients>& subjects_;
    Joining joining_;
    ResultRuns& results_;
    std::unique_ptr<JointFilter> joint_;
    std::vector<Line> lines_;
    std::map<int, cooperative::ClockTrack> tracks_;
    double next_clock_s_ = 0;
    double reached_s_ = -1;  ///< of the last covariances that were noted, common time
};

}  // namespace

Result<bool> processTogether(Take& take, const ProcessRequest& request, const TrackerSettings& settings,
                             std::vector<Ingredients>& subjects, ResultRuns& results, const JobContext& job) {
    auto joining = joinSubjects(take, request, subjects, results.clocks, settings.spool_folder,
                                results.summary.warnings, job);
    if (!joining)
        return joining.error();
    if (!joining->joins())
        return false;
    results.summary.together = ProcessSummary::Together{};
    results.summary.together->between = joining->between;
    results.summary.together->room = joining->roomHoldsWorld();
    Together together(take, settings, subjects, std::move(*joining), results);
    if (Status run = together.run(request.select, job); !run)
        return run.error();
    return true;
}

}  // namespace noctule
