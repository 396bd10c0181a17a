// SPDX-License-Identifier: Apache-2.0
// A number that carries its first and second derivative in time. Kinematics written once for double gives
// positions; the same code for Jet gives velocities and accelerations to rounding.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/math/conventions.h"

namespace noctule::simulation {

struct Jet {
    double value = 0, rate = 0, acceleration = 0;

    Jet() = default;
    Jet(double constant) : value(constant) {}
    Jet(double v, double r, double a) : value(v), rate(r), acceleration(a) {}

    Jet operator-() const { return {-value, -rate, -acceleration}; }
    Jet& operator+=(const Jet& b) {
        value += b.value;
        rate += b.rate;
        acceleration += b.acceleration;
        return *this;
    }
    Jet& operator-=(const Jet& b) { return *this += -b; }
    Jet& operator*=(const Jet& b) { return *this = *this * b; }

    friend Jet operator+(Jet a, const Jet& b) { return a += b; }
    friend Jet operator-(Jet a, const Jet& b) { return a -= b; }
    friend Jet operator*(const Jet& a, const Jet& b) {
        return {a.value * b.value, a.rate * b.value + a.value * b.rate,
                a.acceleration * b.value + 2 * a.rate * b.rate + a.value * b.acceleration};
    }
    friend Jet operator*(const Jet& a, double b) { return {a.value * b, a.rate * b, a.acceleration * b}; }
    friend Jet operator*(double a, const Jet& b) { return b * a; }
};

}  // namespace noctule::simulation

template <>
struct Eigen::NumTraits<noctule::simulation::Jet> : Eigen::GenericNumTraits<noctule::simulation::Jet> {
    using Real = noctule::simulation::Jet;
    using NonInteger = noctule::simulation::Jet;
    using Nested = noctule::simulation::Jet;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 3,
        AddCost = 3,
        MulCost = 9
    };
};

namespace noctule::simulation {

/// f(x) by the chain rule, from f and its first two derivatives at x.value.
inline Jet chain(const Jet& x, double f, double df, double ddf) {
    return {f, df * x.rate, ddf * x.rate * x.rate + df * x.acceleration};
}
inline Jet sin(const Jet& x) {
    const double s = std::sin(x.value), c = std::cos(x.value);
    return chain(x, s, c, -s);
}
inline Jet cos(const Jet& x) {
    const double s = std::sin(x.value), c = std::cos(x.value);
    return chain(x, c, -s, -c);
}
inline Jet sqrt(const Jet& x) {
    const double root = std::sqrt(x.value);
    return chain(x, root, 0.5 / root, -0.25 / (root * x.value));
}
inline Jet inverse(const Jet& x) {
    const double i = 1 / x.value;
    return chain(x, i, -i * i, 2 * i * i * i);
}
inline double inverse(double x) {
    return 1 / x;
}
inline Jet atan(const Jet& x) {
    const double d = 1 / (1 + x.value * x.value);
    return chain(x, std::atan(x.value), d, -2 * x.value * d * d);
}

inline double valueOf(double x) {
    return x;
}
inline double valueOf(const Jet& x) {
    return x.value;
}

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;

inline Vector3d values(const Vector3<Jet>& v) {
    return {v[0].value, v[1].value, v[2].value};
}
inline Vector3d rates(const Vector3<Jet>& v) {
    return {v[0].rate, v[1].rate, v[2].rate};
}
inline Vector3d accelerations(const Vector3<Jet>& v) {
    return {v[0].acceleration, v[1].acceleration, v[2].acceleration};
}

}  // namespace noctule::simulation
