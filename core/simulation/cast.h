// SPDX-License-Identifier: Apache-2.0
// Several performers and a room's anchors: each wears a suit with its own carrier, pulse interval and clock,
// all are in one world and one chamber. A cast is a list of stages, one of each suit.
#pragma once

#include "core/simulation/cast_world.h"
#include "core/simulation/simulate.h"
#include "core/simulation/sound_room.h"
#include "core/simulation/suit_rows.h"

namespace noctule::simulation {

struct CastSubject {
    std::string name;
    StageRequest stage;                  ///< motion, actor and suit; scenario, seed and timing are the cast's
    std::optional<StandingPlace> place;  ///< none: where the motion's file has the performer
    double start_s = 0;                  ///< how much longer the rest pose is held
    std::optional<double> carrier_hz{};  ///< none: the suit's, or else the next one that is free
    std::optional<int> pulse_interval_samples{};
};

struct CastRequest {
    std::vector<CastSubject> subjects;
    std::optional<Suit> room;  ///< anchors; all of their segments are empty
    bool shared_clock = false;
    Scenario scenario;
    std::optional<double> rest_seconds;  ///< none: the scenario's
    double duration_s = 0;               ///< of the whole take; 0: the longest motion once
    double comes_back_s = 0;             ///< > 0: all go through it to and fro together for so long
    uint64_t seed = 1;
};

/// Of the take's suits the one with index + 1 as its id.
struct CastSuit {
    std::string name;  ///< of the subject; empty: the room
    Stage stage;
    BoxClock clock;         ///< truth
    SuitClock first_guess;  ///< what the recorder believes

    bool isRoom() const { return name.empty(); }
};

struct Cast {
    std::vector<CastSuit> suits;
    bool shared_clock = false;
    Room chamber;
    std::vector<StandingPlace> places;  ///< per subject
    std::vector<std::string> notes;     ///< what was decided, one sentence each

    nlohmann::json truthJson() const;
    /// -1: nobody is called so; the room is called "room".
    int find(const std::string& name) const;
};

/// As rows and sound are made of them; good as long as the cast stays where it is.
std::vector<StagedSuit> stagedSuits(const Cast& cast);

/// Fails (kUsage) when two suits have one carrier or two subjects one name, and for whatever prepareStage()
/// does not make.
Result<Cast> prepareCast(const CastRequest& request);

Result<SimulationSummary> writeTake(const Cast& cast, const TakeRequest& request, const JobContext& job);

/// The carriers that suits get, in this order; neighbours are 5 kHz apart, the first five as usual.
inline constexpr double kCarriers_hz[] = {40000, 48000, 58000, 32800, 25000, 68000, 63000, 53000};
inline constexpr double kLowestCarrier_hz = 24000, kHighestCarrier_hz = 68000;
inline constexpr double kCarrierSpacing_hz = 5000;

}  // namespace noctule::simulation
