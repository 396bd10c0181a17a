// SPDX-License-Identifier: Apache-2.0
// Two bodies and anchors in one small world that moves and errs as the filters believe: is the joint
// covariance honest, and does what nobody sees stay unsure?
#include "core/estimation/joint_filter.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "core/estimation/error_state.h"
#include "tests/core/estimation/small_world.h"
#include "tests/support/nees.h"

namespace noctule {
namespace {

using testing::World;

constexpr double kRest_s = 1;
constexpr int kBodies = 2, kRoom = 2;
constexpr double kSound = 344;
/// Take time of suit time 0; the second one is what the recorder does not know.
const double kOffset_s[] = {0, 16 * testing::kFineStep_s};
constexpr double kGuessError_s = 0.003;

struct Anchor {
    Vector3d surveyed_m, true_m;
};

Vector3d headingFrame(const MotionState& motion) {
    return motion.q_parent_link[0].conjugate() * Vector3d::UnitY();
}

class JointWorld {
public:
    JointWorld(unsigned seed, bool between, bool room, double share = 1)
        : parameters(testing::fittingParameters({true, true, true}, false)),
          random(seed + 1000),
          between_(between),
          room_(room) {
        joint_parameters.share = share;
        joint_parameters.flesh_m = 0;
        for (int i = 0; i < kBodies; ++i)
            worlds.emplace_back(parameters, 2 * seed + static_cast<unsigned>(i));
        if (room_)  // else the world is where the first one stands
            moveTo(worlds[0], {0.3, 0, -0.2}, 0.4);
        moveTo(worlds[1], {1.5, 0, 0.4}, -2.3);
        for (const Vector3d& p : {Vector3d(2, 2.3, 2), {2, 1.9, -2}, {-2, 2.2, -2}, {-2, 2.0, 2}})
            anchors.push_back({p, p + random.vector(joint_parameters.anchor_m)});
    }

    /// Plays the whole take, then filters it; `judge(time)` is called ten times a second.
    template <class Judge>
    void run(double seconds, const Judge& judge) {
        play(seconds);
        std::vector<JointBody> bodies;
        for (const World& world : worlds)
            bodies.push_back({testing::smallSkeleton(), world.suit, parameters, false});
        std::optional<JointFilter::Room> room;
        if (room_)
            room = roomModel();
        joint = std::make_unique<JointFilter>(
            std::move(bodies), std::move(room),
            std::vector<ClockLine>{{kOffset_s[0], 1}, {kOffset_s[1] + kGuessError_s, 1}, {0, 1}},
            std::move(distances_), joint_parameters);
        for (size_t i = 0; i < kBodies; ++i)
            joint->start(i, testing::smallSkeleton().zeroPose(), {0, kRest_s, {}});
        for (const Event& event : events_) {
            if (event.inertial)
                joint->filter(event.body).add(*event.inertial);
            if (event.own)
                joint->filter(event.body).add(*event.own);
            if (!event.truth)
                continue;
            for (size_t i = 0; i < kBodies; ++i)
                joint->promise(i, event.time_s - kOffset_s[i] + testing::kUntilSure_s);
            joint->advance();
            truth_ = *event.truth;
            if (event.time_s > kRest_s + seconds / 3)
                judge(event.time_s);
        }
    }
    /// Of the instant that the filters have reached.
    const MotionState& truth(size_t body) const { return truth_[body]; }

    ManifoldParameters parameters;
    JointParameters joint_parameters;
    testing::Gaussian random;
    std::vector<World> worlds;
    std::vector<Anchor> anchors;
    std::unique_ptr<JointFilter> joint;

private:
    struct Event {
        double time_s = 0;
        size_t body = 0;
        std::optional<InertialMeasurement> inertial{};
        std::optional<DistanceMeasurement> own{};
        std::optional<std::vector<MotionState>> truth{};
    };

    static void moveTo(World& world, const Vector3d& p, double heading_rad) {
        const Quaterniond turn(axisAngle(Vector3d::UnitY(), heading_rad));
        world.motion.p_world_root = p + turn * world.motion.p_world_root;
        world.motion.q_parent_link[0] = turn * world.motion.q_parent_link[0];
    }
    JointFilter::Room roomModel() const {
        JointFilter::Room room;
        for (const Anchor& anchor : anchors) {
            MountedBoard board;
            board.p_link_mic = anchor.surveyed_m;
            room.suit.boards.push_back(board);
            room.suit.sources.push_back({-1, anchor.surveyed_m, -anchor.surveyed_m.normalized()});
            room.housings.push_back(static_cast<int>(room.housings.size()));
        }
        return room;
    }

    Vector3d sourceAt(int member, int source) const {
        if (member == kRoom)
            return anchors[static_cast<size_t>(source)].true_m;
        const MountedSource& s =
            worlds[static_cast<size_t>(member)].suit.sources[static_cast<size_t>(source)];
        return worlds[static_cast<size_t>(member)].point(s.link, s.p_link_source);
    }
    Vector3d boardAt(int member, int board) const {
        if (member == kRoom)
            return anchors[static_cast<size_t>(board)].true_m;
        const MountedBoard& b = worlds[static_cast<size_t>(member)].suit.boards[static_cast<size_t>(board)];
        return worlds[static_cast<size_t>(member)].point(b.link, b.p_link_mic);
    }
    static double suitTime(int member, double time_s) {
        return member == kRoom ? time_s : time_s - kOffset_s[member];
    }

    void play(double seconds) {
        struct Pulse {
            int member, source;
            Vector3d from;
            double emission_s;
        };
        std::vector<Pulse> flying;
        int turn = 0;
        std::vector<MotionState> now{worlds[0].motion, worlds[1].motion};
        for (int k = 1; k < (kRest_s + seconds) / testing::kFineStep_s; ++k) {
            const double t = k * testing::kFineStep_s;
            if (t > kRest_s)
                for (World& world : worlds)
                    world.move(testing::kFineStep_s);
            for (int i = 0; i < kBodies && k % testing::kFine == 0 && t > kRest_s; ++i)
                for (int b = 0; b < 4; ++b)
                    events_.push_back({t,
                                       static_cast<size_t>(i),
                                       worlds[static_cast<size_t>(i)].inertial(b, suitTime(i, t)),
                                       {},
                                       {}});
            if (k % testing::kFine == 1) {
                flying.clear();
                for (int i = 0; i < kBodies; ++i)
                    flying.push_back({i, turn % 2, sourceAt(i, turn % 2), t});
                if (room_)
                    flying.push_back({kRoom, turn % 4, sourceAt(kRoom, turn % 4), t});
                ++turn;
            }
            if (k % testing::kFine == 3)
                for (const Pulse& pulse : flying)
                    hear(pulse.member, pulse.source, pulse.from, pulse.emission_s, t);
            if (k % testing::kFine != 0)
                continue;
            const std::vector<MotionState> before = std::exchange(now, {worlds[0].motion, worlds[1].motion});
            if (k / testing::kFine % 14 == 0)
                events_.push_back({t, 0, {}, {}, before});
        }
    }
    void hear(int member, int source, const Vector3d& from, double emission_s, double t) {
        const double scale = member == kRoom ? 0 : worlds[static_cast<size_t>(member)].sound_scale;
        const double offset =
            member == kRoom ? 0
                            : worlds[static_cast<size_t>(member)].source_offset[static_cast<size_t>(source)];
        for (int to = 0; to < (room_ ? 3 : 2); ++to)
            for (int b = 0; b < 4; ++b) {
                if (member == kRoom && to == kRoom)
                    continue;
                const double stretch =
                    1 + (member == kRoom ? worlds[static_cast<size_t>(to)].sound_scale : scale);
                const double measured =
                    (boardAt(to, b) - from).norm() * stretch + offset + random(World::kDistanceSigma);
                if (to == member) {
                    if (t > kRest_s)
                        events_.push_back(
                            {t,
                             static_cast<size_t>(to),
                             {},
                             DistanceMeasurement{0, source, b, suitTime(to, emission_s), suitTime(to, t),
                                                 measured, World::kDistanceSigma, 1},
                             {}});
                } else if ((member != kRoom && to != kRoom) ? between_ : room_) {
                    distances_.push_back({member, to, source, b, suitTime(member, emission_s),
                                          suitTime(to, t), kSound, measured - kSound * (t - emission_s),
                                          World::kDistanceSigma, 1});
                }
            }
    }

    bool between_, room_;
    std::vector<Event> events_;
    std::vector<JointDistance> distances_;
    std::vector<MotionState> truth_;
};

/// Of the pose of body 1's root in the frame of body 0's.
struct Relative {
    Eigen::Matrix<double, 6, 1> error;
    Eigen::Matrix<double, 6, 6> covariance;
};

Relative relativeOf(const JointWorld& world) {
    const auto place = [](const MotionState& a, const MotionState& b) -> Vector3d {
        return a.q_parent_link[0].conjugate() * (b.p_world_root - a.p_world_root);
    };
    const auto turn = [](const MotionState& a, const MotionState& b) {
        return Quaterniond(a.q_parent_link[0].conjugate() * b.q_parent_link[0]);
    };
    const MotionState &a = world.joint->filter(0).state().motion, &b = world.joint->filter(1).state().motion;
    Relative relative;
    relative.error << place(world.truth(0), world.truth(1)) - place(a, b),
        logQuaternion(turn(a, b).conjugate() * turn(world.truth(0), world.truth(1)));
    Eigen::Matrix<double, 6, 12> J = Eigen::Matrix<double, 6, 12>::Zero();
    const Matrix3d R = a.q_parent_link[0].toRotationMatrix().transpose();
    J.block<3, 3>(0, 0) = -R;
    J.block<3, 3>(0, 3) = skew(place(a, b));
    J.block<3, 3>(0, 6) = R;
    J.block<3, 3>(3, 3) = -turn(a, b).toRotationMatrix().transpose();
    J.block<3, 3>(3, 9).setIdentity();
    Eigen::Matrix<double, 12, 12> P;
    P.block<6, 6>(0, 0) = world.joint->filter(0).covariance().topLeftCorner(6, 6);
    P.block<6, 6>(6, 6) = world.joint->filter(1).covariance().topLeftCorner(6, 6);
    P.block<6, 6>(0, 6) = world.joint->covariance().between(0, 1).topLeftCorner(6, 6);
    P.block<6, 6>(6, 0) = P.block<6, 6>(0, 6).transpose();
    relative.covariance = J * P * J.transpose();
    return relative;
}

double headingSigma(const ManifoldFilter& filter) {
    const Vector3d up = headingFrame(filter.state().motion);
    return std::sqrt(up.dot(filter.covariance().block<3, 3>(3, 3) * up));
}

/// Of the vector from a joint of body 0 to one of body 1, in the frame of the first one's root.
double relativeNees(const JointWorld& world, int joint, int other) {
    const auto seen = [&](const MotionState& a, const MotionState& b) -> Vector3d {
        const auto at = [&](size_t body, int of, const MotionState& motion) {
            ChainMotion chain;
            const KinematicTree& tree = world.joint->filter(body).tree();
            chain.evaluate(tree, motion, tree.linkOfJoint(of), 0);
            return chain.end().p_m;
        };
        return a.q_parent_link[0].conjugate() * (at(1, other, b) - at(0, joint, a));
    };
    const Vector3d error = seen(world.truth(0), world.truth(1)) -
                           seen(world.joint->filter(0).state().motion, world.joint->filter(1).state().motion);
    const Matrix3d covariance = world.joint->relativeCovariance(0, joint, 1, other);
    return test::nees(error, covariance);
}

TEST(JointFilter, TwoBodiesKnowHonestlyWhereTheyAreToEachOther) {
    const int last = testing::smallSkeleton().size() - 1;
    double nees = 0, vectors = 0, place_m = 0, count = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        JointWorld world(seed, true, false);
        world.run(4, [&](double) {
            const Relative relative = relativeOf(world);
            EXPECT_LT((world.joint->relativeCovariance(0, 0, 1, 0) - relative.covariance.topLeftCorner(3, 3))
                          .norm(),
                      1e-9);
            vectors += relativeNees(world, last, last);
            nees += test::nees(relative.error, relative.covariance);
            place_m += relative.error.head<3>().norm();
            ++count;
        });
        EXPECT_GE(headingSigma(world.joint->filter(0)), world.parameters.initial_pose_rad);
        EXPECT_GE(headingSigma(world.joint->filter(1)), world.parameters.initial_pose_rad);
        EXPECT_EQ(world.joint->filter(0).resets() + world.joint->filter(1).resets(), 0);
    }
    std::printf("joint: NEES %.2f, of vectors between ends %.2f, place %.1f mm\n", nees / count,
                vectors / count, 1000 * place_m / count);
    EXPECT_GT(vectors / count, 0.5);
    EXPECT_LT(vectors / count, 1.5);
    EXPECT_GT(nees / count, 0.6);
    EXPECT_LT(nees / count, 1.3);
    EXPECT_LT(place_m / count, 0.06);
}

TEST(JointFilter, AnchorsHoldPlaceAndHeading) {
    double nees = 0, place_m = 0, heading_rad = 0, count = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        JointWorld world(seed, true, true);
        world.run(4, [&](double) {
            for (size_t i = 0; i < 2; ++i) {
                const ManifoldFilter& filter = world.joint->filter(i);
                const Eigen::VectorXd error =
                    coordinateError(filter.tree(), filter.state().motion, world.truth(i)).head(6);
                const Eigen::MatrixXd P = filter.covariance().topLeftCorner(6, 6);
                nees += test::nees(error, P);
                place_m += error.head<3>().norm();
                heading_rad += std::abs(headingFrame(filter.state().motion).dot(error.tail<3>()));
                ++count;
            }
        });
    }
    std::printf("room: NEES %.2f, place %.1f mm, heading %.2f deg\n", nees / count, 1000 * place_m / count,
                degrees(heading_rad / count));
    EXPECT_GT(nees / count, 0.5);
    EXPECT_LT(nees / count, 1.4);
    EXPECT_LT(place_m / count, 0.04);  // the survey's error is common to all
    EXPECT_LT(degrees(heading_rad / count), 0.5);
}

TEST(JointFilter, TheClockIsFoundWithoutTransceivers) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        JointWorld world(seed, true, false);
        world.run(3, [](double) {});
        const double error_s = world.joint->clockNow(1).common_s(2) - (2 + kOffset_s[1]);
        EXPECT_LT(std::abs(error_s), 4 * world.joint->clockSigma_s(1)) << seed;
        EXPECT_LT(std::abs(error_s), 5e-6) << seed;
    }
}

TEST(JointFilter, AShareOfTheRangesIsUsed) {
    JointWorld world(1, true, false, 0.25);
    world.run(3, [](double) {});
    int64_t used = 0, left = 0;
    for (const JointDecision& decision : world.joint->takeDecisions()) {
        used += decision.fate == RangeFate::kUsed || decision.fate == RangeFate::kWeighted;
        left += decision.fate == RangeFate::kNotTried;
    }
    EXPECT_GT(used, 300);
    EXPECT_LT(used, left);
    const Relative relative = relativeOf(world);
    EXPECT_LT(relative.error.head<3>().norm(),
              4 * std::sqrt(relative.covariance.topLeftCorner(3, 3).trace()));
}

}  // namespace
}  // namespace noctule
