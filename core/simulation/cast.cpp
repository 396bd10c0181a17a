// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/cast.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/body/text.h"
#include "core/simulation/anchor_world.h"
#include "core/simulation/take_maker.h"

namespace noctule::simulation {
namespace {

constexpr int kFirstInterval_samples = 1200, kIntervalStep_samples = 30;
constexpr double kTooNear_m = 0.3;  ///< of two performers' hips, who then were not recorded together
constexpr double kRowSpacing_m = 1.2;

uint64_t seedOfSuit(uint64_t seed, size_t suit) {
    return suit == 0 ? seed : Random(seed, "suit", suit).bits();
}

std::string hertz(double carrier_hz) {
    char text[32];
    std::snprintf(text, sizeof text, "%g kHz", carrier_hz / 1000);
    return text;
}

/// A suit that is to sound, before it has a stage.
struct Voice {
    std::string who;  ///< "subject A"
    std::optional<double> carrier_hz;
    std::optional<int64_t> interval_samples;
};

std::vector<Voice> voicesOf(const CastRequest& request) {
    std::vector<Voice> voices;
    for (const CastSubject& subject : request.subjects) {
        const Suit& suit = subject.stage.suit;
        Voice voice{"subject " + subject.name, suit.carrier_hz, suit.pulse_interval_samples};
        if (subject.carrier_hz)
            voice.carrier_hz = subject.carrier_hz;
        if (subject.pulse_interval_samples)
            voice.interval_samples = subject.pulse_interval_samples;
        voices.push_back(std::move(voice));
    }
    if (request.room)
        voices.push_back({"the room", request.room->carrier_hz, request.room->pulse_interval_samples});
    return voices;
}

bool collide(double one_hz, double other_hz) {
    return std::abs(one_hz - other_hz) < kCarrierSpacing_hz - 1e-6;
}

/// A usual carrier that nobody has, the usual of the voice's own place first.
std::optional<double> freeCarrier(const std::vector<Voice>& voices) {
    for (const double carrier_hz : kCarriers_hz)
        if (std::ranges::none_of(voices, [&](const Voice& voice) {
                return voice.carrier_hz && collide(*voice.carrier_hz, carrier_hz);
            }))
            return carrier_hz;
    return std::nullopt;
}

Error carrierClash(const Voice& one, const Voice& other, const std::vector<Voice>& voices) {
    const bool same = *one.carrier_hz == *other.carrier_hz;
    const auto free_hz = freeCarrier(voices);
    return {ErrorKind::kUsage,
            one.who + " and " + other.who + " both sound at " + hertz(*one.carrier_hz) +
                (same ? std::string() : " and " + hertz(*other.carrier_hz)) +
                ", and only carriers 5 kHz apart can be told from each other",
            free_hz ? "Give " + other.who + " another carrier_hz, such as " +
                          std::to_string(std::lround(*free_hz))
                    : "Leave out a subject: no carrier between 24 and 68 kHz is free"};
}

Status giveCarriers(std::vector<Voice>& voices) {
    for (size_t i = 0; i < voices.size(); ++i) {
        if (!voices[i].interval_samples)
            voices[i].interval_samples = kFirstInterval_samples + kIntervalStep_samples * int64_t(i);
        if (voices[i].carrier_hz &&
            !(*voices[i].carrier_hz >= kLowestCarrier_hz && *voices[i].carrier_hz <= kHighestCarrier_hz))
            return Error{ErrorKind::kUsage,
                         voices[i].who + " cannot sound at " + hertz(*voices[i].carrier_hz),
                         "Give a carrier_hz between 24000 and 68000"};
        for (size_t other = 0; other < i; ++other)
            if (voices[i].carrier_hz && voices[other].carrier_hz &&
                collide(*voices[i].carrier_hz, *voices[other].carrier_hz))
                return carrierClash(voices[other], voices[i], voices);
    }
    for (Voice& voice : voices) {
        if (voice.carrier_hz)
            continue;
        voice.carrier_hz = freeCarrier(voices);
        if (!voice.carrier_hz)
            return Error{ErrorKind::kUsage, "No carrier is left for " + voice.who,
                         "Leave out a subject: at most eight suits, the room's among them, fit between 24 "
                         "and 68 kHz"};
    }
    return Done{};
}

Scenario scenarioOf(const Voice& voice, const Scenario& common, const Suit& suit) {
    Scenario scenario = common;
    scenario.drive_hz = *voice.carrier_hz;
    scenario.pulse_interval_s = static_cast<double>(*voice.interval_samples) / scenario.sample_rate_hz;
    if (suit.pulse_cycles)
        scenario.pulse_cycles = static_cast<int>(std::lround(*suit.pulse_cycles));
    for (double& resonance_hz : scenario.sound.source_resonance_hz)
        resonance_hz *= scenario.drive_hz / common.drive_hz;
    scenario.sound.absorption_db_per_m = absorptionAt(scenario.drive_hz, common.sound.absorption_db_per_m);
    return scenario;
}

/// As the take describes it.
Suit soundingSuit(Suit suit, const Scenario& scenario) {
    suit.carrier_hz = scenario.drive_hz;
    suit.pulse_interval_samples = scenario.schedule().interval_samples;
    suit.pulse_cycles = scenario.pulse_cycles;
    for (Source& source : suit.sources)
        source.nominal_hz = scenario.drive_hz;
    return suit;
}

Status checkPulses(const Voice& voice, const Scenario& scenario) {
    const double drive_s = scenario.pulse_cycles / scenario.drive_hz;
    if (scenario.pulse_cycles >= 1 && drive_s < scenario.pulse_interval_s / 2)
        return Done{};
    return Error{ErrorKind::kUsage,
                 voice.who + ": pulses of " + std::to_string(scenario.pulse_cycles) +
                     " cycles do not fit into their interval of " + std::to_string(*voice.interval_samples) +
                     " samples",
                 "Give fewer pulse_cycles or more pulse_interval_samples"};
}

/// Where everybody begins who has no place of their own.
class Placer {
public:
    Placer(const CastRequest& request, Cast& cast) : request_(request), cast_(cast) {}

    void place() {
        std::vector<size_t> kept;
        for (size_t i = 0; i < request_.subjects.size(); ++i) {
            cast_.places.push_back(request_.subjects[i].place.value_or(StandingPlace{}));
            if (!request_.subjects[i].place)
                kept.push_back(i);
        }
        if (kept.size() > 1 && stoodTogether(kept))
            placeInRow(kept);
        else if (kept.size() > 1)
            placeAsRecorded(kept);
        for (size_t i = 0; i < request_.subjects.size(); ++i)
            cast_.suits[i].stage.body->standAt(cast_.places[i]);
    }

private:
    const FittedMotion& motionOf(size_t subject) const { return cast_.suits[subject].stage.motion; }

    bool stoodTogether(const std::vector<size_t>& kept) const {
        for (const size_t a : kept)
            for (const size_t b : kept)
                if (a < b && (motionOf(a).start_m - motionOf(b).start_m).norm() < kTooNear_m)
                    return true;
        return false;
    }

    void placeInRow(const std::vector<size_t>& kept) {
        std::string names;
        for (size_t i = 0; i < kept.size(); ++i) {
            const double middle = (static_cast<double>(kept.size()) - 1) / 2;
            cast_.places[kept[i]] = {(static_cast<double>(i) - middle) * kRowSpacing_m, 0, 0};
            names += (i == 0 ? "" : ", ") + request_.subjects[kept[i]].name;
        }
        cast_.notes.push_back(names + " begin in one place in their files and stand in a row instead");
    }

    /// One world: the middle of all that is walked comes to the middle of the floor.
    void placeAsRecorded(const std::vector<size_t>& kept) {
        Vector3d low = Vector3d::Constant(1e9), high = -low;
        for (const size_t i : kept) {
            const FittedMotion& motion = motionOf(i);
            const Quaterniond turn(Eigen::AngleAxisd(motion.start_yaw_rad, Vector3d::UnitY()));
            for (const std::vector<double>& row : motion.rows) {
                const Vector3d p = motion.start_m + turn * Vector3d(row[0], 0, row[2]);
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
            }
        }
        const Vector3d middle = (low + high) / 2;
        for (const size_t i : kept)
            cast_.places[i] = {motionOf(i).start_m.x() - middle.x(), motionOf(i).start_m.z() - middle.z(),
                               motionOf(i).start_yaw_rad};
    }

    const CastRequest& request_;
    Cast& cast_;
};

/// A file's motion knows nothing of walls.
void noteWhoLeaves(const ChamberScenario& chamber, double duration_s, Cast& cast) {
    for (const CastSuit& suit : cast.suits) {
        const Performance& performance = suit.stage.body->performance();
        double beyond_m = 0, since_s = 0;
        for (double t_s = 0; t_s < duration_s; t_s += 0.1) {
            const Vector3d root_m = performance.pose(t_s).p_world_root;
            const double out_m = std::max(std::abs(root_m.x()) - chamber.width_m / 2,
                                          std::abs(root_m.z()) - chamber.depth_m / 2);
            if (out_m > 0 && beyond_m <= 0)
                since_s = t_s;
            beyond_m = std::max(beyond_m, out_m);
        }
        if (beyond_m > 0)
            cast.notes.push_back(suit.name + " walks through the wall at " + text::number(since_s, 1) +
                                 " s, up to " + text::number(beyond_m, 1) +
                                 " m beyond it; sound is not true there. The room is " +
                                 text::number(chamber.width_m, 0) + " x " + text::number(chamber.depth_m, 0) +
                                 " m: give another place or a shorter duration");
    }
}

Result<Stage> stageOf(const CastSubject& subject, const CastRequest& request, const Scenario& scenario,
                      uint64_t seed) {
    StageRequest stage = subject.stage;
    stage.suit = soundingSuit(stage.suit, scenario);
    stage.scenario = scenario;
    stage.rest_seconds = request.rest_seconds.value_or(scenario.rest_seconds) + subject.start_s;
    stage.duration_s = 0;
    stage.seed = seed;
    auto prepared = prepareStage(stage);
    if (prepared)
        return prepared;
    Error error = prepared.error();
    error.message = "subject " + subject.name + ": " + error.message;
    return error;
}

/// Anchors: what the file says of them is what the survey found.
Result<Stage> roomStage(const Suit& room, const Scenario& scenario, double duration_s, uint64_t seed) {
    Scenario surveyed = scenario;
    surveyed.mounting_m = surveyed.source_position_m = scenario.cast.survey_m;
    surveyed.mounting_rad = 0;
    Stage stage;
    stage.suit = soundingSuit(room, scenario);
    stage.scenario = scenario;
    Result<WornSuit> anchors = wear(stage.suit, Skeleton(), surveyed, seed);
    if (!anchors)
        return anchors.error();
    stage.world = std::make_unique<AnchorWorld>(std::move(*anchors), duration_s);
    stage.truth = drawHiddenTruth(stage.suit, scenario, seed);
    stage.calibration = laboratoryCalibration(stage.suit, scenario, stage.truth);
    for (size_t b = 0; b < room.boards.size(); ++b)
        stage.calibration.boards[b].p_segment_board_m = room.boards[b].p_segment_board_m;
    for (size_t s = 0; s < room.sources.size(); ++s)
        stage.calibration.sources[s].p_segment_source_m = room.sources[s].p_segment_source_m;
    return stage;
}

nlohmann::json clockJson(const BoxClock& clock, double duration_s) {
    nlohmann::json rows = nlohmann::json::array();
    for (double suit_s = 0; suit_s <= duration_s; suit_s += 1)
        rows.push_back({suit_s, (clock.takeTime_s(suit_s) - suit_s) * 1e9});
    return {{"offset_ns", clock.offset_s() * 1e9}, {"rate", clock.rate()}, {"suit_s_offset_ns", rows}};
}

Status checkRoom(const Suit& room) {
    const auto check = [&](const auto& parts, const std::string& kind) -> Status {
        for (const auto& part : parts)
            if (!part.segment.empty())
                return Error{ErrorKind::kUnusable,
                             "room " + room.name + ": " + kind + " '" + part.id + "' sits on segment '" +
                                 part.segment + "', but anchors hang in the room",
                             "Set its segment to null and its position to that in the world"};
        return Done{};
    };
    const Status boards = check(room.boards, "board");
    return boards.ok() ? check(room.sources, "source") : boards;
}

Status checkNames(const CastRequest& request) {
    if (request.subjects.empty())
        return Error{ErrorKind::kUsage, "The cast has no subjects", "Name at least one, with its motion"};
    std::set<std::string> names;
    for (const CastSubject& subject : request.subjects) {
        if (subject.name.empty() || !names.insert(subject.name).second)
            return Error{ErrorKind::kUsage, "Two subjects are called \"" + subject.name + "\"",
                         "Give every subject a name of its own"};
        if (request.room && subject.name == "room")
            return Error{ErrorKind::kUsage, "A subject is called \"room\" beside the room",
                         "Give the subject another name"};
        if (!subject.stage.clip)
            return Error{ErrorKind::kUsage, "subject " + subject.name + " has no motion",
                         "Give it one with \"motion\""};
    }
    return Done{};
}

void drawClock(CastSuit& suit, size_t index, bool shared) {
    const Stage& stage = suit.stage;
    if (index == 0 || shared)
        return;
    suit.clock = BoxClock(stage.scenario.cast, stage.world->duration_s(), stage.truth.seed);
    suit.first_guess = firstGuess(suit.clock, stage.scenario.cast, stage.truth.seed);
}

}  // namespace

Result<Cast> prepareCast(const CastRequest& request) {
    if (Status named = checkNames(request); !named)
        return named.error();
    if (request.room)
        if (Status hangs = checkRoom(*request.room); !hangs)
            return hangs.error();
    std::vector<Voice> voices = voicesOf(request);
    if (Status given = giveCarriers(voices); !given)
        return given.error();
    Cast cast{{},
              request.shared_clock,
              Room::chamber(ChamberScenario{}, request.scenario.sound, request.seed),
              {},
              {}};
    const auto add = [&](const std::string& name, Result<Stage> stage) -> Status {
        if (!stage)
            return stage.error();
        cast.suits.push_back({name, std::move(*stage), {}, {}});
        return Done{};
    };
    const auto scenario = [&](size_t suit, const Suit& worn) {
        return scenarioOf(voices[suit], request.scenario, worn);
    };
    double duration_s = 0;
    for (size_t i = 0; i < request.subjects.size(); ++i) {
        const CastSubject& subject = request.subjects[i];
        const Scenario heard = scenario(i, subject.stage.suit);
        if (Status fit = checkPulses(voices[i], heard); !fit)
            return fit.error();
        if (Status added = add(subject.name, stageOf(subject, request, heard, seedOfSuit(request.seed, i)));
            !added)
            return added.error();
        duration_s = std::max(duration_s, cast.suits[i].stage.world->duration_s());
    }
    if (request.duration_s > 0)
        duration_s = request.duration_s;
    for (CastSuit& suit : cast.suits)
        suit.stage.body->lastFor(duration_s);
    Placer(request, cast).place();
    noteWhoLeaves(ChamberScenario{}, duration_s, cast);
    if (request.comes_back_s > 0) {
        duration_s = request.comes_back_s;
        for (CastSuit& suit : cast.suits)
            suit.stage.body->comeBack(duration_s);
    }
    if (const size_t i = cast.suits.size(); request.room) {
        const Scenario heard = scenario(i, *request.room);
        if (Status fit = checkPulses(voices[i], heard); !fit)
            return fit.error();
        if (Status added = add("", roomStage(*request.room, heard, duration_s, seedOfSuit(request.seed, i)));
            !added)
            return added.error();
    }
    const Air air = drawAir(request.scenario, request.seed);
    for (size_t i = 0; i < cast.suits.size(); ++i) {
        cast.suits[i].stage.truth.air.temperature_c = air.temperature_c;
        cast.suits[i].stage.truth.air.humidity_percent = air.humidity_percent;
        drawClock(cast.suits[i], i, request.shared_clock);
    }
    return cast;
}

nlohmann::json Cast::truthJson() const {
    nlohmann::json list = nlohmann::json::array();
    for (const CastSuit& suit : suits) {
        nlohmann::json json = suit.stage.truthJson();
        if (const auto* anchors = dynamic_cast<const AnchorWorld*>(suit.stage.world.get()))
            addWorn(json, anchors->anchors());
        json["name"] = suit.isRoom() ? "room" : suit.name;
        json["clock"] = clockJson(suit.clock, suit.stage.world->duration_s());
        list.push_back(std::move(json));
    }
    return {{"format", "noctule-truth"}, {"version", 1}, {"suits", list}};
}

int Cast::find(const std::string& name) const {
    const auto found = std::ranges::find_if(
        suits, [&](const CastSuit& suit) { return (suit.isRoom() ? "room" : suit.name) == name; });
    return found == suits.end() ? -1 : static_cast<int>(found - suits.begin());
}

std::vector<StagedSuit> stagedSuits(const Cast& cast) {
    std::vector<StagedSuit> staged;
    for (const CastSuit& suit : cast.suits)
        staged.push_back({&suit.stage, &suit.clock, suit.first_guess, static_cast<int>(staged.size()) + 1});
    return staged;
}

Result<SimulationSummary> writeTake(const Cast& cast, const TakeRequest& request, const JobContext& job) {
    TakeContent content;
    content.suits = stagedSuits(cast);
    content.chamber = cast.chamber;
    nlohmann::json subjects = nlohmann::json::array();
    for (size_t i = 0; i < cast.suits.size(); ++i) {
        const CastSuit& suit = cast.suits[i];
        nlohmann::json subject{{"suits", {i + 1}}};
        if (suit.isRoom())
            subject["room"] = true;
        else
            subject["name"] = suit.name;
        subjects.push_back(std::move(subject));
    }
    content.meta = {{"subjects", subjects.dump()}};
    if (cast.shared_clock)
        content.meta.emplace_back("clock_shared", "1");
    return makeTake(content, request, job);
}

}  // namespace noctule::simulation
