// SPDX-License-Identifier: Apache-2.0
#include "core/math/symmetric_update.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

TEST(SymmetricUpdate, EqualsTheDenseProductForEverySize) {
    std::srand(3);
    for (long n : {1, 3, 4, 7, 8, 13, 45, 150, 243})
        for (long m : {1, 3, 18, 54}) {
            const Eigen::MatrixXd half = Eigen::MatrixXd::Random(n, n), X = Eigen::MatrixXd::Random(n, m);
            const Eigen::MatrixXd P = half * half.transpose();
            Eigen::MatrixXd updated = P;
            subtractOuterProduct(updated, X);
            EXPECT_LT((updated - (P - X * X.transpose())).cwiseAbs().maxCoeff(), 1e-11 * double(n))
                << n << " " << m;
            EXPECT_EQ((updated - updated.transpose()).cwiseAbs().maxCoeff(), 0) << n << " " << m;
        }
}

}  // namespace
}  // namespace noctule
