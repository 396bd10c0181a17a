// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/trajectory_spool.h"

namespace noctule {
void TrajectorySpool::put(int64_t index, const BodyState& state, const Eigen::VectorXd& correction) {
    double* place = record_.data();
    forEachNumber(state, [&](const double* numbers, Eigen::Index count) {
        place = std::copy_n(numbers, count, place);
    });
    std::copy_n(correction.data(), correction.size(), place);
    const auto bytes = sizeof(double) * static_cast<size_t>(record_.size());
    file_.seek(index * static_cast<int64_t>(bytes));
    file_.putBytes(record_.data(), bytes);
}

void TrajectorySpool::add(const BodyState& state) {
    if (size_ == 0) {
        like_ = state;
        Eigen::Index count = layout_.size;
        forEachNumber(state, [&](const double*, Eigen::Index more) { count += more; });
        record_.resize(count);
    }
    put(size_++, state, Eigen::VectorXd::Zero(layout_.size));
}

void TrajectorySpool::replace(int64_t index, const BodyState& state, const Eigen::VectorXd& correction) {
    put(index, state, correction);
}

BodyState TrajectorySpool::at(int64_t index) {
    const auto bytes = sizeof(double) * static_cast<size_t>(record_.size());
    file_.seek(index * static_cast<int64_t>(bytes));
    good_ = good_ && file_.takeBytes(record_.data(), bytes);
    BodyState state = like_;
    const double* place = record_.data();
    forEachNumber(state, [&](double* numbers, Eigen::Index count) {
        std::copy_n(place, count, numbers);
        place += count;
    });
    if (share_ != 0)
        addError(tree_, layout_, share_ * record_.tail(layout_.size), state);
    return state;
}

}  // namespace noctule
