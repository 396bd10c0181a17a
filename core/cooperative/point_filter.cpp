// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/point_filter.h"

#include <algorithm>

#include "core/job/contract.h"

namespace noctule::cooperative {

std::optional<PointMethod> pointMethodFromText(const std::string& text) {
    if (text == "comocap")
        return PointMethod::kComocap;
    if (text == "ms-comocap")
        return PointMethod::kMsComocap;
    if (text == "environment")
        return PointMethod::kEnvironment;
    if (text == "own")
        return PointMethod::kOwn;
    return std::nullopt;
}

PointFilterSettings welchSettings(PointMethod method, double q_m2_per_s3) {
    PointFilterSettings settings;
    settings.method = method;
    settings.q_m2_per_s3 = q_m2_per_s3;
    settings.share = method == PointMethod::kMsComocap ? 2.0 / 3 : 1;
    settings.keeps_unchosen_rows = true;
    settings.drops_reference_covariance = true;
    return settings;
}

PointFilter::PointFilter(const PointFilterSettings& settings, FreePoints start,
                         std::vector<int> user_of_point, std::vector<Vector3d> anchors_m)
    : settings_(settings),
      points_(std::move(start)),
      user_of_point_(std::move(user_of_point)),
      anchors_m_(std::move(anchors_m)) {
    require(user_of_point_.size() == static_cast<size_t>(points_.count()),
            "PointFilter: a user for each point");
    for (const int user : user_of_point_)
        users_ = std::max(users_, user + 1);
}

bool PointFilter::takes(const PointRange& range) const {
    if (range.other < 0)
        return true;
    if (settings_.method == PointMethod::kEnvironment)
        return false;
    const auto user = [&](int point) { return user_of_point_[static_cast<size_t>(point)]; };
    return settings_.method != PointMethod::kOwn || user(range.point) == user(range.other);
}

size_t PointFilter::correct(const std::vector<PointRange>& ranges, int target) {
    if (settings_.drops_reference_covariance)
        forgetReferences(target);
    std::vector<PointRange> taken;
    std::copy_if(ranges.begin(), ranges.end(), std::back_inserter(taken),
                 [&](const PointRange& range) { return takes(range); });
    std::vector<RangeRow> rows = linearise(points_, anchors_m_, taken);
    size_t used = rows.size();
    if (settings_.share < 1 && !rows.empty()) {
        used = shareOf(rows.size(), settings_.share);
        std::vector<char> chosen(rows.size(), 0);
        for (const int k : selectRows(points_, rows, used, settings_.rule))
            chosen[static_cast<size_t>(k)] = 1;
        std::vector<RangeRow> kept;
        for (size_t k = 0; k < rows.size(); ++k) {
            if (!chosen[k] && settings_.keeps_unchosen_rows)
                rows[k].innovation_m = 0;  // below equation 17
            if (chosen[k] || settings_.keeps_unchosen_rows)
                kept.push_back(rows[k]);
        }
        rows = std::move(kept);
    }
    // Both are the same update. The gain costs in proportion to the rows, the other one hardly does.
    constexpr size_t kFewRows = 4;
    if (kFewRows * rows.size() < static_cast<size_t>(points_.p_m.size()))
        correctByGain(points_, rows);
    else
        cooperative::correct(points_, rows);
    return used;
}

/// Section 3: "We do not maintain error covariances between the reference user filters".
void PointFilter::forgetReferences(int target) {
    for (int i = 0; i < points_.count(); ++i)
        for (int j = 0; j < points_.count(); ++j) {
            const int a = user_of_point_[static_cast<size_t>(i)], b = user_of_point_[static_cast<size_t>(j)];
            if (a == b || a == target || b == target)
                continue;
            points_.cov_pp.block<3, 3>(3 * i, 3 * j).setZero();
            points_.cov_pv.block<3, 3>(3 * i, 3 * j).setZero();
            points_.cov_vv.block<3, 3>(3 * i, 3 * j).setZero();
        }
}

std::vector<PointRange> pairsOfTarget(const std::vector<int>& user_of_point, int anchors, int target) {
    std::vector<PointRange> pairs;
    const int count = static_cast<int>(user_of_point.size());
    for (int i = 0; i < count; ++i) {
        if (user_of_point[static_cast<size_t>(i)] != target)
            continue;
        for (int k = 0; k < anchors; ++k)
            pairs.push_back({i, anchorPoint(k), 0, 0});
        for (int j = 0; j < count; ++j)
            if (j != i)
                pairs.push_back({i, j, 0, 0});
    }
    return pairs;
}

}  // namespace noctule::cooperative
