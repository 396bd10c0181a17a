// SPDX-License-Identifier: Apache-2.0
// A pose as a row of numbers that can be filtered and interpolated: root position, then per joint a
// quaternion (free, ball), two angles (universal), one (hinge) or nothing (fixed). And the simulator's own
// kinematics from such a row, by matrices; with T = Jet also velocities and accelerations. Shares nothing
// with core/body's.
#pragma once

#include <vector>

#include "core/body/skeleton.h"
#include "core/simulation/jet.h"

namespace noctule::simulation {

/// Where a joint frame stands in the world.
template <class T>
struct Frame {
    Matrix3<T> r;
    Vector3<T> p;
};

class Coordinates {
public:
    explicit Coordinates(Skeleton skeleton);

    const Skeleton& skeleton() const { return skeleton_; }
    int size() const { return size_; }

    /// The pose must be one that the joints can make; it is projected onto their freedoms without limits.
    std::vector<double> fromPose(const Pose& pose) const;
    Pose toPose(const std::vector<double>& row) const;

    /// Makes `row` continue `previous`: quaternions to the same half, angles less than half a turn away.
    void continueFrom(const std::vector<double>& previous, std::vector<double>& row) const;
    void normalise(std::vector<double>& row) const;

    /// a + weight (b - a), quaternions on the shorter way and left unnormalised.
    template <class T>
    void blend(const std::vector<T>& a, const std::vector<T>& b, const T& weight, std::vector<T>& out) const;

    /// World frames of all joints; quaternions need no unit length.
    template <class T>
    void frames(const std::vector<T>& row, std::vector<Frame<T>>& frames) const;

    /// First coordinate of a joint's rotation: 4, 2, 1 or 0 of them.
    int first(int joint) const { return first_[static_cast<size_t>(joint)]; }
    bool isQuaternion(int joint) const;

private:
    template <class T>
    Matrix3<T> rotation(int joint, const std::vector<T>& row) const;

    Skeleton skeleton_;
    std::vector<int> first_;
    int size_ = 0;
};

/// r * v for a constant v.
template <class T>
Vector3<T> rotate(const Matrix3<T>& r, const Vector3d& v) {
    Vector3<T> result;
    for (int i = 0; i < 3; ++i)
        result[i] = r(i, 0) * v.x() + r(i, 1) * v.y() + r(i, 2) * v.z();
    return result;
}

/// Rotation matrix of a quaternion of any length but zero.
template <class T>
Matrix3<T> matrixOf(const T& w, const T& x, const T& y, const T& z) {
    const T s = inverse(w * w + x * x + y * y + z * z) * 2.0;
    const T xs = x * s, ys = y * s, zs = z * s;
    const T wx = w * xs, wy = w * ys, wz = w * zs, xx = x * xs, xy = x * ys, xz = x * zs, yy = y * ys,
            yz = y * zs, zz = z * zs;
    Matrix3<T> r;
    r << 1.0 - (yy + zz), xy - wz, xz + wy, xy + wz, 1.0 - (xx + zz), yz - wx, xz - wy, yz + wx,
        1.0 - (xx + yy);
    return r;
}

}  // namespace noctule::simulation
