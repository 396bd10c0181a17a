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

[[gnu::always_inline]] inline void shiftForth(const LinkColumns& c, const RotationShift& link) {
#pragma GCC ivdep
    for (long i = 0; i < c.rows; ++i) {
        double theta[3];
        for (int k = 0; k < 3; ++k)
            theta[k] = c.theta[k * c.rows + i];
        for (int j = 0; j < 3; ++j) {
            double turned = 0, rate = c.rate[j * c.rows + i], accel = c.accel[j * c.rows + i];
            for (int k = 0; k < 3; ++k) {
                turned += link.to_theta(j, k) * theta[k];
                rate += link.to_rate(j, k) * theta[k];
                accel += link.to_accel(j, k) * theta[k];
            }
            c.theta[j * c.rows + i] = turned;
            c.rate[j * c.rows + i] = rate;
            c.accel[j * c.rows + i] = accel;
        }
    }
}

[[gnu::always_inline]] inline void shiftBack(const LinkColumns& c, const RotationShift& link) {
#pragma GCC ivdep
    for (long i = 0; i < c.rows; ++i) {
        double turned[3] = {0, 0, 0};
        for (int k = 0; k < 3; ++k) {
            const double theta = c.theta[k * c.rows + i], rate = c.rate[k * c.rows + i],
                         accel = c.accel[k * c.rows + i];
            for (int j = 0; j < 3; ++j)
                turned[j] +=
                    link.to_theta(k, j) * theta + link.to_rate(k, j) * rate + link.to_accel(k, j) * accel;
        }
        for (int j = 0; j < 3; ++j)
            c.theta[j * c.rows + i] = turned[j];
    }
}

[[gnu::always_inline]] inline void shift(const LinkColumns& columns, const RotationShift& link, bool back) {
    back ? shiftBack(columns, link) : shiftForth(columns, link);
}

#ifdef NOCTULE_AVX2

NOCTULE_AVX2 void shiftAvx2(const LinkColumns& columns, const RotationShift& link, bool back) {
    shift(columns, link, back);
}

NOCTULE_AVX2 void mixAvx2(const LinkColumns& columns, const LinkTransition& link, bool back) {
    mix(columns, link, back);
}

#endif

LinkColumns columnsOf(Eigen::MatrixXd& M, Eigen::Index n, Eigen::Index first, int count, double dt_s) {
    require((count == 1 || count == 3) && first + count <= n && 3 * n <= M.cols(),
            "columns of a link: shapes do not fit");
    return {M.col(first).data(), M.col(n + first).data(), M.col(2 * n + first).data(), M.rows(), dt_s};
}

void shiftWithBest(Eigen::MatrixXd& M, Eigen::Index n, const RotationShift& link, bool back) {
    const LinkColumns columns = columnsOf(M, n, link.first, 3, 0);
#ifdef NOCTULE_AVX2
    if (hasAvx2())
        return shiftAvx2(columns, link, back);
#endif
    shift(columns, link, back);
}

void mixWithBest(Eigen::MatrixXd& M, Eigen::Index n, double dt_s, const LinkTransition& link, bool back) {
    const LinkColumns columns = columnsOf(M, n, link.first, link.count, dt_s);
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

void shiftColumns(Eigen::MatrixXd& M, Eigen::Index n, const RotationShift& link) {
    shiftWithBest(M, n, link, false);
}

void shiftColumnsBack(Eigen::MatrixXd& M, Eigen::Index n, const RotationShift& link) {
    shiftWithBest(M, n, link, true);
}

}  // namespace noctule
