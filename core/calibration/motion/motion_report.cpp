// SPDX-License-Identifier: Apache-2.0
// What a calibration from motion found, put into calibrations and actors.
#include "core/calibration/motion/motion_calibration.h"
#include "core/suit/calibration_entries.h"

namespace noctule {

Calibration MotionReport::applied(const Calibration& base, const Suit& suit) const {
    Calibration calibration = base;
    for (size_t b = 0; b < boards.size(); ++b) {
        const BoardInMotion& board = boards[b];
        if (!board.measured)
            continue;
        BoardCalibration& known = entryOf(calibration, suit.boards[b]);
        known.q_segment_board = board.q_segment_board;
        known.sigma_mounting_rad = board.sigma_turn_rad;
        known.p_segment_board_m = board.p_segment_board_m;
        known.flesh = board.flesh;
        known.gyro.zero_counts =
            board.gyro_zero_counts + known.gyro.matrix.inverse() * board.gyro_zero_rad_per_s;
        known.accel.zero_counts += known.accel.matrix.inverse() * board.accel_zero_m_per_s2;
    }
    for (size_t s = 0; s < sources.size(); ++s) {
        SourceCalibration& known = entryOf(calibration, suit.sources[s]);
        if (known.offsets_s.contains(detector))
            known.offsets_s[detector] += sources[s].offset_m / c_m_per_s;
        known.p_segment_source_m = sources[s].p_segment_source_m;
    }
    if (!sources.empty() && calibration.sound.kind != SoundModel::Kind::kFixed)
        calibration.sound.scale *= sound_scale;
    return calibration;
}

Actor MotionReport::applied(const Actor& actor) const {
    std::vector<Joint> joints = actor.skeleton.joints();
    for (const BoneInMotion& bone : bones)
        for (Joint& joint : joints)
            if (joint.name == bone.joint)
                joint.offset_m *= bone.scale;
    Actor measured = actor;
    measured.skeleton = Skeleton::make(std::move(joints)).value();
    return measured;
}

}  // namespace noctule
