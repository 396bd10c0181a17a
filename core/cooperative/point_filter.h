// SPDX-License-Identifier: Apache-2.0
// Welch 2018 as a filter of several users: which ranges of a step are used, and what of the aggregate
// covariance is kept. Where the paper cannot be followed its letter is an option; README.md says why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/cooperative/range_selection.h"

namespace noctule::cooperative {

enum class PointMethod {
    kComocap,      ///< section 3.2: room, own and partners' ranges
    kMsComocap,    ///< section 3.3: of those, a share
    kEnvironment,  ///< the room's ranges alone, the conventional filter the paper compares with
    kOwn,          ///< the room's and each user's own ranges
};
/// "comocap", "ms-comocap", "environment", "own".
std::optional<PointMethod> pointMethodFromText(const std::string& text);

struct PointFilterSettings {
    PointMethod method = PointMethod::kComocap;
    double q_m2_per_s3 = 0.3;  ///< 0.03 a calm handshake, 0.3 a dance; larger: follows faster, smooths less
    double share = 1;          ///< of the ranges of a step that are used, 0 to 1; kMsComocap: the paper's 2/3
    SelectionRule rule = SelectionRule::kRatio;
    /// The paper's letter: an unchosen range has its innovation zeroed but still shrinks the covariance.
    /// Otherwise its row is left out.
    bool keeps_unchosen_rows = false;
    /// The paper's letter: covariances between reference users are not kept.
    bool drops_reference_covariance = false;
};

/// The paper to the letter.
PointFilterSettings welchSettings(PointMethod method, double q_m2_per_s3);

class PointFilter {
public:
    /// `user_of_point`: 0, 1, ... of each point.
    PointFilter(const PointFilterSettings& settings, FreePoints start, std::vector<int> user_of_point,
                std::vector<Vector3d> anchors_m);

    void predict(double dt_s) { cooperative::predict(points_, dt_s, settings_.q_m2_per_s3); }
    /// Section 3.2 with `target` as the target user; ranges that do not touch one of its points are as
    /// welcome. Returns how many rows were used.
    size_t correct(const std::vector<PointRange>& ranges, int target);

    const FreePoints& points() const { return points_; }
    FreePoints& points() { return points_; }  ///< for lost points, which are placed from outside
    int users() const { return users_; }

private:
    bool takes(const PointRange& range) const;
    void forgetReferences(int target);

    PointFilterSettings settings_;
    FreePoints points_;
    std::vector<int> user_of_point_;
    std::vector<Vector3d> anchors_m_;
    int users_ = 0;
};

/// The pairs of equation 10 for one target: its points with the room, with each other both ways, and with all
/// points of the others; distances and variances are left to the caller.
std::vector<PointRange> pairsOfTarget(const std::vector<int>& user_of_point, int anchors, int target);

}  // namespace noctule::cooperative
