// SPDX-License-Identifier: Apache-2.0
#include "core/processing/ingredients.h"

#include <algorithm>

#include "core/live/estimators.h"
#include "core/suit/calibration_parts.h"

namespace noctule {

Error unusableTake(const Take& take, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnusable, take.path() + ": " + what, remedy};
}

CalibrationLack lackOfTake(const Take& take, const Suit& suit, const Calibration& calibration) {
    CalibrationLack lack = lackOf(suit, calibration);
    if (take.level() == TakeLevel::kReadings)
        lack.sources.clear();
    return lack;
}

namespace {

/// "l_hand (is NB-21, calibrated was NB-17)"; empty when nothing speaks against it.
template <class Part, class Values>
std::string otherSerial(const Part& part, const Values* values) {
    if (!values || values->serial.empty() || part.serial.empty() || values->serial == part.serial)
        return "";
    return part.id + " (is " + part.serial + ", calibrated was " + values->serial + ")";
}

void warnOfOtherSerials(const Take& take, const Suit& suit, const Calibration& calibration,
                        std::vector<std::string>& warnings) {
    std::string others;
    const auto add = [&others](const std::string& other) {
        others += (others.empty() || other.empty() ? "" : ", ") + other;
    };
    for (const Board& board : suit.boards)
        add(otherSerial(board, calibration.findBoard(board.id)));
    for (const Source& source : suit.sources)
        add(otherSerial(source, calibration.findSource(source.id)));
    if (!others.empty())
        warnings.push_back("The calibration is of other parts: " + others +
                           ". Its values are used all the same; calibrate these parts.");
    else if (ownerOf(calibration, suit, take.boxSerial()) == CalibrationOwner::kAnotherSuit)
        warnings.push_back("The calibration was made for another suit, box " + calibration.box_serial +
                           "; the take is of " + take.boxSerial() +
                           ". Its values are used all the same; give the calibration of this suit.");
}

/// A calibration of another suit is refused; boards it lacks get nominal values, as CalibrationLack tells.
Status checkCalibration(const Take& take, const Suit& suit, const Calibration& calibration,
                        std::vector<std::string>& warnings) {
    std::string missing;
    size_t found = 0;
    for (const Board& board : suit.boards) {
        if (calibration.findBoard(board.id))
            ++found;
        else
            missing += (missing.empty() ? "" : ", ") + board.id;
    }
    if (found == 0 && !suit.boards.empty() && !calibration.boards.empty())
        return unusableTake(take, "the calibration knows none of the suit's boards (" + missing + ")",
                            "Give the calibration of this suit");
    warnOfOtherSerials(take, suit, calibration, warnings);
    return Done{};
}

Result<Calibration> chooseCalibration(const Take& take, const ProcessRequest& request, Ingredients& in) {
    if (request.calibration)
        return *request.calibration;
    const auto stored = take.calibrations();
    if (!stored)
        return stored.error();
    if (stored->empty())
        return nominalCalibration(in.suit);
    auto in_force = take.calibrationInForce();
    if (!in_force)
        return in_force.error();
    in.calibration_id = in_force->id;
    return in_force->value;
}

struct FirstReadings {
    int64_t first_sample = 0;
    bool some_negative = false;  ///< as counts never are
};

Result<FirstReadings> lookAtFirst(const Take& take) {
    constexpr int kLookedAt = 2000;
    FirstReadings first;
    auto readings = take.readings(kPrimaryRun);
    if (!readings)
        return readings.error();
    for (int i = 0; i < kLookedAt; ++i) {
        const auto reading = readings->next();
        if (!reading)
            return reading.error();
        if (!*reading)
            break;
        if (i == 0)
            first.first_sample = static_cast<int64_t>((*reading)->sample);
        for (const auto& count : (*reading)->counts)
            first.some_negative = first.some_negative || count.value_or(0) < kCountsMin;
    }
    return first;
}

Result<Actor> chooseActor(const Take& take, const ProcessRequest& request, Ingredients& in,
                          std::vector<std::string>& warnings) {
    if (request.actor)
        return *request.actor;
    const auto stored = take.actors();
    if (!stored)
        return stored.error();
    if (stored->empty()) {
        warnings.push_back("The take names no actor: the default actor of 1.75 m is used.");
        return defaultActor();
    }
    auto in_force = take.actorInForce();
    if (!in_force)
        return in_force.error();
    in.actor_id = in_force->id;
    return in_force->value;
}

Status readDecoderSettings(const Take& take, const ProcessRequest& request, Ingredients& in) {
    const auto rate = take.sampleRate_hz();
    if (!rate)
        return rate.error();
    const auto boards = take.boardCount();
    if (!boards)
        return boards.error();
    if (*boards != static_cast<int>(in.suit.boards.size()))
        return unusableTake(take,
                            "the sound holds " + std::to_string(*boards) + " boards, the suit describes " +
                                std::to_string(in.suit.boards.size()),
                            "Correct board_count in meta or the suit's JSON");
    in.decoder.train = {static_cast<double>(*rate), static_cast<int>(take.header().pulse_interval_samples),
                        take.header().drive_hz, static_cast<int>(take.header().pulse_cycles)};
    // The matched detector hears 12 kHz to both sides of its carrier, inflection 2.5 kHz: it tells the pulses
    // of other suits apart. Ranges of a take without sound were measured before.
    const bool own_choice = take.level() == TakeLevel::kSignal && take.suitIds().size() < 2;
    const EstimatorEntry& estimator = *findEstimator(request.tracker.estimator);
    in.decoder.detector = request.detector.value_or(own_choice ? estimator.detector : Detector::kInflection);
    return Done{};
}

}  // namespace

/// What a filter needs: without rates or distances its poses would be guesses, as they are of boards that sit
/// on nobody. Sound and takes of several, whose ranges may be between suits, tell by themselves.
Status checkSensors(const Take& take, const TrackerSettings& tracker, const Suit& suit,
                    std::vector<std::string>& warnings) {
    if (!suit.boards.empty() &&
        std::ranges::all_of(suit.boards, [](const Board& board) { return board.segment.empty(); }))
        return unusableTake(
            take, "none of its boards sits on a segment of the body",
            "Say where they sit when it is imported (--map); single sensors need no body (verb orient)");
    if (take.level() != TakeLevel::kReadings || take.suitIds().size() > 1)
        return Done{};
    const auto measured = take.measured();
    if (!measured)
        return measured.error();
    const SensorSelection& asked = tracker.sensors;
    std::string missing;
    const auto lacks = [&missing](bool wanted, bool there, const char* what) {
        if (wanted && !there)
            missing += (missing.empty() ? "" : ", ") + std::string(what);
        return wanted && !there;
    };
    const bool no_rates = lacks(asked.gyroscopes, measured->gyroscopes, "no gyroscopes");
    const bool no_distances = lacks(asked.distances, measured->distances, "no distances");
    const bool no_forces = lacks(asked.accelerometers, measured->accelerometers, "no accelerometers");
    const bool has_any = (asked.accelerometers && !no_forces) || (asked.gyroscopes && !no_rates) ||
                         (asked.distances && !no_distances);
    if (!has_any || (no_rates && !(asked.distances && !no_distances)))
        return unusableTake(
            take, "it has " + missing + ", so this estimator has too little to go by",
            "Process it as independent sensors, by attitudes and accelerations (--estimator orientation)");
    if (!missing.empty())
        warnings.push_back("The take has " + missing + "; the poses are made without.");
    return Done{};
}

Result<Ingredients> gatherIngredients(const Take& take, const ProcessRequest& request,
                                      std::vector<std::string>& warnings) {
    Ingredients in;
    const auto estimator = estimatorNamed(request.tracker.estimator);
    if (!estimator)
        return estimator.error();
    if (Status known =
            checkParameters((*estimator)->parameters, request.tracker.parameters, request.tracker.estimator);
        !known)
        return known.error();
    auto suit = take.suit();
    if (!suit)
        return suit.error();
    in.suit = *suit;
    in.clock = take.suitClock();
    for (const Board& board : in.suit.boards)
        if (take.level() == TakeLevel::kSignal && board.rate_hz != kUsualBoardRate_hz)
            return unusableTake(take,
                                "board " + board.id +
                                    " is said to read other than 140 times a second, "
                                    "which sound cannot carry",
                                "Correct rate_hz in the suit's JSON");
    if (Status ready = readDecoderSettings(take, request, in); !ready)
        return ready.error();
    auto calibration = chooseCalibration(take, request, in);
    if (!calibration)
        return calibration.error();
    in.calibration = *calibration;
    if (Status fits = checkCalibration(take, in.suit, in.calibration, warnings); !fits)
        return fits.error();
    in.lack = lackOfTake(take, in.suit, in.calibration);
    auto actor = chooseActor(take, request, in, warnings);
    if (!actor)
        return actor.error();
    in.actor = *actor;
    const auto rest = take.restInterval();
    if (!rest)
        return rest.error();
    if (*rest)
        in.rest = {(*rest)->first, (*rest)->last};
    else if (!(*estimator)->whole_take)
        warnings.push_back("No rest pose is marked: the motion is believed to begin in it.");
    const bool is_nominal = !request.calibration && !in.calibration_id;
    if (take.level() == TakeLevel::kReadings && (!in.rest || is_nominal)) {
        const auto first = lookAtFirst(take);
        if (!first)
            return first.error();
        if (is_nominal && first->some_negative)
            return unusableTake(take,
                                "it has no calibration, and its readings are no counts: some are negative",
                                "Give it a calibration; for readings in rad/s and m/s^2 one with zero 0 and "
                                "the identity");
        in.first_sample = first->first_sample;
    }
    if (request.tracker.root_given) {
        auto roots = take.externalRoot();
        if (!roots)
            return roots.error();
        in.roots = *roots;
        if (in.roots.empty())
            return unusableTake(take, "the root is to be given, but the take has no external_root rows",
                                "Leave the root free (--root free), or attach the other system's motion "
                                "(--as external-root)");
    }
    auto contacts = take.editedContacts();
    if (!contacts)
        return contacts.error();
    in.contacts = std::move(*contacts);
    const auto count = take.sampleCount();
    if (!count)
        return count.error();
    in.sample_count = *count;
    return in;
}

}  // namespace noctule
