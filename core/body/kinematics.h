// SPDX-License-Identifier: Apache-2.0
// Forward kinematics of an articulated body with analytic Jacobians (Vlasic 2007, section 5.2): position,
// velocity and acceleration of any point, orientation and angular velocity of any segment.
//
// A KinematicTree unfolds a skeleton into links with one simple motion each: free (3 translations along the
// world's axes, then 3 rotations), ball (3 rotations), hinge (1) or fixed; a universal joint is two hinges.
// Rotational coordinates perturb on the right, R = R_hat exp(delta), rates are in the link's own frame.
// `Jacobians` are taken with respect to these coordinates ("velocity indices"), their rates and
// accelerations.
#pragma once

#include <vector>

#include "core/body/skeleton.h"

namespace noctule {

enum class LinkType { kFree, kBall, kHinge, kFixed };

struct Link {
    int parent = -1;
    int joint = 0;  ///< joint of the skeleton it belongs to
    LinkType type = LinkType::kFixed;
    Vector3d offset_m = Vector3d::Zero();
    Vector3d axis = Vector3d::UnitX();     ///< hinge only, in the link's frame
    int first = 0;                         ///< its first velocity index
    int count = 0;                         ///< free 6, ball 3, hinge 1, fixed 0
    double min_rad = -1e9, max_rad = 1e9;  ///< hinge only
};

/// How ball joints and the free root's rotation are described.
enum class BallCoordinates {
    kManifold,  ///< one rotation, no singularity
    kEuler,     ///< three hinges, as in the paper; the bone's own axis (twist) comes last
};

/// Coordinates of a moving body with rates and accelerations, all in SI.
struct MotionState {
    Vector3d p_world_root = Vector3d::Zero();
    std::vector<Quaterniond> q_parent_link;  ///< per link
    std::vector<double> angle_rad;           ///< per link; hinges only
    Eigen::VectorXd rate;                    ///< per velocity index
    Eigen::VectorXd accel;                   ///< per velocity index
};

class KinematicTree {
public:
    KinematicTree() = default;
    KinematicTree(const Skeleton& skeleton, BallCoordinates balls);

    const std::vector<Link>& links() const { return links_; }
    const Link& link(int index) const { return links_[static_cast<size_t>(index)]; }
    /// Number of velocity indices.
    int freedoms() const { return freedoms_; }
    /// The link whose frame is that of the joint (its last one).
    int linkOfJoint(int joint) const { return link_of_joint_[static_cast<size_t>(joint)]; }
    /// The link that carries this one about: itself unless its joint is rigid.
    int movingLink(int link) const;
    /// A joint's turn from its zero pose, and its angular velocity in its own frame.
    struct JointTurn {
        Matrix3d R_parent_joint = Matrix3d::Identity();
        Vector3d omega_rad_per_s = Vector3d::Zero();
    };
    JointTurn jointTurn(const MotionState& state, int joint) const;
    /// Links from the root to `link`, both included.
    const std::vector<int>& chain(int link) const { return chains_[static_cast<size_t>(link)]; }

    /// Coordinates at rest in a pose; rotations that a joint cannot make are projected onto its freedoms.
    MotionState stateFromPose(const Pose& pose) const;
    Pose poseFromState(const MotionState& state) const;
    /// Adds a perturbation of the coordinates (length freedoms()).
    void retract(MotionState& state, const Eigen::VectorXd& delta) const;
    /// The same for one link; `delta` points at its first coordinate.
    void retractLink(MotionState& state, int link, const double* delta) const;

private:
    void addHinge(int parent, int joint, const Vector3d& offset_m, const Vector3d& axis);

    Skeleton skeleton_;
    BallCoordinates balls_ = BallCoordinates::kManifold;
    std::vector<Link> links_;
    std::vector<int> link_of_joint_;
    std::vector<std::vector<int>> chains_;
    int freedoms_ = 0;
};

/// The chain from the root to one link at one time, `offset_s` later (or earlier) than the state with
/// accelerations held: the one evaluation behind every quantity and Jacobian of points on that link.
class ChainMotion {
public:
    /// `link` as in KinematicTree; keeps references to nothing.
    void evaluate(const KinematicTree& tree, const MotionState& state, int link, double offset_s);

    /// Motion of one link's frame in world coordinates.
    struct Frame {
        Matrix3d R_world_link;
        Vector3d p_m, v_m_per_s, a_m_per_s2;  ///< of its origin (the pivot)
        Vector3d omega_rad_per_s, alpha_rad_per_s2;
    };
    const Frame& end() const { return frames_.back(); }
    /// Of the links from the root to the end.
    const std::vector<Frame>& frames() const { return frames_; }

    struct Point {
        Vector3d p_m, v_m_per_s, a_m_per_s2;
    };
    Point point(const Vector3d& p_link_point_m) const;

    /// One coordinate that moves the end link.
    struct Coordinate {
        int index;         ///< velocity index
        bool translation;  ///< of the root
        Vector3d axis;     ///< world direction
        int frame;         ///< position of its link in the chain
    };
    const std::vector<Coordinate>& coordinates() const { return coordinates_; }

    /// Derivatives at the evaluated time with respect to one coordinate, its rate and its acceleration.
    struct PointDerivative {
        Vector3d p_theta, v_theta, v_rate, a_theta, a_rate, a_accel;
    };
    PointDerivative pointDerivative(const Coordinate& c, const Point& point) const;
    /// d omega / d coordinate; d omega / d rate is the axis itself (zero for a translation).
    Vector3d omegaByTheta(const Coordinate& c) const;
    /// World rotation vector by which the end link turns per unit of the coordinate.
    Vector3d rotationByTheta(const Coordinate& c) const;

    /// Columns of a derivative d/d(coordinate, rate, acceleration) for one link's coordinates.
    struct Columns {
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> theta, rate,
            accel;  ///< rows x freedoms of the chain
    };
    /// Takes derivatives by the coordinates at the evaluated time to those of the state given to evaluate(),
    /// in place: column k belongs to coordinates()[k].
    void transportToState(Columns& columns) const;

private:
    const Vector3d& parentOmega(const Coordinate& c) const;
    const Vector3d& parentAlpha(const Coordinate& c) const;

    std::vector<Frame> frames_;
    std::vector<Coordinate> coordinates_;
    struct Turn {
        int first_column, count;  ///< columns of one link's rotation
        Matrix3d exp_u_transposed, right_jacobian;
    };
    std::vector<Turn> turns_;  ///< ball and free links: how a perturbation is carried over offset_s
    double offset_s_ = 0;
};

}  // namespace noctule
