// SPDX-License-Identifier: Apache-2.0
// What the box measures of itself and of the air, for STATUS: as the sound's source says, unless the control
// port says otherwise. Times in nanoseconds of any clock that does not go back.
#pragma once

#include <functional>
#include <optional>

#include "devices/driver_box/messages.h"

namespace noctule::virtual_suit {

struct Measurements {
    std::optional<double> temperature_c, humidity_percent, battery_v, battery_percent;
};
/// What there is to measure at a sample of the suit.
using MeasurementsAt = std::function<Measurements(int64_t sample)>;

class Instruments {
public:
    static constexpr double kLowSupply_percent = 10, kBatteryLow_percent = 5;
    static constexpr double kFullLasts_s = 8 * 3600;

    explicit Instruments(MeasurementsAt source) : source_(std::move(source)) {}

    /// Of what the thermometer shows; the air stays as it is.
    void setTemperature(double temperature_c) { temperature_c_ = temperature_c; }
    /// From here it drains as batteries do.
    void setBattery(double percent, int64_t now_ns) { battery_ = Battery{percent, now_ns}; }

    /// Flags of boards are not filled in.
    link::BoxStatus read(int64_t sample, int64_t now_ns) const {
        const Measurements found = source_(sample);
        link::BoxStatus status;
        status.temperature_c = narrowed(temperature_c_ ? temperature_c_ : found.temperature_c);
        status.humidity_percent = narrowed(found.humidity_percent);
        status.battery_v = narrowed(found.battery_v);
        status.battery_percent = narrowed(found.battery_percent);
        if (!battery_)
            return status;
        const double used = static_cast<double>(now_ns - battery_->since_ns) * 1e-9 / kFullLasts_s * 100;
        const double percent = std::max(0.0, battery_->percent - used);
        status.battery_percent = static_cast<float>(percent);
        status.battery_v = static_cast<float>(voltageOf(percent));
        return status;
    }

private:
    struct Battery {
        double percent = 100;
        int64_t since_ns = 0;
    };
    static std::optional<float> narrowed(std::optional<double> value) {
        return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
    }
    /// A lithium cell, roughly.
    static double voltageOf(double percent) { return 3.3 + 0.9 * percent / 100; }

    MeasurementsAt source_;
    std::optional<double> temperature_c_;
    std::optional<Battery> battery_;
};

}  // namespace noctule::virtual_suit
