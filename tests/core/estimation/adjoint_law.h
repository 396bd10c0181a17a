// SPDX-License-Identifier: Apache-2.0
// The law that every linear change of errors must keep for a smoother to go back over it.
#pragma once

#include <gtest/gtest.h>

#include "tests/core/estimation/small_body.h"

namespace noctule::testing {

/// carryBack() is the adjoint of carry(), on matrices of `size` and on vectors.
template <class Shift>
void expectAdjoint(const Shift& shift, Eigen::Index size, Gaussian& random) {
    const auto symmetric = [&] {
        const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return random(1.0); });
        return Eigen::MatrixXd(A * A.transpose());
    };
    const Eigen::MatrixXd P = symmetric(), Lambda = symmetric();
    Eigen::MatrixXd carried = P, back = Lambda;
    shift.carry(carried);
    shift.carryBack(back);
    EXPECT_NEAR((Lambda * carried).trace(), (back * P).trace(), 1e-9 * (back * P).trace());
    const Eigen::VectorXd lambda = random.vector(size, 1);
    Eigen::VectorXd lambda_back = lambda;
    Eigen::MatrixXd square_back = lambda * lambda.transpose();
    shift.carryBack(lambda_back);
    shift.carryBack(square_back);
    EXPECT_LT((square_back - lambda_back * lambda_back.transpose()).norm(), 1e-9 * square_back.norm());
}

}  // namespace noctule::testing
