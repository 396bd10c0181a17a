// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/pulse_model.h"

#include <numbers>

#include "core/job/contract.h"

namespace noctule {

using std::numbers::pi;

PulseModel::PulseModel(const PulseTrain& train, double resonance_hz, double q)
    : drive_rad_per_s_(2 * pi * train.drive_hz),
      drive_end_s_(train.cycles / train.drive_hz),
      damping_per_s_(pi * resonance_hz / q),
      L_(-damping_per_s_, 2 * pi * (resonance_hz - train.drive_hz)) {
    require(train.drive_hz > 0 && train.cycles > 0, "a pulse needs a drive frequency and cycles");
    require(resonance_hz > 0 && q > 0, "a resonator needs a positive frequency and quality");
    E_end_ = damping_per_s_ / -L_ * (1.0 - std::exp(L_ * drive_end_s_));
}

double PulseModel::at(double u_s) const {
    return (envelope(u_s) * std::polar(1.0, drive_rad_per_s_ * u_s)).imag();
}

std::complex<double> PulseModel::envelope(double u_s) const {
    if (u_s <= 0)
        return 0;
    return u_s < drive_end_s_ ? damping_per_s_ / -L_ * (1.0 - std::exp(L_ * u_s))
                              : E_end_ * std::exp(L_ * (u_s - drive_end_s_));
}

std::complex<double> PulseModel::envelopeSlope(double u_s) const {
    if (u_s <= 0)
        return 0;
    return u_s < drive_end_s_ ? damping_per_s_ * std::exp(L_ * u_s) : L_ * envelope(u_s);
}

}  // namespace noctule
