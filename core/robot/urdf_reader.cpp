// SPDX-License-Identifier: Apache-2.0
#include "core/robot/urdf_reader.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <limits>

#include "core/job/atomic_file.h"
#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/robot/urdf_check.h"

namespace noctule::robot {
namespace {

constexpr size_t kMostUrdfBytes = 16 << 20;  ///< Robonaut 2 takes 0.1 MB
constexpr size_t kMostLinks = 2000;
constexpr size_t kMostMeshes = 100;  ///< of a link

/// Keeps what urdfdom would print, while it lives.
class Overheard : public console_bridge::OutputHandler {
public:
    Overheard() { console_bridge::useOutputHandler(this); }
    ~Overheard() override { console_bridge::restorePreviousOutputHandler(); }
    void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
        if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty())
            first_ = shortText(visibleText(text), 300);
    }
    const std::string& first() const { return first_; }

private:
    std::string first_;
};

Eigen::Isometry3d isometry(const urdf::Pose& pose) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() = Vector3d(pose.position.x, pose.position.y, pose.position.z);
    const Quaterniond q(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
    T.linear() = q.normalized().toRotationMatrix();
    return T;
}

std::optional<LinkShape> shapeOf(const urdf::Collision& collision) {
    const Eigen::Isometry3d T = isometry(collision.origin);
    Vector3d half = Vector3d::Zero();
    double radius_m = 0;
    if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(collision.geometry.get())) {
        radius_m = sphere->radius;
    } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(collision.geometry.get())) {
        radius_m = cylinder->radius;
        half.z() = std::max(0.0, cylinder->length / 2 - radius_m);
    } else if (const auto* box = dynamic_cast<const urdf::Box*>(collision.geometry.get())) {
        const Vector3d size(box->dim.x, box->dim.y, box->dim.z);
        Eigen::Index longest = 0;
        const double length_m = size.maxCoeff(&longest);
        radius_m = (size.sum() - length_m) / 4;  // the mean of the two shorter half edges
        half[longest] = std::max(0.0, length_m / 2 - radius_m);
    } else {
        return std::nullopt;
    }
    if (!(radius_m > 0) || radius_m > limits::kLengthOfBody_m || !T.matrix().allFinite())
        return std::nullopt;
    return LinkShape{T * -half, T * half, radius_m};
}

std::optional<JointKind> kindOf(const urdf::Joint& joint) {
    switch (joint.type) {
        case urdf::Joint::FIXED:
            return JointKind::kFixed;
        case urdf::Joint::REVOLUTE:
            return JointKind::kRevolute;
        case urdf::Joint::CONTINUOUS:
            return JointKind::kContinuous;
        case urdf::Joint::PRISMATIC:
            return JointKind::kPrismatic;
        default:
            return std::nullopt;
    }
}

class ModelBuilder {
public:
    ModelBuilder(const urdf::ModelInterface& source, std::string where)
        : source_(source), where_(std::move(where)) {}

    Result<RobotModel> build(std::vector<std::string> notices) {
        model_.name = source_.getName();
        model_.notices = std::move(notices);
        if (source_.links_.size() > kMostLinks)
            return unreadable("has more than 2000 links", "Take a simpler model");
        if (Status added = addLink(*source_.getRoot(), -1); !added)
            return added.error();
        for (RobotJoint& joint : model_.joints)
            if (Status tied = tie(joint); !tied)
                return tied.error();
        return std::move(model_);
    }

private:
    Error unreadable(const std::string& what, const std::string& remedy) const {
        return {ErrorKind::kUnreadable, where_ + ": " + what, remedy};
    }

    /// Depth first without recursion, since chains of links may be long.
    Status addLink(const urdf::Link& root, int parent_joint) {
        std::vector<std::pair<const urdf::Link*, int>> waiting{{&root, parent_joint}};
        while (!waiting.empty()) {
            const auto [link, above] = waiting.back();
            waiting.pop_back();
            const int index = static_cast<int>(model_.links.size());
            model_.links.push_back(linkOf(*link, above));
            if (above >= 0)
                model_.joints[static_cast<size_t>(above)].child_link = index;
            for (const auto& child : link->child_joints) {
                auto joint = jointOf(*child, index);
                if (!joint)
                    return joint.error();
                const int number = static_cast<int>(model_.joints.size());
                model_.joints.push_back(std::move(*joint));
                model_.links.back().child_joints.push_back(number);
                waiting.emplace_back(source_.getLink(child->child_link_name).get(), number);
            }
        }
        return Done{};
    }

    static RobotLink linkOf(const urdf::Link& link, int parent_joint) {
        RobotLink made;
        made.name = link.name;
        made.parent_joint = parent_joint;
        for (const auto& collision : link.collision_array)
            if (collision && collision->geometry)
                if (const auto shape = shapeOf(*collision))
                    made.shapes.push_back(*shape);
        for (const auto& visual : link.visual_array)
            if (const auto* mesh = visual ? dynamic_cast<const urdf::Mesh*>(visual->geometry.get()) : nullptr)
                addMesh(*mesh, isometry(visual->origin), made);
        if (link.inertial && isometry(link.inertial->origin).matrix().allFinite())
            made.centre_m = isometry(link.inertial->origin).translation();
        return made;
    }

    static void addMesh(const urdf::Mesh& mesh, const Eigen::Isometry3d& T_link_mesh, RobotLink& link) {
        const Vector3d scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
        const bool is_sound = scale.allFinite() && T_link_mesh.matrix().allFinite() &&
                              scale.cwiseAbs().minCoeff() > 1e-9 && scale.cwiseAbs().maxCoeff() < 1e6;
        if (is_sound && link.meshes.size() < kMostMeshes)
            link.meshes.push_back({mesh.filename, T_link_mesh, scale});
    }

    Result<RobotJoint> jointOf(const urdf::Joint& joint, int parent_link) {
        const std::string quoted = "joint \"" + visibleText(shortText(joint.name, 100)) + "\"";
        RobotJoint made;
        made.name = joint.name;
        made.parent_link = parent_link;
        const auto kind = kindOf(joint);
        if (!kind)
            return unreadable(quoted + " is floating or planar, or of no known type",
                              "Use fixed, revolute, continuous and prismatic joints");
        made.kind = *kind;
        made.T_parent_joint = isometry(joint.parent_to_joint_origin_transform);
        made.axis = Vector3d(joint.axis.x, joint.axis.y, joint.axis.z);
        const double farthest_m = made.T_parent_joint.translation().norm();
        if (!made.T_parent_joint.matrix().allFinite() || !(farthest_m < limits::kFarthest_m))
            return unreadable("the origin of " + quoted + " is no place", "Correct its origin");
        if (made.moves() && !(made.axis.allFinite() && made.axis.norm() > 1e-6))
            return unreadable("the axis of " + quoted + " has no direction", "Give it an axis such as 0 0 1");
        if (made.moves())
            made.axis.normalize();
        setLimits(joint, made);
        return made;
    }

    void setLimits(const urdf::Joint& joint, RobotJoint& made) {
        if (!made.moves())
            return;
        constexpr double kEndless = std::numeric_limits<double>::infinity();
        const bool turns_on = made.kind == JointKind::kContinuous;
        made.lower = turns_on ? -kEndless : joint.limits->lower;
        made.upper = turns_on ? kEndless : joint.limits->upper;
        made.max_speed = joint.limits->velocity;
        if (made.max_speed > kHighestSpeed_rad_per_s)
            model_.notices.push_back("the velocity limit of joint \"" + visibleText(joint.name) +
                                     "\" is beyond 100 rad/s and says nothing; the profile's limit holds");
    }

    Status tie(RobotJoint& joint) {
        const auto source = source_.getJoint(joint.name);
        if (!source->mimic)
            return Done{};
        const Mimic mimic{model_.findJoint(source->mimic->joint_name), source->mimic->multiplier,
                          source->mimic->offset};
        if (mimic.joint < 0 || !std::isfinite(mimic.factor) || !std::isfinite(mimic.offset))
            return unreadable("joint \"" + visibleText(joint.name) + "\" mimics no joint that is there",
                              "Correct its mimic element");
        const RobotJoint& leader = model_.joints[static_cast<size_t>(mimic.joint)];
        if (&leader == &joint || source_.getJoint(leader.name)->mimic)
            return unreadable("joint \"" + visibleText(joint.name) + "\" mimics a joint that mimics too",
                              "Let it mimic the joint that leads");
        joint.mimic = mimic;
        return Done{};
    }

    const urdf::ModelInterface& source_;
    std::string where_;
    RobotModel model_;
};

}  // namespace

Result<RobotModel> parseUrdf(std::string_view text, const std::string& where) {
    std::vector<std::string> notices;
    const auto checked = checkedUrdf(text, where, notices);
    if (!checked)
        return checked.error();
    Overheard overheard;
    const urdf::ModelInterfaceSharedPtr source = urdf::parseURDF(*checked);
    if (!source || !source->getRoot())
        return Error{
            ErrorKind::kUnreadable,
            where + ": is no usable URDF" + (overheard.first().empty() ? "" : " (" + overheard.first() + ")"),
            "Correct the file; `check_urdf` of ROS names its mistakes"};
    return ModelBuilder(*source, where).build(std::move(notices));
}

Result<RobotModel> readUrdf(const std::string& path, const CancelFlag* cancel) {
    const auto text = readWholeFile(path, {kMostUrdfBytes, kMostUrdfBytes, cancel});
    if (!text)
        return text.error();
    return parseUrdf(*text, path);
}

}  // namespace noctule::robot
