// SPDX-License-Identifier: Apache-2.0
#include "core/math/euler_sequence.h"

#include <gtest/gtest.h>

#include <random>

#include "core/math/rotation.h"

namespace noctule {
namespace {

TEST(EulerSequence, ThereAreTwelveByName) {
    const auto names = eulerSequenceNames();
    EXPECT_EQ(names.size(), 12u);
    for (const std::string& name : names)
        EXPECT_TRUE(eulerSequenceNamed(name)) << name;
    EXPECT_EQ(eulerSequenceNamed("zxz"), (EulerSequence{2, 0, 2}));
    for (const char* wrong : {"", "XX", "XXY", "XYY", "ABC", "XYZX"})
        EXPECT_FALSE(eulerSequenceNamed(wrong)) << wrong;
}

TEST(EulerSequence, AnglesGiveTheRotationBackAndFollowThoseBefore) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-3, 3);
    std::normal_distribution<double> small(0, 0.01);
    for (const std::string& name : eulerSequenceNames()) {
        const EulerSequence sequence = *eulerSequenceNamed(name);
        for (int trial = 0; trial < 200; ++trial) {
            const Vector3d angles{any(random), any(random), any(random)};
            const Quaterniond q = rotationFromAngles(sequence, angles);
            const Vector3d other{any(random), any(random), any(random)};
            EXPECT_LT(angleBetween(rotationFromAngles(sequence, anglesFromRotation(sequence, q, other)), q),
                      1e-7)
                << name;
            const double middle = sequence.isProper() ? std::sin(angles[1]) : std::cos(angles[1]);
            const Vector3d near = angles + Vector3d{small(random), small(random), small(random)};
            if (std::abs(middle) > 0.3) {
                EXPECT_LT((anglesFromRotation(sequence, q, near) - angles).norm(), 1e-7) << name;
            }
        }
    }
}

TEST(EulerSequence, WhereTwoTurnsShareAnAxisTheFirstStays) {
    const EulerSequence zxz = *eulerSequenceNamed("ZXZ");
    const Quaterniond q = axisAngle(Vector3d::UnitZ(), 0.8);
    const Vector3d angles = anglesFromRotation(zxz, q, Vector3d(0.3, 0, 0));
    EXPECT_NEAR(angles[0], 0.3, 1e-9);
    EXPECT_NEAR(angles[1], 0, 1e-9);
    EXPECT_NEAR(angles[2], 0.5, 1e-9);
}

}  // namespace
}  // namespace noctule
