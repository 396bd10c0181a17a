// SPDX-License-Identifier: Apache-2.0
// Ada and Bea sway where they stand, 1.3 m apart and facing each other: five housings each, four anchors in
// the corners of the room.
#pragma once

#include "core/processing/process_take.h"
#include "tests/core/simulation/two_people.h"
#include "tests/support/take_files.h"

namespace noctule::test {

inline constexpr double kSwayingRest_s = 1, kSwaying_s = 3;

inline Suit fewHousings() {
    Suit suit;
    suit.name = "few";
    const auto outwards = [](const Vector3d& to) { return smallestRotation(Vector3d::UnitZ(), to); };
    simulation::addTransceiver(suit, "hips", "Hips", {0, -0.03, 0.125}, Quaterniond::Identity());
    simulation::addTransceiver(suit, "chest", "Chest", {0, 0.09, 0.13}, Quaterniond::Identity());
    simulation::addTransceiver(suit, "head", "Head", {0, 0.11, 0.12}, Quaterniond::Identity());
    simulation::addTransceiver(suit, "l_hand", "LeftHand", {0.085, 0.03, 0}, outwards(Vector3d::UnitY()));
    simulation::addTransceiver(suit, "r_hand", "RightHand", {-0.085, 0.03, 0}, outwards(Vector3d::UnitY()));
    return suit;
}

inline Suit fourCorners() {
    Suit room;
    room.name = "corners";
    const std::pair<const char*, Vector3d> corners[] = {{"south", {1.6, 2.3, -2}},
                                                        {"east", {2, 0.8, 1.7}},
                                                        {"north", {-1.8, 2.2, 2}},
                                                        {"west", {-2, 1.2, -1.5}}};
    for (const auto& [id, p] : corners)
        simulation::addTransceiver(room, id, "", p,
                                   smallestRotation(Vector3d::UnitZ(), Vector3d(0, 1, 0) - p));
    return room;
}

/// Sways where it stands; every joint swings.
inline MotionClip swaying() {
    MotionClip clip = simulation::madeMotion(kSwaying_s);
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const double t = static_cast<double>(f) / 120;
        clip.frames[f].p_world_root = {0.08 * std::sin(1.3 * t), 0.97, 0.08 * std::sin(t)};
        clip.frames[f].q_parent_joint[0] = axisAngle(Vector3d::UnitY(), 0.2 * std::sin(t));
    }
    return clip;
}

/// Readings level.
inline Status writeSwayingPair(const std::string& path, const JobContext& job = {}) {
    simulation::CastRequest request;
    for (const std::string name : {"Ada", "Bea"}) {
        simulation::CastSubject subject;
        subject.name = name;
        subject.stage.clip = swaying();
        subject.stage.suit = fewHousings();
        subject.place = name == "Ada" ? simulation::StandingPlace{0, -0.6, 0}
                                      : simulation::StandingPlace{0, 0.7, std::numbers::pi};
        request.subjects.push_back(std::move(subject));
    }
    request.room = fourCorners();
    request.scenario = *simulation::Scenario::named("nominal");
    request.rest_seconds = kSwayingRest_s;
    const auto cast = simulation::prepareCast(request);
    if (!cast)
        return cast.error();
    const simulation::TakeRequest take{.out_path = path,
                                       .level = simulation::Level::kReadings,
                                       .name = "pair",
                                       .created_utc = "2026-01-02T03:04:05Z",
                                       .software = "test"};
    const auto written = simulation::writeTake(*cast, take, job);
    return written ? Status(Done{}) : Status(written.error());
}

/// The same with a run of both together.
inline Status writeProcessedPair(const std::string& path) {
    if (Status written = writeSwayingPair(path); !written)
        return written;
    ProcessRequest request;
    request.take_path = path;
    request.software = "test";
    const auto summary = processTake(request, {});
    return summary ? Status(Done{}) : Status(summary.error());
}

/// Bea's box is lost at 0.5 s, while the rest pose is held; processed then.
inline Status writePairLostInRest(const std::string& path) {
    if (Status written = writeSwayingPair(path); !written)
        return written;
    runSql(path,
           "DELETE FROM range WHERE suit=2 AND arrival_sample>75000;"
           "DELETE FROM range WHERE pulse IN (SELECT id FROM pulse WHERE suit=2 AND sample>75000);"
           "DELETE FROM pulse WHERE suit=2 AND sample>75000;"
           "DELETE FROM inertial WHERE suit=2 AND sample>75000;"
           "DELETE FROM meta WHERE key='sample_count';");
    ProcessRequest request;
    request.take_path = path;
    request.software = "test";
    const auto summary = processTake(request, {});
    return summary ? Status(Done{}) : Status(summary.error());
}

}  // namespace noctule::test
