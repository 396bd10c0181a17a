// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/heading_shift.h"

namespace noctule {
namespace {

constexpr Eigen::Index kRotation = 3;  // of the root, after its place

}  // namespace

HeadingShift::HeadingShift(const MotionState& before, const MotionState& after, bool turns_place)
    : n_(before.rate.size()),
      turn_((after.q_parent_link[0].conjugate() * before.q_parent_link[0]).toRotationMatrix()),
      up_root_(before.q_parent_link[0].conjugate() * Vector3d::UnitY()),
      velocity_(Vector3d::UnitY().cross(after.rate.head<3>() - before.rate.head<3>())),
      acceleration_(Vector3d::UnitY().cross(after.accel.head<3>() - before.accel.head<3>())),
      turns_place_(turns_place),
      place_(Vector3d::UnitY().cross(after.p_world_root - before.p_world_root)) {}

void HeadingShift::carry(Eigen::MatrixXd& P) const {
    const auto left = [&](auto&& X) {
        const Eigen::RowVectorXd heading = up_root_.transpose() * X.template middleRows<3>(kRotation);
        if (turns_place_)
            X.template topRows<3>() += place_ * heading;
        X.template middleRows<3>(n_) += velocity_ * heading;
        X.template middleRows<3>(2 * n_) += acceleration_ * heading;
        X.template middleRows<3>(kRotation) = (turn_ * X.template middleRows<3>(kRotation)).eval();
    };
    left(P);
    left(P.transpose());
}

void HeadingShift::timesTransposed(Eigen::MatrixXd& C) const {
    const Eigen::VectorXd heading = C.middleCols<3>(kRotation) * up_root_;
    if (turns_place_)
        C.leftCols<3>() += heading * place_.transpose();
    C.middleCols<3>(n_) += heading * velocity_.transpose();
    C.middleCols<3>(2 * n_) += heading * acceleration_.transpose();
    C.middleCols<3>(kRotation) = (C.middleCols<3>(kRotation) * turn_.transpose()).eval();
}

void HeadingShift::carryBack(Eigen::VectorXd& lambda) const {
    double heading = velocity_.dot(lambda.segment<3>(n_)) + acceleration_.dot(lambda.segment<3>(2 * n_));
    if (turns_place_)
        heading += place_.dot(lambda.head<3>());
    lambda.segment<3>(kRotation) = turn_.transpose() * lambda.segment<3>(kRotation) + heading * up_root_;
}

void HeadingShift::carryBack(Eigen::MatrixXd& Lambda) const {
    const auto left = [&](auto&& X) {
        Eigen::RowVectorXd heading = velocity_.transpose() * X.template middleRows<3>(n_) +
                                     acceleration_.transpose() * X.template middleRows<3>(2 * n_);
        if (turns_place_)
            heading += place_.transpose() * X.template topRows<3>();
        X.template middleRows<3>(kRotation) =
            (turn_.transpose() * X.template middleRows<3>(kRotation)).eval() + up_root_ * heading;
    };
    left(Lambda);
    left(Lambda.transpose());
}

}  // namespace noctule
