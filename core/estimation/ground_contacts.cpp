// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/ground_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/body/joint_names.h"

namespace noctule {
namespace {

constexpr double kLeastLeg_m = 0.2;     // from the root down to what may be a foot
constexpr double kSameHeight_m = 0.15;  // of points that both count as lowest
constexpr double kShortestFlight_s = 0.05;
constexpr double kHeelPerBall = -0.3;  // behind the ankle, as a share of the ball's way before it
constexpr double kFlat_m = 0.02;  // by which heel or ball are lifted from a foot that still counts as flat
constexpr std::array kGroundNames{"level", "uneven", "treadmill", "none"};  // in the order of Ground

/// In the joint's frame.
Vector3d contactPoint(const Skeleton& actor, int joint) {
    for (int j = joint + 1; j < actor.size(); ++j)
        if (actor.joint(j).parent == joint)
            return actor.joint(j).offset_m;
    return actor.joint(joint).end_m.value_or(Vector3d::Zero());
}

/// Where a point on a link is; the chain then holds its motion.
Vector3d pointOn(ChainMotion& chain, const KinematicTree& tree, const MotionState& motion, int link,
                 const Vector3d& p_link_m) {
    chain.evaluate(tree, motion, link, 0);
    return chain.point(p_link_m).p_m;
}

/// The boards by which the feet are known.
std::vector<int> footBoards(const Skeleton& actor, const KinematicTree& tree, const SuitModel& suit,
                            const MotionState& rest) {
    std::vector<int> found, below;
    std::vector<double> height_m(suit.boards.size());
    ChainMotion chain;
    double lowest_m = rest.p_world_root.y() - kLeastLeg_m;
    for (size_t b = 0; b < suit.boards.size(); ++b) {
        const int link = suit.boards[b].link;
        if (link < 0)
            continue;
        const int joint = tree.link(link).joint;
        if (joint == findByAnyName(actor, "LeftFoot") || joint == findByAnyName(actor, "RightFoot"))
            found.push_back(static_cast<int>(b));
        height_m[b] = pointOn(chain, tree, rest, link, contactPoint(actor, joint)).y();
        if (height_m[b] <= rest.p_world_root.y() - kLeastLeg_m)
            below.push_back(static_cast<int>(b));
        lowest_m = std::min(lowest_m, height_m[b]);
    }
    if (!found.empty())
        return found;
    std::erase_if(below, [&](int b) { return height_m[static_cast<size_t>(b)] > lowest_m + kSameHeight_m; });
    return below;
}

/// The sole between heel and ball: where the foot, as it is tilted, stands. A flat foot stands on the middle.
ChainMotion::Point lowestPoint(const ChainMotion& chain, const Vector3d& p_link_ball_m) {
    const Vector3d p_link_heel_m(p_link_ball_m.x(), p_link_ball_m.y(), kHeelPerBall * p_link_ball_m.z());
    const double ball_up_m = (chain.end().R_world_link * (p_link_ball_m - p_link_heel_m)).y();
    const double on_heel = std::clamp(0.5 + 0.5 * ball_up_m / kFlat_m, 0.0, 1.0);
    return chain.point(p_link_ball_m + on_heel * (p_link_heel_m - p_link_ball_m));
}

/// What is given of this joint, under whatever name.
std::vector<FootContact> givenOf(const Skeleton& actor, int joint, const GroundParameters& parameters) {
    std::vector<FootContact> contacts;
    if (parameters.given)
        for (const FootContacts& feet : *parameters.given)
            if (findByAnyName(actor, feet.foot) == joint)
                contacts.insert(contacts.end(), feet.contacts.begin(), feet.contacts.end());
    return contacts;
}

/// How a point's velocity (rows 0 to 2) and height (row 3) follow all coordinates but the root's
/// translations and heading, with which the root's velocity turns as well.
ObservationBlock byTheBody(const ChainMotion& chain, const ChainMotion::Point& point,
                           const Vector3d& root_v_m_per_s, const StateLayout& layout) {
    ObservationBlock block;
    block.H = Eigen::MatrixXd::Zero(4, 2 * std::ssize(chain.coordinates()));
    const Vector3d by_heading = Vector3d::UnitY().cross(point.v_m_per_s - root_v_m_per_s);
    for (const auto& c : chain.coordinates()) {
        if (c.translation)
            continue;
        const auto d = chain.pointDerivative(c, point);
        const Eigen::Index column = std::ssize(block.columns);
        block.H.col(column) << d.v_theta, d.p_theta.y();
        if (c.frame == 0)
            block.H.col(column).head<3>() -= c.axis.y() * by_heading;
        block.H.col(column + 1).head<3>() = d.v_rate;
        block.columns.insert(block.columns.end(), {layout.theta(c.index), layout.rate(c.index)});
    }
    block.H.conservativeResize(4, std::ssize(block.columns));
    block.residual = block.variance = Eigen::Vector4d::Zero();
    return block;
}

/// By how much an error that lasts weighs more than one that is drawn anew with every update (first-order
/// autoregression, as in ExcessNoise).
double whitening(double lasts_s, double interval_s) {
    const double r = lasts_s > 0 ? std::exp(-interval_s / lasts_s) : 0;
    return (1 + r) / (1 - r);
}

/// The root's translation alone is observed: where a foot that rolls or slips is believed to stand, it must
/// not bend the body, which other sensors know far better. What is not known of the body is noise here.
ObservationBlock ofRoot(const std::vector<int>& columns, const Eigen::VectorXd& residual, double sigma,
                        const Eigen::VectorXd& body_variance) {
    const Eigen::Index rows = residual.size();
    return {columns, Eigen::MatrixXd::Identity(rows, rows), residual, body_variance.array() + sigma * sigma};
}

/// Too fast for a foot that stands, unless an operator says that it does. On a belt that moves a foot that
/// stands moves, too.
bool isSwung(const GroundParameters& parameters, const Vector3d& v_m_per_s, const Eigen::VectorXd& variance) {
    return !parameters.given && parameters.ground != Ground::kTreadmill &&
           v_m_per_s.norm() > parameters.fastest_m_per_s + parameters.swing_sigma * std::sqrt(variance.sum());
}

}  // namespace

const char* groundName(Ground ground) {
    return kGroundNames[static_cast<size_t>(ground)];
}

std::optional<Ground> groundFromName(const std::string& name) {
    const auto found = std::find(kGroundNames.begin(), kGroundNames.end(), name);
    return found == kGroundNames.end() ? std::nullopt
                                       : std::optional(static_cast<Ground>(found - kGroundNames.begin()));
}

void ContactLog::note(const std::string& foot, double from_s, double to_s) {
    auto found = std::ranges::find(feet_, foot, &FootContacts::foot);
    if (found == feet_.end())
        found = feet_.insert(found, {foot, {}});
    std::vector<FootContact>& contacts = found->contacts;
    if (contacts.empty() || from_s > contacts.back().to_s + kShortestFlight_s)
        contacts.push_back({from_s, to_s, 0});
    contacts.back().to_s = to_s;
}

GroundContacts::GroundContacts(const Skeleton& actor, const KinematicTree& tree, const SuitModel& suit,
                               const MotionState& rest, const GroundParameters& parameters)
    : parameters_(parameters) {
    if (parameters.ground == Ground::kNone)
        return;
    ChainMotion chain;
    for (const int b : footBoards(actor, tree, suit, rest)) {
        const MountedBoard& board = suit.boards[static_cast<size_t>(b)];
        const int joint = tree.link(board.link).joint;
        const Vector3d p_link_contact_m = contactPoint(actor, joint);
        const Vector3d p_board_contact_m =
            board.R_link_board.transpose() * (p_link_contact_m - board.p_link_board);
        const double floor_m = pointOn(chain, tree, rest, board.link, p_link_contact_m).y();
        feet_.push_back({actor.joint(joint).name, givenOf(actor, joint, parameters), b, board.link,
                         p_link_contact_m, StanceDetector(parameters.stance, p_board_contact_m), floor_m});
    }
}

void GroundContacts::rest(double begin_s, double end_s, ContactLog& log) {
    for (Foot& foot : feet_) {
        if (!parameters_.given) {
            foot.detector.standsFrom(begin_s, end_s);
            log.note(foot.name, begin_s, end_s);
            continue;
        }
        for (const FootContact& contact : foot.given)
            if (contact.from_s < end_s && contact.to_s > begin_s)
                log.note(foot.name, contact.from_s, std::min(contact.to_s, end_s));
    }
}

void GroundContacts::listen(const std::vector<InertialMeasurement>& measurements, const BodyState& state) {
    if (parameters_.given)
        return;
    for (const InertialMeasurement& measurement : measurements)
        for (Foot& foot : feet_)
            if (foot.board == measurement.board)
                foot.detector.add(measurement, state.gyro_bias[static_cast<size_t>(foot.board)]);
}

std::optional<double> GroundContacts::standsSince_s(const Foot& foot, double now_s) const {
    if (!parameters_.given)
        return foot.detector.standsSince_s(now_s);
    for (const FootContact& contact : foot.given)
        if (contact.from_s <= now_s && now_s <= contact.to_s)
            return contact.from_s;
    return std::nullopt;
}

std::vector<ObservationBlock> GroundContacts::observe(const KinematicTree& tree, const StateLayout& layout,
                                                      const BodyState& state, Covariance& P, double now_s,
                                                      ContactLog& log) {
    std::vector<ObservationBlock> blocks;
    ChainMotion chain;
    for (Foot& foot : feet_) {
        const auto since_s = standsSince_s(foot, now_s);
        if (!since_s)
            continue;
        const bool is_due = now_s - foot.observed_s >= parameters_.interval_s;
        if (!is_due && !foot.swings)
            log.note(foot.name, std::max(*since_s, foot.swung_s), now_s);
        if (!is_due)
            continue;
        foot.observed_s = now_s;
        chain.evaluate(tree, state.motion, foot.link, 0);
        const ChainMotion::Point point = lowestPoint(chain, foot.p_link_contact_m);
        const Vector3d root_v_m_per_s = state.motion.rate.head<3>();
        const Eigen::VectorXd body_variance =
            P.innovationVariance(byTheBody(chain, point, root_v_m_per_s, layout));
        const double sigma = std::hypot(parameters_.velocity_m_per_s,
                                        parameters_.pivot_m * chain.end().omega_rad_per_s.norm());
        ObservationBlock still = velocityOfRoot(layout, state.motion, -point.v_m_per_s,
                                                body_variance.head<3>().array() + sigma * sigma);
        const Eigen::VectorXd variance = P.innovationVariance(still);
        foot.swings = isSwung(parameters_, point.v_m_per_s, variance);
        if (foot.swings) {
            foot.swung_s = now_s;
            continue;
        }
        log.note(foot.name, std::max(*since_s, foot.swung_s), now_s);
        if (!parameters_.holds_feet || parameters_.ground == Ground::kTreadmill)
            continue;
        limitPull(still, variance, parameters_.huber_sigma);
        still.variance *= whitening(parameters_.slip_lasts_s, parameters_.interval_s);
        blocks.push_back(std::move(still));
        if (parameters_.ground != Ground::kLevel)
            continue;
        if (auto floor = onFloor(foot, point.p_m.y(), body_variance[3], layout.theta(1), P))
            blocks.push_back(std::move(*floor));
    }
    return blocks;
}

/// `height_m` of the point of contact, `column` of the root's height; nothing where the foot stands on
/// something else, or where that height is known better than floors are level.
std::optional<ObservationBlock> GroundContacts::onFloor(const Foot& foot, double height_m,
                                                        double body_variance_m2, int column,
                                                        Covariance& P) const {
    if (P.dense()(column, column) < parameters_.level_m * parameters_.level_m)
        return std::nullopt;
    P.dense()(column, column) += parameters_.sole_m * parameters_.sole_m;
    ObservationBlock floor = ofRoot({column}, Eigen::VectorXd::Constant(1, foot.floor_m - height_m),
                                    parameters_.height_m, Eigen::VectorXd::Constant(1, body_variance_m2));
    const Eigen::VectorXd variance = P.innovationVariance(floor);
    const double known_m = std::sqrt(std::max(0.0, variance[0] - floor.variance[0] + body_variance_m2));
    if (std::abs(floor.residual[0]) > parameters_.height_gate_m + parameters_.height_gate_sigma * known_m)
        return std::nullopt;
    limitPull(floor, variance, parameters_.huber_sigma);
    return floor;
}

}  // namespace noctule
