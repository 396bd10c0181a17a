// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/clock_estimator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

namespace noctule::cooperative {
namespace {

constexpr double kSound_m_per_s = 344;

/// Suits of some housings each that sway about; suit 2, if any, is the room and stands still.
struct World {
    std::mt19937 random{7};
    std::normal_distribution<double> normal{};
    int steps = 4100;       ///< of 10 ms
    double bend_per_s = 0;  ///< by which rates grow
    std::vector<ClockGuess> guesses;
    std::vector<double> true_rate;
    std::vector<std::vector<double>> true_offset_s;  ///< per suit, every 10 ms of suit time
    std::vector<std::vector<Vector3d>> housings;

    double takeOf(size_t suit, double suit_s) const {
        const double at = std::max(suit_s, 0.0) * 100;
        const auto i = std::min(static_cast<size_t>(at), true_offset_s[suit].size() - 2);
        const double u = at - static_cast<double>(i);
        return suit_s + (1 - u) * true_offset_s[suit][i] + u * true_offset_s[suit][i + 1];
    }
    double suitOf(size_t suit, double take_s) const {
        double suit_s = take_s;
        for (int i = 0; i < 4; ++i)
            suit_s -= takeOf(suit, suit_s) - take_s;
        return suit_s;
    }
    Vector3d place(size_t suit, size_t housing, double t) const {
        const Vector3d& at = housings[suit][housing];
        if (guesses[suit].stands_still)
            return at;
        const double body = 1.3 * static_cast<double>(suit);
        return at + sway(2.1, body, t) + 0.3 * sway(3.3, body + 0.7 * static_cast<double>(housing), t);
    }
    static Vector3d sway(double rate, double phase, double t) {
        return Vector3d(0.25 * std::sin(rate * t + phase), 0.05 * std::sin(1.3 * rate * t + 2 * phase),
                        0.2 * std::sin(0.8 * rate * t + 3 * phase));
    }

    void addSuit(const Vector3d& middle, int count, bool still) {
        ClockGuess guess;
        guess.stands_still = still;
        std::vector<Vector3d> places;
        for (int i = 0; i < count; ++i)
            places.push_back(middle + 0.5 * Vector3d{normal(random), normal(random), normal(random)});
        std::uniform_real_distribution<double> uniform(-1, 1);
        const bool first = guesses.empty();
        double offset = first ? 0 : 0.02 * uniform(random);
        const double rate = first ? 1 : 1 + 20e-6 * uniform(random);
        guess.offset_s = first ? 0 : offset + 0.005 * uniform(random);
        std::vector<double> offsets;
        for (int i = 0; i < steps; ++i) {
            offsets.push_back(offset);
            offset += (rate - 1 + (first ? 0 : bend_per_s * 0.01 * i)) * 0.01 +
                      (first ? 0 : 0.5e-6 * 0.1 * normal(random));
        }
        guesses.push_back(guess);
        true_rate.push_back(rate);
        true_offset_s.push_back(offsets);
        housings.push_back(places);
    }

    std::vector<TimedFlight> flights(double seconds, double sigma_s) {
        std::vector<TimedFlight> all;
        for (size_t from = 0; from < housings.size(); ++from) {
            const double interval = 0.008 * (1 + 0.025 * static_cast<double>(from));
            for (int pulse = 0; pulse * interval < seconds; ++pulse) {
                const double emission = pulse * interval, take = takeOf(from, emission);
                const size_t source = static_cast<size_t>(pulse) % housings[from].size();
                for (size_t to = 0; to < housings.size(); ++to)
                    for (size_t mic = 0; to != from && mic < housings[to].size(); ++mic) {
                        double flight = 0;
                        for (int i = 0; i < 6; ++i)
                            flight = (place(from, source, take) - place(to, mic, take + flight)).norm() /
                                     kSound_m_per_s;
                        all.push_back({static_cast<int>(from), static_cast<int>(to), static_cast<int>(source),
                                       static_cast<int>(mic), emission,
                                       suitOf(to, take + flight) + sigma_s * normal(random), sigma_s});
                    }
            }
        }
        return all;
    }
};

struct ClockErrors {
    double worst_offset_s = 0, rate = 0, nees = 0;
};

/// Of all windows within the take; the rate at its end.
ClockErrors errorsOf(const World& world, const ClockTrack& track, size_t suit) {
    ClockErrors errors;
    double count = 0;
    for (const ClockPoint& point : track.points) {
        if (point.suit_s < 0)
            continue;
        const double error = point.suit_s + point.offset_s - world.takeOf(suit, point.suit_s);
        errors.worst_offset_s = std::max(errors.worst_offset_s, std::abs(error));
        errors.nees += error * error / (point.sigma_s * point.sigma_s);
        count += 1;
    }
    errors.nees /= count;
    errors.rate = track.points.back().rate - world.true_rate[suit];
    return errors;
}

/// Two suits that sway, with or without the room; microphone and source of a housing are at one place.
struct SwayingPair {
    SwayingPair(unsigned seed, bool with_room) {
        world.random.seed(seed);
        world.addSuit({-0.6, 1.2, 0}, 4, false);
        world.addSuit({0.6, 1.2, 0}, 4, false);
        if (with_room)
            world.addSuit({0, 2.5, 0}, 4, true);
        ClockSettings settings;
        settings.housing_s = 0;
        tracks = estimateClocks(world.flights(30, 6e-6), world.guesses, settings);
    }
    World world;
    std::vector<ClockTrack> tracks;
};

TEST(ClockEstimator, OffsetAndRateAfter30Seconds) {
    double square = 0, nees = 0;
    constexpr int kWorlds = 6;
    for (unsigned seed = 1; seed <= kWorlds; ++seed) {
        const SwayingPair pair(seed, true);
        for (const size_t suit : {1u, 2u}) {
            ASSERT_TRUE(pair.tracks[suit].joined);
            const ClockErrors errors = errorsOf(pair.world, pair.tracks[suit], suit);
            EXPECT_LT(errors.worst_offset_s, 2e-6) << "seed " << seed << " suit " << suit;
            square += errors.rate * errors.rate;
            nees += errors.nees;
        }
    }
    EXPECT_LT(std::sqrt(square / (2 * kWorlds)), 0.1e-6 * 1.2);
    EXPECT_GT(nees / (2 * kWorlds), 0.6);
    EXPECT_LT(nees / (2 * kWorlds), 1.4);
}

TEST(ClockEstimator, WithoutTheRoomMotionOfBothIsAllowedFor) {
    double nees = 0, worst_s = 0;
    constexpr int kWorlds = 24;
    for (unsigned seed = 1; seed <= kWorlds; ++seed) {
        const SwayingPair pair(seed, false);
        ASSERT_TRUE(pair.tracks[1].joined);
        const ClockErrors errors = errorsOf(pair.world, pair.tracks[1], 1);
        EXPECT_LT(errors.worst_offset_s, 3e-6) << "seed " << seed;
        worst_s = std::max(worst_s, errors.worst_offset_s);
        nees += errors.nees / kWorlds;
    }
    std::printf("clocks of two that sway, %d worlds: worst offset %.2f us, NEES %.2f\n", kWorlds,
                1e6 * worst_s, nees);
    EXPECT_GT(nees, 0.4);
    EXPECT_LT(nees, 1.6);
}

TEST(ClockEstimator, EchoesDoNotTellTheTime) {
    World world;
    world.addSuit({-0.6, 1.2, 0}, 4, false);
    world.addSuit({0, 2.5, 0}, 4, true);
    auto flights = world.flights(20, 6e-6);
    for (size_t i = 0; i < flights.size(); i += 17)
        flights[i].arrival_s += 1e-3;
    ClockSettings settings;
    settings.housing_s = 0;
    const auto tracks = estimateClocks(flights, world.guesses, settings);
    EXPECT_LT(errorsOf(world, tracks[1], 1).worst_offset_s, 3e-6);
}

TEST(ClockEstimator, SecondsInWhichOnlyEchoesAreHeardDoNotBendTheClock) {
    for (const double begin_s : {0.0, 12.0}) {
        World world;
        world.addSuit({-0.6, 1.2, 0}, 4, false);
        world.addSuit({0.6, 1.2, 0}, 4, false);
        world.addSuit({0, 2.5, 0}, 4, true);
        auto flights = world.flights(20, 6e-6);
        for (TimedFlight& flight : flights)  // suit 1 by way of a wall, in one direction 6 ms later
            if ((flight.from_suit == 1 || flight.to_suit == 1) && flight.emission_s > begin_s &&
                flight.emission_s < begin_s + 8)
                flight.arrival_s += flight.to_suit == 1 ? 8e-3 : 2e-3;
        ClockSettings settings;
        settings.housing_s = 0;
        const auto tracks = estimateClocks(flights, world.guesses, settings);
        for (const size_t suit : {1u, 2u}) {
            ASSERT_TRUE(tracks[suit].joined);
            EXPECT_LT(errorsOf(world, tracks[suit], suit).worst_offset_s, 6e-6)
                << "from " << begin_s << " s, suit " << suit;
        }
    }
}

TEST(ClockEstimator, AClockThatWarmsUpForHalfAnHourIsFollowed) {
    World world;
    world.steps = 181'000;
    world.bend_per_s = 4e-6 / 1800;  // off its best line by 0.6 ms
    world.addSuit({-0.6, 1.2, 0}, 1, false);
    world.addSuit({0, 2.5, 0}, 1, true);
    ClockSettings settings;
    settings.housing_s = 0;
    const auto tracks = estimateClocks(world.flights(1800, 6e-6), world.guesses, settings);
    ASSERT_TRUE(tracks[1].joined);
    EXPECT_LT(errorsOf(world, tracks[1], 1).worst_offset_s, 6e-6);
}

TEST(ClockEstimator, WhereWindowsDoNotAgreeNothingIsJoined) {
    World world;
    world.addSuit({-0.6, 1.2, 0}, 4, false);
    world.addSuit({0, 2.5, 0}, 4, true);
    auto flights = world.flights(20, 6e-6);
    for (TimedFlight& flight : flights)  // every second by another wall
        if (flight.to_suit == 1)
            flight.arrival_s += 2e-3 * std::floor(flight.emission_s);
    EXPECT_FALSE(estimateClocks(flights, world.guesses)[1].joined);
}

TEST(ClockEstimator, OneDirectionAloneJoinsNothing) {
    World world;
    world.addSuit({-0.6, 1.2, 0}, 4, false);
    world.addSuit({0.6, 1.2, 0}, 4, false);
    auto flights = world.flights(5, 6e-6);
    std::erase_if(flights, [](const TimedFlight& flight) { return flight.from_suit == 1; });
    const auto tracks = estimateClocks(flights, world.guesses);
    EXPECT_TRUE(tracks[0].joined);
    EXPECT_FALSE(tracks[1].joined);
    EXPECT_TRUE(estimateClocks({}, world.guesses)[0].joined);
    EXPECT_FALSE(estimateClocks({}, world.guesses)[1].joined);
}

}  // namespace
}  // namespace noctule::cooperative
