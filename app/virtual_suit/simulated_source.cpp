// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/simulated_source.h"

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "core/math/rotation.h"
#include "core/simulation/cast_sampler.h"

namespace noctule::virtual_suit {
namespace {

using namespace simulation;

/// Later than anything that has been asked about: echoes and readings of the present block.
constexpr double kSoon_s = 0.1;

Error notHere(const std::string& what, const std::string& option) {
    return {ErrorKind::kUsage, what, "Start noctule-virtual-suit with " + option};
}

/// Whether a performer, or the rig, can do that.
Status wornAccepts(const ControlCommand& command, const Stage& stage) {
    if (command.kind == ControlKind::kSlip && stage.suit.boards[command.board].segment.empty())
        return Error{ErrorKind::kUsage,
                     "board " + stage.suit.boards[command.board].id + " is fixed in the room",
                     "Choose one that is worn"};
    if (command.kind == ControlKind::kPose && !stage.motion.rows.empty())
        return notHere("the performer does what the motion says", "--rig rest");
    return command.kind == ControlKind::kSlip || command.kind == ControlKind::kPose
               ? Status(Done{})
               : notHere("the suit is worn, there is no rig to move", "--rig level, turntable, jig or bag");
}

Status rigAccepts(const ControlCommand& command, const RigWorld& rig) {
    switch (command.kind) {
        case ControlKind::kSide:
            return rig.kind() == RigKind::kLevelPlate ? Status(Done{})
                                                      : notHere("no level plate is here", "--rig level");
        case ControlKind::kSpin:
            return rig.kind() == RigKind::kTurntable ? Status(Done{})
                                                     : notHere("no turntable is here", "--rig turntable");
        case ControlKind::kRoll:
        case ControlKind::kHeight:
            return rig.kind() == RigKind::kBag ? Status(Done{}) : notHere("no bag is here", "--rig bag");
        case ControlKind::kPlacement:
            if (rig.kind() != RigKind::kJig)
                return notHere("no jig is here", "--rig jig");
            if (command.number > rig.placementCount())
                return Error{ErrorKind::kUsage, "the jig has no such placement",
                             "Give a number from 1 to " + std::to_string(rig.placementCount())};
            return Done{};
        default:
            return notHere("nobody wears the suit", "--motion or --rig rest");
    }
}

/// Seated: thighs forward, shins down; all else as in the rest pose.
Pose poseNamed(const std::string& name, const Actor& actor) {
    Pose pose = actor.skeleton.zeroPose();
    if (name == "t")
        return pose;
    pose.q_parent_joint = actor.rest_q_parent_joint;
    const double bent_rad = std::numbers::pi / 2;
    for (int j = 0; name == "sit" && j < actor.skeleton.size(); ++j) {
        const std::string& joint = actor.skeleton.joint(j).name;
        if (joint.ends_with("UpLeg"))
            pose.q_parent_joint[j] = axisAngle(Vector3d::UnitX(), -bent_rad);
        else if (joint.ends_with("Leg"))
            pose.q_parent_joint[j] = axisAngle(Vector3d::UnitX(), bent_rad);
    }
    return pose;
}

class SimulatedSource : public SoundSource {
public:
    /// The stage must outlive the source.
    explicit SimulatedSource(Stage& stage) : stage_(stage) {}

    Result<std::optional<SoundBlock>> next() override {
        const int64_t count =
            std::min<int64_t>(link::kUsualBlockSamples, stage_.sampleCount() - first_sample_ - next_sample_);
        if (count <= 0)
            return std::optional<SoundBlock>();
        const auto values = sample(count);
        SoundBlock block{{next_sample_, stage_.world->boardCount(), {values.begin(), values.end()}}, {}};
        next_sample_ += count;
        addPulses(block);
        return std::optional(std::move(block));
    }

    bool isSimulated() const override { return true; }
    Status accepts(const ControlCommand& command) const override {
        return stage_.rig ? rigAccepts(command, *stage_.rig) : wornAccepts(command, stage_);
    }
    void obey(const ControlCommand& command) override {
        const double soon_s =
            static_cast<double>(first_sample_ + next_sample_) / stage_.scenario.sample_rate_hz + kSoon_s;
        if (command.kind == ControlKind::kSlip)
            stage_.body->slip(command.board, radians(command.number), soon_s);
        else if (command.kind == ControlKind::kPose)
            stage_.body->takePose(poseNamed(command.pose, stage_.mover), soon_s);
        else if (command.kind == ControlKind::kSide)
            stage_.rig->layOn(command.side, soon_s);
        else if (command.kind == ControlKind::kSpin)
            stage_.rig->spin(command.side, command.number, soon_s);
        else if (command.kind == ControlKind::kPlacement)
            stage_.rig->place(static_cast<int>(command.number) - 1, soon_s);
        else if (command.kind == ControlKind::kRoll)
            stage_.rig->roll(command.number, soon_s);
        else if (command.kind == ControlKind::kHeight)
            stage_.rig->carryTo(command.number, soon_s);
    }
    void set(const link::Settings& settings) override {
        Scenario& scenario = stage_.scenario;
        if (settings.pulse_interval_samples)
            scenario.pulse_interval_s =
                static_cast<double>(*settings.pulse_interval_samples) / scenario.sample_rate_hz;
        scenario.pulse_cycles = settings.pulse_cycles.value_or(scenario.pulse_cycles);
        if (settings.enabled_sources)
            scenario.enabled_sources = settings.enabled_sources;
    }

protected:
    /// The first sample that is sent has that number on the suit's clock.
    void beginAt(int64_t first_sample) {
        first_sample_ = first_sample;
        next_sample_ = 0;
        const int64_t interval = stage_.scenario.schedule().interval_samples;
        next_pulse_ = std::max<int64_t>(0, (first_sample + interval - 1) / interval);
    }

private:
    virtual std::span<const int16_t> sample(int64_t count) = 0;

    void addPulses(SoundBlock& block) {
        const PulseSchedule schedule = stage_.scenario.schedule();
        if (schedule.isSilent(stage_.world->sourceCount()))
            return;
        for (;; ++next_pulse_) {
            const Pulse pulse = schedule.pulse(next_pulse_, stage_.world->sourceCount());
            if (pulse.sample - first_sample_ >= block.end())
                return;
            block.pulses.push_back({pulse.sample - first_sample_, pulse.source});
        }
    }

    Stage& stage_;
    int64_t first_sample_ = 0, next_sample_ = 0, next_pulse_ = 0;
};

/// A suit that is alone.
class LoneSource : public SimulatedSource {
public:
    explicit LoneSource(std::unique_ptr<Stage> stage) : SimulatedSource(*stage), own_(std::move(stage)) {}

    Status restart(int64_t /*begin_ns*/) override {
        own_->world->beginAgain();
        sampler_ = std::make_unique<SignalSampler>(*own_->world, own_->scenario, own_->truth, room_);
        room_ = sampler_->room();
        beginAt(0);
        return Done{};
    }

private:
    std::span<const int16_t> sample(int64_t count) override { return sampler_->next(count); }

    std::unique_ptr<Stage> own_;
    std::optional<Room> room_;  ///< takes seconds to find in a long performance
    std::unique_ptr<SignalSampler> sampler_;
};

/// One of several suits: it hears the others too.
class CastSource : public SimulatedSource {
public:
    CastSource(std::unique_ptr<Cast> cast, size_t suit, int64_t start_ns)
        : SimulatedSource(cast->suits[suit].stage),
          cast_(std::move(cast)),
          suit_(suit),
          start_ns_(start_ns) {}

    bool isTimed() const override { return true; }
    Status restart(int64_t begin_ns) override {
        const CastSuit& own = cast_->suits[suit_];
        const double rate_hz = own.stage.scenario.sample_rate_hz;
        const double since_start_s = 1e-9 * static_cast<double>(begin_ns - start_ns_);
        const auto first = static_cast<int64_t>(std::llround(own.clock.suitTime_s(since_start_s) * rate_hz));
        own.stage.world->beginAgain();
        staged_ = stagedSuits(*cast_);
        sampler_ = std::make_unique<CastSampler>(staged_, suit_, cast_->chamber, first);
        beginAt(first);
        return Done{};
    }

private:
    std::span<const int16_t> sample(int64_t count) override { return sampler_->next(count); }

    std::unique_ptr<Cast> cast_;
    size_t suit_;
    int64_t start_ns_;
    std::vector<StagedSuit> staged_;
    std::unique_ptr<CastSampler> sampler_;
};

/// Six digits, another suit for another seed.
std::string serialOf(uint64_t seed) {
    char text[24];
    std::snprintf(text, sizeof text, "NB-9%05d", static_cast<int>(seed % 100'000));
    return text;
}

/// What the box says and measures; the source is still missing.
SoundOfSuit boxOf(const Stage& stage) {
    const Scenario& scenario = stage.scenario;
    const PulseSchedule schedule = scenario.schedule();
    link::Hello hello;
    hello.serial = serialOf(stage.truth.seed);
    hello.sample_rate_hz = scenario.sample_rate_hz;
    hello.pulse_interval_samples = schedule.interval_samples;
    hello.pulse_cycles = schedule.cycles;
    hello.drive_hz = schedule.drive_hz;
    hello.suit = stage.suit;
    auto air = std::make_shared<AirInstruments>(stage.truth.air, scenario, stage.truth.seed);
    const auto measurements = [air](int64_t) {
        const AirInstruments::Values values = air->read();
        return Measurements{values.temperature_c, values.humidity_percent, {}, {}};
    };
    return {nullptr, std::move(hello), measurements};
}

}  // namespace

SoundOfSuit makeSimulatedSource(Stage stage) {
    SoundOfSuit sound = boxOf(stage);
    sound.source = std::make_unique<LoneSource>(std::make_unique<Stage>(std::move(stage)));
    return sound;
}

SoundOfSuit makeCastSource(Cast cast, size_t suit, int64_t start_ns) {
    SoundOfSuit sound = boxOf(cast.suits[suit].stage);
    sound.source = std::make_unique<CastSource>(std::make_unique<Cast>(std::move(cast)), suit, start_ns);
    return sound;
}

}  // namespace noctule::virtual_suit
