// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/orientation_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/rotation.h"
#include "core/orientation/error_filter.h"
#include "core/orientation/orientation_smoother.h"

namespace noctule {

namespace orientation {

namespace {

constexpr double kLongestLag_s = 0.1;
constexpr double kMissingRate_rad_per_s = 2;  ///< standard deviation of a rate that was not read
constexpr double kMissingAccel_m_per_s2 = 5;  ///< the same of an acceleration
constexpr double kHuber_sigma = 2.5;          ///< headings farther off count less
constexpr double kRestGate_sigma = 3;         ///< rates farther off are a slow turn, no rest
constexpr double kReferenceMemory_s = 20;     ///< how slowly the Earth's field is learnt
constexpr int kPseudoPerSecond = 1;

/// The Earth's field as it was mostly: strength in the readings' unit, inclination downwards positive.
struct FieldMemory {
    double strength = 0, inclination_rad = 0;

    /// 1 where the field is the Earth's, more where it is not.
    double inflation(double strength_now, double inclination_now, const OrientationSettings& s) const {
        const double a = (strength_now / strength - 1) / s.strength_share;
        const double b = (inclination_now - inclination_rad) / s.inclination_rad;
        const double off = 1 + a * a + b * b;
        return off * off;
    }
    void learn(double strength_now, double inclination_now, double dt_s) {
        const double share =
            -std::expm1(-dt_s / kReferenceMemory_s);  // a pause may be longer than the memory
        strength += share * (strength_now - strength);
        inclination_rad += share * (inclination_now - inclination_rad);
    }
};

/// Whether the sensor lies still: readings stay near their low-passed values for a while. After VQF's rest
/// detection (Laidig, Seel 2023, section 3.4), with its published thresholds.
class RestDetector {
public:
    void add(const Vector3d& rate, const Vector3d& force, double dt_s) {
        if (!rate.allFinite() || !force.allFinite() || !seen_) {
            seen_ = rate.allFinite() && force.allFinite();
            rate_ = rate;
            force_ = force;
            still_s_ = 0;
            return;
        }
        const double share = dt_s / (kMemory_s + dt_s);
        rate_ += share * (rate - rate_);
        force_ += share * (force - force_);
        const bool near =
            (rate - rate_).norm() < kRate_rad_per_s && (force - force_).norm() < kForce_m_per_s2;
        still_s_ = near ? still_s_ + dt_s : 0;
    }
    bool rests() const { return still_s_ > kLeast_s; }

private:
    static constexpr double kMemory_s = 0.5, kLeast_s = 1.5;
    static constexpr double kRate_rad_per_s = 2 * std::numbers::pi / 180, kForce_m_per_s2 = 0.5;
    bool seen_ = false;
    Vector3d rate_ = Vector3d::Zero(), force_ = Vector3d::Zero();
    double still_s_ = 0;
};

class Filter {
public:
    Filter(const ImuSamples& samples, const OrientationSettings& settings)
        : samples_(samples), settings_(settings), P_(startCovariance(settings)), attitudes_(samples.size()) {
        const FieldReference reference = initialReference(samples);
        nominal_.q_world_sensor = reference.q_world_sensor;
        field_.strength = reference.strength;
        field_.inclination_rad = -std::asin(std::clamp(reference.field_world.y(), -1.0, 1.0));
        per_step_ = std::max<size_t>(1, static_cast<size_t>(std::lround(settings.step_s * samples.rate_hz)));
        steps_per_pseudo_ = std::max<size_t>(
            2, static_cast<size_t>(std::lround(samples.rate_hz / double(per_step_) / kPseudoPerSecond)));
    }

    Result<OrientationRun> run(const JobContext& job) {
        OrientationRun out;
        out.q_world_sensor.resize(samples_.size());
        out.heading_sigma_rad.resize(samples_.size());
        Smoother smoother(samples_, settings_, per_step_);
        for (size_t begin = 0, step = 0; begin < samples_.size(); begin += per_step_, ++step) {
            if (job.cancelled())
                return JobContext::cancelledError();
            const size_t end = std::min(samples_.size(), begin + per_step_);
            integrate(begin, end);
            std::copy(attitudes_.begin() + long(begin), attitudes_.begin() + long(end),
                      out.q_world_sensor.begin() + long(begin));
            P_ = predictCovariance(transition_, P_, settings_);
            const ErrorVector error = correctAt(step);
            nominal_.add(error);
            keepHeadingUnseen(error, P_);
            turnRecent(error.segment<3>(kTurn), end);
            out.q_world_sensor[end - 1] = nominal_.q_world_sensor;
            const double sigma = std::sqrt(std::max(0.0, P_(kTurn + 1, kTurn + 1)));
            std::fill(out.heading_sigma_rad.begin() + long(begin), out.heading_sigma_rad.begin() + long(end),
                      sigma);
            if (settings_.smooth)
                smoother.push({transition_, P_, error, nominal_});
            if (step % 256 == 0)
                job.progress(double(end) / double(samples_.size()), "Orientation");
        }
        out.mag_lag_s = nominal_.mag_lag_s;
        out.mag_lag_sigma_s = std::sqrt(P_(kMagLag, kMagLag));
        out.gyro_bias_rad_per_s = nominal_.gyro_bias_rad_per_s;
        if (settings_.smooth)
            smoother.run(out);
        return out;
    }

private:
    /// Integrates readings [begin, end) and sums up what the transition and the heading by the field need.
    void integrate(size_t begin, size_t end) {
        transition_ = {};
        field_sum_ = field_rate_sum_ = Vector3d::Zero();
        field_count_ = 0;
        strength_sum_ = 0;
        for (size_t i = begin; i < end; ++i) {
            const double dt_s = samples_.interval_s(i);
            if (samples_.pause_s(i) > 0)
                passPause(i);
            const Matrix3d R_before = nominal_.q_world_sensor.toRotationMatrix();
            const Vector3d rate = integrateRate(i, dt_s, R_before);
            // Readings are means over their interval: the force is turned as the sensor stood in its middle.
            integrateForce(i, dt_s, R_before * expQuaternion(rate * (dt_s / 2)).toRotationMatrix());
            rest_.add(samples_.gyro_rad_per_s[i], samples_.accel_m_per_s2[i], dt_s);
            attitudes_[i] = nominal_.q_world_sensor;
            if (samples_.hasMag(i))
                gatherField(i, R_before * rate);
            transition_.dt_s += dt_s;
        }
        transition_.disturbance_decay = std::exp(-transition_.dt_s / settings_.disturbance_s);
        nominal_.disturbance_rad *= transition_.disturbance_decay;
    }

    /// The turn goes on as it did around the pause, and counts as little as that of missing readings.
    void passPause(size_t i) {
        const double pause_s = samples_.pause_s(i);
        transition_.dt_s += pause_s;
        transition_.turn_by_bias -= pause_s * nominal_.q_world_sensor.toRotationMatrix();
        transition_.missing_turn_rad2 += std::pow(kMissingRate_rad_per_s, 2) * pause_s / samples_.rate_hz;
        transition_.missing_velocity_m2_per_s2 +=
            std::pow(kMissingAccel_m_per_s2, 2) * pause_s / samples_.rate_hz;
        const Vector3d rate = nominal_.rate(samples_.rateInPause_rad_per_s(i));
        nominal_.q_world_sensor = nominal_.q_world_sensor * expQuaternion(rate * pause_s);
    }

    Vector3d integrateRate(size_t i, double dt_s, const Matrix3d& R) {
        const Vector3d& reading = samples_.gyro_rad_per_s[i];
        transition_.turn_by_bias -= dt_s * R;
        if (!reading.allFinite()) {
            transition_.missing_turn_rad2 += std::pow(kMissingRate_rad_per_s * dt_s, 2);
            return Vector3d::Zero();
        }
        transition_.turn_by_scale += dt_s * (R * reading.asDiagonal());
        const Vector3d rate = nominal_.rate(reading);
        nominal_.q_world_sensor = nominal_.q_world_sensor * expQuaternion(rate * dt_s);
        return rate;
    }

    void integrateForce(size_t i, double dt_s, const Matrix3d& R) {
        const Vector3d& reading = samples_.accel_m_per_s2[i];
        if (!reading.allFinite()) {
            transition_.missing_velocity_m2_per_s2 += std::pow(kMissingAccel_m_per_s2 * dt_s, 2);
            return;
        }
        const Vector3d force_dt = dt_s * (R * (reading - nominal_.accel_bias_m_per_s2));
        transition_.force_dt += force_dt;
        nominal_.place_m += dt_s * nominal_.velocity_m_per_s;
        nominal_.velocity_m_per_s += force_dt;
        nominal_.velocity_m_per_s.y() -= kStandardGravity_m_per_s2 * dt_s;
    }

    /// Rows before `i` within the magnetometer's lag, and the time from the first of them to `i`.
    std::pair<size_t, double> rowsOfLag(size_t i) const {
        const double lag_s = std::clamp(nominal_.mag_lag_s, 0.0, kLongestLag_s);
        size_t rows = 0;
        double back_s = 0;
        for (; rows < i; ++rows) {
            const double farther_s = back_s + samples_.interval_s(i - rows) + samples_.pause_s(i - rows);
            if (farther_s > lag_s)
                break;
            back_s = farther_s;
        }
        return {rows, back_s};
    }

    /// The field in the world as the magnetometer saw it when the sensor was turned so: its lag ago.
    void gatherField(size_t i, const Vector3d& rate_world) {
        const auto [rows, back_s] = rowsOfLag(i);
        const Vector3d field = attitudes_[i - rows] * samples_.mag[i];
        const Vector3d field_rate = rate_world.cross(field);
        field_sum_ += field - (nominal_.mag_lag_s - back_s) * field_rate;
        field_rate_sum_ += field_rate;
        strength_sum_ += samples_.mag[i].norm();
        ++field_count_;
    }

    ErrorVector correctAt(size_t step) {
        ErrorVector error = ErrorVector::Zero();
        const size_t phase = step % steps_per_pseudo_;
        if (phase == 0)
            holdToZero(kVelocity, nominal_.velocity_m_per_s, settings_.velocity_m_per_s, error);
        else if (phase == steps_per_pseudo_ / 2)
            holdToZero(kPlace, nominal_.place_m, settings_.place_m, error);
        if (field_count_ > 0)
            correctHeading(error);
        if (rest_.rests())
            correctBiasAtRest(step, error);
        return error;
    }

    /// The gyroscope's mean while the sensor rests is its bias. A turn so slow and even that it looks like
    /// rest is told apart once the bias is known: its innovation is too large.
    void correctBiasAtRest(size_t step, ErrorVector& error) {
        const size_t begin = step * per_step_, end = std::min(samples_.size(), begin + per_step_);
        Vector3d mean = Vector3d::Zero();
        double read_s = 0;  // without a pause
        for (size_t i = begin; i < end; ++i) {
            mean += samples_.gyro_rad_per_s[i] / double(end - begin);
            read_s += samples_.interval_s(i);
        }
        if (!mean.allFinite())
            return;
        const double variance = std::pow(settings_.gyro_noise_rad_per_sqrt_s, 2) / read_s;
        const Vector3d rate = nominal_.rate(mean);
        for (int axis = 0; axis < 3; ++axis)
            if (std::pow(rate[axis], 2) >
                kRestGate_sigma * kRestGate_sigma * (P_(kGyroBias + axis, kGyroBias + axis) + variance))
                return;
        for (int axis = 0; axis < 3; ++axis)
            correct(ErrorVector::Unit(kGyroBias + axis), rate[axis], variance, error, P_);
    }

    void holdToZero(int part, const Vector3d& value, double sigma, ErrorVector& error) {
        // Held in a frame that turns with the heading: which way is north does not follow from staying in a
        // room, so the row has no part along a common turn of attitude, velocity and place about the
        // vertical.
        const Vector3d turned = Vector3d::UnitY().cross(value);
        for (int axis = 0; axis < 3; ++axis) {
            ErrorVector h = ErrorVector::Unit(part + axis);
            h[kTurn + 1] = -turned[axis];
            correct(h, -value[axis], sigma * sigma, error, P_);
        }
    }

    void correctHeading(ErrorVector& error) {
        const Vector3d field = field_sum_ / field_count_;
        const Vector3d field_rate = field_rate_sum_ / field_count_;
        const double strength = strength_sum_ / field_count_;
        const double level2 = field.x() * field.x() + field.z() * field.z();
        if (level2 < 1e-4 * field.squaredNorm())
            return;  // at the pole or beside a magnet: no heading
        const double heading = std::atan2(field.x(), field.z());
        const double heading_rate = (field.z() * field_rate.x() - field.x() * field_rate.z()) / level2;
        const double inclination = -std::atan2(field.y(), std::sqrt(level2));
        ErrorVector h = ErrorVector::Zero();
        h[kTurn + 1] = 1;
        h[kDisturbance] = -1;
        h[kMagLag] = -heading_rate;
        const double y = std::remainder(nominal_.disturbance_rad - heading, 2 * std::numbers::pi);
        const double inflation = field_.inflation(strength, inclination, settings_);
        double variance = settings_.mag_heading_rad * settings_.mag_heading_rad * inflation;
        const double off = std::abs(y) / std::sqrt(h.dot(P_ * h) + variance);
        if (off > kHuber_sigma)
            variance *= off * off / (kHuber_sigma * kHuber_sigma);
        correct(h, y, variance, error, P_);
        if (inflation < 2)
            field_.learn(strength, inclination, transition_.dt_s);
    }

    /// The last attitudes belong to the corrected world too: the next readings of the field look back at
    /// them.
    void turnRecent(const Vector3d& turn, size_t end) {
        const Quaterniond q = expQuaternion(turn);
        const size_t back = rowsOfLag(end - 1).first + 1;
        for (size_t i = end - back; i < end; ++i)
            attitudes_[i] = q * attitudes_[i];
    }

    const ImuSamples& samples_;
    const OrientationSettings& settings_;
    size_t per_step_ = 1, steps_per_pseudo_ = 2;
    Nominal nominal_;
    ErrorMatrix P_;
    Transition transition_;
    FieldMemory field_;
    RestDetector rest_;
    Vector3d field_sum_, field_rate_sum_;
    double strength_sum_ = 0;
    int field_count_ = 0;
    std::vector<Quaterniond> attitudes_;  ///< of each reading, turned along with the last corrections
};

}  // namespace
}  // namespace orientation

Result<OrientationRun> estimateOrientation(const ImuSamples& samples, const OrientationSettings& settings,
                                           const JobContext& job) {
    return orientation::Filter(samples, settings).run(job);
}

}  // namespace noctule
