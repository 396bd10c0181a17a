// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/body_world.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"
#include "core/simulation/fade.h"

namespace noctule::simulation {
namespace {

constexpr int64_t kWindowRows = 1024, kCheckpointRows = 256;
constexpr double kRowStep_s = 1 / BodyWorld::kRowsPerSecond;
constexpr double kSlipping_s = 0.5;
/// After 2 s a wobble has forgotten how it began, by twenty orders of magnitude.
constexpr int64_t kForgottenRows = 500;

Jet constant(double value) {
    return Jet(value);
}

}  // namespace

BodyWorld::BodyWorld(Performance performance, WornSuit worn, const std::vector<Capsule>& capsules,
                     std::optional<SoftTissue> soft_tissue)
    : performance_(std::move(performance)),
      worn_(std::move(worn)),
      soft_tissue_(soft_tissue),
      slips_(worn_.boards.size()),
      window_(kWindowRows) {
    const Skeleton& skeleton = performance_.coordinates().skeleton();
    for (const Capsule& capsule : capsules)
        if (const int segment = skeleton.find(capsule.segment); segment >= 0)
            capsules_.push_back({segment, capsule.a_m, capsule.b_m, capsule.radius_m});
    child_of_.assign(skeleton.joints().size(), -1);
    for (int j = skeleton.size() - 1; j > 0; --j)
        child_of_[skeleton.joint(j).parent] = j;
    std::vector<Jet> rest;
    performance_.at(0, rest);
    for (const WornBoard& board : worn_.boards) {
        Eigen::Matrix<Jet, 6, 1> features;
        angleFeatures(board.segment, rest, features);
        rest_features_.push_back(features.unaryExpr([](const Jet& f) { return f.value; }));
    }
}

/// Half the sine of the angles about x, y, z of the segment's joint and of the next one; the same for q and
/// -q.
void BodyWorld::angleFeatures(int segment, const std::vector<Jet>& coordinates,
                              Eigen::Matrix<Jet, 6, 1>& features) const {
    features.setConstant(constant(0));
    const Coordinates& layout = performance_.coordinates();
    const int joints[2] = {segment > 0 ? segment : -1, segment >= 0 ? child_of_[segment] : -1};
    for (int k = 0; k < 2; ++k) {
        if (joints[k] < 0)
            continue;
        const Jet* c = coordinates.data() + layout.first(joints[k]);
        if (layout.isQuaternion(joints[k])) {
            for (int i = 0; i < 3; ++i)
                features[3 * k + i] = c[0] * c[i + 1];
        } else {
            const auto& dof = layout.skeleton().joint(joints[k]).dof;
            for (size_t d = 0; d < dof.size(); ++d)
                for (int i = 0; i < 3; ++i)
                    features[3 * k + i] += sin(c[d]) * (0.5 * dof[d].axis[i]);
        }
    }
}

/// Slow shifts of the board on its segment with the pose. p and r: board in the segment's frame.
void BodyWorld::giveWay(int board, const std::vector<Jet>& coordinates, Vector3<Jet>& p,
                        Matrix3<Jet>& r) const {
    const WornBoard& worn = worn_.boards[board];
    Eigen::Matrix<Jet, 6, 1> features;
    angleFeatures(worn.segment, coordinates, features);
    if (worn.twist_lag > 0 && child_of_[worn.segment] >= 0) {
        const Vector3d bone =
            performance_.coordinates().skeleton().joint(child_of_[worn.segment]).offset_m.normalized();
        Jet twist;  // sine of the axial twist: equal to it for small ones, never singular
        for (int i = 0; i < 3; ++i)
            twist += features[i] * (2 * bone[i]);
        const Jet half = twist * (-0.5 * worn.twist_lag);
        const Matrix3<Jet> lag = matrixOf(constant(1), half * bone.x(), half * bone.y(), half * bone.z());
        p = lag * p;
        r = lag * r;
    }
    Vector3<Jet> tilt;
    for (int i = 0; i < 3; ++i) {
        Jet shift_argument, tilt_argument;
        for (int c = 0; c < 6; ++c) {
            const Jet change = features[c] - rest_features_[board][c];
            shift_argument += change * worn.shift_m.slope(i, c);
            tilt_argument += change * worn.tilt_rad.slope(i, c);
        }
        p[i] += sin(shift_argument) * (worn.shift_m.bound / std::numbers::sqrt3);
        tilt[i] = sin(tilt_argument) * (worn.tilt_rad.bound / std::numbers::sqrt3 / 2);
    }
    r = matrixOf(constant(1), tilt[0], tilt[1], tilt[2]) * r;
}

void BodyWorld::slip(int board, double angle_rad, double t_s) {
    slips_[board].push_back({t_s, angle_rad});
    forgetRowsAfter(t_s);
}

void BodyWorld::takePose(const Pose& pose, double t_s) {
    performance_.takePose(pose, t_s);
    forgetRowsAfter(t_s);
}

void BodyWorld::standAt(const StandingPlace& place) {
    performance_.standAt(place);
    forgetRowsAfter(-1);
}

void BodyWorld::lastFor(double duration_s) {
    performance_.lastFor(duration_s);
    forgetRowsAfter(-1);
}

void BodyWorld::comeBack(double duration_s) {
    performance_.comeBack(duration_s);
    forgetRowsAfter(-1);
}

void BodyWorld::forgetRowsAfter(double t_s) {
    for (Row& row : window_)
        if (static_cast<double>(row.index) * kRowStep_s > t_s)
            row.index = -1;
    std::erase_if(checkpoints_,
                  [&](const auto& entry) { return static_cast<double>(entry.first) * kRowStep_s > t_s; });
}

void BodyWorld::beginAgain() {
    for (std::vector<Slip>& slips : slips_)
        for (Slip& slip : slips)
            slip.begin_s = std::min(slip.begin_s, -kSlipping_s);
    performance_.keepPose();
    forgetRowsAfter(-1);
}

/// Towards the next joint, or on from the last one.
Vector3d BodyWorld::boneOf(int segment) const {
    const Skeleton& skeleton = performance_.coordinates().skeleton();
    const Vector3d& bone = skeleton.joint(child_of_[segment] >= 0 ? child_of_[segment] : segment).offset_m;
    return bone.norm() > 0 ? bone.normalized() : Vector3d(Vector3d::UnitY());
}

void BodyWorld::slideRound(int board, double t_s, Vector3<Jet>& p, Matrix3<Jet>& r) const {
    Jet half_angle;
    for (const Slip& slip : slips_[board])
        half_angle += fadeWeight<Jet>(t_s - slip.begin_s, kSlipping_s) * (slip.angle_rad / 2);
    const Vector3d bone = boneOf(worn_.boards[board].segment);
    const Jet s = sin(half_angle);
    const Matrix3<Jet> turn = matrixOf(cos(half_angle), s * bone.x(), s * bone.y(), s * bone.z());
    p = turn * p;
    r = turn * r;
}

Frame<Jet> BodyWorld::boardFrame(int board, const Instant& instant, const Vector3<Jet>& wobble_m) const {
    const WornBoard& worn = worn_.boards[board];
    Vector3<Jet> p = worn.p_segment_board_m.cast<Jet>();
    Matrix3<Jet> r = worn.q_segment_board.toRotationMatrix().cast<Jet>();
    if (worn.segment < 0)
        return {r, p};
    const Frame<Jet>& segment = instant.frames[worn.segment];
    const bool slipped = !slips_[board].empty();
    if (slipped)
        slideRound(board, instant.t_s, p, r);
    if (!soft_tissue_)
        return {segment.r * r,
                segment.p + (slipped ? segment.r * p : rotate(segment.r, worn.p_segment_board_m))};
    giveWay(board, instant.coordinates, p, r);
    const double tilt_per_m =
        soft_tissue_->rotation_rad_at_30_m_per_s2 / soft_tissue_->displacement_m_at_30_m_per_s2;
    const Vector3<Jet> tilt = worn.wobble_axis.cast<Jet>().cross(wobble_m) * constant(tilt_per_m / 2);
    r = matrixOf(constant(1), tilt[0], tilt[1], tilt[2]) * r;
    p += wobble_m;
    return {segment.r * r, segment.p + segment.r * p};
}

Vector3d BodyWorld::wobbleAcceleration(const Vector3d& x, const Vector3d& rate, const Vector3d& drive) const {
    const double omega = 2 * std::numbers::pi * soft_tissue_->natural_hz;
    const double gain = soft_tissue_->displacement_m_at_30_m_per_s2 / 30 * omega * omega;  // static: that sag
    return -gain * drive - 2 * soft_tissue_->damping * omega * rate - omega * omega * x;
}

/// One row's step of every board's oscillator, by the classical Runge-Kutta rule with linear drive.
void BodyWorld::moveWobbles(int64_t index, const std::vector<Frame<Jet>>& frames,
                            std::vector<Wobble>& wobbles) const {
    for (size_t b = 0; b < worn_.boards.size(); ++b) {
        const WornBoard& worn = worn_.boards[b];
        if (worn.segment < 0)
            continue;
        const Frame<Jet>& segment = frames[worn.segment];
        const Vector3d acceleration =
            accelerations(Vector3<Jet>(segment.p + rotate(segment.r, worn.p_segment_board_m)));
        const Matrix3d r = segment.r.unaryExpr([](const Jet& j) { return j.value; });
        const Vector3d next_drive = r.transpose() * acceleration;
        Wobble& w = wobbles[b];
        if (index > 0) {
            const double h = kRowStep_s;
            const Vector3d middle = (w.drive + next_drive) / 2;
            const Vector3d k1 = wobbleAcceleration(w.x_m, w.rate, w.drive);
            const Vector3d r2 = w.rate + h / 2 * k1;
            const Vector3d k2 = wobbleAcceleration(w.x_m + h / 2 * w.rate, r2, middle);
            const Vector3d r3 = w.rate + h / 2 * k2;
            const Vector3d k3 = wobbleAcceleration(w.x_m + h / 2 * r2, r3, middle);
            const Vector3d r4 = w.rate + h * k3;
            const Vector3d k4 = wobbleAcceleration(w.x_m + h * r3, r4, next_drive);
            w.x_m += h / 6 * (w.rate + 2 * r2 + 2 * r3 + r4);
            w.rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        w.drive = next_drive;
    }
}

void BodyWorld::makeRow(int64_t index, bool settled) const {
    const double t_s = static_cast<double>(index) * kRowStep_s;
    std::vector<Jet> coordinates;
    std::vector<Frame<Jet>> frames;
    performance_.at(t_s, coordinates);
    performance_.coordinates().frames(coordinates, frames);

    std::vector<Wobble> wobbles(worn_.boards.size());
    if (soft_tissue_) {
        if (const auto checkpoint = checkpoints_.find(index); checkpoint != checkpoints_.end()) {
            wobbles = checkpoint->second;
        } else {
            if (index > 0 && window_[(index - 1) % kWindowRows].index == index - 1)
                wobbles = window_[(index - 1) % kWindowRows].wobbles;
            moveWobbles(index, frames, wobbles);
            if (settled && index % kCheckpointRows == 0)
                checkpoints_[index] = wobbles;
        }
    }

    Row& row = window_[index % kWindowRows];
    row.index = index;
    row.points.clear();
    const auto add = [&](const Vector3<Jet>& p) { row.points.push_back({values(p), rates(p)}); };
    std::vector<Frame<Jet>> boards;
    for (int b = 0; b < boardCount(); ++b) {
        const Wobble& w = wobbles[b];
        Vector3<Jet> wobble_m;
        const Vector3d a = soft_tissue_ ? wobbleAcceleration(w.x_m, w.rate, w.drive) : Vector3d::Zero();
        for (int i = 0; i < 3; ++i)
            wobble_m[i] = Jet(w.x_m[i], w.rate[i], a[i]);
        const Frame<Jet> board = boardFrame(b, {t_s, coordinates, frames}, wobble_m);
        add(board.p + rotate(board.r, worn_.boards[b].p_board_mic_m));
        boards.push_back(board);
    }
    const auto onSegment = [&](int segment, const Vector3d& p) {
        return segment < 0 ? Vector3<Jet>(p.cast<Jet>())
                           : Vector3<Jet>(frames[segment].p + rotate(frames[segment].r, p));
    };
    for (const WornSource& source : worn_.sources)
        add(source.board < 0 ? onSegment(source.segment, source.p_segment_source_m)
                             : Vector3<Jet>(boards[source.board].p +
                                            rotate(boards[source.board].r, source.p_board_source_m)));
    for (const WornSource& source : worn_.sources)
        add(source.board >= 0    ? rotate(boards[source.board].r, source.normal_board)
            : source.segment < 0 ? Vector3<Jet>(source.normal_segment.cast<Jet>())
                                 : rotate(frames[source.segment].r, source.normal_segment));
    for (const WornCapsule& capsule : capsules_) {
        add(onSegment(capsule.segment, capsule.a_m));
        add(onSegment(capsule.segment, capsule.b_m));
    }
    row.wobbles = std::move(wobbles);
}

const BodyWorld::Row& BodyWorld::row(int64_t index) const {
    const Row& wanted = window_[index % kWindowRows];
    if (wanted.index == index)
        return wanted;
    const auto isKnown = [&](int64_t k) {
        return k == 0 || window_[(k - 1) % kWindowRows].index == k - 1 || checkpoints_.contains(k);
    };
    int64_t from = index;
    if (soft_tissue_)  // the oscillators must be led here from the nearest known state, or from far enough
        while (!isKnown(from) && index - from < kForgottenRows)
            --from;
    const bool settled = !soft_tissue_ || isKnown(from);
    for (int64_t k = from; k <= index; ++k)
        makeRow(k, settled || k == index);
    for (int64_t k = from; k < index && !settled; ++k)
        window_[k % kWindowRows].index = -1;
    return wanted;
}

Vector3d BodyWorld::point(size_t index, double t_s) const {
    const double place = std::max(0.0, t_s) * kRowsPerSecond;
    const int64_t k = static_cast<int64_t>(place);
    const Point p0 = row(k).points[index], &p1 = row(k + 1).points[index];
    const double u = place - static_cast<double>(k), w = 1 - u;
    return w * w * ((1 + 2 * u) * p0.p + u * kRowStep_s * p0.v) +
           u * u * ((1 + 2 * w) * p1.p - w * kRowStep_s * p1.v);
}

Vector3d BodyWorld::microphone(int board, double t_s) const {
    return point(static_cast<size_t>(board), t_s);
}

Vector3d BodyWorld::source(int source, double t_s) const {
    return point(worn_.boards.size() + source, t_s);
}

Vector3d BodyWorld::sourceNormal(int source, double t_s) const {
    return point(worn_.boards.size() + worn_.sources.size() + source, t_s).normalized();
}

void BodyWorld::capsules(double t_s, std::vector<WorldCapsule>& capsules) const {
    const size_t first = worn_.boards.size() + 2 * worn_.sources.size();
    capsules.clear();
    for (size_t c = 0; c < capsules_.size(); ++c)
        capsules.push_back({point(first + 2 * c, t_s), point(first + 2 * c + 1, t_s), capsules_[c].radius_m,
                            capsules_[c].segment});
}

/// Quintic Hermite arc between two rows' displacement, velocity and acceleration.
Vector3<Jet> BodyWorld::wobbleAt(int board, double t_s) const {
    Vector3<Jet> result;
    result.setConstant(constant(0));
    if (!soft_tissue_)
        return result;
    const double place = std::max(0.0, t_s) * kRowsPerSecond, h = kRowStep_s;
    const int64_t k = static_cast<int64_t>(place);
    const Wobble w0 = row(k).wobbles[board], w1 = row(k + 1).wobbles[board];
    const Vector3d a0 = h * h * wobbleAcceleration(w0.x_m, w0.rate, w0.drive);
    const Vector3d a1 = h * h * wobbleAcceleration(w1.x_m, w1.rate, w1.drive);
    const Jet u(place - static_cast<double>(k), kRowsPerSecond, 0);
    for (int i = 0; i < 3; ++i) {
        const double x0 = w0.x_m[i], v0 = h * w0.rate[i], c = a0[i] / 2;
        // What x0 + v0 u + c u^2 misses at u = 1, in value, slope and curvature.
        const double e0 = w1.x_m[i] - x0 - v0 - c, e1 = h * w1.rate[i] - v0 - 2 * c, e2 = a1[i] - 2 * c;
        const Jet cubic = u * u * u;
        result[i] = x0 + v0 * u + c * u * u +
                    cubic * (Jet(10 * e0 - 4 * e1 + 0.5 * e2) +
                             u * (Jet(-15 * e0 + 7 * e1 - e2) + u * Jet(6 * e0 - 3 * e1 + 0.5 * e2)));
    }
    return result;
}

BoardMotion BodyWorld::boardMotion(int board, double t_s) const {
    std::vector<Jet> coordinates;
    std::vector<Frame<Jet>> frames;
    performance_.at(t_s, coordinates);
    performance_.coordinates().frames(coordinates, frames);
    return motionOf(boardFrame(board, {t_s, coordinates, frames}, wobbleAt(board, t_s)));
}

}  // namespace noctule::simulation
