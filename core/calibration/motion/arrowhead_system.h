// SPDX-License-Identifier: Apache-2.0
// Normal equations of a long chain of nodes, each tied to the two that follow it, which all share a border of
// constants: least squares over a trajectory and what does not change along it. Solved exactly by block
// Cholesky, node by node, then the border by its Schur complement. Time grows with nodes * (node size +
// border)^2.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/job/job.h"
#include "core/math/conventions.h"

namespace noctule {

/// Up to three columns of a residual's derivative.
struct ColumnBlock {
    bool border = false;
    int first = 0;  ///< of the border, or of the three nodes beginning with the residual's first one
    int width = 3;  ///< columns of J that count
    Matrix3d J = Matrix3d::Zero();
};

/// Up to three linearised residuals on at most three nodes in a row: residual + sum of J * step.
struct ResidualBlock {
    int first_node = 0, rows = 3;  ///< below `rows` residual and J are zero
    Vector3d residual = Vector3d::Zero();
    Vector3d weight = Vector3d::Ones();  ///< 1 / variance
    std::vector<ColumnBlock> columns{};  ///< may overlap

    void addNode(int first, const Matrix3d& J) { columns.push_back({false, first, 3, J}); }
    void addBorder(int first, const Matrix3d& J) { columns.push_back({true, first, 3, J}); }
    void addBorder(int first, const Vector3d& column);
};

class ArrowheadSystem {
public:
    ArrowheadSystem(int nodes, int node_size, int border_size);

    void add(const ResidualBlock& residuals);

    /// Minimises the sum of squares; with `damping` times the diagonal added. False when it is not positive
    /// definite or the job is cancelled; the system is used up in every case.
    bool solve(double damping, const JobContext& job = {});
    /// After solve(): the nodes' steps, the border's, and the border's covariance.
    const Eigen::MatrixXd& nodeSteps() const { return node_step_; }  ///< node size x nodes
    const Eigen::VectorXd& borderStep() const { return border_step_; }
    Eigen::MatrixXd borderCovariance() const;

private:
    struct Node {
        // Rows: this node, the next, the one after; columns: this. Of own the lower triangle counts.
        Eigen::MatrixXd own, next, after_next;
        Eigen::MatrixXd border;  ///< node size x border
    };
    void addPair(const ResidualBlock& residuals, const ColumnBlock& a, const Matrix3d& JtW_a,
                 const ColumnBlock& b);
    bool eliminate(int node);
    void shrinkCorner();
    void substituteBack();

    int node_size_;
    std::vector<Node> nodes_;
    Eigen::MatrixXd node_gradient_, node_step_;  ///< node size x nodes
    Eigen::MatrixXd corner_;  ///< its lower triangle counts; after solve() its Cholesky factor
    /// Eliminated borders that the corner has yet to lose: it is far larger than the cache, and is gone
    /// through once for several nodes.
    Eigen::MatrixXd waiting_;
    int waiting_rows_ = 0;
    Eigen::VectorXd border_gradient_, border_step_;
};

}  // namespace noctule
