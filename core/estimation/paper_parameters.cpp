// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/paper_parameters.h"

namespace noctule {

const ParameterTable<PaperParameters>& paperParameters() {
    using P = PaperParameters;
    static const ParameterTable<P> kTable{
        {kPaperProcessSigma, "rad/s^2", 1e-6, 1e6, at(&P::process_sigma_rad_per_s2),
         "Process noise: standard deviation of the change of a joint's acceleration per frame. Larger: "
         "faster motion is followed, less is smoothed.",
         "Vlasic 2007, equation 1 and section 5.2"},
        {"gyro_sigma", "rad/s", 1e-6, 10, at(&P::gyro_sigma_rad_per_s),
         "Standard deviation of a gyroscope's reading.", "Vlasic 2007, section 5.2"},
        {"accel_sigma", "m/s^2", 1e-6, 100, at(&P::accel_sigma_m_per_s2),
         "Standard deviation of an accelerometer's reading.", "Vlasic 2007, section 5.2"},
        {"range_sigma", "m", 1e-6, 1, at(&P::distance_sigma_m),
         "Standard deviation of a range at full confidence.", "Vlasic 2007, section 5.2"},
        {"initial.pose_sigma", "rad", 1e-6, 3, at(&P::initial_pose_rad),
         "Initial standard deviation of each joint coordinate about the rest pose.", "tuned on simulations"},
        {"initial.rate_sigma", "rad/s", 1e-6, 100, at(&P::initial_rate_rad_per_s),
         "Initial standard deviation of each joint rate.", "tuned on simulations"},
        {"initial.accel_sigma", "rad/s^2", 1e-6, 1000, at(&P::initial_accel_rad_per_s2),
         "Initial standard deviation of each joint acceleration.", "tuned on simulations"},
    };
    return kTable;
}

}  // namespace noctule
