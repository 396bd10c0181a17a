// SPDX-License-Identifier: Apache-2.0
#include "core/import/unit_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/body/text.h"
#include "core/math/rotation.h"

namespace noctule {

namespace {

double medianNorm(const std::vector<Vector3d>& readings) {
    std::vector<double> norms;
    for (const Vector3d& reading : readings)
        if (reading.allFinite())
            norms.push_back(reading.norm());
    if (norms.empty())
        return 0;
    std::nth_element(norms.begin(), norms.begin() + long(norms.size() / 2), norms.end());
    return norms[norms.size() / 2];
}

struct Unit {
    const char* name;
    double gravity;  ///< what gravity reads in it
};

void scale(std::vector<Vector3d>& readings, double factor) {
    for (Vector3d& reading : readings)
        reading *= factor;
}

void convertAccelerations(ImportedSensor& sensor, std::vector<std::string>& warnings) {
    const double median = medianNorm(sensor.samples.accel_m_per_s2);
    if (std::none_of(sensor.samples.accel_m_per_s2.begin(), sensor.samples.accel_m_per_s2.end(),
                     [](const Vector3d& reading) { return reading.allFinite(); }))
        return;
    for (const Unit& unit : {Unit{"g", 1}, Unit{"cm/s^2", 981}, Unit{"mg", 1000}})
        if (std::abs(median / unit.gravity - 1) < 0.012 ||
            (unit.gravity == 1 && std::abs(median - 1) < 0.25)) {
            scale(sensor.samples.accel_m_per_s2, kStandardGravity_m_per_s2 / unit.gravity);
            warnings.push_back(sensor.id + ": accelerations were read as " + unit.name +
                               " and converted to m/s^2");
            return;
        }
    if (median < 6 || median > 14)
        warnings.push_back(sensor.id + ": accelerations have a median of " + std::to_string(median) +
                           ", which is gravity in no known unit");
}

constexpr double kFastestGyroscope_rad_per_s = 70;  ///< 4000 deg/s, where the widest ranges end
constexpr double kShareOfGlitches = 0.005;

/// Rates that no gyroscope shows, where gravity turns too little to tell their unit.
void questionRates(const ImportedSensor& sensor, std::vector<std::string>& warnings) {
    size_t given = 0, too_fast = 0;
    double fastest = 0;
    for (const Vector3d& rate : sensor.samples.gyro_rad_per_s) {
        if (!rate.allFinite())
            continue;
        const double most = rate.cwiseAbs().maxCoeff();
        ++given;
        too_fast += most > kFastestGyroscope_rad_per_s;
        fastest = std::max(fastest, most);
    }
    if (double(too_fast) > kShareOfGlitches * double(given))
        warnings.push_back(sensor.id + ": rates reach " + std::to_string(std::lround(fastest)) +
                           " rad/s, which no gyroscope measures; they look like deg/s and were left as they "
                           "are. Give the file as a table with a map that states deg/s");
}

void convertRates(ImportedSensor& sensor, std::vector<std::string>& warnings) {
    switch (rateReading(sensor.samples)) {
        case RateReading::kDegrees:
            scale(sensor.samples.gyro_rad_per_s, radians(1));
            warnings.push_back(sensor.id + ": rates were read as deg/s and converted to rad/s");
            break;
        case RateReading::kConvertedTwice:
            scale(sensor.samples.gyro_rad_per_s, degrees(1));
            warnings.push_back(
                sensor.id + ": rates are stated as deg/s, but gravity shows rad/s; they were taken as rad/s");
            break;
        case RateReading::kMirrored:
            warnings.push_back(sensor.id +
                               ": gravity turns against the gyroscope; check the gyroscope's axes");
            break;
        case RateReading::kUnknown:
            questionRates(sensor, warnings);
            break;
        case RateReading::kRadians:
            break;
    }
}

/// The Earth's field is 22 to 67 microtesla. Numbers near 1 may be gauss or of no unit, and are left as they
/// are.
void convertFields(ImportedSensor& sensor, std::vector<std::string>& warnings) {
    constexpr double kWeakest_ut = 15, kStrongest_ut = 150;
    const double median = medianNorm(sensor.samples.mag);
    if (!(median > 0)) {
        sensor.samples.mag.clear();
        warnings.push_back(sensor.id + ": the magnetometer reads zero throughout and is left out");
        return;
    }
    for (const auto& [name, microtesla] : {std::pair{"tesla", 1e6}, std::pair{"nanotesla", 1e-3}})
        if (median * microtesla > kWeakest_ut && median * microtesla < kStrongest_ut) {
            scale(sensor.samples.mag, microtesla);
            warnings.push_back(sensor.id + ": fields were read as " + name + " and converted to microtesla");
        }
}

/// A tenth of a second.
struct Block {
    Vector3d up = Vector3d::Zero();
    bool quiet = false;
};

std::vector<Block> blocksOf(const ImuSamples& samples, size_t size, double gravity) {
    std::vector<Block> blocks;
    for (size_t begin = 0; begin + size <= samples.size(); begin += size) {
        Block block;
        for (size_t i = begin; i < begin + size; ++i)
            block.up += samples.accel_m_per_s2[i] / double(size);
        double spread = 0;
        for (size_t i = begin; i < begin + size; ++i)
            spread += (samples.accel_m_per_s2[i] - block.up).squaredNorm() / double(size);
        block.quiet = spread < 0.25 && std::abs(block.up.norm() / gravity - 1) < 0.03;  // NaN is not quiet
        blocks.push_back(block);
    }
    return blocks;
}

/// The turn from the middle of block `from` to the middle of block `to`, were the rates `factor` rad/s.
Quaterniond turnBetween(const ImuSamples& samples, size_t size, size_t from, size_t to, double factor) {
    Quaterniond q = Quaterniond::Identity();
    for (size_t i = from * size + size / 2; i < to * size + size / 2; ++i)
        q = q * expQuaternion(factor / samples.rate_hz * samples.gyro_rad_per_s[i]);
    return q;
}

constexpr double kWindow_s = 5;
constexpr double kTurned_rad = 0.35;
constexpr int kFewestTurns = 3, kMostTurns = 200;

double angleOfDirections(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

RateReading rateReading(const ImuSamples& samples) {
    const auto size = static_cast<size_t>(std::max(1.0, samples.rate_hz / 10));
    const auto blocks = blocksOf(samples, size, medianNorm(samples.accel_m_per_s2));
    constexpr std::array<std::pair<RateReading, double>, 4> kReadings{
        {{RateReading::kRadians, 1},
         {RateReading::kDegrees, std::numbers::pi / 180},
         {RateReading::kMirrored, -1},
         {RateReading::kConvertedTwice, 180 / std::numbers::pi}}};
    std::array<double, kReadings.size()> off_rad{};
    int turns = 0;
    for (size_t from = 0; from < blocks.size() && turns < kMostTurns; ++from) {
        size_t to = from;
        while (++to < blocks.size() && double((to - from) * size) < kWindow_s * samples.rate_hz)
            if (blocks[to].quiet && angleOfDirections(blocks[from].up, blocks[to].up) > kTurned_rad)
                break;
        if (!blocks[from].quiet || to >= blocks.size() ||
            double((to - from) * size) >= kWindow_s * samples.rate_hz)
            continue;
        for (size_t k = 0; k < kReadings.size(); ++k) {
            const Quaterniond turn = turnBetween(samples, size, from, to, kReadings[k].second);
            const double off = angleOfDirections(turn * blocks[to].up, blocks[from].up);
            off_rad[k] += std::isfinite(off) ? off : 0;
        }
        ++turns;
        from = to;
    }
    if (turns < kFewestTurns)
        return RateReading::kUnknown;
    const size_t best = size_t(std::min_element(off_rad.begin(), off_rad.end()) - off_rad.begin());
    return off_rad[best] / turns < kTurned_rad / 2 ? kReadings[best].first : RateReading::kUnknown;
}

void convertToSi(ImportedRecording& recording) {
    for (ImportedSensor& sensor : recording.sensors) {
        convertAccelerations(sensor, recording.warnings);
        convertRates(sensor, recording.warnings);
        if (!sensor.samples.mag.empty())
            convertFields(sensor, recording.warnings);
    }
}

namespace {

// Beyond any sensor of the kind: gyroscopes end at 70 rad/s, accelerometers at 4000 m/s^2.
constexpr double kImpossibleRate_rad_per_s = 1000, kImpossibleAccel_m_per_s2 = 1e4;
constexpr double kImpossibleField = 1e5;
constexpr double kUsualShareMissing = 0.01;
constexpr double kUnevenLength = 0.02;

/// Counts what is missing; what is impossible becomes so.
struct ReadingCount {
    size_t missing = 0, impossible = 0, partial = 0, same = 0;

    ReadingCount(std::vector<Vector3d>& readings, double impossible_beyond) {
        const Vector3d nothing = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
        const Vector3d* last = nullptr;
        for (Vector3d& reading : readings) {
            if (reading.allFinite() && reading.cwiseAbs().maxCoeff() > impossible_beyond) {
                ++impossible;
                reading = nothing;
            }
            if (!reading.allFinite() && reading.array().isFinite().any()) {
                ++partial;
                reading = nothing;
            }
            missing += !reading.allFinite();
            same += last && *last == reading;
            last = &reading;
        }
    }
};

void describeReadings(const std::string& who, const char* what, std::vector<Vector3d>& readings,
                      double impossible_beyond, std::vector<std::string>& warnings) {
    if (readings.empty())
        return;
    const ReadingCount count(readings, impossible_beyond);
    const std::string of = std::to_string(readings.size()) + " " + what;
    if (count.impossible > 0)
        warnings.push_back(who + ": " + std::to_string(count.impossible) + " of " + of +
                           " are beyond any sensor's range and were left out");
    if (count.partial > 0)
        warnings.push_back(who + ": " + std::to_string(count.partial) + " of " + of +
                           " lack an axis and were left out");
    if (count.missing == readings.size())
        return;  // the quantity is not there, which the summary says
    if (double(count.missing) > kUsualShareMissing * double(readings.size()))
        warnings.push_back(who + ": " + std::to_string(count.missing) + " of " + of + " are missing");
    if (2 * count.same > readings.size())
        warnings.push_back(who + ": more than half of " + of +
                           " repeat the one before; the sensor may stand "
                           "still or the file may hold fewer");
}

void describeAttitudes(const ImportedSensor& sensor, std::vector<std::string>& warnings) {
    const auto& all = sensor.q_world_sensor;
    const auto missing =
        std::ranges::count_if(all, [](const Quaterniond& q) { return !q.coeffs().allFinite(); });
    if (double(missing) > kUsualShareMissing * double(all.size()))
        warnings.push_back(sensor.id + ": " + std::to_string(missing) + " of " + std::to_string(all.size()) +
                           " attitudes are missing or of no unit length");
}

}  // namespace

bool holdsReadings(const ImportedRecording& recording) {
    if (recording.reference)
        return true;
    const auto finite = [](const Vector3d& reading) { return reading.allFinite(); };
    return std::ranges::any_of(recording.sensors, [&](const ImportedSensor& sensor) {
        return std::ranges::any_of(sensor.samples.gyro_rad_per_s, finite) ||
               std::ranges::any_of(sensor.samples.accel_m_per_s2, finite) ||
               std::ranges::any_of(sensor.samples.mag, finite) ||
               std::ranges::any_of(sensor.q_world_sensor,
                                   [](const Quaterniond& q) { return q.coeffs().allFinite(); });
    });
}

void checkReadings(ImportedRecording& recording) {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (ImportedSensor& sensor : recording.sensors) {
        ImuSamples& samples = sensor.samples;
        describeReadings(sensor.id, "rates", samples.gyro_rad_per_s, kImpossibleRate_rad_per_s,
                         recording.warnings);
        describeReadings(sensor.id, "accelerations", samples.accel_m_per_s2, kImpossibleAccel_m_per_s2,
                         recording.warnings);
        describeReadings(sensor.id, "fields", samples.mag, kImpossibleField, recording.warnings);
        describeAttitudes(sensor, recording.warnings);
        const double duration_s = double(samples.size()) / samples.rate_hz;
        shortest = std::min(shortest, duration_s);
        longest = std::max(longest, duration_s);
    }
    if (longest > 0 && shortest < (1 - kUnevenLength) * longest)
        recording.warnings.push_back("The sensors are of different lengths: " + text::number(shortest, 2) +
                                     " to " + text::number(longest, 2) + " s");
}

}  // namespace noctule
