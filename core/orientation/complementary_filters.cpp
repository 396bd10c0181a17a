// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/complementary_filters.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "core/math/rotation.h"

namespace noctule {

namespace {

/// The axis of the sensor that gravity lies along: 2 is the paper's partition 1, 1 partition 2, 0
/// partition 3.
int partitionOf(const Vector3d& g_sensed) {
    int axis = 0;
    g_sensed.cwiseAbs().maxCoeff(&axis);
    return axis;
}

/// Angle from `from` to `to` about `axis`, both projected onto the plane across it; -pi..pi. 0 when either
/// one has no part in the plane.
double angleAcross(int axis, const Vector3d& from, const Vector3d& to) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sine = from[u] * to[v] - from[v] * to[u];
    const double cosine = from[u] * to[u] + from[v] * to[v];
    return sine == 0 && cosine == 0 ? 0 : std::atan2(sine, cosine);
}

/// Equation 11 without its dt: turns about the sensor's axes that take the predicted vectors to the sensed
/// ones.
Vector3d correctionAngles(const Vector3d& g_local, const Vector3d& g_sensed, const Vector3d& m_local,
                          const Vector3d& m_sensed) {
    const int along = partitionOf(g_sensed);
    Vector3d angles;
    for (int axis = 0; axis < 3; ++axis)
        angles[axis] =
            axis == along ? angleAcross(axis, m_local, m_sensed) : angleAcross(axis, g_local, g_sensed);
    return angles;
}

/// The world seen in the sensor turns against the sensor: equations 3, 4, 12, 13 and 14.
void stepAndCorrect(Quaterniond& q, const Vector3d& turn_rad) {
    const Quaterniond half(0, turn_rad.x() / 2, turn_rad.y() / 2, turn_rad.z() / 2);
    q.coeffs() += (q * half).coeffs();
    q.normalize();
}

/// m_ref: the field turned into the horizontal plane (the paper's correction by its angle to gravity).
Vector3d levelled(const Vector3d& field, const Vector3d& up) {
    const Vector3d level = field - field.dot(up) / up.squaredNorm() * up;
    return level.norm() > 1e-12 ? Vector3d(level.normalized()) : field;
}

template <class Correct>
std::vector<Quaterniond> integrate(const ImuSamples& samples, const Correct& correct) {
    const FieldReference reference = initialReference(samples);
    Quaterniond q = reference.q_world_sensor;
    std::vector<Quaterniond> out;
    out.reserve(samples.size());
    for (size_t i = 0; i < samples.size(); ++i) {
        const double dt_s = samples.interval_s(i);
        if (const double pause_s = samples.pause_s(i); pause_s > 0)
            q = q * expQuaternion(samples.rateInPause_rad_per_s(i) * pause_s);
        const Vector3d& rate = samples.gyro_rad_per_s[i];
        Vector3d turn = rate.allFinite() ? Vector3d(rate * dt_s) : Vector3d::Zero();
        if (samples.accel_m_per_s2[i].allFinite() && !samples.accel_m_per_s2[i].isZero())
            turn += correct(q, i, reference) * dt_s;
        stepAndCorrect(q, turn);
        out.push_back(q);
    }
    return out;
}

}  // namespace

std::vector<Quaterniond> millerOrientation(const ImuSamples& samples, const MillerSettings& settings) {
    return integrate(samples, [&](const Quaterniond& q, size_t i, const FieldReference& reference) {
        const Vector3d g_sensed = samples.accel_m_per_s2[i].normalized();
        const Vector3d g_local = q.conjugate() * reference.up_world;
        const Vector3d m_local = q.conjugate() * levelled(reference.field_world, reference.up_world);
        Vector3d m_sensed = m_local;
        if (samples.hasMag(i))
            m_sensed =
                settings.level_reading ? levelled(samples.mag[i], g_sensed) : samples.mag[i].normalized();
        return Vector3d(-settings.alpha_per_s * correctionAngles(g_local, g_sensed, m_local, m_sensed));
    });
}

std::vector<Quaterniond> bachmannOrientation(const ImuSamples& samples, const BachmannSettings& settings) {
    return integrate(samples, [&](const Quaterniond& q, size_t i, const FieldReference& reference) {
        const Vector3d g_local = q.conjugate() * reference.up_world;
        const Vector3d m_local = q.conjugate() * reference.field_world;
        Eigen::Matrix<double, 6, 3> X;
        X << skew(g_local), skew(m_local);
        Eigen::Matrix<double, 6, 1> difference;
        difference << samples.accel_m_per_s2[i].normalized() - g_local,
            samples.hasMag(i) ? Vector3d(samples.mag[i].normalized() - m_local) : Vector3d::Zero();
        if (!samples.hasMag(i))
            X.bottomRows<3>().setZero();
        const Matrix3d information = X.transpose() * X + 1e-9 * Matrix3d::Identity();
        return Vector3d(settings.gain_per_s * information.ldlt().solve(X.transpose() * difference));
    });
}

}  // namespace noctule
