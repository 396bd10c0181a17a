// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/range_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

namespace noctule::cooperative {
namespace {

/// P H^T: what the places vary with each row.
Eigen::MatrixXd placesByRows(const FreePoints& points, const std::vector<RangeRow>& rows) {
    Eigen::MatrixXd G(points.p_m.size(), static_cast<Eigen::Index>(rows.size()));
    for (size_t k = 0; k < rows.size(); ++k) {
        const RangeRow& row = rows[k];
        auto column = G.col(static_cast<Eigen::Index>(k));
        column.noalias() = points.cov_pp.middleCols<3>(3 * row.point) * row.direction;
        if (row.other >= 0)
            column.noalias() -= points.cov_pp.middleCols<3>(3 * row.other) * row.direction;
    }
    return G;
}

/// h^T g of one row.
double project(const RangeRow& row, const Eigen::Ref<const Eigen::VectorXd>& g) {
    double sum = row.direction.dot(g.segment<3>(3 * row.point));
    if (row.other >= 0)
        sum -= row.direction.dot(g.segment<3>(3 * row.other));
    return sum;
}

std::vector<int> byRatio(const std::vector<RangeRow>& rows, const Eigen::MatrixXd& G, size_t most) {
    std::vector<double> ratios(rows.size());
    for (size_t k = 0; k < rows.size(); ++k)  // equation 21, its diagonal, over R
        ratios[k] = project(rows[k], G.col(static_cast<Eigen::Index>(k))) / rows[k].variance_m2;
    std::vector<int> order(rows.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return ratios[static_cast<size_t>(a)] > ratios[static_cast<size_t>(b)];
    });
    order.resize(most);
    return order;
}

std::vector<int> byTrace(const std::vector<RangeRow>& rows, Eigen::MatrixXd G, size_t most) {
    const Eigen::Index m = G.cols();
    Eigen::VectorXd S(m), drop = G.colwise().squaredNorm();
    for (Eigen::Index k = 0; k < m; ++k)
        S[k] = project(rows[static_cast<size_t>(k)], G.col(k));
    std::vector<int> chosen;
    Eigen::VectorXd S_of_best(m);
    while (chosen.size() < most) {
        Eigen::Index best = -1;
        double best_drop = -1;
        for (Eigen::Index k = 0; k < m; ++k) {
            const double gain = drop[k] / (std::max(S[k], 0.0) + rows[static_cast<size_t>(k)].variance_m2);
            if (drop[k] >= 0 && gain > best_drop)
                best_drop = gain, best = k;
        }
        chosen.push_back(static_cast<int>(best));
        const Eigen::VectorXd g = G.col(best);
        const double total = std::max(S[best], 0.0) + rows[static_cast<size_t>(best)].variance_m2;
        // |G_k - g s_k / total|^2 from products with g alone.
        const Eigen::VectorXd g_dot_G = G.transpose() * g;
        const double g2 = g.squaredNorm();
        for (Eigen::Index k = 0; k < m; ++k) {
            const double s = project(rows[static_cast<size_t>(k)], g) / total;
            S_of_best[k] = s;
            if (drop[k] >= 0)
                drop[k] = std::max(drop[k] - 2 * s * g_dot_G[k] + s * s * g2, 0.0);
            S[k] -= s * s * total;
        }
        G.noalias() -= g * S_of_best.transpose();
        drop[best] = -1;
    }
    return chosen;
}

/// One candidate of the lazy choice: its variance given the first `seen` of the chosen rows, and its
/// coordinates along them.
struct Candidate {
    double variance = 0;
    std::vector<double> along;
};

class LazyLogDet {
public:
    LazyLogDet(const std::vector<RangeRow>& rows, const Eigen::MatrixXd& G)
        : rows_(rows), G_(G), candidates_(rows.size()) {
        for (size_t k = 0; k < rows.size(); ++k) {
            candidates_[k].variance = project(rows[k], G.col(static_cast<Eigen::Index>(k)));
            queue_.push({gain(k), k});
        }
    }

    std::vector<int> choose(size_t most) {
        while (chosen_.size() < most) {
            const auto [old_gain, k] = queue_.top();
            queue_.pop();
            // Submodular: a gain only falls, so one that is up to date and still the largest is the largest.
            if (candidates_[k].along.size() == chosen_.size())
                chosen_.push_back(static_cast<int>(k));
            else {
                bringUpToDate(k);
                queue_.push({gain(k), k});
            }
        }
        return chosen_;
    }

private:
    double gain(size_t k) const { return candidates_[k].variance / rows_[k].variance_m2; }

    /// A Cholesky factorisation of S + R of the chosen rows, row by row as asked for.
    void bringUpToDate(size_t k) {
        Candidate& it = candidates_[k];
        for (size_t c = it.along.size(); c < chosen_.size(); ++c) {
            const auto j = static_cast<size_t>(chosen_[c]);
            const Candidate& other = candidates_[j];
            double shared = project(rows_[k], G_.col(static_cast<Eigen::Index>(j)));
            for (size_t i = 0; i < c; ++i)
                shared -= it.along[i] * other.along[i];
            const double along = shared / std::sqrt(std::max(other.variance, 0.0) + rows_[j].variance_m2);
            it.along.push_back(along);
            it.variance -= along * along;
        }
    }

    const std::vector<RangeRow>& rows_;
    const Eigen::MatrixXd& G_;
    std::vector<Candidate> candidates_;
    std::priority_queue<std::pair<double, size_t>> queue_;
    std::vector<int> chosen_;
};

}  // namespace

std::optional<SelectionRule> selectionRuleFromText(const std::string& text) {
    if (text == "ratio")
        return SelectionRule::kRatio;
    if (text == "trace")
        return SelectionRule::kTrace;
    if (text == "log-det")
        return SelectionRule::kLogDet;
    return std::nullopt;
}

std::vector<int> selectRows(const FreePoints& points, const std::vector<RangeRow>& rows, size_t most,
                            SelectionRule rule) {
    most = std::min(most, rows.size());
    const Eigen::MatrixXd G = placesByRows(points, rows);
    switch (rule) {
        case SelectionRule::kRatio:
            return byRatio(rows, G, most);
        case SelectionRule::kTrace:
            return byTrace(rows, G, most);
        case SelectionRule::kLogDet:
            return LazyLogDet(rows, G).choose(most);
    }
    return {};
}

size_t shareOf(size_t count, double share) {
    if (count == 0)
        return 0;
    const auto part = static_cast<size_t>(std::lround(share * static_cast<double>(count)));
    return std::clamp<size_t>(part, 1, count);
}

}  // namespace noctule::cooperative
