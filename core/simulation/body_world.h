// SPDX-License-Identifier: Apache-2.0
// A performer in motion, wearing the suit: where every microphone, source and capsule is at any time, and
// what every board feels. Rates come from the world trajectories themselves (Jet), never from joint
// equations. Points are kept as rows at kRowsPerSecond of a sliding window and joined by cubic Hermite arcs
// with exact velocities (error below a micrometre for motion up to 15 Hz); rows are made on demand, so the
// object is not safe to share between threads although its functions are const.
#pragma once

#include <map>

#include "core/simulation/performance.h"
#include "core/simulation/suit_world.h"
#include "core/simulation/worn_suit.h"

namespace noctule::simulation {

class BodyWorld : public SuitWorld {
public:
    static constexpr double kRowsPerSecond = 250;

    BodyWorld(Performance performance, WornSuit worn, const std::vector<Capsule>& capsules,
              std::optional<SoftTissue> soft_tissue);

    double duration_s() const override { return performance_.duration_s(); }
    int boardCount() const override { return static_cast<int>(worn_.boards.size()); }
    int sourceCount() const override { return static_cast<int>(worn_.sources.size()); }
    Vector3d microphone(int board, double t_s) const override;
    Vector3d source(int source, double t_s) const override;
    Vector3d sourceNormal(int source, double t_s) const override;
    int boardSegment(int board) const override { return worn_.boards[board].segment; }
    int sourceSegment(int source) const override { return worn_.sources[source].segment; }
    int sourceBoard(int source) const override { return worn_.sources[source].board; }
    void capsules(double t_s, std::vector<WorldCapsule>& capsules) const override;

    BoardMotion boardMotion(int board, double t_s) const override;

    /// The strap gives way: within half a second from t the board turns about its segment's bone by that much
    /// and stays there. Its gyroscope feels it. What was asked about times after t before is not taken back.
    void slip(int board, double angle_rad, double t_s);
    /// The performer, who has no motion to follow, goes into another pose within kPosing_s.
    void takePose(const Pose& pose, double t_s);
    void beginAgain() override;
    /// Before anything is asked: see Performance.
    void standAt(const StandingPlace& place);
    void lastFor(double duration_s);
    void comeBack(double duration_s);
    const Performance& performance() const { return performance_; }
    const WornSuit& worn() const { return worn_; }

private:
    /// Displacement of a board on its flesh, in the segment's frame, and what drives it.
    struct Wobble {
        Vector3d x_m = Vector3d::Zero(), rate = Vector3d::Zero(), drive = Vector3d::Zero();
    };
    struct Point {
        Vector3d p, v;
    };
    struct Row {
        int64_t index = -1;
        std::vector<Point> points;  ///< microphones, sources, normals, ends of capsules
        std::vector<Wobble> wobbles;
    };
    struct Slip {
        double begin_s = 0, angle_rad = 0;
    };
    struct WornCapsule {
        int segment;
        Vector3d a_m, b_m;
        double radius_m;
    };

    const Row& row(int64_t index) const;
    void makeRow(int64_t index, bool settled) const;
    void moveWobbles(int64_t index, const std::vector<Frame<Jet>>& frames,
                     std::vector<Wobble>& wobbles) const;
    Vector3d wobbleAcceleration(const Vector3d& x, const Vector3d& rate, const Vector3d& drive) const;
    Vector3<Jet> wobbleAt(int board, double t_s) const;
    /// A body at an instant.
    struct Instant {
        double t_s = 0;
        const std::vector<Jet>& coordinates;
        const std::vector<Frame<Jet>>& frames;
    };
    Frame<Jet> boardFrame(int board, const Instant& instant, const Vector3<Jet>& wobble_m) const;
    void slideRound(int board, double t_s, Vector3<Jet>& p, Matrix3<Jet>& r) const;
    Vector3d boneOf(int segment) const;
    void giveWay(int board, const std::vector<Jet>& coordinates, Vector3<Jet>& p, Matrix3<Jet>& r) const;
    void angleFeatures(int segment, const std::vector<Jet>& coordinates,
                       Eigen::Matrix<Jet, 6, 1>& features) const;
    Vector3d point(size_t index, double t_s) const;
    void forgetRowsAfter(double t_s);

    Performance performance_;
    WornSuit worn_;
    std::vector<WornCapsule> capsules_;
    std::optional<SoftTissue> soft_tissue_;
    std::vector<std::vector<Slip>> slips_;                    ///< per board
    std::vector<int> child_of_;                               ///< per joint its first child or -1
    std::vector<Eigen::Matrix<double, 6, 1>> rest_features_;  ///< per board
    mutable std::vector<Row> window_;
    mutable std::map<int64_t, std::vector<Wobble>> checkpoints_;  ///< for going back in time
};

}  // namespace noctule::simulation
