// SPDX-License-Identifier: Apache-2.0
#include "core/processing/point_flights.h"

#include <algorithm>

namespace noctule {
namespace {

constexpr double kUnstatedRange_m = 0.0025;
constexpr double kUsableConfidence = 0.05;

class FlightReader {
public:
    FlightReader(const Take& take, const std::vector<Ingredients>& subjects, const Joining& joining,
                 const RestAlignment& alignment, std::vector<std::string>& warnings)
        : take_(joining.dataOf(take)),
          subjects_(subjects),
          joining_(joining),
          alignment_(alignment),
          warnings_(warnings) {
        if (joining.room)
            housings_ = joining.room->suit.housings();
    }

    Result<std::vector<PointFlight>> read(const TakeClocks& clocks) {
        // A clock that follows its wander is better than a line; all members need one, for one common time.
        const size_t members = joining_.guesses.size();
        bool tracked = !joining_.clocks_shared;
        for (size_t member = 0; member < members; ++member)
            tracked = tracked && joining_.clock_known[member];
        tracks_.resize(room() + 1);
        for (size_t member = 0; tracked && member < members; ++member) {
            const auto track = clocks.tracks.find(joining_.suitOf(member, subjects_));
            tracks_[member] =
                track != clocks.tracks.end() ? track->second : cooperative::ClockTrack{true, {{0, 0, 1, 0}}};
        }
        if (!tracked && !joining_.clocks_shared)
            warnings_.push_back(
                "The boxes' clocks are known from the rest pose alone, since no transceivers of all suits "
                "hear each other both ways: ranges between suits drift.");
        for (const JointDistance& distance : joining_.distances) {
            if (distance.confidence < kUsableConfidence || isMoved(distance))
                continue;
            const double emission_s = commonTime_s(static_cast<size_t>(distance.from), distance.emission_s),
                         arrival_s = commonTime_s(static_cast<size_t>(distance.to), distance.arrival_s);
            flights_.push_back({emission_s, arrival_s - emission_s, distance.from, distance.source,
                                distance.to, distance.board,
                                distance.beyond_m + distance.c_m_per_s * (arrival_s - emission_s),
                                distance.sigma_m / distance.confidence});
        }
        for (size_t member = 0; member < subjects_.size(); ++member)
            if (Status own = readOwn(member); !own)
                return own.error();
        std::ranges::stable_sort(flights_, {}, &PointFlight::emission_s);
        return std::move(flights_);
    }

private:
    size_t room() const { return subjects_.size(); }

    double commonTime_s(size_t member, double suit_s) const {
        const auto& track = tracks_[member];
        return track ? cooperative::takeTime_s(*track, suit_s) : alignment_.clocks[member].common_s(suit_s);
    }

    bool isMoved(const JointDistance& distance) const {
        int board = -1;
        if (static_cast<size_t>(distance.to) == room())
            board = distance.board;
        if (static_cast<size_t>(distance.from) == room())
            board = housings_[static_cast<size_t>(distance.source)];
        return std::ranges::count(alignment_.moved_anchors, board) > 0;
    }

    Status readOwn(size_t member) {
        auto ranges = take_.ranges(kPrimaryRun, subjects_[member].subject.suit());
        if (!ranges)
            return ranges.error();
        const double rate_hz = subjects_[member].decoder.train.sample_rate_hz;
        const auto index = static_cast<int>(member);
        while (true) {
            const auto range = ranges->next();
            if (!range)
                return range.error();
            if (!*range)
                return Done{};
            const RangeMeasurement& own = **range;
            const double confidence = own.w_s * own.w_t;
            if (confidence < kUsableConfidence)
                continue;
            const double emission_s = commonTime_s(member, static_cast<double>(own.pulse_sample) / rate_hz);
            flights_.push_back({emission_s, commonTime_s(member, own.arrival_sample / rate_hz) - emission_s,
                                index, own.source, index, own.board, own.distance_m,
                                (own.sigma_m > 0 ? own.sigma_m : kUnstatedRange_m) / confidence});
        }
    }

    const Take& take_;
    const std::vector<Ingredients>& subjects_;
    const Joining& joining_;
    const RestAlignment& alignment_;
    std::vector<std::string>& warnings_;
    std::vector<int> housings_;                                   ///< of the room's sources
    std::vector<std::optional<cooperative::ClockTrack>> tracks_;  ///< per member; none: a line
    std::vector<PointFlight> flights_;
};

}  // namespace

Result<std::vector<PointFlight>> pointFlights(const Take& take, const std::vector<Ingredients>& subjects,
                                              const Joining& joining, const RestAlignment& alignment,
                                              const TakeClocks& clocks, std::vector<std::string>& warnings) {
    return FlightReader(take, subjects, joining, alignment, warnings).read(clocks);
}

}  // namespace noctule
