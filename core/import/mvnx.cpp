// SPDX-License-Identifier: Apache-2.0
// MVNX as a recording: attitudes of the sensors, and MVN's own result as the reference. World: X forward, Y
// left, Z up. Its identity frame is the T pose with all segments' frames parallel to the world.
#include "core/import/mvnx.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/body/text.h"
#include "core/import/formats.h"
#include "core/import/segment_names.h"
#include "core/import/sensor_rows.h"

namespace noctule {

namespace {

bool knowsMvnx(const ImportFile& file) {
    return file.head().find("<mvnx") != std::string_view::npos || file.extension() == ".mvnx";
}

Vector3d vectorAt(const std::vector<double>& numbers, size_t i) {
    return numbers.size() >= 3 * i + 3 ? Vector3d(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2])
                                       : missingVector();
}
Quaterniond rotationAt(const std::vector<double>& numbers, size_t i) {
    return numbers.size() >= 4 * i + 4 ? checkedRotation(Quaterniond(numbers[4 * i], numbers[4 * i + 1],
                                                                     numbers[4 * i + 2], numbers[4 * i + 3]))
                                       : missingRotation();
}

bool anyFrameHas(const MvnxFile& file, std::vector<double> MvnxFrame::*list) {
    return std::ranges::any_of(file.frames, [&](const MvnxFrame& frame) { return !(frame.*list).empty(); });
}
/// Accelerations of sensors can be derived.
bool hasForce(const MvnxFile& file) {
    return anyFrameHas(file, &MvnxFrame::free_acceleration) &&
           anyFrameHas(file, &MvnxFrame::sensor_orientation);
}

/// Segments from the root outwards: place in the file, and place of the parent in this list.
struct OrderedSegment {
    size_t segment;
    int parent;
};

/// MVN's own body, for files that do not say how their segments hang together: segment and the one it hangs
/// on.
constexpr std::pair<const char*, const char*> kMvnBody[] = {
    {"L5", "Pelvis"},
    {"L3", "L5"},
    {"T12", "L3"},
    {"T8", "T12"},
    {"Neck", "T8"},
    {"Head", "Neck"},
    {"RightShoulder", "T8"},
    {"RightUpperArm", "RightShoulder"},
    {"RightForeArm", "RightUpperArm"},
    {"RightHand", "RightForeArm"},
    {"LeftShoulder", "T8"},
    {"LeftUpperArm", "LeftShoulder"},
    {"LeftForeArm", "LeftUpperArm"},
    {"LeftHand", "LeftForeArm"},
    {"RightUpperLeg", "Pelvis"},
    {"RightLowerLeg", "RightUpperLeg"},
    {"RightFoot", "RightLowerLeg"},
    {"RightToe", "RightFoot"},
    {"LeftUpperLeg", "Pelvis"},
    {"LeftLowerLeg", "LeftUpperLeg"},
    {"LeftFoot", "LeftLowerLeg"},
    {"LeftToe", "LeftFoot"},
};

std::vector<OrderedSegment> orderedSegments(const MvnxFile& file) {
    const size_t count = file.segments.size();
    const auto indexOf = [&](const std::string& label) {
        return size_t(std::find(file.segments.begin(), file.segments.end(), label) - file.segments.begin());
    };
    std::vector<size_t> parent(count, count);
    for (const MvnxJoint& joint : file.joints)
        if (const size_t child = indexOf(joint.child); child < count)
            parent[child] = indexOf(joint.parent);
    if (file.joints.empty())
        for (const auto& [below, above] : kMvnBody)
            if (const size_t child = indexOf(below); child < count)
                parent[child] = indexOf(above);
    std::vector<OrderedSegment> order;
    for (size_t s = 0; s < count; ++s)
        if (parent[s] == count)
            order.push_back({s, -1});
    if (order.size() != 1)
        return {};
    for (size_t at = 0; at < order.size() && order.size() <= count; ++at)
        for (size_t s = 0; s < count; ++s)
            if (parent[s] == order[at].segment)
                order.push_back({s, int(at)});
    return order.size() == count ? order : std::vector<OrderedSegment>{};
}

/// The frame that shows the lengths: identity, else any other pose, else the first of the motion.
const MvnxFrame* lengthsOf(const MvnxFile& file) {
    const auto whole = [](const MvnxFrame& frame) {
        return !frame.position.empty() && !frame.orientation.empty();
    };
    for (const MvnxFrame& frame : file.poses)
        if (frame.type == "identity" && whole(frame))
            return &frame;
    for (const auto* frames : {&file.poses, &file.frames})
        for (const MvnxFrame& frame : *frames)
            if (whole(frame))
                return &frame;
    return nullptr;
}

std::optional<Skeleton> skeletonOf(const MvnxFile& file, const std::vector<OrderedSegment>& order,
                                   const Quaterniond& turn) {
    const MvnxFrame* lengths = lengthsOf(file);
    if (!lengths || order.empty())
        return std::nullopt;
    std::vector<Joint> joints;
    for (const OrderedSegment& one : order) {
        Joint joint;
        const std::string& label = file.segments[one.segment];
        joint.name = segmentByName(label).value_or(label);
        if (std::any_of(joints.begin(), joints.end(), [&](const Joint& j) { return j.name == joint.name; }))
            joint.name = label;
        joint.parent = one.parent;
        joint.type = one.parent < 0 ? JointType::kFree : JointType::kBall;
        if (one.parent >= 0) {
            const size_t parent = order[size_t(one.parent)].segment;
            joint.dof = {{"x", Vector3d::UnitX()}, {"y", Vector3d::UnitY()}, {"z", Vector3d::UnitZ()}};
            joint.offset_m =
                turn * (rotationAt(lengths->orientation, parent).conjugate() *
                        (vectorAt(lengths->position, one.segment) - vectorAt(lengths->position, parent)));
        }
        if (!joint.offset_m.allFinite() || joint.offset_m.norm() > 10)
            return std::nullopt;
        joints.push_back(std::move(joint));
    }
    auto skeleton = Skeleton::make(std::move(joints));
    return skeleton ? std::optional(*skeleton) : std::nullopt;
}

/// `p_file_root`: where the root stands in a file without positions.
std::optional<Pose> poseOf(const MvnxFrame& frame, const std::vector<OrderedSegment>& order,
                           const Quaterniond& turn, const std::optional<Vector3d>& p_file_root) {
    Pose pose;
    pose.p_world_root = turn * p_file_root.value_or(vectorAt(frame.position, order[0].segment));
    bool whole = pose.p_world_root.allFinite() && pose.p_world_root.norm() < 1e5;
    for (const OrderedSegment& one : order) {
        Quaterniond q = rotationAt(frame.orientation, one.segment);
        if (one.parent >= 0)
            q = rotationAt(frame.orientation, order[size_t(one.parent)].segment).conjugate() * q;
        pose.q_parent_joint.push_back((turn * q * turn.conjugate()).normalized());
        whole = whole && pose.q_parent_joint.back().coeffs().allFinite();
    }
    return whole ? std::optional(pose) : std::nullopt;
}

void takeMvnxReference(const MvnxFile& file, const RowGrid& grid, const Quaterniond& turn,
                       ImportedRecording& recording) {
    const auto order = orderedSegments(file);
    const auto skeleton = skeletonOf(file, order, turn);
    if (!skeleton) {
        recording.warnings.push_back("The file has no whole body with positions, so it brings no reference");
        return;
    }
    std::optional<Vector3d> p_file_root;
    if (!anyFrameHas(file, &MvnxFrame::position))
        p_file_root = vectorAt(lengthsOf(file)->position, order[0].segment);
    TimedMotion motion;
    motion.skeleton = *skeleton;
    for (size_t row = 0; row < grid.rows; ++row)
        if (grid.from[row] != RowGrid::kNoRow)
            motion.frames.push_back({std::llround(double(row) / grid.rate_hz * 1e9),
                                     poseOf(file.frames[grid.from[row]], order, turn, p_file_root),
                                     {}});
    if (std::ranges::none_of(motion.frames, [](const TimedPose& timed) { return timed.pose.has_value(); })) {
        recording.warnings.push_back(
            "No frame has the orientations of all segments, so the file brings no reference");
        return;
    }
    if (p_file_root)
        recording.warnings.push_back(
            "The file has no positions: its reference tells orientations alone, and its root stays in place");
    recording.reference = std::move(motion);
}

/// Specific force from the free acceleration of the world, which MVN writes without gravity.
Vector3d specificForce(const MvnxFrame& frame, size_t sensor) {
    const Vector3d g(0, 0, kStandardGravity_m_per_s2);
    return rotationAt(frame.sensor_orientation, sensor).conjugate() *
           (vectorAt(frame.free_acceleration, sensor) + g);
}

SensorRows rowsOfSensor(const MvnxFile& file, size_t sensor, const Quaterniond& turn) {
    SensorRows rows;
    const bool has_force = hasForce(file);
    const bool has_field = anyFrameHas(file, &MvnxFrame::magnetic_field);
    for (const MvnxFrame& frame : file.frames) {
        rows.q_world_sensor.push_back(turn * rotationAt(frame.sensor_orientation, sensor));
        if (has_force)
            rows.accel_m_per_s2.push_back(specificForce(frame, sensor));
        if (has_field)
            rows.mag.push_back(vectorAt(frame.magnetic_field, sensor));
    }
    return rows;
}

/// A file without sensors: its segments' attitudes stand for them.
SensorRows rowsOfSegment(const MvnxFile& file, size_t segment, const Quaterniond& turn) {
    SensorRows rows;
    for (const MvnxFrame& frame : file.frames)
        rows.q_world_sensor.push_back(turn * rotationAt(frame.orientation, segment));
    return rows;
}

void takeSensors(const MvnxFile& file, const RowGrid& grid, const Quaterniond& turn,
                 ImportedRecording& recording) {
    const bool has_sensors = anyFrameHas(file, &MvnxFrame::sensor_orientation);
    const auto& names = has_sensors ? file.sensors : file.segments;
    for (size_t i = 0; i < names.size(); ++i)
        recording.sensors.push_back(
            sensorOnGrid(names[i].empty() ? "sensor " + std::to_string(i + 1) : names[i],
                         has_sensors ? rowsOfSensor(file, i, turn) : rowsOfSegment(file, i, turn), grid));
    if (!has_sensors)
        recording.warnings.push_back(
            "The file has no attitudes of sensors; those of its segments stand for them");
    else if (!hasForce(file))
        recording.warnings.push_back(
            "MVNX holds no gyroscope, and this file no sensorFreeAcceleration: its sensors have attitudes "
            "alone");
    else
        recording.warnings.push_back(
            "MVNX holds no gyroscope; accelerations were derived from "
            "sensorFreeAcceleration, gravity and the sensors' attitudes");
    std::string unread;
    for (const std::string& name : file.unread)
        unread += (unread.empty() ? "" : ", ") + name.substr(0, 40);
    if (!unread.empty())
        recording.notes.push_back("Not imported: " + unread.substr(0, 400));
}

/// Frames are placed by their counts; times that go another way are told of. Empty: they agree.
std::string timesApart(const MvnxFile& file, const std::vector<int64_t>& counts, double rate_hz) {
    constexpr double kApart_ms = 100;
    for (size_t i = 1; i < counts.size(); ++i) {
        const MvnxFrame &frame = file.frames[i], &before = file.frames[i - 1];
        const double counted_ms = 1000 * double(counts[i] - counts[i - 1]) / rate_hz;
        const double told_ms = frame.time_ms - before.time_ms;
        if (frame.time_ms >= 0 && before.time_ms >= 0 && std::abs(told_ms - counted_ms) > kApart_ms)
            return "From frame " + std::to_string(counts[i - 1]) + " to " + std::to_string(counts[i]) +
                   " its time goes on by " + text::number(told_ms / 1000, 3) +
                   " s; frames were placed by their numbers, " + text::number(counted_ms / 1000, 3) + " s";
    }
    return {};
}

Result<ImportedRecording> readMvnx(const std::vector<ImportFile>& files, const ImportChoice& choice,
                                   const JobContext& job) {
    const ImportFile& given = files.front();
    const auto file = parseMvnx(given.bytes, given.path, job);
    if (!file)
        return file.error();
    const double rate_hz = choice.rate_hz > 0 ? choice.rate_hz : file->rate_hz;
    if (!(rate_hz >= 1 && rate_hz <= 10'000))
        return Error{ErrorKind::kUnreadable, given.path + ": states no usable frameRate",
                     "Give the rate of the recording (--rate HZ)"};
    if (file->frames.empty())
        return Error{ErrorKind::kUnreadable, given.path + ": holds no frame of a motion",
                     "Export the recording as MVNX again"};
    std::vector<int64_t> counts;
    const bool indexed = std::all_of(file->frames.begin(), file->frames.end(), [](const MvnxFrame& frame) {
        return frame.index >= 0 && frame.index < 1e9;
    });
    for (size_t i = 0; i < file->frames.size(); ++i)
        counts.push_back(indexed ? std::llround(file->frames[i].index) : int64_t(i));
    const auto grid = gridOfCounts(counts, rate_hz, given.path);
    if (!grid)
        return grid.error();
    const WorldFrame world = choice.world.value_or(WorldFrame::kNorthWestUp);
    ImportedRecording recording;
    recording.name = given.stem();
    recording.notes = {"MVNX version " + file->version, "Attitudes take frames to " + worldFrameText(world)};
    takeSensors(*file, *grid, worldFromFile(world), recording);
    takeMvnxReference(*file, *grid, worldFromFile(world), recording);
    for (const std::string& finding : grid->findings(given.path))
        recording.warnings.push_back(finding);
    if (const std::string apart = timesApart(*file, counts, rate_hz); !apart.empty())
        recording.warnings.push_back(given.path + ": " + apart);
    if (file->cut)
        recording.warnings.push_back(given.path + ": ends in the middle; the whole frames before were taken");
    return recording;
}

}  // namespace

const ImportFormat& mvnxFormat() {
    static const ImportFormat format = {"mvnx", "Xsens MVN: attitudes, and MVN's result as reference", false,
                                        knowsMvnx, readMvnx};
    return format;
}

}  // namespace noctule
