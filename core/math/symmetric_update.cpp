// SPDX-License-Identifier: Apache-2.0
#include "core/math/symmetric_update.h"

#include <algorithm>

#include "core/job/contract.h"

// Runtime dispatch needs ifuncs, which the sanitizers' runtimes cannot resolve early enough.
#if defined(__x86_64__) && !defined(NOCTULE_SANITIZED)
#define NOCTULE_CLONES __attribute__((target_clones("default", "arch=haswell")))
#else
#define NOCTULE_CLONES
#endif

namespace noctule {
namespace {

constexpr int kRows = 8, kColumns = 4;

/// One tile of the lower triangle: rows i.., columns j.. of sum_k x_k x_k^T, subtracted from p and mirrored.
NOCTULE_CLONES void fullTile(double* p, const double* x, long n, long m, long i, long j) {
    double sum[kColumns][kRows] = {};
    for (long k = 0; k < m; ++k) {
        const double* column = x + k * n;
        for (int c = 0; c < kColumns; ++c)
            for (int r = 0; r < kRows; ++r)
                sum[c][r] += column[i + r] * column[j + c];
    }
    for (int c = 0; c < kColumns; ++c)
        for (int r = 0; r < kRows; ++r) {
            double& lower = p[(j + c) * n + i + r];
            lower -= sum[c][r];
            p[(i + r) * n + j + c] = lower;
        }
}

void edgeTile(double* p, const double* x, long n, long m, long i, long rows, long j, long columns) {
    for (long c = j; c < j + columns; ++c)
        for (long r = std::max(i, c); r < i + rows; ++r) {
            double sum = 0;
            for (long k = 0; k < m; ++k)
                sum += x[k * n + r] * x[k * n + c];
            p[c * n + r] -= sum;
            p[r * n + c] = p[c * n + r];
        }
}

}  // namespace

void subtractOuterProduct(Eigen::MatrixXd& P, const Eigen::MatrixXd& X) {
    const long n = P.rows(), m = X.cols();
    require(P.cols() == n && X.rows() == n, "subtractOuterProduct: shapes do not fit");
    for (long j = 0; j < n; j += kColumns) {
        const long columns = std::min<long>(kColumns, n - j);
        const long below = std::min(n, j + columns);  // the diagonal block itself is an edge
        edgeTile(P.data(), X.data(), n, m, j, below - j, j, columns);
        for (long i = below; i < n; i += kRows) {
            const long rows = std::min<long>(kRows, n - i);
            if (rows == kRows && columns == kColumns)
                fullTile(P.data(), X.data(), n, m, i, j);
            else
                edgeTile(P.data(), X.data(), n, m, i, rows, j, columns);
        }
    }
}

}  // namespace noctule
