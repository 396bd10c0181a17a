// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/suit_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/math/rotation.h"
#include "core/simulation/cast_world.h"

namespace noctule::simulation {
namespace {

constexpr double kReferencePerSecond = 140;

int64_t nanoseconds(double t_s) {
    return std::llround(t_s * 1e9);
}

}  // namespace

int64_t StagedSuit::sampleCount() const {
    if (clock->isTakeTime())
        return stage->sampleCount();
    return static_cast<int64_t>(std::floor(clock->suitTime_s(stage->world->duration_s()) * rate_hz()));
}

Status SuitRows::writeDocuments() {
    Calibration calibration = stage_.calibration;
    calibration.created_utc = request_.created_utc;
    if (auto done = take_.addSuit(stage_.suit, suit_.first_guess); !done)
        return done.error();
    if (auto done = take_.addCalibration(calibration, suit_.id); !done)
        return done.error();
    if (stage_.body)
        return writePerformer();
    return stage_.rig ? writeStations() : Status(Done{});
}

Status SuitRows::writePerformer() {
    const double rest_s = stage_.body->performance().rest_seconds();
    const std::pair<const char*, std::string> meta[] = {{"actor_name", stage_.actor.name},
                                                        {"reference_kind", "simulated"},
                                                        {"x_rest_seconds", std::to_string(rest_s)}};
    for (const auto& [key, value] : meta)
        if (suit_.id == 1)
            if (Status done = take_.setMeta(key, value); !done)
                return done;
    const std::string key = suit_.id == 1 ? "reference_actor" : "reference_actor_" + std::to_string(suit_.id);
    if (stage_.scenario.bone_scale > 0 || stage_.scenario.unreduced_motion)
        if (Status done = take_.setMeta(key, noctule::toJson(stage_.mover).dump()); !done)
            return done;
    if (auto done = take_.addActor(stage_.actor, request_.created_utc, suit_.id); !done)
        return done.error();
    if (Status done = addMarker(0, "rest", "begin"); !done)
        return done;
    return addMarker(std::min(rest_s, duration_s()), "rest", "end");
}

Status SuitRows::writeStations() {
    const bool jig = stage_.rig->kind() == RigKind::kJig;
    if (stage_.rig->kind() == RigKind::kTurntable) {
        char rpm[32];
        std::snprintf(rpm, sizeof rpm, "%g", stage_.scenario.rigs.turntable_rpm);
        if (Status done = take_.setMeta("turntable_rpm", rpm); !done)
            return done;
    }
    for (const RigStation& station : stage_.stations)
        for (const bool begins : {true, false})
            if (Status done = addMarker(begins ? station.begin_s : station.end_s,
                                        jig ? "placement" : "position", begins ? station.label : "");
                !done)
                return done;
    return Done{};
}

Status SuitRows::addMarker(double take_s, const char* kind, const std::string& label) {
    const auto sample = static_cast<int64_t>(suit_.clock->suitTime_s(take_s) * suit_.rate_hz());
    return take_.addMarker({std::clamp<int64_t>(sample, 0, suit_.sampleCount() - 1), kind, label}, suit_.id);
}

Status SuitRows::writeStatus(std::vector<TemperatureStatus>& rows) {
    AirInstruments instruments(stage_.truth.air, stage_.scenario, stage_.truth.seed);
    const int64_t samples = suit_.sampleCount();
    for (int64_t sample = 0; sample < samples; sample += stage_.scenario.sample_rate_hz) {
        const AirInstruments::Values air = instruments.read();
        StatusRow row;
        row.sample = sample;
        row.temperature_c = air.temperature_c;
        row.humidity_percent = air.humidity_percent;
        rows.push_back({sample, air.temperature_c, air.humidity_percent});
        if (Status done = take_.addStatus(row, suit_.id); !done)
            return done;
    }
    return Done{};
}

Status SuitRows::writeTruth() {
    if (!stage_.body)
        return Done{};
    const int64_t frames = static_cast<int64_t>(duration_s() * kReferencePerSecond);
    for (int64_t f = 0; f <= frames; ++f) {
        const double t_s = static_cast<double>(f) / kReferencePerSecond;
        if (Status done =
                take_.addReference({nanoseconds(t_s), stage_.body->performance().pose(t_s), {}}, suit_.id);
            !done)
            return done;
        if (f % 1400 == 0 && job_.cancelled())
            return JobContext::cancelledError();
    }
    return Done{};
}

Status SuitRows::writeExternalRoot() {
    const Scenario& s = stage_.scenario;
    if (!request_.external_root || !stage_.body)
        return Done{};
    Random random(stage_.truth.seed, "external root");
    const int64_t frames = static_cast<int64_t>(duration_s() * s.external_root_rate_hz);
    for (int64_t f = 0; f <= frames; ++f) {
        const double t_s = static_cast<double>(f) / s.external_root_rate_hz;
        const Pose pose = stage_.body->performance().pose(t_s);
        ExternalRootRow row;
        row.time_ns = nanoseconds(t_s);
        row.p_world_root = pose.p_world_root + random.gaussianVector(s.external_root_sigma_position_m);
        row.q_world_root =
            pose.q_parent_joint[0] * expQuaternion(random.gaussianVector(s.external_root_sigma_rotation_rad));
        row.sigma_p_m = s.external_root_sigma_position_m;
        row.sigma_q_rad = s.external_root_sigma_rotation_rad;
        if (Status done = take_.addExternalRoot(row, suit_.id); !done)
            return done;
    }
    return Done{};
}

Status SuitRows::writeInertia(const ProgressShare& share, int64_t& rows) {
    const ClockedWorld clocked(*stage_.world, *suit_.clock);
    const int64_t samples = suit_.sampleCount();
    std::vector<BoardReadings> boards;
    for (int b = 0; b < stage_.world->boardCount(); ++b)
        boards.emplace_back(clocked, b, stage_.truth.inertia[b], stage_.scenario, stage_.truth.seed);
    const auto framesAt = [&](double rate_hz) {
        return static_cast<int64_t>(static_cast<double>(samples) * rate_hz / suit_.rate_hz()) - 1;
    };
    double fastest_hz = 0;
    for (const Board& board : stage_.suit.boards)
        fastest_hz = std::max(fastest_hz, board.rate_hz);
    const int64_t frames = framesAt(fastest_hz);
    for (int64_t frame = 0; frame < frames; ++frame) {
        for (size_t b = 0; b < boards.size(); ++b) {
            if (frame >= framesAt(stage_.suit.boards[b].rate_hz))
                continue;
            if (Status done = take_.addInertial(kPrimaryRun, boards[b].next(frame), suit_.id); !done)
                return done;
            ++rows;
        }
        if (job_.cancelled())
            return JobContext::cancelledError();
        job_.progress(
            share.from + (share.to - share.from) * static_cast<double>(frame) / static_cast<double>(frames),
            "Sampling");
    }
    return Done{};
}

}  // namespace noctule::simulation
