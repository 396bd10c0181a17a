// SPDX-License-Identifier: Apache-2.0
// The states of all steps of a take, kept in a file, each with a correction on trial; of the default suit 1.7
// MB a second.
#pragma once

#include "core/estimation/error_state.h"
#include "core/job/unnamed_file.h"

namespace noctule {

class TrajectorySpool {
public:
    /// Keeps references.
    TrajectorySpool(UnnamedFile file, const KinematicTree& tree, const StateLayout& layout)
        : file_(std::move(file)), tree_(tree), layout_(layout) {}

    int64_t size() const { return size_; }
    void add(const BodyState& state);
    /// With its correction times the share(); not after a failure, see good().
    BodyState at(int64_t index);
    void replace(int64_t index, const BodyState& state, const Eigen::VectorXd& correction);

    double share() const { return share_; }
    void setShare(double share) { share_ = share; }
    /// False once something could not be written or read back.
    bool good() const { return good_; }

private:
    void put(int64_t index, const BodyState& state, const Eigen::VectorXd& correction);

    UnnamedFile file_;
    const KinematicTree& tree_;
    const StateLayout& layout_;
    BodyState like_;  ///< for its sizes
    Eigen::VectorXd record_;
    int64_t size_ = 0;
    double share_ = 0;
    bool good_ = true;
};

}  // namespace noctule
