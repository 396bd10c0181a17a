// SPDX-License-Identifier: Apache-2.0
// Foot contacts and curves on the motions that Debian's assimp-testmodels installs.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/formats/bvh.h"
#include "core/motion/foot_contacts.h"
#include "core/processing/reference_motion.h"
#include "core/review/joint_curves.h"

namespace noctule {
namespace {

std::optional<TimedMotion> installed(const std::string& name) {
    const std::string path = "/usr/share/assimp/models/BVH/" + name;
    if (!std::filesystem::exists(path))
        return std::nullopt;
    const auto document = readBvh(path);
    const auto clip = document ? toClip(*document) : Result<MotionClip>(document.error());
    return clip ? std::optional(timedMotion(*clip)) : std::nullopt;
}

TEST(RealMotion, HopsAreContactsWithFlightsBetween) {
    const auto motion = installed("01_01.bvh");
    if (!motion)
        GTEST_SKIP() << "assimp-testmodels is not installed";
    const auto feet = findFootContacts(*motion);
    ASSERT_EQ(feet.size(), 2u);
    const double duration_s = static_cast<double>(motion->frames.back().time_ns) * 1e-9;
    for (const FootContacts& foot : feet) {
        EXPECT_GE(foot.contacts.size(), 5u) << foot.foot;
        double stood_s = 0;
        for (size_t i = 0; i < foot.contacts.size(); ++i) {
            EXPECT_GE(foot.contacts[i].to_s - foot.contacts[i].from_s, 0.079);
            EXPECT_LT(foot.contacts[i].slide_m, 0.12);
            if (i > 0) {
                EXPECT_GT(foot.contacts[i].from_s, foot.contacts[i - 1].to_s);
            }
            stood_s += foot.contacts[i].to_s - foot.contacts[i].from_s;
        }
        EXPECT_GT(stood_s, 0.15 * duration_s);
        EXPECT_LT(stood_s, 0.95 * duration_s);
    }
    EXPECT_LT(meanSlide_m(feet), 0.03);
}

TEST(RealMotion, NoCurveOfABallJumps) {
    const auto motion = installed("Boxing_Toes.bvh");
    if (!motion)
        GTEST_SKIP() << "assimp-testmodels is not installed";
    for (const CurveChoice& choice : curveChoices(motion->skeleton)) {
        const MotionCurve curve = motionCurve(*motion, choice);
        const std::vector<float>& value = curve.value.series().value;
        for (size_t i = 1; i < value.size(); ++i)
            ASSERT_LT(std::abs(value[i] - value[i - 1]), 185) << choice.joint << " " << choice.freedom;
    }
}

}  // namespace
}  // namespace noctule
