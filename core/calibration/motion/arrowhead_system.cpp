// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/arrowhead_system.h"

#include <Eigen/Cholesky>

#include "core/math/covariance_kernels.h"

namespace noctule {
namespace {

constexpr int kWaitingNodes = 8;

}  // namespace

void ResidualBlock::addBorder(int first, const Vector3d& column) {
    columns.push_back({true, first, 1, Matrix3d::Zero()});
    columns.back().J.col(0) = column;
}

ArrowheadSystem::ArrowheadSystem(int nodes, int node_size, int border_size)
    : node_size_(node_size),
      nodes_(static_cast<size_t>(nodes)),
      node_gradient_(Eigen::MatrixXd::Zero(node_size, nodes)),
      node_step_(Eigen::MatrixXd::Zero(node_size, nodes)),
      corner_(Eigen::MatrixXd::Zero(border_size, border_size)),
      waiting_(kWaitingNodes * node_size, border_size),
      border_gradient_(Eigen::VectorXd::Zero(border_size)),
      border_step_(Eigen::VectorXd::Zero(border_size)) {
    for (Node& node : nodes_) {
        node.own = node.next = node.after_next = Eigen::MatrixXd::Zero(node_size, node_size);
        node.border = Eigen::MatrixXd::Zero(node_size, border_size);
    }
}

/// J_a^T W J_b to where it belongs, unless that lies above the diagonal: nothing reads it there.
void ArrowheadSystem::addPair(const ResidualBlock& residuals, const ColumnBlock& a, const Matrix3d& JtW_a,
                              const ColumnBlock& b) {
    if (a.border && !b.border)
        return;
    Eigen::MatrixXd* into = &corner_;
    int row = a.first, column = b.first;
    bool is_symmetric = true;
    if (!a.border) {
        const int node_a = a.first / node_size_, node_b = b.border ? node_a : b.first / node_size_;
        if (node_a < node_b)
            return;
        Node& node = nodes_[static_cast<size_t>(residuals.first_node + node_b)];
        into = b.border               ? &node.border
               : node_a == node_b     ? &node.own
               : node_a == node_b + 1 ? &node.next
                                      : &node.after_next;
        row = a.first % node_size_;
        column = b.border ? b.first : b.first % node_size_;
        is_symmetric = into == &node.own;
    }
    if (is_symmetric && row + a.width <= column)
        return;
    double* target = into->data() + column * into->rows() + row;
    for (int j = 0; j < b.width; ++j, target += into->rows()) {
        double sum[3];
        for (int i = 0; i < 3; ++i)
            sum[i] = JtW_a(i, 0) * b.J(0, j) + JtW_a(i, 1) * b.J(1, j) + JtW_a(i, 2) * b.J(2, j);
        for (int i = 0; i < a.width; ++i)
            target[i] += sum[i];
    }
}

void ArrowheadSystem::add(const ResidualBlock& residuals) {
    for (const ColumnBlock& a : residuals.columns) {
        // What stands below `rows` is zero.
        const Matrix3d JtW_a = a.J.transpose() * residuals.weight.asDiagonal();
        const Vector3d gradient = JtW_a * residuals.residual;
        if (a.border)
            border_gradient_.segment(a.first, a.width) += gradient.head(a.width);
        else
            node_gradient_.col(residuals.first_node + a.first / node_size_)
                .segment(a.first % node_size_, a.width) += gradient.head(a.width);
        for (const ColumnBlock& b : residuals.columns)
            addPair(residuals, a, JtW_a, b);
    }
}

/// Takes one node out: its share of those that follow, of the border and of the gradients.
bool ArrowheadSystem::eliminate(int index) {
    Node& node = nodes_[static_cast<size_t>(index)];
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(node.own);
    if (factor.info() != Eigen::Success)
        return false;
    const auto lower = node.own.triangularView<Eigen::Lower>();
    auto gradient = node_gradient_.col(index);
    lower.solveInPlace(gradient);
    lower.solveInPlace(node.border);
    waiting_.middleRows(waiting_rows_, node_size_) = node.border;
    waiting_rows_ += node_size_;
    if (waiting_rows_ == waiting_.rows())
        shrinkCorner();
    border_gradient_.noalias() -= node.border.transpose() * gradient;
    const auto later = [&](int distance, Eigen::MatrixXd& coupling) {
        if (index + distance >= static_cast<int>(nodes_.size()))
            return;
        node.own.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(coupling);
        Node& other = nodes_[static_cast<size_t>(index + distance)];
        other.own.noalias() -= coupling * coupling.transpose();
        addProduct(other.border, -1, coupling, node.border);
        node_gradient_.col(index + distance).noalias() -= coupling * gradient;
    };
    later(1, node.next);
    later(2, node.after_next);
    if (index + 2 < static_cast<int>(nodes_.size()))
        nodes_[static_cast<size_t>(index) + 1].next.noalias() -= node.after_next * node.next.transpose();
    return true;
}

void ArrowheadSystem::shrinkCorner() {
    if (waiting_rows_ == 0)
        return;
    subtractOuterProduct(corner_, waiting_.topRows(waiting_rows_));
    waiting_rows_ = 0;
}

void ArrowheadSystem::substituteBack() {
    for (int k = static_cast<int>(nodes_.size()) - 1; k >= 0; --k) {
        const Node& node = nodes_[static_cast<size_t>(k)];
        Eigen::VectorXd right = -node_gradient_.col(k) - node.border * border_step_;
        if (k + 1 < static_cast<int>(nodes_.size()))
            right.noalias() -= node.next.transpose() * node_step_.col(k + 1);
        if (k + 2 < static_cast<int>(nodes_.size()))
            right.noalias() -= node.after_next.transpose() * node_step_.col(k + 2);
        node.own.triangularView<Eigen::Lower>().transpose().solveInPlace(right);
        node_step_.col(k) = right;
    }
}

bool ArrowheadSystem::solve(double damping, const JobContext& job) {
    for (Node& node : nodes_)
        node.own.diagonal() *= 1 + damping;
    corner_.diagonal() *= 1 + damping;
    for (int k = 0; k < static_cast<int>(nodes_.size()); ++k)
        if (job.cancelled() || !eliminate(k))
            return false;
    shrinkCorner();
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(corner_);
    if (factor.info() != Eigen::Success)
        return false;
    border_step_ = -border_gradient_;
    corner_.triangularView<Eigen::Lower>().solveInPlace(border_step_);
    corner_.triangularView<Eigen::Lower>().transpose().solveInPlace(border_step_);
    substituteBack();
    return true;
}

Eigen::MatrixXd ArrowheadSystem::borderCovariance() const {
    const Eigen::MatrixXd inverse = corner_.triangularView<Eigen::Lower>().solve(
        Eigen::MatrixXd::Identity(corner_.rows(), corner_.cols()));
    return inverse.transpose() * inverse;
}

}  // namespace noctule
