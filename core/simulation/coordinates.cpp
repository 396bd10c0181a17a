// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/coordinates.h"

#include <cmath>

#include "core/job/contract.h"
#include "core/math/rotation.h"

namespace noctule::simulation {
namespace {

int countOf(JointType type) {
    switch (type) {
        case JointType::kFree:
        case JointType::kBall:
            return 4;
        case JointType::kUniversal:
            return 2;
        case JointType::kHinge:
            return 1;
        case JointType::kFixed:
            break;
    }
    return 0;
}

/// Rodrigues: I + sin(a) [n]x + (1 - cos(a)) [n]x^2.
template <class T>
Matrix3<T> aboutAxis(const Vector3d& axis, const T& angle) {
    using std::cos, std::sin;
    const T s = sin(angle), c = 1.0 - cos(angle);
    const Matrix3d k = skew(axis), kk = k * k;
    Matrix3<T> r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            r(i, j) = (i == j ? 1.0 : 0.0) + s * k(i, j) + c * kk(i, j);
    return r;
}

}  // namespace

Coordinates::Coordinates(Skeleton skeleton) : skeleton_(std::move(skeleton)), size_(3) {
    for (const Joint& joint : skeleton_.joints()) {
        first_.push_back(size_);
        size_ += countOf(joint.type);
    }
}

bool Coordinates::isQuaternion(int joint) const {
    return countOf(skeleton_.joint(joint).type) == 4;
}

std::vector<double> Coordinates::fromPose(const Pose& pose) const {
    require(pose.q_parent_joint.size() == skeleton_.joints().size(), "the pose does not fit the skeleton");
    std::vector<double> row(static_cast<size_t>(size_));
    for (int i = 0; i < 3; ++i)
        row[i] = pose.p_world_root[i];
    for (int j = 0; j < skeleton_.size(); ++j) {
        const Quaterniond q = pose.q_parent_joint[j].normalized();
        double* out = row.data() + first(j);
        if (isQuaternion(j)) {
            const double values[4] = {q.w(), q.x(), q.y(), q.z()};
            std::copy(values, values + 4, out);
        } else {
            const Eigen::VectorXd angles = projectOntoJoint(skeleton_.joint(j), q, false).angles_rad;
            std::copy(angles.begin(), angles.end(), out);
        }
    }
    return row;
}

Pose Coordinates::toPose(const std::vector<double>& row) const {
    Pose pose{{row[0], row[1], row[2]}, {}};
    for (int j = 0; j < skeleton_.size(); ++j) {
        const double* c = row.data() + first(j);
        const Joint& joint = skeleton_.joint(j);
        if (isQuaternion(j))
            pose.q_parent_joint.push_back(Quaterniond(c[0], c[1], c[2], c[3]).normalized());
        else
            pose.q_parent_joint.push_back(
                rotationFromAngles(joint, Eigen::Map<const Eigen::VectorXd>(c, countOf(joint.type))));
    }
    return pose;
}

void Coordinates::continueFrom(const std::vector<double>& previous, std::vector<double>& row) const {
    for (int j = 0; j < skeleton_.size(); ++j) {
        const int begin = first(j), end = begin + countOf(skeleton_.joint(j).type);
        if (isQuaternion(j)) {
            double dot = 0;
            for (int i = begin; i < end; ++i)
                dot += previous[i] * row[i];
            for (int i = begin; dot < 0 && i < end; ++i)
                row[i] = -row[i];
        } else {
            for (int i = begin; i < end; ++i)
                row[i] = previous[i] + std::remainder(row[i] - previous[i], 2 * std::numbers::pi);
        }
    }
}

void Coordinates::normalise(std::vector<double>& row) const {
    for (int j = 0; j < skeleton_.size(); ++j)
        if (isQuaternion(j)) {
            Eigen::Map<Eigen::Vector4d> q(row.data() + first(j));
            q.normalize();
        }
}

template <class T>
void Coordinates::blend(const std::vector<T>& a, const std::vector<T>& b, const T& weight,
                        std::vector<T>& out) const {
    out.resize(a.size());
    for (size_t i = 0; i < 3; ++i)
        out[i] = a[i] + weight * (b[i] - a[i]);
    for (int j = 0; j < skeleton_.size(); ++j) {
        const int begin = first(j), end = begin + countOf(skeleton_.joint(j).type);
        double dot = 0;
        for (int i = begin; i < end; ++i)
            dot += valueOf(a[i]) * valueOf(b[i]);
        const double sign = isQuaternion(j) && dot < 0 ? -1 : 1;
        for (int i = begin; i < end; ++i)
            out[i] = a[i] + weight * (b[i] * sign - a[i]);
    }
}

template <class T>
Matrix3<T> Coordinates::rotation(int joint, const std::vector<T>& row) const {
    const T* c = row.data() + first(joint);
    const std::vector<DegreeOfFreedom>& dof = skeleton_.joint(joint).dof;
    switch (skeleton_.joint(joint).type) {
        case JointType::kFree:
        case JointType::kBall:
            return matrixOf(c[0], c[1], c[2], c[3]);
        case JointType::kUniversal:
            return aboutAxis(dof[0].axis, c[0]) * aboutAxis(dof[1].axis, c[1]);
        case JointType::kHinge:
            return aboutAxis(dof[0].axis, c[0]);
        case JointType::kFixed:
            break;
    }
    return Matrix3<T>::Identity();
}

template <class T>
void Coordinates::frames(const std::vector<T>& row, std::vector<Frame<T>>& frames) const {
    frames.resize(static_cast<size_t>(skeleton_.size()));
    for (int j = 0; j < skeleton_.size(); ++j) {
        const Joint& joint = skeleton_.joint(j);
        if (j == 0) {
            frames[0] = {rotation(0, row), {row[0], row[1], row[2]}};
            continue;
        }
        const Frame<T>& parent = frames[joint.parent];
        frames[j].p = parent.p + rotate(parent.r, joint.offset_m);
        if (joint.type == JointType::kFixed)
            frames[j].r = parent.r;
        else
            frames[j].r.noalias() = parent.r * rotation(j, row);
    }
}

template void Coordinates::blend<double>(const std::vector<double>&, const std::vector<double>&,
                                         const double&, std::vector<double>&) const;
template void Coordinates::blend<Jet>(const std::vector<Jet>&, const std::vector<Jet>&, const Jet&,
                                      std::vector<Jet>&) const;
template void Coordinates::frames<double>(const std::vector<double>&, std::vector<Frame<double>>&) const;
template void Coordinates::frames<Jet>(const std::vector<Jet>&, std::vector<Frame<Jet>>&) const;

}  // namespace noctule::simulation
