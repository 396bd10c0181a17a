// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/formats/figure.h"
#include "core/formats/number_text.h"
#include "core/formats/positions_csv.h"
#include "core/job/atomic_file.h"

namespace noctule {
namespace {

/// RFC 4180: a cell with a separator or quote stands in quotes.
void appendCell(std::string& text, const std::string& cell) {
    text += ',';
    if (cell.find_first_of(",;\"\t\n") == std::string::npos) {
        text += cell;
        return;
    }
    text += '"';
    for (const char c : cell)
        text += c == '"' ? std::string("\"\"") : std::string(1, c);
    text += '"';
}

void appendNumber(std::string& text, double value) {
    text += ',';
    appendFixed(text, value, 6);
}

void appendHeader(std::string& text, const Skeleton& skeleton, bool angles) {
    text += "time_s";
    for (const Joint& joint : skeleton.joints())
        for (const char* axis : {".x", ".y", ".z"})
            appendCell(text, joint.name + axis);
    if (angles)
        for (const Joint& joint : skeleton.joints())
            for (const DegreeOfFreedom& dof : joint.dof)
                appendCell(text, joint.name + "." + dof.name);
    text += '\n';
}

void appendAngles(std::string& text, const Skeleton& skeleton, const Pose& pose) {
    for (size_t j = 0; j < skeleton.joints().size(); ++j) {
        const Joint& joint = skeleton.joints()[j];
        if (joint.dof.empty())
            continue;
        const JointAngles projected = projectOntoJoint(joint, pose.q_parent_joint[j], false);
        for (const double angle_rad : projected.angles_rad)
            appendNumber(text, degrees(angle_rad));
    }
}

}  // namespace

std::string formatPositionsCsv(const MotionClip& clip, bool angles, double begin_s) {
    std::string text;
    appendHeader(text, clip.skeleton, angles);
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        appendFixed(text, begin_s + static_cast<double>(f) * clip.frame_time_s, 9);
        for (const Vector3d& p_m : globalPose(clip, f).p_world_joint)
            for (int axis = 0; axis < 3; ++axis)
                appendNumber(text, p_m[axis]);
        if (angles)
            appendAngles(text, clip.skeleton, clip.frames[f]);
        text += '\n';
    }
    return text;
}

Status writePositionsCsv(const std::string& path, const MotionClip& clip, bool angles, bool overwrite,
                         double begin_s) {
    if (Status free = checkOutputPath(path, overwrite); !free)
        return free;
    if (Status finite = checkFinite(clip); !finite)
        return finite;
    return writeFileAtomically(path, formatPositionsCsv(clip, angles, begin_s), overwrite);
}

}  // namespace noctule
