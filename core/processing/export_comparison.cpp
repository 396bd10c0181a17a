// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_comparison.h"

#include <algorithm>
#include <cmath>

#include "core/formats/bvh.h"
#include "core/formats/positions_csv.h"
#include "core/formats/rigged_figure.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kLevel = 0.1;  ///< a direction's horizontal part below which its heading means nothing

/// Joints of the take's skeleton as the file numbers them, -1: not there.
std::vector<int> jointsInFile(const Skeleton& skeleton, const std::vector<std::string>& names) {
    std::vector<int> indices;
    for (const Joint& joint : skeleton.joints()) {
        const auto found = std::find(names.begin(), names.end(), joint.name);
        indices.push_back(found == names.end() ? -1 : static_cast<int>(found - names.begin()));
    }
    return indices;
}

/// Heading of somebody whose hips these are: the left leg is on the left. Nothing without both legs.
std::optional<double> facing(const std::vector<Vector3d>& p_world, int left_leg, int right_leg) {
    if (left_leg < 0 || right_leg < 0)
        return std::nullopt;
    const Vector3d left = p_world[static_cast<size_t>(left_leg)] - p_world[static_cast<size_t>(right_leg)];
    const Vector3d forward = left.cross(Vector3d::UnitY());
    return std::atan2(forward.x(), forward.z());
}

double headingError_rad(const Quaterniond& q_world_root) {
    const Vector3d forward = q_world_root * Vector3d::UnitZ();
    return std::hypot(forward.x(), forward.z()) > kLevel ? std::abs(std::atan2(forward.x(), forward.z())) : 0;
}

/// Of a skeleton's zero pose: joints, and the tips that `with_tips` knows.
double zeroPoseHeight(const Skeleton& skeleton, const Skeleton& with_tips) {
    const GlobalPose zero = globalPose(skeleton, skeleton.zeroPose());
    Eigen::AlignedBox3d box;
    for (int j = 0; j < skeleton.size(); ++j) {
        const Vector3d& p = zero.p_world_joint[static_cast<size_t>(j)];
        box.extend(p);
        const int known = with_tips.find(skeleton.joint(j).name);
        if (skeleton.joint(j).end_m && known >= 0 && with_tips.joint(known).end_m)
            box.extend(Vector3d(p + *skeleton.joint(j).end_m));
    }
    return box.sizes().y();
}

double lowestPoint(const MotionClip& clip, size_t frame) {
    const GlobalPose global = globalPose(clip, frame);
    double lowest = INFINITY;
    for (size_t j = 0; j < global.p_world_joint.size(); ++j) {
        lowest = std::min(lowest, global.p_world_joint[j].y());
        if (const auto& end_m = clip.skeleton.joints()[j].end_m)
            lowest = std::min(lowest, (global.p_world_joint[j] + global.q_world_joint[j] * *end_m).y());
    }
    return lowest;
}

/// Where the root should be, as far as the way it is held determines that.
Vector3d expectedRoot(const ExpectedMotion& expected, size_t frame) {
    Vector3d root = expected.frames[frame].p_world_root;
    if (expected.root != RootMotion::kMoving) {
        root.x() = expected.frames.front().p_world_root.x();
        root.z() = expected.frames.front().p_world_root.z();
    }
    return root;
}

/// `lowest_m`: of each frame.
void noteLowest(std::vector<double> lowest_m, ExportCheck& check) {
    check.lowest_m = check.usual_lowest_m = INFINITY;
    if (lowest_m.empty())
        return;
    const auto middle = lowest_m.begin() + static_cast<std::ptrdiff_t>(lowest_m.size() / 2);
    std::nth_element(lowest_m.begin(), middle, lowest_m.end());
    check.usual_lowest_m = *middle;
    check.lowest_m = *std::min_element(lowest_m.begin(), lowest_m.end());
}

class ClipComparison {
public:
    ClipComparison(const MotionClip& file, const ExpectedMotion& expected, ExportCheck& check)
        : file_(file), expected_(expected), check_(check) {
        std::vector<std::string> names;
        for (const Joint& joint : file.skeleton.joints())
            names.push_back(joint.name);
        joints_ = jointsInFile(expected.skeleton, names);
    }

    void run() {
        check_.frames = file_.frames.size();
        check_.frames_per_second =  // a scene file with one frame does not tell
            1 / (check_.frames > 1 ? file_.frame_time_s : expected_.frame_time_s);
        check_.joints =
            static_cast<int>(std::count_if(joints_.begin(), joints_.end(), [](int j) { return j >= 0; }));
        check_.height_m = zeroPoseHeight(file_.skeleton, expected_.skeleton);
        check_.expected_height_m = zeroPoseHeight(expected_.skeleton, file_.skeleton);
        check_.facing_rad = zeroPoseFacing(file_.skeleton);
        check_.expected_facing_rad = zeroPoseFacing(expected_.skeleton);
        check_.has_angles = check_.has_figure = true;
        std::vector<double> lowest_m;
        for (size_t f = 0; f < file_.frames.size(); ++f)
            lowest_m.push_back(lowestPoint(file_, f));
        noteLowest(std::move(lowest_m), check_);
        for (size_t f = 0; f < std::min(file_.frames.size(), expected_.frames.size()); ++f) {
            compareRoot(f);
            compareJoints(f);
        }
    }

private:
    static double zeroPoseFacing(const Skeleton& skeleton) {
        return facing(globalPose(skeleton, skeleton.zeroPose()).p_world_joint, skeleton.find("LeftUpLeg"),
                      skeleton.find("RightUpLeg"))
            .value_or(0);
    }

    void compareRoot(size_t f) {
        const Quaterniond& q_file = file_.frames[f].q_parent_joint[0];
        const Quaterniond& q_take = expected_.frames[f].q_parent_joint[0];
        if (expected_.root == RootMotion::kHeading) {
            const Vector3d up_file = q_file.conjugate() * Vector3d::UnitY();
            const Vector3d up_take = q_take.conjugate() * Vector3d::UnitY();
            add(std::max(std::atan2(up_file.cross(up_take).norm(), up_file.dot(up_take)),
                         headingError_rad(q_file)));
        } else {
            add(angleBetween(q_file, q_take));
        }
        addDistance(file_.frames[f].p_world_root - expectedRoot(expected_, f));
    }

    /// Local rotations, and positions within the root's frame: those show offsets that differ.
    void compareJoints(size_t f) {
        for (size_t j = 1; j < joints_.size(); ++j)
            if (joints_[j] >= 0)
                add(angleBetween(file_.frames[f].q_parent_joint[static_cast<size_t>(joints_[j])],
                                 expected_.frames[f].q_parent_joint[j]));
        const GlobalPose in_file = globalPose(file_, f);
        const GlobalPose in_take = globalPose(expected_.skeleton, expected_.frames[f]);
        const auto inRoot = [](const GlobalPose& pose, size_t j) -> Vector3d {
            return pose.q_world_joint[0].conjugate() * (pose.p_world_joint[j] - pose.p_world_joint[0]);
        };
        for (size_t j = 1; j < joints_.size(); ++j)
            if (joints_[j] >= 0)
                addDistance(inRoot(in_file, static_cast<size_t>(joints_[j])) - inRoot(in_take, j));
    }

    void add(double angle_rad) { check_.largest_angle_rad = std::max(check_.largest_angle_rad, angle_rad); }
    void addDistance(const Vector3d& apart_m) {
        check_.largest_position_m = std::max(check_.largest_position_m, apart_m.norm());
    }

    const MotionClip& file_;
    const ExpectedMotion& expected_;
    ExportCheck& check_;
    std::vector<int> joints_;
};

class CsvComparison {
public:
    CsvComparison(const PositionTable& file, const ExpectedMotion& expected, ExportCheck& check)
        : file_(file),
          expected_(expected),
          check_(check),
          joints_(jointsInFile(expected.skeleton, file.joints)) {}

    void run() {
        check_.frames = file_.time_s.size();
        check_.frames_per_second = check_.frames > 1 ? static_cast<double>(check_.frames - 1) /
                                                           (file_.time_s.back() - file_.time_s.front())
                                                     : 1 / expected_.frame_time_s;
        check_.joints =
            static_cast<int>(std::count_if(joints_.begin(), joints_.end(), [](int j) { return j >= 0; }));
        check_.has_figure = true;
        std::vector<double> lowest_m;
        for (size_t f = 0; f < check_.frames; ++f) {
            lowest_m.push_back(INFINITY);
            for (size_t j = 0; j < file_.joints.size(); ++j)
                lowest_m.back() = std::min(lowest_m.back(), file_.at(f, j).y());
        }
        noteLowest(std::move(lowest_m), check_);
        for (size_t f = 0; f < std::min(check_.frames, expected_.frames.size()); ++f)
            compareFrame(f);
    }

private:
    std::vector<Vector3d> inFile(size_t f) const {
        std::vector<Vector3d> p_m;
        for (const int j : joints_)
            p_m.push_back(j < 0 ? Vector3d::Constant(NAN) : file_.at(f, static_cast<size_t>(j)));
        return p_m;
    }

    /// The take's joints as they should stand. With the heading taken out the file may show them turned about
    /// the vertical: they are turned onto it, and what is left of the heading counts as an angle.
    std::vector<Vector3d> inTake(size_t f, const std::vector<Vector3d>& in_file) {
        std::vector<Vector3d> p_m = globalPose(expected_.skeleton, expected_.frames[f]).p_world_joint;
        const Vector3d root = expectedRoot(expected_, f), moved = root - p_m[0];
        for (Vector3d& p : p_m)
            p += moved;
        if (expected_.root != RootMotion::kHeading)
            return p_m;
        const Quaterniond turn = turnOnto(p_m, in_file);
        for (Vector3d& p : p_m)
            p = root + turn * (p - root);
        check_.largest_angle_rad = std::max(check_.largest_angle_rad,
                                            headingError_rad(turn * expected_.frames[f].q_parent_joint[0]));
        return p_m;
    }

    /// The turn about the vertical that fits best, in the sense of least squares.
    static Quaterniond turnOnto(const std::vector<Vector3d>& from, const std::vector<Vector3d>& onto) {
        double sine = 0, cosine = 0;
        for (size_t j = 1; j < from.size(); ++j) {
            const Vector3d a = from[j] - from[0], b = onto[j] - onto[0];
            if (!b.allFinite())
                continue;
            sine += a.z() * b.x() - a.x() * b.z();
            cosine += a.x() * b.x() + a.z() * b.z();
        }
        return axisAngle(Vector3d::UnitY(), std::atan2(sine, cosine));
    }

    void compareFrame(size_t f) {
        const std::vector<Vector3d> in_file = inFile(f), in_take = inTake(f, in_file);
        for (size_t j = 0; j < in_take.size(); ++j)
            if (joints_[j] >= 0)
                check_.largest_position_m =
                    std::max(check_.largest_position_m, (in_file[j] - in_take[j]).norm());
        if (f == 0)
            describeFirst(in_file, in_take);
    }

    void describeFirst(const std::vector<Vector3d>& in_file, const std::vector<Vector3d>& in_take) {
        const auto height = [&](const std::vector<Vector3d>& p_m) {
            double low = INFINITY, high = -INFINITY;
            for (size_t j = 0; j < p_m.size(); ++j)
                if (joints_[j] >= 0) {
                    low = std::min(low, p_m[j].y());
                    high = std::max(high, p_m[j].y());
                }
            return high - low;
        };
        const int left = expected_.skeleton.find("LeftUpLeg"), right = expected_.skeleton.find("RightUpLeg");
        check_.height_m = height(in_file);
        check_.expected_height_m = height(in_take);
        check_.facing_rad = facing(in_file, left, right).value_or(0);
        check_.expected_facing_rad = facing(in_take, left, right).value_or(0);
    }

    const PositionTable& file_;
    const ExpectedMotion& expected_;
    ExportCheck& check_;
    std::vector<int> joints_;
};

}  // namespace

Status compareBvh(const std::string& path, double metres_per_unit, const ExpectedMotion& expected,
                  ExportCheck& check) {
    const auto document = readBvh(path);
    if (!document)
        return document.error();
    for (const BvhUnit unit : {BvhUnit::kMetre, BvhUnit::kCentimetre, BvhUnit::kMillimetre, BvhUnit::kInch}) {
        if (metresPer(unit) != metres_per_unit)
            continue;
        const auto clip = toClip(*document, unit);
        if (!clip)
            return clip.error();
        ClipComparison(*clip, expected, check).run();
        return Done{};
    }
    return Error{ErrorKind::kUsage, path + ": the unit of its lengths is not one that can be checked",
                 "Write metres, centimetres, millimetres or inches"};
}

namespace {

/// Scene files end with the last joint; where its segment ends is taken from the take.
Skeleton withTips(const Skeleton& skeleton, const Skeleton& with_tips) {
    std::vector<Joint> joints = skeleton.joints();
    for (size_t j = 0; j < joints.size(); ++j)
        joints[j].end_m = with_tips.joints()[j].end_m;
    return Skeleton::make(std::move(joints)).value();
}

/// Ours where a bone is one of our joints, so that left and right are known; else a number.
MotionClip underOurNames(MotionClip clip, const std::map<std::string, int>& joint_of_ours) {
    std::vector<Joint> joints = clip.skeleton.joints();
    for (size_t j = 0; j < joints.size(); ++j)
        joints[j].name = "bone " + std::to_string(j);
    for (const auto& [name, joint] : joint_of_ours)
        joints[static_cast<size_t>(joint)].name = name;
    clip.skeleton = Skeleton::make(std::move(joints)).value();
    return clip;
}

/// As the skin says that its bones were bound.
std::vector<Quaterniond> boundTurns(const SceneMotion& file) {
    std::vector<Quaterniond> q_world_rest;
    for (const Eigen::Matrix4d& bind_inverse : file.bind_inverse)
        q_world_rest.push_back(
            Quaterniond(Matrix3d(bind_inverse.topLeftCorner<3, 3>().transpose())).normalized());
    return q_world_rest;
}

}  // namespace

Status compareRiggedFile(const SceneFile& scene, const ExpectedMotion& expected, const ExportRequest& request,
                         ExportCheck& check) {
    const WearableBody& body = *request.worn;
    const auto moving = MovingBody::of(request.worn, expected.skeleton, expected.feet_at_rest);
    if (!moving)
        return moving.error();
    MotionClip clip;
    clip.skeleton = expected.skeleton;
    clip.frame_time_s = expected.frame_time_s;
    clip.frames = expected.frames;
    const auto feet = request.lock_feet
                          ? moving->lockedFeet({expected.frames, expected.frame_time_s, expected.plants})
                          : std::vector<FootCorrections>();
    auto figure = riggedFigure(clip, {}, body, request.names, expected.feet_at_rest, feet);
    if (!figure)
        return figure.error();
    if (!request.character.empty())
        figure = asCharacter(std::move(*figure), request.character);
    std::vector<std::string> bones;
    for (const Joint& joint : figure->clip.skeleton.joints())
        bones.push_back(joint.name);
    check.expected_joints = static_cast<int>(bones.size());
    const auto file = scene.read(bones, expected.name);
    if (!file)
        return file.error();
    const auto joint_of_ours = figureJoints(body);
    const MotionClip wanted = underOurNames(
        restParallel(figure->clip, globalPose(figure->clip.skeleton, figure->rest).q_world_joint),
        joint_of_ours);
    const ExpectedMotion rigged{expected.name,
                                wanted.skeleton,
                                expected.root,
                                expected.frame_time_s,
                                expected.begin_s,
                                wanted.frames,
                                {},
                                {}};
    ClipComparison(underOurNames(restParallel(file->clip, boundTurns(*file)), joint_of_ours), rigged, check)
        .run();
    return Done{};
}

Status compareSceneFile(const SceneFile& scene, const ExpectedMotion& expected, ExportCheck& check) {
    std::vector<std::string> names;
    for (const Joint& joint : expected.skeleton.joints())
        names.push_back(joint.name);
    auto file = scene.read(names, expected.name);
    if (!file)
        return file.error();
    file->clip.skeleton = withTips(file->clip.skeleton, expected.skeleton);
    ClipComparison(file->clip, expected, check).run();
    return Done{};
}

Status compareCsv(const std::string& path, bool angles, const ExpectedMotion& expected, ExportCheck& check) {
    const auto table = readPositionsCsv(path);
    if (!table)
        return table.error();
    CsvComparison(*table, expected, check).run();
    return angles ? compareAngles(path, expected, check) : Status(Done{});
}

}  // namespace noctule
