// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/still_stretch.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/order_statistics.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kSlot_s = 0.25;
constexpr double kShake_rad_per_s = 0.1, kShake_m_per_s2 = 0.6;
constexpr double kTurn_rad_per_s = 0.1, kTurn_m_per_s2 = 0.4;
constexpr int kLeastReadings = 20;  // in the stretch: a seventh of a second
constexpr int kParts = 8;           // of the stretch, for the sigma of means
constexpr size_t kLeastFlights = 5;
constexpr double kSamePose_rad = radians(25);  // held twice, with a few degrees in each joint of a chain

struct SlotOfBoard {
    int readings = 0;
    Vector3d gyro_rad_per_s = Vector3d::Zero(), accel_m_per_s2 = Vector3d::Zero();  ///< means, without zeros
    double gyro_shake_rad_per_s = 0, accel_shake_m_per_s2 = 0;
};

/// Without its zeros: only differences count here.
AxisCalibration scaleOf(const Observations& take, size_t board, bool gyro) {
    const Board& described = take.suit.boards[board];
    const BoardCalibration* known = take.calibration.findBoard(described.id);
    if (known)
        return gyro ? known->gyro : known->accel;
    return AxisCalibration::nominal(gyro ? described.gyro_full_scale_rad_per_s
                                         : described.accel_full_scale_m_per_s2);
}

using Readings = std::vector<CountReading>;

/// Readings of [begin, end).
std::pair<Readings::const_iterator, Readings::const_iterator> between(const Readings& readings,
                                                                      double begin_s, double end_s) {
    return {std::ranges::lower_bound(readings, begin_s, {}, &CountReading::time_s),
            std::ranges::lower_bound(readings, end_s, {}, &CountReading::time_s)};
}

SlotOfBoard slotOf(const Readings& readings, double begin_s, const AxisCalibration& gyro,
                   const AxisCalibration& accel) {
    SlotOfBoard slot;
    const auto [first, last] = between(readings, begin_s, begin_s + kSlot_s);
    slot.readings = static_cast<int>(last - first);
    if (slot.readings == 0)
        return slot;
    double gyro_square = 0, accel_square = 0;
    for (auto reading = first; reading != last; ++reading) {
        const Vector3d omega = gyro.apply(reading->gyro_counts), a = accel.apply(reading->accel_counts);
        slot.gyro_rad_per_s += omega / slot.readings;
        slot.accel_m_per_s2 += a / slot.readings;
        gyro_square += omega.squaredNorm() / slot.readings;
        accel_square += a.squaredNorm() / slot.readings;
    }
    slot.gyro_shake_rad_per_s = std::sqrt(std::max(0.0, gyro_square - slot.gyro_rad_per_s.squaredNorm()));
    slot.accel_shake_m_per_s2 = std::sqrt(std::max(0.0, accel_square - slot.accel_m_per_s2.squaredNorm()));
    return slot;
}

bool moves(const SlotOfBoard& before, const SlotOfBoard& slot) {
    if (slot.gyro_shake_rad_per_s > kShake_rad_per_s || slot.accel_shake_m_per_s2 > kShake_m_per_s2)
        return true;
    return before.readings > 0 && slot.readings > 0 &&
           ((slot.gyro_rad_per_s - before.gyro_rad_per_s).norm() > kTurn_rad_per_s ||
            (slot.accel_m_per_s2 - before.accel_m_per_s2).norm() > kTurn_m_per_s2);
}

/// Adds the board's movements in the range; `still` keeps what no board disturbs.
void markMovements(const Observations& take, size_t board, const Stretch& range, std::vector<bool>& still,
                   std::vector<BoardMovement>& movements) {
    const AxisCalibration gyro = scaleOf(take, board, true), accel = scaleOf(take, board, false);
    SlotOfBoard before;
    bool moved_before = false;
    for (size_t i = 0; i < still.size(); ++i) {
        const double begin_s = range.begin_s + static_cast<double>(i) * kSlot_s;
        const SlotOfBoard slot = slotOf(take.boards[board], begin_s, gyro, accel);
        const bool moved = moves(before, slot);
        if (moved && moved_before)
            movements.back().end_s = begin_s + kSlot_s;
        else if (moved)
            movements.push_back({static_cast<int>(board), begin_s, begin_s + kSlot_s});
        if (moved)
            still[i] = false;
        moved_before = moved;
        before = moved ? SlotOfBoard{} : slot;
    }
}

/// Runs of still slots, in order of time.
std::vector<Stretch> runsOf(const std::vector<bool>& still, const Stretch& range) {
    std::vector<Stretch> runs;
    for (size_t i = 0; i < still.size(); ++i) {
        if (!still[i])
            continue;
        const double begin_s = range.begin_s + static_cast<double>(i) * kSlot_s;
        if (i == 0 || !still[i - 1])
            runs.push_back({begin_s, begin_s, "still"});
        runs.back().end_s = begin_s + kSlot_s;
    }
    return runs;
}

double length_s(const Stretch& stretch) {
    return stretch.end_s - stretch.begin_s;
}

/// Rotation that the readings integrate to with these zeros; each reading holds until the next.
Vector3d netRotation(Readings::const_iterator first, Readings::const_iterator last,
                     const AxisCalibration& gyro, const Vector3d& zero_counts) {
    Quaterniond q = Quaterniond::Identity();
    for (auto reading = first; std::next(reading) != last; ++reading) {
        const Vector3d counts = (reading->gyro_counts + std::next(reading)->gyro_counts) / 2 - zero_counts;
        q = q * expQuaternion(gyro.matrix * counts * (std::next(reading)->time_s - reading->time_s));
    }
    return logQuaternion(q);
}

/// Means of equal parts of the stretch: how they differ tells how sure the mean of all is.
struct PartMeans {
    std::vector<Vector3d> gyro, accel;
};
PartMeans partMeans(Readings::const_iterator first, Readings::const_iterator last) {
    PartMeans means;
    const auto length = (last - first) / kParts;
    for (int part = 0; part < kParts; ++part) {
        Vector3d gyro = Vector3d::Zero(), accel = Vector3d::Zero();
        for (auto reading = first + part * length; reading != first + (part + 1) * length; ++reading) {
            gyro += reading->gyro_counts / static_cast<double>(length);
            accel += reading->accel_counts / static_cast<double>(length);
        }
        means.gyro.push_back(gyro);
        means.accel.push_back(accel);
    }
    return means;
}

/// What rounding to whole counts does to a mean of readings with this variance: noise far below a count does
/// not smooth it away. Amplitude of the first harmonic (Widrow, Kollar, "Quantization Noise", section 9).
double roundingOfMean_counts(double variance_counts) {
    const double noise_square = std::max(0.0, variance_counts - 1.0 / 12);
    return std::exp(-2 * std::numbers::pi * std::numbers::pi * noise_square) /
           (std::numbers::pi * std::numbers::sqrt2);
}

Vector3d sigmaOfMean(const std::vector<Vector3d>& parts) {
    Vector3d mean = Vector3d::Zero(), square = Vector3d::Zero();
    for (const Vector3d& part : parts)
        mean += part / static_cast<double>(parts.size());
    for (const Vector3d& part : parts)
        square += (part - mean).cwiseAbs2();
    return (square / static_cast<double>(parts.size() * (parts.size() - 1))).cwiseSqrt();
}

StillBoard averageBoard(const Observations& take, size_t board, const Stretch& stretch) {
    StillBoard still;
    const auto [first, last] = between(take.boards[board], stretch.begin_s, stretch.end_s);
    const auto count = static_cast<int>(last - first);
    if (count < kLeastReadings)
        return still;
    still.readings = count;
    Vector3d gyro_square = Vector3d::Zero(), accel_square = Vector3d::Zero();
    for (auto reading = first; reading != last; ++reading) {
        still.clipped |= reading->clipped;
        still.gyro_counts += reading->gyro_counts / count;
        still.accel_counts += reading->accel_counts / count;
        gyro_square += reading->gyro_counts.cwiseAbs2() / count;
        accel_square += reading->accel_counts.cwiseAbs2() / count;
    }
    const AxisCalibration gyro = scaleOf(take, board, true), accel = scaleOf(take, board, false);
    const auto rounding = [](const AxisCalibration& of, const Vector3d& variance_counts) {
        return of.isOfCounts() ? Vector3d(variance_counts.unaryExpr(&roundingOfMean_counts))
                               : Vector3d::Zero();
    };
    const Vector3d gyro_rounding = rounding(gyro, gyro_square - still.gyro_counts.cwiseAbs2());
    const Vector3d accel_rounding = rounding(accel, accel_square - still.accel_counts.cwiseAbs2());
    const double lasts_s = std::prev(last)->time_s - first->time_s;
    const Matrix3d counts_of_rate = gyro.matrix.inverse();
    for (int round = 0; round < 3; ++round)  // the first step is exact but for the order of small rotations
        still.gyro_counts += counts_of_rate * netRotation(first, last, gyro, still.gyro_counts) / lasts_s;
    const PartMeans parts = partMeans(first, last);
    const Vector3d begins = accel.apply(parts.accel.front()), ends = accel.apply(parts.accel.back());
    if (begins.norm() > 0 && ends.norm() > 0)
        still.sway_rad = std::atan2(begins.cross(ends).norm(), begins.dot(ends));
    const Vector3d sway_counts = (counts_of_rate * Vector3d::Constant(still.sway_rad / lasts_s)).cwiseAbs();
    still.sigma_gyro_counts =
        (sigmaOfMean(parts.gyro).cwiseAbs2() + sway_counts.cwiseAbs2() + gyro_rounding.cwiseAbs2())
            .cwiseSqrt();
    still.sigma_accel_counts =
        (sigmaOfMean(parts.accel).cwiseAbs2() + accel_rounding.cwiseAbs2()).cwiseSqrt();
    const bool sensible = still.gyro_counts.allFinite() && still.accel_counts.allFinite();
    return sensible ? still : StillBoard{};
}

std::vector<StillFlight> averageFlights(const Observations& take, const Stretch& stretch) {
    struct Heard {
        std::vector<double> flight_s, confidence;
        double c_m_per_s = 0;
    };
    std::map<std::pair<int, int>, Heard> pairs;
    size_t most = 0;
    const auto known = [&](const FlightTime& flight) {
        return flight.source >= 0 && flight.source < static_cast<int>(take.suit.sources.size()) &&
               flight.board >= 0 && flight.board < static_cast<int>(take.suit.boards.size());
    };
    for (const FlightTime& flight : take.flights)
        if (known(flight) && stretch.contains(flight.time_s) && std::isfinite(flight.flight_s)) {
            Heard& heard = pairs[{flight.source, flight.board}];
            heard.flight_s.push_back(flight.flight_s);
            heard.confidence.push_back(flight.confidence);
            heard.c_m_per_s = flight.c_m_per_s;
            most = std::max(most, heard.flight_s.size());
        }
    std::vector<StillFlight> means;
    for (auto& [pair, heard] : pairs) {
        if (heard.flight_s.size() < std::max(kLeastFlights, most / 4))
            continue;
        const double median_s = middleValue(heard.flight_s);
        for (double& flight_s : heard.flight_s)
            flight_s = std::abs(flight_s - median_s);
        means.push_back({pair.first, pair.second, median_s, 1.4826 * middleValue(heard.flight_s),
                         middleValue(heard.confidence), heard.c_m_per_s});
    }
    return means;
}

size_t heardBoards(const Observations& take) {
    return std::min(take.boards.size(), take.suit.boards.size());
}

/// Every board is as upright as it was in the pose.
bool isHeldAgain(const StillStretch& pose, const Observations& take, const Stretch& run) {
    for (size_t b = 0; b < heardBoards(take); ++b) {
        const StillBoard now = averageBoard(take, b, run);
        const AxisCalibration accel = scaleOf(take, b, false);
        if (pose.boards[b].heard() && now.heard() &&
            logQuaternion(
                smallestRotation(accel.apply(pose.boards[b].accel_counts), accel.apply(now.accel_counts)))
                    .norm() > kSamePose_rad)
            return false;
    }
    return true;
}

std::vector<Stretch> stillRuns(const Observations& take, const Stretch& range,
                               std::vector<BoardMovement>& movements) {
    const double slots = std::floor(length_s(range) / kSlot_s + 1e-6);
    if (!(slots >= 1 && slots < 1e7))
        return {};
    std::vector<bool> still(static_cast<size_t>(slots), true);
    for (size_t b = 0; b < heardBoards(take); ++b)
        markMovements(take, b, range, still, movements);
    return runsOf(still, range);
}

}  // namespace

bool StillStretch::isUsable() const {
    return found && std::ranges::any_of(boards, &StillBoard::heard);
}

StillStretch findStillStretch(const Observations& take) {
    StillStretch all;
    all.marked = take.rest.has_value();
    all.boards.resize(take.suit.boards.size());
    const std::vector<Stretch> runs =
        stillRuns(take, take.rest.value_or(Stretch{0, take.duration_s, ""}), all.movements);
    std::ranges::stable_sort(all.movements, std::greater{},
                             [](const BoardMovement& moved) { return moved.end_s - moved.begin_s; });
    const auto longest = std::ranges::max_element(
        runs, {}, [](const Stretch& run) { return std::lround(length_s(run) / kSlot_s); });
    if (longest == runs.end())
        return all;
    all.stretch = *longest;
    all.found = length_s(all.stretch) >= StillStretch::kShortestStill_s;
    if (!all.found)
        return all;
    for (size_t b = 0; b < heardBoards(take); ++b)
        all.boards[b] = averageBoard(take, b, all.stretch);
    all.flights = averageFlights(take, all.stretch);
    return all;
}

std::vector<Stretch> returnsTo(const StillStretch& pose, const Observations& take) {
    std::vector<BoardMovement> movements;
    std::vector<Stretch> runs = stillRuns(take, {pose.stretch.end_s, take.duration_s, ""}, movements);
    std::erase_if(runs, [&](const Stretch& run) {
        return length_s(run) < StillStretch::kShortestStill_s || !isHeldAgain(pose, take, run);
    });
    return runs;
}

}  // namespace noctule
