// SPDX-License-Identifier: Apache-2.0
// A board's gyroscope and accelerometer: what is true becomes counts, with zero, scale, misalignment, a bias
// that nobody knows, its slow walk and white noise. Counts = zero + matrix^-1 (value + bias + noise).
#pragma once

#include <array>

#include "core/inertial/frame_decoder.h"
#include "core/inertial/frame_encoder.h"
#include "core/simulation/random.h"
#include "core/simulation/scenario.h"
#include "core/simulation/suit_world.h"
#include "core/suit/calibration.h"

namespace noctule::simulation {

/// What one three-axis chip hides.
struct ChipTruth {
    AxisCalibration calibration;       ///< exact zero and matrix
    Vector3d bias = Vector3d::Zero();  ///< rad/s or m/s^2, at the take's beginning; in no calibration
    double noise = 0;                  ///< rad/s or m/s^2, white, per reading
    double bias_walk_per_sqrt_s = 0;   ///< rad/s or m/s^2 per root of a second
};

/// What a board's own iron makes of the world's field: counts of the nominal scale = 2048 + soft * field +
/// hard.
struct MagnetometerTruth {
    Matrix3d soft = Matrix3d::Identity();
    Vector3d hard_ut = Vector3d::Zero();
    double noise_ut = 0;
};

struct InertialTruth {
    ChipTruth gyro, accel;
    std::optional<MagnetometerTruth> mag{};  ///< none: the board has no magnetometer
    double rate_hz = kUsualBoardRate_hz;
    int64_t phase_samples = 0;  ///< s0: first sample of frame 0
    int first_counter = 0;      ///< of the stream, a little before the take
};

InertialTruth drawInertialTruth(const Board& board, const Scenario& scenario, uint64_t seed, uint64_t index);

/// What the laboratory found: the exact zeros and, up to its matrix errors, the matrices.
AxisCalibration asCalibrated(const AxisCalibration& truth, double matrix_error, Random random);

/// Readings of one board, frame after frame; frame n belongs to sample s0 + n fs / rate.
class InertialSensor {
public:
    /// `world` must outlive the sensor. The first frame asked for is `first_frame`, perhaps negative.
    InertialSensor(const SuitWorld& world, int board, const InertialTruth& truth, int sample_rate_hz,
                   uint64_t seed, int64_t first_frame);

    double sampleOf(int64_t frame) const;

    /// The next frame's gyroscope and accelerometer counts, unrounded, saturated at 0 and 4095.
    std::array<double, 6> next();
    /// Of the frame that next() returned last: the magnetometer's counts, rounded; 0 without one.
    const std::array<int, 3>& field() const { return field_; }
    int64_t nextFrame() const { return frame_; }

private:
    struct Chip {
        ChipTruth truth;
        Matrix3d counts_per_unit;
        Vector3d bias;
        Random noise, walk;
        Vector3d counts(const Vector3d& value, double rate_hz);
    };
    void feelField(const BoardMotion& motion);
    static Chip makeChip(const ChipTruth& truth, uint64_t seed, const std::string& name, int board);

    const SuitWorld& world_;
    int board_;
    double sample_rate_hz_, phase_samples_, rate_hz_;
    Chip gyro_, accel_;
    std::optional<MagnetometerTruth> mag_;
    Random mag_noise_;
    std::array<int, 3> field_{};
    int64_t frame_;
};

/// A board's digital stream: readings rounded to 12 bits, coded and packed. It was switched on a second
/// before the take, so that the coder has settled.
class BoardStream {
public:
    BoardStream(const SuitWorld& world, int board, const InertialTruth& truth, int sample_rate_hz,
                uint64_t seed);

    static constexpr int64_t kFirstFrame = -1;  ///< the one under way at sample 0
    /// The next frame, from kFirstFrame on; its counter is written to `counter`.
    LineBits next(int& counter);

private:
    static constexpr int64_t kWarmUpFrames = 140;
    InertialSensor sensor_;
    FrameEncoder encoder_;
};

/// Inertial rows of one board at readings level: through the codec, or unrounded where the scenario has none.
class BoardReadings {
public:
    BoardReadings(const SuitWorld& world, int board, const InertialTruth& truth, const Scenario& scenario,
                  uint64_t seed);

    /// The row of the next frame, from 0 on.
    InertialReading next(int64_t frame);

private:
    int board_;
    InertialSensor sensor_;  ///< not asked for readings when there is a stream
    std::optional<BoardStream> stream_;
    FrameDecoder decoder_;
};

}  // namespace noctule::simulation
