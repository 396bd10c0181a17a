// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/inertial_sensor.h"

#include <algorithm>
#include <cmath>

namespace noctule::simulation {
namespace {

constexpr double kFieldFullScale_ut = 100, kHardIron_ut = 12, kSoftIron = 0.03, kFieldNoise_ut = 0.25;

struct Spread {
    double full_scale, zero_counts, scale, misalignment_rad;
};

AxisCalibration drawAxes(Random& random, const Spread& spread) {
    AxisCalibration axes = AxisCalibration::nominal(spread.full_scale);
    axes.zero_counts += random.gaussianVector(spread.zero_counts);
    Matrix3d error;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            error(i, j) = random.gaussian(i == j ? spread.scale : spread.misalignment_rad);
    axes.matrix = axes.matrix * (Matrix3d::Identity() + error);
    return axes;
}

}  // namespace

InertialTruth drawInertialTruth(const Board& board, const Scenario& scenario, uint64_t seed, uint64_t index) {
    InertialTruth truth;
    const double misalignment_rad = radians(scenario.axis_misalignment_deg);
    Random gyro(seed, "gyro axes", index), accel(seed, "accel axes", index);
    truth.gyro.calibration = drawAxes(gyro, {board.gyro_full_scale_rad_per_s, scenario.gyro_zero_counts,
                                             scenario.gyro_scale_spread, misalignment_rad});
    truth.accel.calibration = drawAxes(accel, {board.accel_full_scale_m_per_s2, scenario.accel_zero_counts,
                                               scenario.accel_scale_spread, misalignment_rad});
    truth.gyro.bias = Random(seed, "gyro bias", index).gaussianVector(scenario.gyro_bias_rad_per_s);
    truth.accel.bias = Random(seed, "accel bias", index).gaussianVector(scenario.accel_bias_m_per_s2);
    if (board.has_magnetometer) {
        Random iron(seed, "iron", index);
        MagnetometerTruth mag;
        mag.hard_ut = iron.gaussianVector(kHardIron_ut);
        for (double& element : mag.soft.reshaped())
            element += iron.gaussian(kSoftIron);
        mag.noise_ut = kFieldNoise_ut;
        truth.mag = mag;
    }
    truth.rate_hz = board.rate_hz;
    truth.gyro.noise = board.gyro_noise_rad_per_s.value_or(scenario.gyro_noise_rad_per_s);
    truth.accel.noise = board.accel_noise_m_per_s2.value_or(scenario.accel_noise_m_per_s2);
    truth.gyro.bias_walk_per_sqrt_s = scenario.gyro_bias_walk_rad_per_s_per_sqrt_s;
    Random clock(seed, "stream phase", index);
    truth.phase_samples = clock.below(static_cast<int64_t>(scenario.sample_rate_hz / board.rate_hz));
    truth.first_counter = static_cast<int>(clock.below(kCounterPeriod));
    return truth;
}

AxisCalibration asCalibrated(const AxisCalibration& truth, double matrix_error, Random random) {
    AxisCalibration found = truth;
    Matrix3d error;
    for (double& element : error.reshaped())
        element = random.gaussian(matrix_error);
    found.matrix = truth.matrix * (Matrix3d::Identity() + error);
    return found;
}

InertialSensor::InertialSensor(const SuitWorld& world, int board, const InertialTruth& truth,
                               int sample_rate_hz, uint64_t seed, int64_t first_frame)
    : world_(world),
      board_(board),
      sample_rate_hz_(sample_rate_hz),
      phase_samples_(static_cast<double>(truth.phase_samples)),
      rate_hz_(truth.rate_hz),
      gyro_(makeChip(truth.gyro, seed, "gyro", board)),
      accel_(makeChip(truth.accel, seed, "accel", board)),
      mag_(truth.mag),
      mag_noise_(seed, "field noise", static_cast<uint64_t>(board)),
      frame_(first_frame) {}

void InertialSensor::feelField(const BoardMotion& motion) {
    if (!mag_)
        return;
    const Vector3d felt_ut =
        mag_->soft * (motion.q_world_board.conjugate() * world_.field_ut(motion.p_world_board_m)) +
        mag_->hard_ut + mag_noise_.gaussianVector(mag_->noise_ut);
    for (int axis = 0; axis < 3; ++axis)
        field_[static_cast<size_t>(axis)] = static_cast<int>(std::lround(
            std::clamp(2048 + felt_ut[axis] * 2048 / kFieldFullScale_ut, kCountsMin, kCountsMax)));
}

InertialSensor::Chip InertialSensor::makeChip(const ChipTruth& truth, uint64_t seed, const std::string& name,
                                              int board) {
    const uint64_t index = static_cast<uint64_t>(board);
    return {truth, truth.calibration.matrix.inverse(), truth.bias, Random(seed, name + " noise", index),
            Random(seed, name + " bias walk", index)};
}

Vector3d InertialSensor::Chip::counts(const Vector3d& value, double rate_hz) {
    const Vector3d measured = value + bias + noise.gaussianVector(truth.noise);
    bias += walk.gaussianVector(truth.bias_walk_per_sqrt_s / std::sqrt(rate_hz));
    return truth.calibration.zero_counts + counts_per_unit * measured;
}

double InertialSensor::sampleOf(int64_t frame) const {
    return phase_samples_ + static_cast<double>(frame) * sample_rate_hz_ / rate_hz_;
}

std::array<double, 6> InertialSensor::next() {
    const BoardMotion motion = world_.boardMotion(board_, sampleOf(frame_) / sample_rate_hz_);
    ++frame_;
    feelField(motion);
    const Vector3d gyro = gyro_.counts(motion.gyro_rad_per_s, rate_hz_),
                   accel = accel_.counts(motion.accel_m_per_s2, rate_hz_);
    std::array<double, 6> counts{gyro.x(), gyro.y(), gyro.z(), accel.x(), accel.y(), accel.z()};
    for (double& count : counts)
        count = std::clamp(count, kCountsMin, kCountsMax);
    return counts;
}

BoardStream::BoardStream(const SuitWorld& world, int board, const InertialTruth& truth, int sample_rate_hz,
                         uint64_t seed)
    : sensor_(world, board, truth, sample_rate_hz, seed, kFirstFrame - kWarmUpFrames),
      encoder_(truth.mag.has_value(), truth.first_counter) {
    int counter = 0;
    while (sensor_.nextFrame() < kFirstFrame)
        next(counter);
}

LineBits BoardStream::next(int& counter) {
    const std::array<double, 6> counts = sensor_.next();
    std::array<int, 6> reading{};
    for (size_t i = 0; i < counts.size(); ++i)
        reading[i] = static_cast<int>(std::lround(counts[i]));
    counter = encoder_.counter();
    return encoder_.encode(reading, sensor_.field());
}

BoardReadings::BoardReadings(const SuitWorld& world, int board, const InertialTruth& truth,
                             const Scenario& scenario, uint64_t seed)
    : board_(board),
      sensor_(world, board, truth, scenario.sample_rate_hz, seed, 0),
      decoder_(truth.mag.has_value()) {
    // The stream of our boards carries 140 readings a second and no other number.
    if (!scenario.codec || truth.rate_hz != kInertialFramesPerSecond)
        return;
    stream_.emplace(world, board, truth, scenario.sample_rate_hz, seed);
    int counter = 0;
    stream_->next(counter);  // the frame under way at sample 0 is heard only in part
}

InertialReading BoardReadings::next(int64_t frame) {
    InertialReading reading;
    if (stream_) {
        int counter = 0;
        const LineBits bits = stream_->next(counter);
        reading = decoder_.decode(bits, counter);
    } else {
        const std::array<double, 6> counts = sensor_.next();
        std::copy(counts.begin(), counts.end(), reading.counts.begin());
        reading.corrected_bits = 0;
    }
    reading.board = board_;
    reading.frame = frame;
    reading.sample = sensor_.sampleOf(frame);
    return reading;
}

}  // namespace noctule::simulation
