// SPDX-License-Identifier: Apache-2.0
// Which axis of a file points up. A standing figure shows it: trunk and legs in one line along it, in the
// frames and in the zero pose, and soles that stay at one height.
#pragma once

#include "core/figure/joint_mapping.h"

namespace noctule::figure {

enum class UpAxis { kAuto, kY, kZ, kX, kMinusX, kMinusY, kMinusZ };

/// "y", "z" or "auto"; otherwise kUsage.
Result<UpAxis> upAxisFromText(const std::string& text);
/// "+Y"; not of kAuto.
std::string toText(UpAxis axis);

struct UpAxisChoice {
    UpAxis axis = UpAxis::kY;
    double upright = 0;     ///< mean cosine between that axis and the body, from -1 to 1
    double standing = 0;    ///< share of frames in which trunk and legs are in one line
    bool doubtful = false;  ///< another axis fits about as well
};
/// Y unless another axis fits clearly better.
UpAxisChoice findUpAxis(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping);
/// The same for an axis that was given.
UpAxisChoice judgeUpAxis(const SeenMotion& seen, const JointMapping& mapping, UpAxis axis);

/// Turns a clip so that the axis becomes Y.
void turnUp(MotionClip& clip, UpAxis axis);

}  // namespace noctule::figure
