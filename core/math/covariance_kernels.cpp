// SPDX-License-Identifier: Apache-2.0
#include "core/math/covariance_kernels.h"

#include <algorithm>

#include "core/job/contract.h"
#include "core/math/instruction_sets.h"

namespace noctule {
namespace {

constexpr long kColumns = 4;  // of a tile

/// sum[c][r] = sum_k panel[k][r] * factors[c][k] for c < 4, r < kRows: a tile of X X^T. `panel` holds kRows
/// rows of X, measurement after measurement; `factors` holds four rows of X, each m long, `stride` apart.
template <int kRows>
void tileSum(const double* panel, const double* factors, long stride, long m, double* sum) {
    std::fill(sum, sum + kColumns * kRows, 0.0);
    for (long k = 0; k < m; ++k)
        for (long c = 0; c < kColumns; ++c)
            for (long r = 0; r < kRows; ++r)
                sum[c * kRows + r] += panel[k * kRows + r] * factors[c * stride + k];
}

/// P H^T for some rows of H: P's columns have n rows and stand p_stride apart, those of the product
/// product_stride.
struct SparseFactors {
    const double* p;
    long n, p_stride;
    const int* columns;
    long count, h_rows, product_stride;
};

/// Rows of three measurements at once: every column of P is read once for all.
void multiplyThree(const SparseFactors& s, const double* h, long from, double* product) {
    for (long i = from; i < s.n; ++i) {
        double sum[3] = {};
        for (long k = 0; k < s.count; ++k)
            for (long r = 0; r < 3; ++r)
                sum[r] += s.p[s.columns[k] * s.p_stride + i] * h[k * s.h_rows + r];
        for (long r = 0; r < 3; ++r)
            product[r * s.product_stride + i] = sum[r];
    }
}

[[gnu::always_inline]] inline void multiplyOne(const SparseFactors& s, const double* h, double* product) {
    std::fill(product, product + s.n, 0.0);
    for (long k = 0; k < s.count; ++k)
        for (long i = 0; i < s.n; ++i)
            product[i] += h[k * s.h_rows] * s.p[s.columns[k] * s.p_stride + i];
}

/// target += sum over kCount columns of m (each `length` long) times factors.
template <int kCount>
[[gnu::always_inline]] inline void addColumns(double* target, const double* m, long length,
                                              const double* factors) {
    for (long i = 0; i < length; ++i) {
        double sum = target[i];
        for (long k = 0; k < kCount; ++k)
            sum += m[k * length + i] * factors[k];
        target[i] = sum;
    }
}

/// addTimesSparse() for the columns of one block; `m` begins at the block's first row.
[[gnu::always_inline]] inline void addBlockColumns(double* c, const double* m, long length,
                                                   const int* columns, long count, const double* h,
                                                   long h_rows) {
    for (long k = 0; k < count; ++k) {
        double* target = c + columns[k] * length;
        const double* factors = h + k * h_rows;
        long row = 0;
        for (; row + 3 <= h_rows; row += 3)
            addColumns<3>(target, m + row * length, length, factors + row);
        for (; row < h_rows; ++row)
            addColumns<1>(target, m + row * length, length, factors + row);
    }
}

#ifdef NOCTULE_AVX2

NOCTULE_AVX2 void addBlockColumnsAvx2(double* c, const double* m, long length, const int* columns, long count,
                                      const double* h, long h_rows) {
    addBlockColumns(c, m, length, columns, count, h, h_rows);
}

namespace avx2 {

struct Pack {
    static constexpr int kWidth = 4;
    using Type = __m256d;
    NOCTULE_AVX2 static Type load(const double* x) { return _mm256_loadu_pd(x); }
    NOCTULE_AVX2 static void store(double* x, Type pack) { _mm256_storeu_pd(x, pack); }
    NOCTULE_AVX2 static Type all(double x) { return _mm256_set1_pd(x); }
    NOCTULE_AVX2 static Type multiplyAdd(Type a, Type b, Type c) { return _mm256_fmadd_pd(a, b, c); }
};

#define NOCTULE_TARGET NOCTULE_AVX2
#include "core/math/covariance_packs.inc"
#undef NOCTULE_TARGET

}  // namespace avx2

namespace avx512 {

struct Pack {
    static constexpr int kWidth = 8;
    using Type = __m512d;
    NOCTULE_AVX512 static Type load(const double* x) { return _mm512_loadu_pd(x); }
    NOCTULE_AVX512 static void store(double* x, Type pack) { _mm512_storeu_pd(x, pack); }
    NOCTULE_AVX512 static Type all(double x) { return _mm512_set1_pd(x); }
    NOCTULE_AVX512 static Type multiplyAdd(Type a, Type b, Type c) { return _mm512_fmadd_pd(a, b, c); }
};

#define NOCTULE_TARGET NOCTULE_AVX512
#include "core/math/covariance_packs.inc"
#undef NOCTULE_TARGET

}  // namespace avx512

NOCTULE_AVX2 void multiplyOneAvx2(const SparseFactors& s, const double* h, double* product) {
    multiplyOne(s, h, product);
}

/// kCount columns: C (m rows) += A * B; A's columns are padded with zeros to whole eights (a_rows). Of
/// a lower triangular A the upper part is not read.
template <int kCount>
NOCTULE_AVX2 void addColumnsAvx2(MatrixOut& C, long column, const Eigen::MatrixXd& A, const MatrixIn& B,
                                 bool lower) {
    const long m = C.rows(), c_rows = C.outerStride(), a_rows = A.rows(), p = A.cols();
    double* c = C.col(column).data();
    const double *a = A.data(), *b = B.col(column).data();
    const auto used = [&](long row_end) { return lower ? std::min(p, row_end) : p; };
    long r = 0;
    if (hasAvx512())
        for (; r + 16 <= m; r += 16)
            avx512::addBlock<2, kCount>(c + r, c_rows, a + r, a_rows, b, B.outerStride(), used(r + 16));
    const auto addEight = hasAvx512() ? avx512::addBlock<1, kCount> : avx2::addBlock<2, kCount>;
    for (; r + 8 <= m; r += 8)
        addEight(c + r, c_rows, a + r, a_rows, b, B.outerStride(), used(r + 8));
    if (r == m)
        return;
    double last[8 * kCount] = {};
    for (long i = 0; i < kCount; ++i)
        std::copy(c + i * c_rows + r, c + i * c_rows + m, last + 8 * i);
    addEight(last, 8, a + r, a_rows, b, B.outerStride(), used(m));
    for (long i = 0; i < kCount; ++i)
        std::copy(last + 8 * i, last + 8 * i + m - r, c + i * c_rows + r);
}

#endif

template <int kRows>
void bestTileSum(const double* panel, const double* factors, long stride, long m, double* sum) {
#ifdef NOCTULE_AVX2
    if constexpr (kRows % 8 == 0)
        if (hasAvx512())
            return avx512::tileSum<kRows / 8>(panel, factors, stride, m, sum);
    if (hasAvx2())
        return avx2::tileSum<kRows / 4>(panel, factors, stride, m, sum);
#endif
    tileSum<kRows>(panel, factors, stride, m, sum);
}

/// P(r, c) -= (X X^T)(r, c), mirrored: for what fills no tile, and for small P.
void subtractOne(double* p, const MatrixIn& rows_of_x, long n, long r, long c) {
    p[c * n + r] -= rows_of_x.col(r).dot(rows_of_x.col(c));
    p[r * n + c] = p[c * n + r];
}

/// Rows i + done .. i + kRows of P up to the diagonal, mirrored. Tiles that the diagonal crosses are computed
/// whole and used below it.
template <int kRows>
void subtractRows(double* p, const MatrixIn& rows_of_x, long n, long i, std::vector<double>& panel,
                  long done = 0) {
    const long m = rows_of_x.rows();
    panel.resize(static_cast<size_t>(kRows * m));
    for (long r = 0; r < kRows; ++r)
        for (long k = 0; k < m; ++k)
            panel[static_cast<size_t>(k * kRows + r)] = rows_of_x(k, i + r);
    long j = 0;
    for (; j < i + kRows && j + kColumns <= n; j += kColumns) {
        alignas(32) double sum[kColumns * kRows];
        bestTileSum<kRows>(panel.data(), rows_of_x.col(j).data(), rows_of_x.outerStride(), m, sum);
        for (long c = 0; c < kColumns; ++c)
            for (long r = std::max(done, j + c - i); r < kRows; ++r)
                p[(j + c) * n + i + r] -= sum[c * kRows + r];
        for (long r = done; r < kRows; ++r)
            for (long c = 0; c < kColumns && j + c < i + r; ++c)
                p[(i + r) * n + j + c] = p[(j + c) * n + i + r];
    }
    for (; j < i + kRows; ++j)
        for (long r = std::max(done + i, j); r < n; ++r)
            subtractOne(p, rows_of_x, n, r, j);
}

/// All rows from i on by panels of kRows, the last of which begins early enough to be whole; returns the
/// first row not done, n unless P is smaller than a panel.
template <int kRows>
long subtractFrom(double* p, const MatrixIn& rows_of_x, long n, long i, std::vector<double>& panel) {
    for (; i + kRows <= n; i += kRows)
        subtractRows<kRows>(p, rows_of_x, n, i, panel);
    if (i == n || n < kRows)
        return i;
    subtractRows<kRows>(p, rows_of_x, n, n - kRows, panel, kRows - (n - i));
    return n;
}

}  // namespace

void subtractOuterProduct(MatrixOut P, const MatrixIn& X_transposed) {
    require(P.cols() == P.rows() && P.outerStride() == P.rows() && X_transposed.cols() == P.rows(),
            "subtractOuterProduct: shapes do not fit");
    const long n = P.rows();
    std::vector<double> panel;
    long i = 0;
#ifdef NOCTULE_AVX2
    if (hasAvx512())
        i = subtractFrom<24>(P.data(), X_transposed, n, i, panel);
#endif
    i = subtractFrom<12>(P.data(), X_transposed, n, i, panel);
    for (; i < n; ++i)
        for (long c = 0; c <= i; ++c)
            subtractOne(P.data(), X_transposed, n, i, c);
}

void invertLowerTriangle(MatrixOut L) {
    constexpr Eigen::Index kSmall = 8;
    const Eigen::Index n = L.rows(), half = (n / 2 + 3) / 4 * 4;
    require(L.cols() == n, "invertLowerTriangle: not square");
    if (n > kSmall) {  // [A 0; C D] becomes [1/A 0; -1/D C 1/A 1/D]
        auto A = L.topLeftCorner(half, half), C = L.bottomLeftCorner(n - half, half),
             D = L.bottomRightCorner(n - half, n - half);
        invertLowerTriangle(A);
        invertLowerTriangle(D);
        Eigen::MatrixXd C_A = Eigen::MatrixXd::Zero(n - half, half);
        addProduct(C_A, 1, C, A);
        C.setZero();
        addProduct(C, -1, D, C_A, Shape::kLowerTriangular);
        return;
    }
    for (Eigen::Index j = n - 1; j >= 0; --j) {
        L(j, j) = 1 / L(j, j);
        for (Eigen::Index i = n - 1; i > j; --i) {
            double sum = 0;
            for (Eigen::Index k = j + 1; k <= i; ++k)
                sum += L(i, k) * L(k, j);
            L(i, j) = -L(j, j) * sum;
        }
    }
}

void multiplySparse(const MatrixIn& P, const std::vector<int>& columns, const Eigen::MatrixXd& H,
                    MatrixOut product, Eigen::Index first) {
    const long rows = H.rows();
    const SparseFactors factors{P.data(),
                                P.rows(),
                                P.outerStride(),
                                columns.data(),
                                static_cast<long>(columns.size()),
                                rows,
                                product.outerStride()};
    require(H.cols() == factors.count && product.rows() == P.rows() && first + rows <= product.cols(),
            "multiplySparse: shapes do not fit");
    long row = 0;
    for (; row + 3 <= rows; row += 3) {
        double* target = product.col(first + row).data();
        long done = 0;
#ifdef NOCTULE_AVX2
        if (hasAvx512())
            done = avx512::multiplyThree<3>(factors, H.data() + row, done, target);
        if (hasAvx2())
            for (auto* multiply : {avx2::multiplyThree<3>, avx2::multiplyThree<1>})
                done = multiply(factors, H.data() + row, done, target);
#endif
        multiplyThree(factors, H.data() + row, done, target);
    }
    for (; row < rows; ++row) {
        double* target = product.col(first + row).data();
#ifdef NOCTULE_AVX2
        if (hasAvx2()) {
            multiplyOneAvx2(factors, H.data() + row, target);
            continue;
        }
#endif
        multiplyOne(factors, H.data() + row, target);
    }
}

void addTimesSparse(Eigen::MatrixXd& C, const Eigen::MatrixXd& M, Eigen::Index first,
                    const std::vector<int>& columns, const Eigen::MatrixXd& H) {
    const long count = static_cast<long>(columns.size());
    require(H.cols() == count && C.rows() == M.rows() && first + H.rows() <= M.cols(),
            "addTimesSparse: shapes do not fit");
    const double* m = M.data() + first * M.rows();
#ifdef NOCTULE_AVX2
    if (hasAvx2())
        return addBlockColumnsAvx2(C.data(), m, C.rows(), columns.data(), count, H.data(), H.rows());
#endif
    addBlockColumns(C.data(), m, C.rows(), columns.data(), count, H.data(), H.rows());
}

void addWithTranspose(Eigen::MatrixXd& P, const Eigen::MatrixXd& X) {
    constexpr Eigen::Index kTile = 32;  // both tiles stay in the fastest cache
    const Eigen::Index n = P.rows();
    require(P.cols() == n && X.rows() == n && X.cols() == n, "addWithTranspose: shapes do not fit");
    for (Eigen::Index column = 0; column < n; column += kTile)
        for (Eigen::Index row = column; row < n; row += kTile) {
            const Eigen::Index rows = std::min(kTile, n - row), columns = std::min(kTile, n - column);
            Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kTile, kTile> sum =
                X.block(column, row, columns, rows).transpose();
            sum += X.block(row, column, rows, columns);
            sum += P.block(row, column, rows, columns);
            P.block(row, column, rows, columns) = sum;
            if (row != column)
                P.block(column, row, columns, rows) = sum.transpose();
        }
}

void addProduct(MatrixOut C, double factor, const MatrixIn& A, const MatrixIn& B, Shape shape) {
    require(C.rows() == A.rows() && A.cols() == B.rows() && C.cols() == B.cols(),
            "addProduct: shapes do not fit");
    const bool lower = shape == Shape::kLowerTriangular;
#ifdef NOCTULE_AVX2
    if (hasAvx2()) {
        const long m = C.rows(), n = C.cols(), padded = (m + 7) / 8 * 8;
        Eigen::MatrixXd scaled(padded, A.cols());
        scaled.topRows(m) = factor * A;
        scaled.bottomRows(padded - m).setZero();
        long j = 0;
        for (; hasAvx512() && j + 8 <= n; j += 8)  // it has the registers for as many sums
            addColumnsAvx2<8>(C, j, scaled, B, lower);
        for (; j + 4 <= n; j += 4)
            addColumnsAvx2<4>(C, j, scaled, B, lower);
        for (; j < n; ++j)
            addColumnsAvx2<1>(C, j, scaled, B, lower);
        return;
    }
#endif
    if (lower)
        C.noalias() += (factor * A).triangularView<Eigen::Lower>() * B;
    else
        C.noalias() += factor * A * B;
}

}  // namespace noctule
