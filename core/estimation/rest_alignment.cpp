// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/rest_alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

constexpr double kBin_s = 0.5;
constexpr size_t kFewestPairs = 6;
constexpr int kIterations = 15;
constexpr double kCoarse_m = 0.15, kFine_m = 0.03;  ///< scale of the Cauchy loss
constexpr double kWorstFit_m = 0.08;                ///< a body cannot be said to stand there
constexpr size_t kFewestAnchors = 4;                ///< so that one of them can be told from the others
constexpr size_t kFewestAgreeing = 3;               ///< two fit nearly everywhere
constexpr double kSuspicious_m = 0.025;             ///< median residual of an anchor
constexpr double kPlainlyBetter = 0.5;              ///< share of the misfit that is left without it
constexpr int kNoAnchor = -1;                       ///< board of no anchor
constexpr double kMovedAnchor_m = 0.04;             ///< beyond a survey's errors
constexpr double kAnyClock_m = 3, kAnyRate_m_per_s = 0.01;  ///< prior: 9 ms, 29 parts per million
constexpr double kKnownClock_m = 0.01, kKnownRate_m_per_s = 2e-4;

/// Mean of the ranges of one pair within one bin.
struct PairRow {
    Vector3d known_m, own_m;  ///< in the world, in the new member's frame
    double distance_m = 0, time_s = 0, weight = 0;
    double clock = 1;  ///< +1: the new member hears
    int known_member = 0, known_board = -1;
};

/// Where a member stands (x, z), its heading, its clock's error in metres and metres per second.
class PlaceFit {
public:
    PlaceFit(std::vector<PairRow> rows, bool clock_known, bool moves)
        : rows_(std::move(rows)), moves_(moves) {
        const double clock_m = clock_known ? kKnownClock_m : kAnyClock_m;
        const double rate = clock_known ? kKnownRate_m_per_s : kAnyRate_m_per_s;
        prior_ << 0, 0, 0, 1 / (clock_m * clock_m), 1 / (rate * rate);
        if (!moves)
            prior_.head<3>().setConstant(1e12);
    }

    double residual(const PairRow& row, const Vector5& u, Vector5* derivative = nullptr) const {
        const Matrix3d R = axisAngle(Vector3d::UnitY(), u[2]).toRotationMatrix();
        return residual(row, u, R, derivative);
    }
    double cost(const Vector5& u, double scale_m) const {
        const Matrix3d R = axisAngle(Vector3d::UnitY(), u[2]).toRotationMatrix();
        double sum = u.cwiseAbs2().tail<2>().dot(prior_.tail<2>()) * kFine_m * kFine_m;
        for (const PairRow& row : rows_)
            sum += row.weight * std::log1p(std::pow(residual(row, u, R, nullptr) / scale_m, 2));
        return sum;
    }
    double meanCost(const Vector5& u) const {
        double weight = 1e-9;
        for (const PairRow& row : rows_)
            weight += row.weight;
        return cost(u, kFine_m) / weight;
    }
    Vector5 improve(Vector5 u, double scale_m) const {
        for (int i = 0; i < kIterations; ++i) {
            const Matrix3d R = axisAngle(Vector3d::UnitY(), u[2]).toRotationMatrix();
            Matrix5 A = (prior_ * kFine_m * kFine_m).asDiagonal();
            Vector5 g = -(prior_ * kFine_m * kFine_m).cwiseProduct(u);
            if (!moves_)
                g.head<3>().setZero();
            A.diagonal().head<3>().array() += 1e-9;
            for (const PairRow& row : rows_) {
                Vector5 d;
                const double r = residual(row, u, R, &d);
                const double w = row.weight / (1 + std::pow(r / scale_m, 2));
                A += w * d * d.transpose();
                g += w * r * d;
            }
            Vector5 step = solveSymmetric(A, g);
            step.head<3>() *= std::min(1.0, 0.5 / std::max(1e-9, step.head<3>().norm()));
            u += step;
            if (step.norm() < 1e-7)
                break;
        }
        return u;
    }
    /// The clock that fits a place best, as far as medians tell.
    void guessClock(Vector5& u) const {
        std::array<std::vector<double>, 2> seen;
        u[3] = 0;
        for (const PairRow& row : rows_)
            seen[row.clock > 0 ? 1 : 0].push_back(residual(row, u) * row.clock);
        double sum = 0, count = 0;
        for (std::vector<double>& of : seen)
            if (!of.empty()) {
                std::ranges::nth_element(of, of.begin() + std::ssize(of) / 2);
                sum += of[of.size() / 2], count += 1;
            }
        u[3] = count > 0 ? sum / count : 0;
    }
    const std::vector<PairRow>& rows() const { return rows_; }

private:
    double residual(const PairRow& row, const Vector5& u, const Matrix3d& R, Vector5* derivative) const {
        const Vector3d turned = R * row.own_m;
        const Vector3d between = turned + Vector3d(u[0], 0, u[1]) - row.known_m;
        const double length = std::max(between.norm(), 1e-6);
        if (derivative) {
            const Vector3d direction = between / length;
            *derivative << direction.x(), direction.z(), direction.dot(Vector3d::UnitY().cross(turned)),
                row.clock, row.clock * row.time_s;
        }
        return row.distance_m - length - row.clock * (u[3] + u[4] * row.time_s);
    }

    std::vector<PairRow> rows_;
    Vector5 prior_;
    bool moves_;
};

struct Weighed {
    double value, weight;
};
/// Half of the weight lies below it: what is hardly trusted hardly counts.
double median(std::vector<Weighed>& values) {
    std::ranges::sort(values, {}, &Weighed::value);
    double all = 0, below = 0;
    for (const Weighed& one : values)
        all += one.weight;
    for (const Weighed& one : values)
        if ((below += one.weight) >= all / 2)
            return one.value;
    return values.back().value;
}

class Aligner {
public:
    Aligner(const std::vector<RestingMember>& members, const std::vector<JointDistance>& distances,
            std::vector<ClockLine> clocks, int without = kNoAnchor)
        : members_(members), distances_(distances), without_(without) {
        result.clocks = std::move(clocks);
        result.places.resize(members.size());
    }

    void fixFirst(size_t member) { result.places[member].placed = true; }

    /// Against all that are placed; `shifted`: whose clock takes up the difference.
    bool place(size_t member, size_t shifted) {
        std::vector<PairRow> bins = rowsOf(member, kBin_s), coarse = rowsOf(member, 1e9);
        if (coarse.size() < kFewestPairs)
            return false;
        const bool known = members_[member].clock_known && members_[shifted].clock_known;
        const bool moves = !members_[member].is_room;
        const PlaceFit rough(coarse, known, moves), fine(bins, known, moves);
        Vector5 best = Vector5::Zero();
        double least = -1;
        for (Vector5 u : starts(coarse, moves)) {
            if (!known)
                rough.guessClock(u);
            u = rough.improve(rough.improve(u, kCoarse_m), kFine_m);
            if (const double cost = rough.cost(u, kFine_m); least < 0 || cost < least)
                least = cost, best = u;
        }
        best = fine.improve(best, kFine_m);
        keep(member, shifted, fine, best);
        return result.places[member].placed;
    }

    RestAlignment result;
    using AnchorsOff = std::map<int, double>;  ///< median residual of each, of the body that it fits worst
    double misfit = 0;                         ///< mean loss per range, of all members
    AnchorsOff anchor_off_m, placed_off_m;     ///< of all bodies, of those that are placed

    double worstAnchor_m() const {
        double worst_m = 0;
        for (const auto& [anchor, off_m] : anchor_off_m)
            worst_m = std::max(worst_m, off_m);
        return worst_m;
    }
    /// A body that fits nowhere blames every anchor: where others are placed, they alone are asked.
    const AnchorsOff& judgedAnchors() const { return placed_off_m.empty() ? anchor_off_m : placed_off_m; }
    std::ptrdiff_t agreeingAnchors() const {
        return std::ranges::count_if(judgedAnchors(),
                                     [](const auto& entry) { return entry.second <= kMovedAnchor_m; });
    }

private:
    std::vector<PairRow> rowsOf(size_t member, double bin_s) const {
        std::map<std::tuple<int, int, int, bool, int64_t>, std::pair<PairRow, double>> means;
        for (const JointDistance& distance : distances_) {
            const auto from = static_cast<size_t>(distance.from), to = static_cast<size_t>(distance.to);
            const bool hears = to == member;
            const size_t other = hears ? from : to;
            if ((!hears && from != member) || !result.places[other].placed)
                continue;
            const int known_board = hears ? boardOf(members_[other], distance.source) : distance.board;
            if (members_[other].is_room && known_board == without_)
                continue;
            const double emitted_s = result.clocks[from].common_s(distance.emission_s);
            if (!isStill(members_[from], emitted_s) || !isStill(members_[to], emitted_s))
                continue;
            const auto bin = static_cast<int64_t>(std::floor((emitted_s - members_[member].from_s) / bin_s));
            auto& [row, count] =
                means[{static_cast<int>(other), distance.source, distance.board, hears, bin}];
            const double weight = std::max(distance.confidence, 1e-3);
            if (count == 0) {
                const Vector3d source = members_[from].sources_m[static_cast<size_t>(distance.source)];
                const Vector3d board = members_[to].microphones_m[static_cast<size_t>(distance.board)];
                row.own_m = hears ? board : source;
                row.known_m = inWorld(other, hears ? source : board);
                row.clock = hears ? 1 : -1;
                row.known_member = static_cast<int>(other);
                row.known_board = known_board;
            }
            count += weight;
            row.weight += weight;
            row.distance_m += (distance.distance_m(result.clocks) - row.distance_m) * weight / count;
            row.time_s += (emitted_s - kTimeOrigin_s - row.time_s) * weight / count;
        }
        std::vector<PairRow> rows;
        for (auto& [key, mean] : means)
            rows.push_back(mean.first);
        return rows;
    }
    /// An anchor without a microphone counts as one of its own, below -1.
    static int boardOf(const RestingMember& member, int source) {
        const auto s = static_cast<size_t>(source);
        const int board = s < member.housings.size() ? member.housings[s] : -1;
        return board >= 0 ? board : -2 - source;
    }
    static bool isStill(const RestingMember& member, double time_s) {
        return member.is_room || (time_s >= member.from_s && time_s <= member.to_s);
    }
    Vector3d inWorld(size_t member, const Vector3d& p_m) const {
        const RestPlace& place = result.places[member];
        return place.p_m + axisAngle(Vector3d::UnitY(), place.heading_rad) * p_m;
    }
    static std::vector<Vector5> starts(const std::vector<PairRow>& rows, bool moves) {
        if (!moves)
            return {Vector5::Zero()};
        Vector3d middle = Vector3d::Zero();
        for (const PairRow& row : rows)
            middle += row.known_m / static_cast<double>(rows.size());
        std::vector<Vector5> all;
        constexpr int kTurns = 8;
        for (const double radius_m : {0.0, 0.7, 1.4, 2.2, 3.2})
            for (int bearing = 0; bearing < (radius_m > 0 ? kTurns : 1); ++bearing)
                for (int heading = 0; heading < kTurns; ++heading) {
                    const double at = 2 * std::numbers::pi * bearing / kTurns;
                    Vector5 u = Vector5::Zero();
                    u[0] = middle.x() + radius_m * std::cos(at);
                    u[1] = middle.z() + radius_m * std::sin(at);
                    u[2] = 2 * std::numbers::pi * heading / kTurns;
                    all.push_back(u);
                }
        return all;
    }
    void keep(size_t member, size_t shifted, const PlaceFit& fit, const Vector5& u) {
        std::vector<Weighed> sizes;
        std::map<int, std::vector<Weighed>> of_anchor;
        for (const PairRow& row : fit.rows()) {
            sizes.push_back({std::abs(fit.residual(row, u)), row.weight});
            if (members_[static_cast<size_t>(row.known_member)].is_room)
                of_anchor[row.known_board].push_back(sizes.back());
        }
        for (auto& [anchor, values] : of_anchor)
            anchor_off_m[anchor] = std::max(anchor_off_m[anchor], median(values));
        misfit += fit.meanCost(u);
        RestPlace& place = result.places[member];
        place.rms_m = 1.48 * median(sizes);
        place.placed = place.rms_m < kWorstFit_m;
        if (!place.placed)
            return;
        for (auto& [anchor, values] : of_anchor)
            placed_off_m[anchor] = std::max(placed_off_m[anchor], median(values));
        place.p_m = {u[0], 0, u[1]};
        place.heading_rad = std::remainder(u[2], 2 * std::numbers::pi);
        for (auto& [anchor, values] : of_anchor)
            if (anchor >= 0 && median(values) > kMovedAnchor_m && of_anchor.size() > 3 &&
                std::ranges::count(result.moved_anchors, anchor) == 0)
                result.moved_anchors.push_back(anchor);
        // d = D - (b_to - b_from): the member's own clock runs late by b, or the other one's early.
        const double sign = shifted == member ? 1 : -1;
        ClockLine& line = result.clocks[shifted];
        const double b_s = sign * u[3] / kSound_m_per_s, rate = sign * u[4] / kSound_m_per_s;
        line.offset_s -= b_s + rate * (line.offset_s - kTimeOrigin_s);
        line.rate *= 1 - rate;
    }

    static constexpr double kTimeOrigin_s = 0, kSound_m_per_s = 344;
    const std::vector<RestingMember>& members_;
    const std::vector<JointDistance>& distances_;
    int without_;  ///< an anchor that is left out
};

/// The first body's clock is the common time: where the room comes first, its clock gives way.
void placeAll(Aligner& aligner, size_t room, bool uses_room) {
    aligner.fixFirst(uses_room ? room : 0);
    bool room_has_clock = !uses_room;
    for (size_t member = uses_room ? 0 : 1; member < room; ++member)
        if (aligner.place(member, room_has_clock ? member : room))
            room_has_clock = true;
}

std::set<int> anchorsOf(const RestingMember& room) {
    std::set<int> anchors;
    for (size_t board = 0; board < room.microphones_m.size(); ++board)
        anchors.insert(static_cast<int>(board));
    return anchors;
}

}  // namespace

RestingMember restingMember(const KinematicTree& tree, const SuitModel& suit, const Pose& rest) {
    const MotionState motion = tree.stateFromPose(rest);
    RestingMember member;
    ChainMotion chain;
    const auto at = [&](int link, const Vector3d& p) -> Vector3d {
        if (link < 0)
            return p;
        chain.evaluate(tree, motion, link, 0);
        return chain.point(p).p_m;
    };
    for (const MountedSource& source : suit.sources)
        member.sources_m.push_back(at(source.link, source.p_link_source));
    for (const MountedBoard& board : suit.boards)
        member.microphones_m.push_back(at(board.link, placeBoard(board, tree, motion, 0).p_mic_m));
    return member;
}

RestingMember restingRoom(const SuitModel& suit, const std::vector<int>& housings) {
    RestingMember room;
    room.is_room = true;
    room.housings = housings;
    for (const MountedSource& source : suit.sources)
        room.sources_m.push_back(source.p_link_source);
    for (const MountedBoard& board : suit.boards)
        room.microphones_m.push_back(board.p_link_mic);
    return room;
}

RestAlignment alignAtRest(const std::vector<RestingMember>& members,
                          const std::vector<JointDistance>& distances, std::vector<ClockLine> clocks,
                          bool uses_room) {
    const size_t room = members.size() - 1;
    Aligner all(members, distances, clocks);
    placeAll(all, room, uses_room);
    const std::set<int> anchors = anchorsOf(members[room]);
    const auto judged = [heard = all.judgedAnchors().size()](Aligner& aligner) {
        aligner.result.room_contradicts =
            heard >= kFewestAgreeing && aligner.agreeingAnchors() < std::ptrdiff_t{kFewestAgreeing};
        return std::move(aligner.result);
    };
    if (!uses_room || anchors.size() < kFewestAnchors || all.worstAnchor_m() < kSuspicious_m)
        return judged(all);
    // An anchor that is off draws the fit of few others to itself, and another one seems to be off. So each
    // is left out in turn: without the right one all bodies fit.
    std::optional<Aligner> best;
    int moved = kNoAnchor;
    for (const int anchor : anchors) {
        Aligner rest(members, distances, clocks, anchor);
        placeAll(rest, room, uses_room);
        const auto placed = [](const Aligner& of) {
            return std::ranges::count(of.result.places, true, &RestPlace::placed);
        };
        if (placed(rest) >= placed(all) && (!best || rest.misfit < best->misfit)) {
            best.emplace(std::move(rest));
            moved = anchor;
        }
    }
    if (!best || best->misfit > kPlainlyBetter * all.misfit)
        return judged(all);
    if (std::ranges::count(best->result.moved_anchors, moved) == 0)
        best->result.moved_anchors.push_back(moved);
    return judged(*best);
}

}  // namespace noctule
