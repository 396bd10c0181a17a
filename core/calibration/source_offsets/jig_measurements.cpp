// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/jig_measurements.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "core/math/order_statistics.h"

namespace noctule {
namespace {

constexpr double kMostOfStretch = 0.25;        // given up at either end of a short one
constexpr double kLeastFlightSpread_s = 5e-7;  // quantised flights of a perfect take have no spread at all
constexpr double kPulseOutlier = 4;            // times the spread
constexpr double kMoved_s = 1e-5;              // 3.4 mm
constexpr size_t kMostNames = 4;

using PairKey = std::tuple<std::string, std::string, std::string>;  // placement, source, board

std::string listed(const std::set<std::string>& names) {
    std::string list;
    size_t count = 0;
    for (const std::string& name : names) {
        if (++count > kMostNames)
            return list + " and " + std::to_string(names.size() - kMostNames) + " more";
        list += (count > 1 ? ", " : "") + name;
    }
    return list;
}

template <class Part>
bool haveEqualIds(const std::vector<Part>& a, const std::vector<Part>& b) {
    return std::ranges::equal(a, b, {}, &Part::id, &Part::id);
}

class JigReader {
public:
    JigReader(const std::vector<Observations>& takes, const KnownDistances& known,
              const SourceOffsetSettings& settings)
        : takes_(takes), known_(known), settings_(settings) {}

    JigData read() {
        if (takes_.empty()) {
            find(Grade::kNotUsable, "", "There is no take of the jig",
                 "Record one with every placement marked");
            return std::move(data_);
        }
        data_.suit = takes_.front().suit;
        for (const Board& board : data_.suit.boards) {
            const BoardCalibration* in_force = takes_.front().calibration.findBoard(board.id);
            data_.mic_delay_s.push_back(in_force ? in_force->mic_delay_s : 0);
        }
        indexDistances();
        for (const Observations& take : takes_)
            readTake(take);
        reportLabels();
        reportParts();
        return std::move(data_);
    }

private:
    void find(Grade grade, const std::string& part, const std::string& what, const std::string& remedy) {
        data_.findings.push_back({grade, part, asSentence(what), remedy});
    }

    void indexDistances() {
        std::set<std::string> strangers;
        for (const KnownDistance& known : known_.distances) {
            labels_in_file_.insert(known.placement);
            if (data_.suit.findSource(known.source) < 0)
                strangers.insert("source " + known.source);
            if (data_.suit.findBoard(known.board) < 0)
                strangers.insert("board " + known.board);
            if (std::isfinite(known.distance_m) && known.distance_m > 0)
                distances_.emplace(PairKey{known.placement, known.source, known.board}, &known);
            else
                find(Grade::kUsable, known.source,
                     "In " + known_.where + ", placement " + known.placement + ", source " + known.source +
                         " and board " + known.board + " are at the same point",
                     "Measure the two points again");
        }
        if (!strangers.empty())
            find(Grade::kUsable, "",
                 known_.where + " names parts that this suit does not have: " + listed(strangers),
                 "Correct the names in the file; until then their rows are left out");
    }

    void readTake(const Observations& take) {
        const Observations& first = takes_.front();
        if (!haveEqualIds(take.suit.boards, first.suit.boards) ||
            !haveEqualIds(take.suit.sources, first.suit.sources) || take.detector != first.detector)
            return find(Grade::kNotUsable, "",
                        take.take + " is of another suit or detector than " + first.take,
                        "Calibrate them one by one");
        if (take.placements.empty())
            return find(Grade::kNotUsable, "", take.take + " has no placements marked",
                        "Mark the begin and end of every placement while the jig is recorded");
        for (const Stretch& stretch : take.placements) {
            labels_in_takes_.insert(stretch.label);
            if (labels_in_file_.contains(stretch.label))
                readStretch(take, stretch);
        }
    }

    void readStretch(const Observations& take, const Stretch& stretch) {
        const double settle_s =
            std::min(settings_.settle_s, kMostOfStretch * (stretch.end_s - stretch.begin_s));
        auto flight =
            std::ranges::lower_bound(take.flights, stretch.begin_s + settle_s, {}, &FlightTime::time_s);
        const double rescaled =
            takes_.front().calibration.sound.scale / std::max(1e-9, take.calibration.sound.scale);
        std::map<std::pair<int, int>, std::vector<FlightTime>> heard;
        for (; flight != take.flights.end() && flight->time_s <= stretch.end_s - settle_s; ++flight)
            if (isTrusted(*flight)) {
                heard[{flight->source, flight->board}].push_back(*flight);
                heard[{flight->source, flight->board}].back().c_m_per_s *= rescaled;
            }
        const int index = data_.stretches++;
        for (const auto& [pair, flights] : heard) {
            const auto known =
                distances_.find({stretch.label, data_.suit.sources[static_cast<size_t>(pair.first)].id,
                                 data_.suit.boards[static_cast<size_t>(pair.second)].id});
            if (known != distances_.end() && static_cast<int>(flights.size()) >= settings_.min_pulses)
                data_.measurements.push_back(measured(index, *known->second, flights));
        }
    }

    bool isTrusted(const FlightTime& flight) const {
        return flight.source >= 0 && flight.source < std::ssize(data_.suit.sources) && flight.board >= 0 &&
               flight.board < std::ssize(data_.suit.boards) && std::isfinite(flight.flight_s) &&
               flight.c_m_per_s > 0 && flight.confidence >= settings_.min_confidence;
    }

    static JigMeasurement measured(int stretch, const KnownDistance& known,
                                   const std::vector<FlightTime>& flights) {
        std::vector<double> times_s, c_m_per_s;
        for (const FlightTime& flight : flights) {
            times_s.push_back(flight.flight_s);
            c_m_per_s.push_back(flight.c_m_per_s);
        }
        const double middle_s = medianOf(times_s);
        const double limit_s = kPulseOutlier * std::max(kLeastFlightSpread_s, spreadAbout(middle_s, times_s));
        double sum_s = 0, sum2_s2 = 0;
        int count = 0;
        for (const double time_s : times_s)
            if (const double off_s = time_s - middle_s; std::abs(off_s) <= limit_s) {
                sum_s += off_s;
                sum2_s2 += off_s * off_s;
                ++count;
            }
        const double mean_s = sum_s / count;
        const double variance_s2 = std::max(0.0, sum2_s2 / count - mean_s * mean_s);
        JigMeasurement result{known.placement,       stretch,          flights.front().source,
                              flights.front().board, known.distance_m, known.sigma_m};
        result.flight_s = middle_s + mean_s;
        result.flight_sigma_s = std::max(kLeastFlightSpread_s, std::sqrt(variance_s2)) / std::sqrt(count);
        result.c_m_per_s = medianOf(c_m_per_s);
        result.pulses = count;
        const auto half = times_s.begin() + std::ssize(times_s) / 2;
        result.moved = std::abs(medianOf({times_s.begin(), half}) - medianOf({half, times_s.end()})) >
                       kMoved_s + limit_s / std::sqrt(count);
        return result;
    }

    void reportLabels() {
        std::set<std::string> only_in_file, only_in_takes;
        std::ranges::set_difference(labels_in_file_, labels_in_takes_,
                                    std::inserter(only_in_file, only_in_file.end()));
        std::ranges::set_difference(labels_in_takes_, labels_in_file_,
                                    std::inserter(only_in_takes, only_in_takes.end()));
        if (labels_in_takes_.empty())
            return;
        if (only_in_file.size() == labels_in_file_.size())
            return find(Grade::kNotUsable, "",
                        "No placement of " + known_.where + " (" + listed(labels_in_file_) +
                            ") is marked in the take (" + listed(labels_in_takes_) + ")",
                        "Give the placements the same labels in the file and in the take");
        if (!only_in_file.empty())
            find(Grade::kUsable, "",
                 "The take has no marker for these placements of " + known_.where + ": " +
                     listed(only_in_file),
                 "Correct the labels, or record these placements too");
        if (!only_in_takes.empty())
            find(
                Grade::kUsable, "",
                known_.where + " has no distances for these placements of the take: " + listed(only_in_takes),
                "Correct the labels, or measure these placements too");
    }

    /// Sources are reported where it is known whether they could be calibrated.
    void reportParts() {
        if (data_.measurements.empty())
            return;
        for (int b = 0; b < std::ssize(data_.suit.boards); ++b) {
            const std::string& id = data_.suit.boards[static_cast<size_t>(b)].id;
            const bool in_file = std::ranges::any_of(
                known_.distances, [&](const KnownDistance& known) { return known.board == id; });
            if (!in_file)
                find(Grade::kUsable, id, known_.where + " does not have " + jigBoard(data_.suit, b),
                     "Measure it too, so that the other boards need not stand for it");
            else if (std::ranges::find(data_.measurements, b, &JigMeasurement::board) ==
                     data_.measurements.end())
                find(Grade::kNotUsable, id, jigBoard(data_.suit, b) + " heard no source in any placement",
                     "See that its plug sits and that its microphone's opening is free");
        }
    }

    const std::vector<Observations>& takes_;
    const KnownDistances& known_;
    const SourceOffsetSettings& settings_;
    JigData data_;
    std::map<PairKey, const KnownDistance*> distances_;
    std::set<std::string> labels_in_file_, labels_in_takes_;
};

}  // namespace

std::string jigBoard(const Suit& suit, int board) {
    return "board " + std::to_string(board + 1) + ", " + suit.boards[static_cast<size_t>(board)].id;
}

std::string jigSource(const Suit& suit, int source) {
    return "source " + std::to_string(source + 1) + ", " + suit.sources[static_cast<size_t>(source)].id;
}

std::string asSentence(std::string words) {
    if (words.starts_with("board ") || words.starts_with("source ") || words.starts_with("placement "))
        words[0] = static_cast<char>(words[0] - ('a' - 'A'));
    return words;
}

JigData measureJig(const std::vector<Observations>& takes, const KnownDistances& known,
                   const SourceOffsetSettings& settings) {
    return JigReader(takes, known, settings).read();
}

}  // namespace noctule
