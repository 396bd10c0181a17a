// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/orientation_smoother.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule::orientation {

void Smoother::smoothSteps() {
    for (size_t k = steps_.size() - 1; k-- > 0;) {
        FilteredStep& here = steps_[k];
        const FilteredStep& next = steps_[k + 1];
        // next.error holds by now what filter and smoother added to the prediction there.
        const ErrorMatrix predicted = predictCovariance(next.transition, here.P, settings_);
        ErrorMatrix FP = here.P;
        applyTransition(next.transition, FP);
        const auto solver = predicted.ldlt();
        const ErrorMatrix gain = solver.solve(FP).transpose();  // P F^T predicted^-1
        const ErrorVector smoothing = gain * next.error;
        const ErrorMatrix P_before = here.P;
        here.P += gain * (next.P - predicted) * gain.transpose();
        here.P = ((here.P + here.P.transpose()) / 2).eval();
        if (!(here.P.diagonal().minCoeff() > 0))
            here.P = P_before;  // rounding at the limit of what is known: keep what the filter knew
        here.nominal.add(smoothing);
        here.error += smoothing;
    }
}

void Smoother::integrateBetween(size_t step, OrientationRun& out) const {
    const size_t begin = step * per_step_, end = std::min(samples_.size(), begin + per_step_);
    const Nominal& target = steps_[step].nominal;
    // Back from the step's end, with the smoothed bias: the first step has nothing before it to begin with.
    std::vector<Quaterniond> back(end - begin + 1);
    back.back() = target.q_world_sensor;
    for (size_t i = end; i-- > begin;) {
        const Vector3d& reading = samples_.gyro_rad_per_s[i];
        const Vector3d turn =
            reading.allFinite() ? Vector3d(target.rate(reading) * samples_.interval_s(i)) : Vector3d::Zero();
        back[i - begin] = back[i - begin + 1] * expQuaternion(-turn);
        if (const double pause_s = samples_.pause_s(i); pause_s > 0)
            back[i - begin] =
                back[i - begin] * expQuaternion(-target.rate(samples_.rateInPause_rad_per_s(i)) * pause_s);
    }
    const Vector3d mismatch =
        step == 0 ? Vector3d::Zero()
                  : logQuaternion(steps_[step - 1].nominal.q_world_sensor * back.front().conjugate());
    double length_s = 0, gone_s = 0;
    for (size_t i = begin; i < end; ++i)
        length_s += samples_.interval_s(i) + samples_.pause_s(i);
    for (size_t i = begin; i < end; ++i) {
        gone_s += samples_.interval_s(i) + samples_.pause_s(i);
        out.q_world_sensor[i] = expQuaternion((1 - gone_s / length_s) * mismatch) * back[i - begin + 1];
        out.heading_sigma_rad[i] = std::sqrt(steps_[step].P(kTurn + 1, kTurn + 1));
    }
}

void Smoother::run(OrientationRun& out) {
    if (steps_.empty())
        return;
    smoothSteps();
    for (size_t step = 0; step < steps_.size(); ++step)
        integrateBetween(step, out);
    out.mag_lag_s = steps_.front().nominal.mag_lag_s;
    out.mag_lag_sigma_s = std::sqrt(steps_.front().P(kMagLag, kMagLag));
}

}  // namespace noctule::orientation
