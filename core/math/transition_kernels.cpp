// SPDX-License-Identifier: Apache-2.0
#include "core/math/transition_kernels.h"

#include <algorithm>

#include "core/job/contract.h"
#include "core/math/instruction_sets.h"

namespace noctule {
namespace {

struct LinkColumns {
    double *theta, *rate, *accel;  ///< `count` columns each, `stride` apart
    long rows, stride;
    double dt;
};

/// A link's numbers where the compiler sees that nothing else changes them.
template <int kCount>
struct Factors {
    explicit Factors(const LinkTransition& link) {
        for (int j = 0; j < kCount; ++j) {
            decay[j] = link.decay[j];
            for (int k = 0; k < kCount; ++k) {
                turn[j][k] = link.turn(j, k);
                jacobian[j][k] = link.jacobian(j, k);
                to_rate[j][k] = link.rate_by_theta(j, k);
                to_accel[j][k] = link.accel_by_theta(j, k);
            }
        }
    }
    double turn[kCount][kCount], jacobian[kCount][kCount], to_rate[kCount][kCount], to_accel[kCount][kCount];
    double decay[kCount];
};

/// Everything of one row at a time: each column is read and written once.
template <int kCount>
[[gnu::always_inline]] inline void mixForth(const LinkColumns& columns, const LinkTransition& link) {
    const LinkColumns c = columns;
    const Factors<kCount> f(link);
    const double half = 0.5 * c.dt * c.dt;
    NOCTULE_INDEPENDENT
    for (long i = 0; i < c.rows; ++i) {
        double theta[kCount], gained[kCount];
        for (int k = 0; k < kCount; ++k)
            theta[k] = c.theta[k * c.stride + i];
        for (int j = 0; j < kCount; ++j) {
            const double rate = c.rate[j * c.stride + i], accel = c.accel[j * c.stride + i];
            gained[j] = c.dt * rate + half * accel;
            double to_rate = rate + c.dt * accel, to_accel = f.decay[j] * accel;
            for (int k = 0; k < kCount; ++k) {
                to_rate += f.to_rate[j][k] * theta[k];
                to_accel += f.to_accel[j][k] * theta[k];
            }
            c.rate[j * c.stride + i] = to_rate;
            c.accel[j * c.stride + i] = to_accel;
        }
        for (int j = 0; j < kCount; ++j) {
            double sum = 0;
            for (int k = 0; k < kCount; ++k)
                sum += f.turn[j][k] * theta[k] + f.jacobian[j][k] * gained[k];
            c.theta[j * c.stride + i] = sum;
        }
    }
}

template <int kCount>
[[gnu::always_inline]] inline void mixBack(const LinkColumns& columns, const LinkTransition& link) {
    const LinkColumns c = columns;
    const Factors<kCount> f(link);
    const double half = 0.5 * c.dt * c.dt;
    NOCTULE_INDEPENDENT
    for (long i = 0; i < c.rows; ++i) {
        double theta[kCount], rate[kCount], accel[kCount];
        for (int k = 0; k < kCount; ++k) {
            theta[k] = c.theta[k * c.stride + i];
            rate[k] = c.rate[k * c.stride + i];
            accel[k] = c.accel[k * c.stride + i];
        }
        for (int j = 0; j < kCount; ++j) {
            double turned = 0, gained = 0;
            for (int k = 0; k < kCount; ++k) {
                turned += f.turn[k][j] * theta[k] + f.to_rate[k][j] * rate[k] + f.to_accel[k][j] * accel[k];
                gained += f.jacobian[k][j] * theta[k];
            }
            c.theta[j * c.stride + i] = turned;
            c.rate[j * c.stride + i] = rate[j] + c.dt * gained;
            c.accel[j * c.stride + i] = f.decay[j] * accel[j] + c.dt * rate[j] + half * gained;
        }
    }
}

[[gnu::always_inline]] inline void mix(const LinkColumns& columns, const LinkTransition& link, bool back) {
    if (link.count == 3)
        back ? mixBack<3>(columns, link) : mixForth<3>(columns, link);
    else
        back ? mixBack<1>(columns, link) : mixForth<1>(columns, link);
}

#ifdef NOCTULE_AVX2

NOCTULE_AVX2 void mixAvx2(const LinkColumns& columns, const LinkTransition& link, bool back) {
    mix(columns, link, back);
}

NOCTULE_AVX512 void mixAvx512(const LinkColumns& columns, const LinkTransition& link, bool back) {
    mix(columns, link, back);
}

#endif

void mixWithBest(const LinkColumns& columns, const LinkTransition& link, bool back) {
#ifdef NOCTULE_AVX2
    if (hasAvx512())
        return mixAvx512(columns, link, back);
    if (hasAvx2())
        return mixAvx2(columns, link, back);
#endif
    mix(columns, link, back);
}

void mixAll(const LinkTransitions& t, Eigen::Ref<Eigen::MatrixXd>& M, bool back) {
    require(3 * t.n <= M.cols(), "transitions: shapes do not fit");
    for (const LinkTransition& link : t.links) {
        require((link.count == 1 || link.count == 3) && link.first + link.count <= t.n,
                "transitions: no such link");
        mixWithBest({M.col(link.first).data(), M.col(t.n + link.first).data(),
                     M.col(2 * t.n + link.first).data(), M.rows(), M.outerStride(), t.dt_s},
                    link, back);
    }
}

/// By columns, which lie in one piece. P F^T first; the transpose of its moving block is F P, which the
/// second pass makes F P F^T. Of what moves with what does not the rows below are then done, and are
/// mirrored.
void carryBothSides(const LinkTransitions& t, Eigen::MatrixXd& P, bool back) {
    if (t.links.empty())
        return;
    const Eigen::Index moving = 3 * t.n, constant = P.cols() - moving;
    Eigen::Ref<Eigen::MatrixXd> once = P;
    mixAll(t, once, back);
    P.topRightCorner(moving, constant) = P.bottomLeftCorner(constant, moving).transpose();
    P.topLeftCorner(moving, moving).transposeInPlace();
    Eigen::Ref<Eigen::MatrixXd> twice = P.topLeftCorner(moving, moving);
    mixAll(t, twice, back);
}

Eigen::Map<Eigen::MatrixXd> asRow(Eigen::VectorXd& x) {
    return {x.data(), 1, x.size()};
}

}  // namespace

void LinkTransitions::timesTransposed(Eigen::Ref<Eigen::MatrixXd> M) const {
    mixAll(*this, M, false);
}

void LinkTransitions::times(Eigen::Ref<Eigen::MatrixXd> M) const {
    mixAll(*this, M, true);
}

void LinkTransitions::carry(Eigen::MatrixXd& P) const {
    carryBothSides(*this, P, false);
}

void LinkTransitions::carry(Eigen::VectorXd& x) const {
    timesTransposed(asRow(x));
}

void LinkTransitions::carryBack(Eigen::MatrixXd& P) const {
    carryBothSides(*this, P, true);
}

void LinkTransitions::carryBack(Eigen::VectorXd& x) const {
    times(asRow(x));
}

void LinkTransitions::beginWith(const LinkTransitions& shift) {
    auto link = links.begin();
    for (const LinkTransition& first : shift.links) {
        link = std::find_if(link, links.end(), [&](const auto& own) { return own.first == first.first; });
        require(shift.dt_s == 0 && link != links.end() && link->count == 3 && first.count == 3,
                "beginWith: not a shift of these rotations");
        link->turn = link->turn * first.turn +
                     link->jacobian * (dt_s * first.rate_by_theta + 0.5 * dt_s * dt_s * first.accel_by_theta);
        link->rate_by_theta =
            link->rate_by_theta * first.turn + first.rate_by_theta + dt_s * first.accel_by_theta;
        link->accel_by_theta =
            link->accel_by_theta * first.turn + link->decay.asDiagonal() * first.accel_by_theta;
    }
}

}  // namespace noctule
