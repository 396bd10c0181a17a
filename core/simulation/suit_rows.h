// SPDX-License-Identifier: Apache-2.0
// What one suit of a simulated take leaves in its tables, apart from sound and ranges: documents, markers,
// status, truth and inertia. A take of one suit is a list of one.
#pragma once

#include "core/acoustics/speed_of_sound.h"
#include "core/recording/take_writer.h"
#include "core/simulation/box_clock.h"
#include "core/simulation/simulate.h"

namespace noctule::simulation {

/// A suit, the clock of its box and its id in the take. Stage and clock must outlive whoever writes it.
struct StagedSuit {
    const Stage* stage = nullptr;
    const BoxClock* clock = nullptr;
    SuitClock first_guess{};
    int id = 1;

    double rate_hz() const { return stage->scenario.sample_rate_hz; }
    /// Of its own clock, until the world ends.
    int64_t sampleCount() const;
    double takeTimeOf_s(double sample) const { return clock->takeTime_s(sample / rate_hz()); }
};

/// Part of the progress that a step makes.
struct ProgressShare {
    double from = 0, to = 1;
};

class SuitRows {
public:
    /// Everything must outlive the object.
    SuitRows(const StagedSuit& suit, const TakeRequest& request, const JobContext& job, TakeWriter& take)
        : suit_(suit), stage_(*suit.stage), request_(request), job_(job), take_(take) {}

    Status writeDocuments();
    Status writeStatus(std::vector<TemperatureStatus>& rows);
    /// Of the performer; nothing for a rig or a room.
    Status writeTruth();
    Status writeExternalRoot();
    /// Counts what it writes in `rows`.
    Status writeInertia(const ProgressShare& share, int64_t& rows);

private:
    Status writePerformer();
    Status writeStations();
    Status addMarker(double take_s, const char* kind, const std::string& label);
    double duration_s() const { return stage_.world->duration_s(); }

    const StagedSuit& suit_;
    const Stage& stage_;
    const TakeRequest& request_;
    const JobContext& job_;
    TakeWriter& take_;
};

}  // namespace noctule::simulation
