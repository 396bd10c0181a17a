// SPDX-License-Identifier: Apache-2.0
// Rows say what a number means in the field's terms; what the code reads stands beside the settings.
#include "core/estimation/manifold_parameters.h"

#include "core/estimation/manifold_limb_parameters.h"

namespace noctule {
namespace {

using Rows = ManifoldRows;

Rows stepParameters() {
    return {
        {"steps_per_frame", "count", 1, 8, at(&ManifoldSetup::filter, &ManifoldParameters::steps_per_frame),
         "Filter steps per 1/140 s. Larger: ranges are predicted nearer to their instants, at more time.",
         "tuned on simulations"},
    };
}

Rows processNoise() {
    return {
        {"process_noise.joint_accel", "rad/s^2", 0.01, 10000,
         at(&ManifoldSetup::filter, &ManifoldParameters::joint_accel_rad_per_s2),
         "Initial standard deviation of a joint's angular acceleration (Ornstein-Uhlenbeck process).",
         "Vlasic 2007, equation 1, with a finite variance"},
        {"process_noise.joint_accel_time", "s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::joint_accel_time_s),
         "Correlation time of a joint's acceleration.", "tuned on simulations"},
        {"process_noise.root_accel", "m/s^2", 0.01, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::root_accel_m_per_s2),
         "Standard deviation of the root's linear acceleration.", "tuned on simulations"},
        {"process_noise.root_accel_time", "s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::root_accel_time_s),
         "Correlation time of the root's linear acceleration.", "tuned on simulations"},
        {"process_noise.root_angular_accel", "rad/s^2", 0.01, 10000,
         at(&ManifoldSetup::filter, &ManifoldParameters::root_turn_accel_rad_per_s2),
         "Initial standard deviation of the root's angular acceleration.", "tuned on simulations"},
        {"process_noise.least", "rad/s^2", 0.0001, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::motion_noise,
            &MotionNoiseParameters::least_rad_per_s2),
         "Lower limit of the adapted process noise of a joint.", "tuned on simulations"},
        {"process_noise.most", "rad/s^2", 0.01, 100000,
         at(&ManifoldSetup::filter, &ManifoldParameters::motion_noise,
            &MotionNoiseParameters::most_rad_per_s2),
         "Upper limit of the adapted process noise of a joint.", "tuned on simulations"},
        {"process_noise.soft_tissue", "rad/s^2", 0, 100000,
         at(&ManifoldSetup::filter, &ManifoldParameters::motion_noise,
            &MotionNoiseParameters::flesh_rad_per_s2),
         "Process noise added where boards ride on soft tissue.", "tuned on simulations"},
        {"process_noise.memory", "s", 0.01, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::motion_noise, &MotionNoiseParameters::memory_s),
         "Time constant of process-noise adaptation.", "covariance matching, Myers and Tapley 1976"},
        {"process_noise.largest_innovation", "-", 1, 10000,
         at(&ManifoldSetup::filter, &ManifoldParameters::motion_noise,
            &MotionNoiseParameters::largest_surprise),
         "Limit of one squared normalised correction in process-noise adaptation. Larger: outliers count "
         "more.",
         "tuned on simulations"},
    };
}

Rows constantsAndRanges() {
    return {
        {"root.velocity_prior", "m/s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::root_velocity_prior_m_per_s),
         "Standard deviation of the zero-velocity prior of a free root, applied once per prior interval.",
         "tuned on simulations"},
        {"constants.estimated", "switch", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::estimates_constants),
         "Estimate sensor biases and constant range errors as states. 0: they are taken to be zero.", "-"},
        {"gyro_bias.sigma", "rad/s", 1e-06, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::gyro_bias_rad_per_s),
         "Initial standard deviation of a gyroscope's bias.", "tuned on simulations"},
        {"gyro_bias.random_walk", "rad/s/sqrt(s)", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::gyro_bias_walk), "Bias random walk of a gyroscope.",
         "tuned on simulations"},
        {"accel_bias.sigma", "m/s^2", 1e-06, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::accel_bias_m_per_s2),
         "Initial standard deviation of an accelerometer's bias.", "tuned on simulations"},
        {"accel_bias.random_walk", "m/s^2/sqrt(s)", 0, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::accel_bias_walk),
         "Bias random walk of an accelerometer.", "tuned on simulations"},
        {"range.source_offset", "m", 1e-07, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::source_offset_m),
         "Initial standard deviation of a source's constant range error.", "tuned on simulations"},
        {"range.sound_scale", "-", 1e-07, 0.1, at(&ManifoldSetup::filter, &ManifoldParameters::sound_scale),
         "Initial standard deviation of the relative error of the speed of sound.", "tuned on simulations"},
        {"range.gate", "sigma", 1, 100, at(&ManifoldSetup::filter, &ManifoldParameters::distance_gate_sigma),
         "Innovation gate of ranges. Larger: fewer ranges are rejected.", "tuned on simulations"},
        {"range.huber", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::distance_huber_sigma),
         "Innovation beyond which the Huber weight of a range falls.", "Huber 1964"},
        {"range.floor", "m", 0, 0.1, at(&ManifoldSetup::filter, &ManifoldParameters::distance_floor_m),
         "Standard deviation added to every range: body and mountings are not rigid.",
         "tuned on simulations"},
        {"range.echo", "m", 0, 0.1, at(&ManifoldSetup::filter, &ManifoldParameters::echo_pull_m),
         "Standard deviation of envelope ranges due to echoes, as white noise of the same effect.",
         "tuned on simulations"},
    };
}

Rows measurementNoise() {
    return {
        {"noise.accel_memory", "count", 2, 100000,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::accel,
            &ExcessNoiseParameters::memory),
         "Readings over which an accelerometer's excess noise is learnt.", "tuned on simulations"},
        {"noise.gyro_memory", "count", 2, 100000,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::gyro,
            &ExcessNoiseParameters::memory),
         "Readings over which a gyroscope's excess noise is learnt.", "tuned on simulations"},
        {"noise.range_memory", "count", 2, 100000,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::distance,
            &ExcessNoiseParameters::memory),
         "Ranges of one pair over which its excess noise is learnt.", "tuned on simulations"},
        {"noise.accel_correlation", "-", 0, 0.999,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::accel,
            &ExcessNoiseParameters::longest_correlation),
         "Upper limit of the learnt lag-one correlation of accelerometer errors.", "tuned on simulations"},
        {"noise.gyro_correlation", "-", 0, 0.999,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::gyro,
            &ExcessNoiseParameters::longest_correlation),
         "Upper limit of the learnt lag-one correlation of gyroscope errors.", "tuned on simulations"},
        {"noise.range_correlation", "-", 0, 0.999,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::distance,
            &ExcessNoiseParameters::longest_correlation),
         "Upper limit of the learnt lag-one correlation of range errors.", "tuned on simulations"},
        {"noise.accel_learning_huber", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::accel,
            &ExcessNoiseParameters::huber_sigma),
         "Innovation beyond which an accelerometer's excess noise learns no more.", "Huber 1964"},
        {"noise.gyro_learning_huber", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::gyro,
            &ExcessNoiseParameters::huber_sigma),
         "Innovation beyond which a gyroscope's excess noise learns no more.", "Huber 1964"},
        {"noise.range_learning_huber", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::distance,
            &ExcessNoiseParameters::huber_sigma),
         "Innovation beyond which a pair's excess noise learns no more.", "Huber 1964"},
        {"noise.huber", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::huber_sigma),
         "Innovation beyond which the Huber weight of an inertial reading falls.", "Huber 1964"},
        {"soft_tissue.accel_per_motion", "-", 0, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise,
            &BoardNoiseParameters::flesh_per_motion),
         "Soft tissue artefact of an accelerometer as a multiple of the recent acceleration.",
         "tuned on simulations"},
        {"soft_tissue.accel", "m/s^2", 0, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise,
            &BoardNoiseParameters::flesh_accel_m_per_s2),
         "Constant part of an accelerometer's soft tissue artefact.", "tuned on simulations"},
        {"soft_tissue.accel_decay", "s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise, &BoardNoiseParameters::wobble_time_s),
         "Decay time of the recent acceleration that soft tissue answers to.",
         "damped oscillator of about 12 Hz"},
        {"soft_tissue.range", "m", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::board_noise,
            &BoardNoiseParameters::flesh_distance_m),
         "Soft tissue artefact of a range, as white noise of the same effect.", "tuned on simulations"},
    };
}

Rows deltaVelocity() {
    return {
        {"delta_velocity.frames", "count", 2, 14000,
         at(&ManifoldSetup::filter, &ManifoldParameters::velocity_gain, &VelocityGainParameters::frames),
         "Frames of 1/140 s in one delta-velocity window.", "tuned on simulations"},
        {"delta_velocity.longest_interval", "s", 0.001, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::velocity_gain, &VelocityGainParameters::longest_s),
         "Interval between readings that counts as a gap.", "tuned on simulations"},
        {"delta_velocity.still", "m/s", 1e-05, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::velocity_gain,
            &VelocityGainParameters::still_m_per_s),
         "Standard deviation of the velocity at a window's ends for a body at rest.", "tuned on simulations"},
        {"delta_velocity.per_motion", "s", 0, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::velocity_gain,
            &VelocityGainParameters::per_motion_s),
         "The same, added per recent force.", "tuned on simulations"},
        {"delta_velocity.decay", "s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::velocity_gain, &VelocityGainParameters::wobble_s),
         "Decay time of that recent force.", "tuned on simulations"},
        {"delta_velocity.least_soft_tissue", "-", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::velocity_gain,
            &VelocityGainParameters::least_flesh_share),
         "Share of soft tissue from which delta velocities are used.", "tuned on simulations"},
        {"delta_velocity.huber", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::velocity_gain, &VelocityGainParameters::huber_sigma),
         "Innovation beyond which the Huber weight of a delta velocity falls.", "Huber 1964"},
    };
}

Rows initialValues() {
    return {
        {"initial.pose_sigma", "rad", 1e-05, 3,
         at(&ManifoldSetup::filter, &ManifoldParameters::initial_pose_rad),
         "Initial standard deviation of each joint coordinate about the rest pose.", "tuned on simulations"},
        {"initial.rest_rate_sigma", "rad/s", 1e-07, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::rest_rate_rad_per_s),
         "Standard deviation of mean joint rates during the rest pose.", "tuned on simulations"},
        {"initial.rest_accel_sigma", "rad/s^2", 1e-07, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::rest_accel_rad_per_s2),
         "Standard deviation of mean joint accelerations during the rest pose.", "tuned on simulations"},
        {"initial.rate_sigma", "rad/s", 1e-06, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::initial_rate_rad_per_s),
         "Standard deviation of joint rates when the rest ends.", "tuned on simulations"},
        {"initial.accel_sigma", "rad/s^2", 1e-06, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::initial_accel_rad_per_s2),
         "Standard deviation of joint accelerations when the rest ends.", "tuned on simulations"},
    };
}

Rows clippedReadings() {
    return {
        {"clipping.excess", "rad/s", 0.1, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::excess_rad_per_s),
         "Mean of the exponential distribution assumed for how far a clipped rate exceeds full scale. "
         "Larger: clipped limbs are assumed to turn faster. Applied per reading.",
         "Tobit Kalman filter, Allik et al. 2016"},
        {"clipping.times_usual", "-", 0.1, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::unseen, &ManifoldParameters::Unseen::times_usual),
         "Prior of an unseen joint rate, as a multiple of its usual rate.", "tuned on simulations"},
        {"clipping.least_rate", "rad/s", 0.01, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::unseen,
            &ManifoldParameters::Unseen::least_rad_per_s),
         "Lower limit of that prior.", "tuned on simulations"},
        {"clipping.memory", "s", 0.01, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::unseen, &ManifoldParameters::Unseen::memory_s),
         "Time constant of the usual rate.", "tuned on simulations"},
        {"clipping.correlation_time", "s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::unseen, &ManifoldParameters::Unseen::alike_s),
         "Time over which that prior counts once.", "tuned on simulations"},
    };
}

Rows posePrior() {
    return {
        {"prior.interval", "s", 0.01, 10, at(&ManifoldSetup::filter, &ManifoldParameters::prior_interval_s),
         "Interval between applications of the pose prior.", "tuned on simulations"},
        {"prior.joint_accel", "rad/s^2", 0.01, 10000,
         at(&ManifoldSetup::filter, &ManifoldParameters::blind,
            &ManifoldParameters::Blind::joint_accel_rad_per_s2),
         "Process noise of a joint whose segment carries no gyroscope.", "tuned on simulations"},
        {"prior.rate", "rad/s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::blind,
            &ManifoldParameters::Blind::rate_prior_rad_per_s),
         "Standard deviation of the zero-rate prior of such a joint.", "tuned on simulations"},
        {"prior.joint_accel_without_gyros", "rad/s^2", 0.01, 10000,
         at(&ManifoldSetup::filter, &ManifoldParameters::all_blind,
            &ManifoldParameters::Blind::joint_accel_rad_per_s2),
         "Process noise of joints when no gyroscope is used.", "tuned on simulations"},
        {"prior.rate_without_gyros", "rad/s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::all_blind,
            &ManifoldParameters::Blind::rate_prior_rad_per_s),
         "Standard deviation of the zero-rate prior when no gyroscope is used.", "tuned on simulations"},
        {"prior.pose", "rad", 0, 10, at(&ManifoldSetup::filter, &ManifoldParameters::unusual_rad),
         "Standard deviation added to the learned pose prior.", "learned from motions that are not scored"},
        {"prior.rest_pose", "rad", 0.001, 10, at(&ManifoldSetup::filter, &ManifoldParameters::unlearnt_rad),
         "Standard deviation about the rest pose, for joints without a learned prior.",
         "tuned on simulations"},
        {"prior.soft_tissue_without_gyros", "-", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::all_blind_flesh_share),
         "Share of soft tissue assumed for accelerometers when no gyroscope is used.",
         "tuned on simulations"},
    };
}

Rows groundContact() {
    return {
        {"ground.holds_feet", "switch", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::holds_feet),
         "Zero-velocity updates at standing feet. 0: contacts are only recorded.", "Foxlin 2005"},
        {"ground.interval", "s", 0.001, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::interval_s),
         "Interval between zero-velocity updates.", "tuned on simulations"},
        {"ground.velocity", "m/s", 0.001, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::velocity_m_per_s),
         "Standard deviation of the velocity of a standing foot.", "tuned on simulations"},
        {"ground.pivot", "m", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::pivot_m),
         "The same, added per foot rate.", "tuned on simulations"},
        {"ground.height", "m", 0.0001, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::height_m),
         "Standard deviation of a standing foot's height on a level floor.", "tuned on simulations"},
        {"ground.slip_time", "s", 0.0001, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::slip_lasts_s),
         "Correlation time of foot slip.", "tuned on simulations"},
        {"ground.sole", "m", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::sole_m),
         "Random change of the sole's place under the root from update to update.", "tuned on simulations"},
        {"ground.level", "m", 0, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::level_m),
         "How level floors are: where the root's height is known better, the floor does not correct it. "
         "Larger: anchors count more than the floor.",
         "floors and soles of recorded people, 1 to 2 cm"},
        {"ground.huber", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::huber_sigma),
         "Innovation beyond which the Huber weight of a zero-velocity update falls.", "Huber 1964"},
        {"ground.height_gate", "m", 0.001, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::height_gate_m),
         "Distance to the floor from which a foot stands on something else.", "a stair is 0.17 m"},
        {"ground.height_gate_sigma", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::height_gate_sigma),
         "Significance which that distance needs.", "tuned on simulations"},
        {"ground.fastest", "m/s", 0.01, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::fastest_m_per_s),
         "Speed from which a foot is swung, whatever the detector says.", "tuned on simulations"},
        {"ground.swing_sigma", "sigma", 0.5, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::swing_sigma),
         "Significance which that speed needs.", "tuned on simulations"},
        {"stance.window", "s", 0.007, 1,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::stance,
            &StanceParameters::window_s),
         "Window of the stance detector.", "Skog et al. 2010, equation 15"},
        {"stance.rolling", "rad/s", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::stance,
            &StanceParameters::rolling_rad_per_s),
         "Rate that a standing foot may have, per axis. Larger: contacts begin earlier and end later.",
         "tuned on simulations"},
        {"stance.shaking", "m/s^2", 0.001, 100,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::stance,
            &StanceParameters::shaking_m_per_s2),
         "Acceleration that a standing foot may have, per axis.", "tuned on simulations"},
        {"stance.touch", "-", 0.01, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::stance,
            &StanceParameters::touch),
         "Statistic below which a foot touches down.", "tuned on simulations"},
        {"stance.leave", "-", 0.01, 1000,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::stance,
            &StanceParameters::leave),
         "Statistic above which a foot leaves.", "tuned on simulations"},
        {"stance.least_contact", "s", 0, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::stance,
            &StanceParameters::least_contact_s),
         "Shortest contact.", "tuned on simulations"},
        {"stance.longest_silence", "s", 0.001, 10,
         at(&ManifoldSetup::filter, &ManifoldParameters::ground, &GroundParameters::stance,
            &StanceParameters::longest_silence_s),
         "Longest gap in readings during a contact.", "tuned on simulations"},
    };
}

Rows smoothers() {
    return {
        {"smoother.lag", "s", 0.05, 10, at(&ManifoldSetup::lag_s),
         "Fixed lag: time over which poses are smoothed (--smooth lag).", "-"},
        {"smoother.stride", "s", 0.01, 10, at(&ManifoldSetup::stride_s),
         "Fixed lag: interval between smoothing passes. Smaller: more time.", "-"},
        {"smoother.stretch", "s", 0.1, 60, at(&ManifoldSetup::stretch_s),
         "Fixed interval: length of a stretch held in memory (--smooth full).", "-"},
        {"smoother.batch_stretch", "s", 0.1, 60, at(&ManifoldSetup::batch, &BatchParameters::stretch_s),
         "Batch: length of a stretch held in memory (--smooth batch).", "-"},
        {"smoother.batch_passes", "count", 1, 100, at(&ManifoldSetup::batch, &BatchParameters::most_passes),
         "Batch: most relinearisation passes.", "-"},
        {"smoother.batch_settled", "-", 1e-12, 0.1, at(&ManifoldSetup::batch, &BatchParameters::settled),
         "Batch: relative gain of the cost that ends relinearisation.", "-"},
    };
}

}  // namespace

const ParameterTable<ManifoldSetup>& manifoldParameters() {
    static const Rows kTable = [] {
        Rows all;
        for (const Rows& part :
             {stepParameters(), processNoise(), constantsAndRanges(), measurementNoise(), limbAlignmentRows(),
              limbRangingRows(), silenceRows(), deltaVelocity(), initialValues(), clippedReadings(),
              posePrior(), jointLaxityRows(), groundContact(), smoothers()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return kTable;
}

}  // namespace noctule
