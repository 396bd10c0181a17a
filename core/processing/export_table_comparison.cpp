// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/formats/opensim.h"
#include "core/formats/positions_csv.h"
#include "core/job/atomic_file.h"
#include "core/processing/export_comparison.h"

namespace noctule {
namespace {

/// Whether a number of the table stays the same however the root was held.
bool staysTheSame(const OpenSimTable& table, size_t in_row, bool is_angles, RootMotion root) {
    if (in_row == 0)
        return false;
    if (root == RootMotion::kMoving)
        return true;
    return is_angles ? !table.columns[in_row].starts_with("pelvis") : root == RootMotion::kInPlace;
}

/// Between two numbers of a column: metres, radians, or a part of a quaternion.
void addDifference(const OpenSimTable& table, size_t in_row, bool is_angles, double apart,
                   ExportCheck& check) {
    if (is_angles && table.columns[in_row].starts_with("pelvis_t") && table.columns[in_row] != "pelvis_tilt")
        check.largest_position_m = std::max(check.largest_position_m, std::abs(apart));
    else if (is_angles)
        check.largest_angle_rad =
            std::max(check.largest_angle_rad, std::abs(std::remainder(radians(apart), 2 * M_PI)));
    else
        check.largest_angle_rad = std::max(check.largest_angle_rad, 2 * std::abs(apart));
}

struct AngleColumns {
    std::vector<std::string> names;
    std::vector<size_t> joint;  ///< whose rotation they are taken from
    std::vector<int> freedom;
};

AngleColumns angleColumns(const Skeleton& skeleton) {
    AngleColumns columns;
    for (size_t j = 0; j < skeleton.joints().size(); ++j)
        for (size_t d = 0; d < skeleton.joints()[j].dof.size(); ++d) {
            columns.names.push_back(skeleton.joints()[j].name + "." + skeleton.joints()[j].dof[d].name);
            columns.joint.push_back(j);
            columns.freedom.push_back(static_cast<int>(d));
        }
    return columns;
}

}  // namespace

Status compareAngles(const std::string& path, const ExpectedMotion& expected, ExportCheck& check) {
    const AngleColumns columns = angleColumns(expected.skeleton);
    const auto table = readNumberColumns(path, columns.names);
    if (!table)
        return table.error();
    check.has_angles = true;
    const size_t width = columns.names.size();
    for (size_t f = 0; f < std::min(table->size() / std::max<size_t>(1, width), expected.frames.size()); ++f)
        for (size_t c = 0; c < width; ++c) {
            const JointAngles angles =
                projectOntoJoint(expected.skeleton.joints()[columns.joint[c]],
                                 expected.frames[f].q_parent_joint[columns.joint[c]], false);
            const double apart_rad = radians((*table)[f * width + c]) - angles.angles_rad[columns.freedom[c]];
            check.largest_angle_rad =
                std::max(check.largest_angle_rad, std::abs(std::remainder(apart_rad, 2 * M_PI)));
        }
    return Done{};
}

Status compareTable(const std::string& path, bool is_angles, const ExpectedMotion& expected,
                    ExportCheck& check) {
    MotionClip clip;
    clip.name = path;
    clip.skeleton = expected.skeleton;
    clip.frame_time_s = expected.frame_time_s;
    clip.frames = expected.frames;
    const auto wanted = is_angles ? openSimAngles(clip) : openSimOrientations(clip);
    const auto text = readWholeFile(path);
    const auto file = text ? parseOpenSimTable(*text, path) : Result<OpenSimTable>(text.error());
    if (!wanted || !file)
        return !wanted ? wanted.error() : file.error();
    if (file->columns != wanted->columns || file->width != wanted->width)
        return Error{ErrorKind::kUnreadable, path + ": its columns are not those of the take's body",
                     "Export the take again"};
    check.frames = file->rows();
    check.frames_per_second = file->rows() > 1 ? 1 / file->values[file->width] : 1 / expected.frame_time_s;
    if (std::abs(check.frames_per_second * expected.frame_time_s - 1) < 1e-6)
        check.frames_per_second = 1 / expected.frame_time_s;  // time stands there in nanoseconds
    check.joints = check.expected_joints;
    check.has_angles = true;
    for (size_t v = 0; v < std::min(file->values.size(), wanted->values.size()); ++v)
        if (staysTheSame(*file, v % file->width, is_angles, expected.root))
            addDifference(*file, v % file->width, is_angles, file->values[v] - wanted->values[v], check);
    return Done{};
}

}  // namespace noctule
