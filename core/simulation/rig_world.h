// SPDX-License-Identifier: Apache-2.0
// The suit off the body, on one of the rigs of calibration: on the jig boards and sources stand apart at
// known distances, on the level plate and the turntable the boards lie side by side, each turned in its own
// seat, and the sources stand in a row before them. In the bag they lie likewise, are rolled by
// hand through all directions and carried up and down. The world's truth; the numbers are the scenario's, and
// so are the rig's own errors, drawn once per take. Every movement takes its time and is felt.
#pragma once

#include <nlohmann/json.hpp>

#include "core/simulation/jet.h"
#include "core/simulation/random.h"
#include "core/simulation/scenario.h"
#include "core/simulation/suit_world.h"
#include "core/suit/suit.h"

namespace noctule::simulation {

enum class RigKind { kJig, kLevelPlate, kTurntable, kBag };

/// "jig", "level", "turntable", "bag", as the command line and takes write them.
const char* nameOf(RigKind kind);

/// An axis of the boards that points up: +x, -x, +y, -y, +z, -z.
struct RigSide {
    int axis = 1;   ///< 0 x, 1 y, 2 z
    int sign = +1;  ///< -1: it points down

    Vector3d up() const { return sign * Vector3d::Unit(axis); }
    std::string name() const { return std::string(sign > 0 ? "+" : "-") + "xyz"[axis]; }
    int index() const { return 2 * axis + (sign > 0 ? 0 : 1); }
    bool operator==(const RigSide&) const = default;
};
/// That in which the boards begin comes first.
std::vector<RigSide> allRigSides();

class RigWorld : public SuitWorld {
public:
    static constexpr double kTurn_s = 1.5;    ///< of the boards onto another side
    static constexpr double kMove_s = 2;      ///< from one placement to another
    static constexpr double kRoll_deg = 100;  ///< of the bag, each in kTurn_s
    static constexpr double kSpeedUp_s = 2;   ///< of the turntable, and until it stands
    static constexpr double kHeight_m = 1.0;  ///< of the rig above the floor

    /// Boards begin with their y axes up, the table stands, the jig is in its first placement.
    RigWorld(RigKind kind, const Suit& suit, const RigScenario& scenario, uint64_t seed, double duration_s);

    RigKind kind() const { return kind_; }
    int placementCount() const { return static_cast<int>(placements_.size()); }

    // From t on, or when what was asked for before is done. They return when it is done. What was asked about
    // times after t before is not taken back.
    double layOn(RigSide side, double t_s);
    /// Right-handed about `side`, which points up: counter-clockwise as seen from above. Another side stops
    /// the table first; 0 stops it.
    double spin(RigSide side, double rpm, double t_s);
    double place(int placement, double t_s);
    /// The bag: rolled about ever other axes for about so long, one roll after another without a pause.
    double roll(double seconds, double t_s);
    /// The bag: to another height above the floor, without turning it.
    double carryTo(double height_m, double t_s);

    double duration_s() const override { return duration_s_; }
    int boardCount() const override { return static_cast<int>(boards_.size()); }
    int sourceCount() const override { return static_cast<int>(normals_.size()); }
    Vector3d microphone(int board, double t_s) const override;
    Vector3d source(int source, double t_s) const override;
    Vector3d sourceNormal(int source, double) const override { return normals_[source]; }
    int boardSegment(int) const override { return -1; }
    int sourceSegment(int) const override { return -1; }
    void capsules(double, std::vector<WorldCapsule>& capsules) const override { capsules.clear(); }
    BoardMotion boardMotion(int board, double t_s) const override;
    /// The bag's room has a steel beam in its floor; near it the field is some 15 % stronger.
    Vector3d field_ut(const Vector3d& p_world_m) const override;
    void beginAgain() override;

    /// What nobody knows: tilts and the table's true speed at its nominal one, points of every placement.
    nlohmann::json truthJson(const RigScenario& scenario, const Suit& suit) const;
    /// Where things stand in a placement of the jig: sources, and the boards' microphones.
    Vector3d sourceIn(int placement, int source) const { return placements_[placement].sources_m[source]; }
    Vector3d microphoneIn(int placement, int board) const {
        return placements_[placement].boards_m[board] + boards_[board];
    }

private:
    struct Placement {
        std::vector<Vector3d> sources_m, boards_m;  ///< in the world while the table stands
    };
    struct Turn {
        double begin_s = 0, angle_rad = 0;
        Vector3d axis = Vector3d::UnitY();
        Quaterniond from, to;  ///< the seat before and after
    };
    struct SpeedChange {
        double begin_s = 0, by_rad_per_s = 0;
    };
    struct Lift {
        double begin_s = 0, by_m = 0;
    };
    struct Move {
        double begin_s = 0;
        int from = 0, to = 0;
    };

    void arrangeJig(const Suit& suit, const RigScenario& scenario, uint64_t seed);
    void arrangeTable(const Suit& suit);
    Quaterniond seatOn(RigSide side) const;
    void turn(double begin_s, double angle_rad, const Vector3d& axis);
    double turnTo(RigSide side, double t_s);
    double changeSpeed(double to_rad_per_s, double t_s);

    Matrix3<Jet> seatAt(double t_s) const;
    Matrix3<Jet> tableAt(double t_s) const;
    Vector3<Jet> centerAt(double t_s) const;
    Vector3<Jet> pointAt(std::vector<Vector3d> Placement::*points, int index, double t_s) const;
    Frame<Jet> boardFrame(int board, double t_s) const;

    RigKind kind_;
    double duration_s_;
    std::vector<Vector3d> boards_;   ///< of each p_board_mic_m
    std::vector<Vector3d> normals_;  ///< of sources
    std::vector<Placement> placements_;
    std::array<Quaterniond, 6> side_errors_;  ///< of the level plate
    Quaterniond table_tilt_ = Quaterniond::Identity();
    double speed_error_ = 0;

    double ready_s_ = 0;
    RigSide side_;
    Quaterniond first_seat_;
    std::vector<Turn> turns_;  ///< one after the other
    int rolls_ = 0;
    double first_height_m_ = kHeight_m, height_m_ = kHeight_m;
    std::vector<Lift> lifts_;
    double speed_rad_per_s_ = 0;
    std::vector<SpeedChange> speeds_;
    int first_placement_ = 0, placement_ = 0;
    std::vector<Move> moves_;
};

/// A stretch of a take in which a rig holds still, or turns evenly.
struct RigStation {
    double begin_s = 0, end_s = 0;
    std::string label;  ///< of its marker: "1", "+x up"
};

/// What a calibration does on a rig, one station after another: all placements, all six sides, all six sides
/// at the scenario's speed.
std::vector<RigStation> runThrough(RigWorld& rig, const RigScenario& scenario, double station_s);
/// How long a station is when the whole takes so long; not positive: too short for it.
double stationLength_s(RigKind kind, const RigScenario& scenario, double duration_s);
double usualDuration_s(RigKind kind, const RigScenario& scenario);

/// What a digitizer measured on the jig, as `calibrate sources` reads it: header, then one row per point and
/// placement.
std::string digitizerCsv(const RigWorld& jig, const Suit& suit, double sigma_m, uint64_t seed);

}  // namespace noctule::simulation
