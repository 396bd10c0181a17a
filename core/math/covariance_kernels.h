// SPDX-License-Identifier: Apache-2.0
// The expensive steps of a Kalman update with a large state and sparse measurements. Plain arrays inside,
// compiled for several instruction sets and chosen at run time: no Eigen type crosses a translation unit
// built with other flags. Arguments may be parts of larger matrices (whole columns or some rows of them):
// nothing is copied.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace noctule {

using MatrixIn = Eigen::Ref<const Eigen::MatrixXd>;
using MatrixOut = Eigen::Ref<Eigen::MatrixXd>;

/// P (n x n, symmetric, both triangles stored) minus X X^T, given X^T (m x n). Both triangles stay equal to
/// the bit.
void subtractOuterProduct(MatrixOut P, const MatrixIn& X_transposed);

/// P H^T for any P and an H (rows x columns.size()) that is zero outside `columns`, into columns first.. of
/// `product`.
void multiplySparse(const MatrixIn& P, const std::vector<int>& columns, const Eigen::MatrixXd& H,
                    MatrixOut product, Eigen::Index first);

/// C (any rows x n) += M H for an H (rows x columns.size()) that is zero outside `columns`; H's rows belong
/// to columns first.. of M.
void addTimesSparse(Eigen::MatrixXd& C, const Eigen::MatrixXd& M, Eigen::Index first,
                    const std::vector<int>& columns, const Eigen::MatrixXd& H);

/// P := P + X + X^T for a symmetric P; both triangles stay equal to the bit.
void addWithTranspose(Eigen::MatrixXd& P, const Eigen::MatrixXd& X);

enum class Shape { kFull, kLowerTriangular };

/// C (m x n) += factor * A (m x p) * B (p x n) for small m and p. What stands above the diagonal of a lower
/// triangular A must be zero.
void addProduct(MatrixOut C, double factor, const MatrixIn& A, const MatrixIn& B, Shape shape = Shape::kFull);

/// L := L^-1 for a lower triangular L without zeros on its diagonal; what stands above it must be zero.
void invertLowerTriangle(MatrixOut L);

}  // namespace noctule
