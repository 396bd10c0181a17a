// SPDX-License-Identifier: Apache-2.0
#include "core/math/transition_kernels.h"

#include "core/job/contract.h"
#include "core/math/instruction_sets.h"

namespace noctule {
namespace {

struct LinkColumns {
    double *theta, *rate, *accel;  ///< `count` columns each
    long rows;
    double dt;
};

/// Everything of one row at a time: each column is read and written once.
template <int kCount>
[[gnu::always_inline]] inline void mixForth(const LinkColumns& c, const LinkTransition& link) {
    const double half = 0.5 * c.dt * c.dt;
#pragma GCC ivdep
    for (long i = 0; i < c.rows; ++i) {
        double theta[kCount], gained[kCount];
        for (int k = 0; k < kCount; ++k) {
            double &rate = c.rate[k * c.rows + i], &accel = c.accel[k * c.rows + i];
            theta[k] = c.theta[k * c.rows + i];
            gained[k] = c.dt * rate + half * accel;
            rate += c.dt * accel;
            accel *= link.decay[k];
        }
        for (int j = 0; j < kCount; ++j) {
            double sum = 0;
            for (int k = 0; k < kCount; ++k)
                sum += link.turn(j, k) * theta[k] + link.jacobian(j, k) * gained[k];
            c.theta[j * c.rows + i] = sum;
        }
    }
}

template <int kCount>
[[gnu::always_inline]] inline void mixBack(const LinkColumns& c, const LinkTransition& link) {
    const double half = 0.5 * c.dt * c.dt;
#pragma GCC ivdep
    for (long i = 0; i < c.rows; ++i) {
        double theta[kCount];
        for (int k = 0; k < kCount; ++k)
            theta[k] = c.theta[k * c.rows + i];
        for (int j = 0; j < kCount; ++j) {
            double turned = 0, gained = 0;
            for (int k = 0; k < kCount; ++k) {
                turned += link.turn(k, j) * theta[k];
                gained += link.jacobian(k, j) * theta[k];
            }
            double &rate = c.rate[j * c.rows + i], &accel = c.accel[j * c.rows + i];
            accel = link.decay[j] * accel + c.dt * rate + half * gained;
            rate += c.dt * gained;
            c.theta[j * c.rows + i] = turned;
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

#endif

void mixWithBest(Eigen::MatrixXd& M, Eigen::Index n, double dt_s, const LinkTransition& link, bool back) {
    require((link.count == 1 || link.count == 3) && link.first + link.count <= n && 3 * n <= M.cols(),
            "mixColumns: shapes do not fit");
    const LinkColumns columns{M.col(link.first).data(), M.col(n + link.first).data(),
                              M.col(2 * n + link.first).data(), M.rows(), dt_s};
#ifdef NOCTULE_AVX2
    if (hasAvx2())
        return mixAvx2(columns, link, back);
#endif
    mix(columns, link, back);
}

}  // namespace

void mixColumns(Eigen::MatrixXd& M, Eigen::Index n, double dt_s, const LinkTransition& link) {
    mixWithBest(M, n, dt_s, link, false);
}

void mixColumnsBack(Eigen::MatrixXd& M, Eigen::Index n, double dt_s, const LinkTransition& link) {
    mixWithBest(M, n, dt_s, link, true);
}

}  // namespace noctule
