// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/rig_world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/job/contract.h"
#include "core/math/json.h"
#include "core/math/rotation.h"
#include "core/simulation/fade.h"

namespace noctule::simulation {
namespace {

// The jig: two boards of wood, one with the boards, one with the sources facing them.
constexpr double kJigWidth_m = 0.5, kJigHeight_m = 0.3;
constexpr double kJigSlotPlay = 0.4;    ///< of a slot's size, to either side
constexpr double kJigMargin_m = 0.002;  ///< within the range of distances
// Plate and table.
constexpr double kSeatPitch_m = 0.05, kSeatsInRow = 6;
const Vector3d kCenter(0, RigWorld::kHeight_m, 0);
const Vector3d kSourceRow(0.35, 0.2, 0.6);  ///< half its width, height above the rig, distance

double radPerSecond(double rpm) {
    return rpm * 2 * std::numbers::pi / 60;
}

Matrix3<Jet> turnedAbout(const Vector3d& axis, const Jet& angle_rad) {
    const Jet half = angle_rad * 0.5, s = sin(half);
    return matrixOf(cos(half), s * axis.x(), s * axis.y(), s * axis.z());
}

/// A small rotation about a random horizontal axis.
Quaterniond tilted(Random random, double sigma_deg) {
    const double x = random.gaussian(radians(sigma_deg)), z = random.gaussian(radians(sigma_deg));
    return expQuaternion({x, 0, z});
}

/// What fadeWeight gathers by t, in seconds.
Jet faded(double t_s, double fade_s) {
    const Jet rate = fadeWeight<Jet>(t_s, fade_s);
    const double x = std::max(0.0, t_s / fade_s);
    const double gathered = x < 1 ? x * x * x * x * (2.5 + x * (x - 3)) : x - 0.5;
    return {fade_s * gathered, rate.value, rate.rate};
}

/// Places in a rectangle around the origin, one for each of `count`, in random order and a little off.
std::vector<Eigen::Vector2d> slots(int count, Random& random) {
    const int columns =
        std::max(1, static_cast<int>(std::ceil(std::sqrt(count * kJigWidth_m / kJigHeight_m))));
    const int rows = (count + columns - 1) / columns;
    const Eigen::Vector2d size(kJigWidth_m / columns, kJigHeight_m / std::max(1, rows));
    std::vector<Eigen::Vector2d> places;
    for (int i = 0; i < count; ++i) {
        // Drawn one by one: compilers evaluate arguments in different orders.
        const double play_y = random.uniform(-kJigSlotPlay, kJigSlotPlay),
                     play_x = random.uniform(-kJigSlotPlay, kJigSlotPlay);
        const Eigen::Vector2d play(play_x, play_y);
        const Eigen::Vector2d slot(i % columns + 0.5, i / columns + 0.5);
        places.push_back((slot + play).cwiseProduct(size) - Eigen::Vector2d(kJigWidth_m, kJigHeight_m) / 2);
        std::swap(places.back(), places[random.below(i + 1)]);
    }
    return places;
}

}  // namespace

const char* nameOf(RigKind kind) {
    switch (kind) {
        case RigKind::kJig:
            return "jig";
        case RigKind::kLevelPlate:
            return "level";
        case RigKind::kTurntable:
            return "turntable";
        case RigKind::kBag:
            break;
    }
    return "bag";
}

std::vector<RigSide> allRigSides() {
    return {{1, +1}, {1, -1}, {0, +1}, {0, -1}, {2, +1}, {2, -1}};
}

RigWorld::RigWorld(RigKind kind, const Suit& suit, const RigScenario& scenario, uint64_t seed,
                   double duration_s)
    : kind_(kind), duration_s_(duration_s) {
    for (const Board& board : suit.boards)
        boards_.push_back(board.p_board_mic_m);
    side_errors_.fill(Quaterniond::Identity());
    if (kind == RigKind::kLevelPlate)
        for (size_t side = 0; side < side_errors_.size(); ++side)
            side_errors_[side] = tilted(Random(seed, "level plate", side), scenario.level_plate_error_deg);
    if (kind == RigKind::kTurntable) {
        table_tilt_ = tilted(Random(seed, "turntable tilt"), scenario.turntable_tilt_deg);
        speed_error_ = Random(seed, "turntable speed").gaussian(scenario.turntable_speed_error);
    }
    kind == RigKind::kJig ? arrangeJig(suit, scenario, seed) : arrangeTable(suit);
    first_seat_ = seatOn(side_);
}

/// Sources and boards face each other; the nearer wood is, the wider the angles. In each placement everything
/// has another place, so that no error of one place stays with one board.
void RigWorld::arrangeJig(const Suit& suit, const RigScenario& scenario, uint64_t seed) {
    const double nearest_m = scenario.jig_range_m[0] + kJigMargin_m;
    const double farthest_m = std::sqrt(std::pow(scenario.jig_range_m[1] - kJigMargin_m, 2) -
                                        kJigWidth_m * kJigWidth_m - kJigHeight_m * kJigHeight_m);
    require(farthest_m > nearest_m, "RigWorld: the jig is wider than its range");
    for (int k = 0; k < scenario.jig_placements; ++k) {
        Random random(seed, "jig", static_cast<uint64_t>(k));
        const double apart_m =
            nearest_m + (farthest_m - nearest_m) * k / std::max(1, scenario.jig_placements - 1);
        Placement placement;
        for (const Eigen::Vector2d& slot : slots(static_cast<int>(suit.sources.size()), random))
            placement.sources_m.push_back(kCenter + Vector3d(slot.x(), slot.y(), apart_m));
        const auto seats = slots(static_cast<int>(suit.boards.size()), random);
        for (size_t b = 0; b < seats.size(); ++b)
            placement.boards_m.push_back(kCenter + Vector3d(seats[b].x(), seats[b].y(), 0) - boards_[b]);
        placements_.push_back(std::move(placement));
    }
    normals_.assign(suit.sources.size(), -Vector3d::UnitZ());
}

void RigWorld::arrangeTable(const Suit& suit) {
    Placement placement;
    const auto boards = static_cast<double>(suit.boards.size()),
               sources = static_cast<double>(suit.sources.size());
    const double rows = std::ceil(boards / kSeatsInRow);
    for (size_t b = 0; b < suit.boards.size(); ++b) {
        const double column = std::fmod(static_cast<double>(b), kSeatsInRow);
        const double row = std::floor(static_cast<double>(b) / kSeatsInRow);
        placement.boards_m.push_back(
            kCenter + kSeatPitch_m * Vector3d(column - (kSeatsInRow - 1) / 2, 0, row - (rows - 1) / 2));
    }
    for (size_t s = 0; s < suit.sources.size(); ++s) {
        const double across = sources > 1 ? 2 * static_cast<double>(s) / (sources - 1) - 1 : 0;
        placement.sources_m.push_back(kCenter + kSourceRow.cwiseProduct(Vector3d(across, 1, 1)));
        normals_.push_back((kCenter - placement.sources_m.back()).normalized());
    }
    placements_ = {std::move(placement)};
}

Quaterniond RigWorld::seatOn(RigSide side) const {
    // Opposite sides lie half a turn about a horizontal axis apart.
    const Quaterniond upright = side == RigSide{1, -1} ? axisAngle(Vector3d::UnitX(), std::numbers::pi)
                                                       : smallestRotation(side.up(), Vector3d::UnitY());
    return side_errors_[side.index()] * upright;
}

void RigWorld::turn(double begin_s, double angle_rad, const Vector3d& axis) {
    const Quaterniond from = turns_.empty() ? first_seat_ : turns_.back().to;
    turns_.push_back({begin_s, angle_rad, axis, from, expQuaternion(angle_rad * axis) * from});
}

double RigWorld::turnTo(RigSide side, double t_s) {
    const Vector3d way = logQuaternion(seatOn(side) * seatOn(side_).conjugate());
    turn(t_s, way.norm(), way.norm() > 0 ? Vector3d(way.normalized()) : Vector3d::UnitY());
    side_ = side;
    return ready_s_ = t_s + kTurn_s;
}

double RigWorld::changeSpeed(double to_rad_per_s, double t_s) {
    if (to_rad_per_s == speed_rad_per_s_)
        return ready_s_ = t_s;
    speeds_.push_back({t_s, to_rad_per_s - speed_rad_per_s_});
    speed_rad_per_s_ = to_rad_per_s;
    return ready_s_ = t_s + kSpeedUp_s;
}

double RigWorld::layOn(RigSide side, double t_s) {
    const double begin_s = std::max(t_s, ready_s_);
    return side == side_ ? begin_s : turnTo(side, begin_s);
}

double RigWorld::spin(RigSide side, double rpm, double t_s) {
    double begin_s = std::max(t_s, ready_s_);
    if (side != side_ && rpm != 0)
        begin_s = turnTo(side, changeSpeed(0, begin_s));
    return changeSpeed(radPerSecond(rpm) * (1 + speed_error_), begin_s);
}

double RigWorld::place(int placement, double t_s) {
    const double begin_s = std::max(t_s, ready_s_);
    if (placement == placement_)
        return begin_s;
    moves_.push_back({begin_s, placement_, placement});
    placement_ = placement;
    return ready_s_ = begin_s + kMove_s;
}

/// Axes in the world: a golden spiral over the sphere, so that no two rolls are about the same one.
double RigWorld::roll(double seconds, double t_s) {
    const double end_s = std::max(t_s, ready_s_) + seconds;
    for (double begin_s = std::max(t_s, ready_s_); begin_s < end_s; begin_s += kTurn_s) {
        const double share = std::fmod(0.5 + 0.618034 * rolls_, 1.0), y = 2 * share - 1;
        const double azimuth_rad = 2.399963 * rolls_++, across = std::sqrt(1 - y * y);
        turn(begin_s, radians(kRoll_deg),
             {across * std::sin(azimuth_rad), y, across * std::cos(azimuth_rad)});
        ready_s_ = begin_s + kTurn_s;
    }
    return ready_s_;
}

double RigWorld::carryTo(double height_m, double t_s) {
    const double begin_s = std::max(t_s, ready_s_);
    if (height_m == height_m_)
        return begin_s;
    lifts_.push_back({begin_s, height_m - height_m_});
    height_m_ = height_m;
    return ready_s_ = begin_s + kMove_s;
}

void RigWorld::beginAgain() {
    first_seat_ = seatOn(side_);
    first_height_m_ = height_m_;
    lifts_.clear();
    turns_.clear();
    speeds_.clear();
    if (speed_rad_per_s_ != 0)
        speeds_.push_back({-kSpeedUp_s, speed_rad_per_s_});
    first_placement_ = placement_;
    moves_.clear();
    ready_s_ = 0;
}

Matrix3<Jet> RigWorld::seatAt(double t_s) const {
    const auto standing = [](const Quaterniond& seat) -> Matrix3<Jet> {
        return seat.toRotationMatrix().cast<Jet>();
    };
    const auto next =
        std::ranges::partition_point(turns_, [t_s](const Turn& turn) { return turn.begin_s <= t_s; });
    if (next == turns_.begin())
        return standing(first_seat_);
    const Turn& latest = *std::prev(next);
    if (t_s >= latest.begin_s + kTurn_s)
        return standing(latest.to);
    return turnedAbout(latest.axis, fadeWeight<Jet>(t_s - latest.begin_s, kTurn_s) * latest.angle_rad) *
           standing(latest.from);
}

Matrix3<Jet> RigWorld::tableAt(double t_s) const {
    if (speeds_.empty())
        return table_tilt_.toRotationMatrix().cast<Jet>();
    Jet angle_rad;
    for (const SpeedChange& change : speeds_)
        angle_rad += faded(t_s - change.begin_s, kSpeedUp_s) * change.by_rad_per_s;
    return table_tilt_.toRotationMatrix().cast<Jet>() * turnedAbout(Vector3d::UnitY(), angle_rad);
}

Vector3<Jet> RigWorld::pointAt(std::vector<Vector3d> Placement::*points, int index, double t_s) const {
    Vector3<Jet> point = (placements_[first_placement_].*points)[index].cast<Jet>();
    for (const Move& move : moves_) {
        const Jet weight = fadeWeight<Jet>(t_s - move.begin_s, kMove_s);
        const Vector3d way = (placements_[move.to].*points)[index] - (placements_[move.from].*points)[index];
        for (int i = 0; i < 3; ++i)
            point[i] += weight * way[i];
    }
    return point;
}

Vector3<Jet> RigWorld::centerAt(double t_s) const {
    Vector3<Jet> center = kCenter.cast<Jet>();
    center.y() = Jet(first_height_m_);
    for (const Lift& lift : lifts_)
        center.y() += fadeWeight<Jet>(t_s - lift.begin_s, kMove_s) * lift.by_m;
    return center;
}

Frame<Jet> RigWorld::boardFrame(int board, double t_s) const {
    const Matrix3<Jet> table = tableAt(t_s);
    return {table * seatAt(t_s),
            centerAt(t_s) + table * (pointAt(&Placement::boards_m, board, t_s) - kCenter.cast<Jet>())};
}

/// A beam below the floor, magnetised by the Earth's vertical field: a dipole.
Vector3d RigWorld::field_ut(const Vector3d& p_world_m) const {
    if (kind_ != RigKind::kBag)
        return kEarthField_ut;
    constexpr double kMoment_ut_m3 = 0.256;
    const Vector3d beam_m(0, -0.25, 0), from_m = p_world_m - beam_m;
    const double distance_m = std::max(0.1, from_m.norm());
    const Vector3d unit = from_m / distance_m;
    const Vector3d down = -Vector3d::UnitY();
    return kEarthField_ut + kMoment_ut_m3 / std::pow(distance_m, 3) * (3 * down.dot(unit) * unit - down);
}

Vector3d RigWorld::microphone(int board, double t_s) const {
    const Frame<Jet> frame = boardFrame(board, t_s);
    return values(Vector3<Jet>(frame.p + rotate(frame.r, boards_[board])));
}

Vector3d RigWorld::source(int source, double t_s) const {
    return values(pointAt(&Placement::sources_m, source, t_s));
}

BoardMotion RigWorld::boardMotion(int board, double t_s) const {
    return motionOf(boardFrame(board, t_s));
}

nlohmann::json RigWorld::truthJson(const RigScenario& scenario, const Suit& suit) const {
    nlohmann::json truth = {{"rig", nameOf(kind_)}};
    if (kind_ == RigKind::kTurntable)
        truth["turntable"] = {{"rpm", scenario.turntable_rpm * (1 + speed_error_)},
                              {"axis_world", json::fromVector(table_tilt_ * Vector3d::UnitY())}};
    if (kind_ == RigKind::kLevelPlate)
        for (const RigSide side : allRigSides())
            truth["level_plate"][side.name()] = {
                {"up_board", json::fromVector(seatOn(side).conjugate() * Vector3d::UnitY())}};
    if (kind_ != RigKind::kJig)
        return truth;
    for (int k = 0; k < placementCount(); ++k) {
        nlohmann::json placement = {{"placement", std::to_string(k + 1)}};
        for (int s = 0; s < sourceCount(); ++s)
            placement["sources"][suit.sources[s].id] = json::fromVector(sourceIn(k, s));
        for (int b = 0; b < boardCount(); ++b)
            placement["boards"][suit.boards[b].id] = json::fromVector(microphoneIn(k, b));
        truth["jig"].push_back(placement);
    }
    return truth;
}

}  // namespace noctule::simulation
