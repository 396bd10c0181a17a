// SPDX-License-Identifier: Apache-2.0
// The motions of ../shared/data/field: one walk in the dialects that people reported trouble with.
#include <filesystem>

#include "tests/core/figure/dialects.h"

namespace noctule::figure {
namespace {

const std::string kField = NOCTULE_SOURCE_DIR "/../shared/data/field/";

Result<UnderstoodMotion> readField(const std::string& name, const MotionHints& hints = {}) {
    Result<BvhDocument> document = readBvh(kField + name);
    EXPECT_TRUE(document) << (document ? "" : document.error().text());
    return understandMotion(std::move(document).value(), hints);
}

bool saysAny(const UnderstoodMotion& motion, const std::string& words) {
    for (const auto& list : {motion.notes, motion.warnings})
        for (const std::string& sentence : list)
            if (sentence.find(words) != std::string::npos)
                return true;
    return false;
}

class FieldMotion : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(kField))
            GTEST_SKIP() << "no folder " << kField;
    }
};

/// Mean bone direction below 1 degree, no bone more than 4, the lengths of the README.
TEST_P(FieldMotion, IsTheSamePerformance) {
    static const Performed base = perform(readField("base.bvh").value());
    const Result<UnderstoodMotion> motion = readField(GetParam());
    ASSERT_TRUE(motion) << motion.error().text();
    const Performed performed = perform(*motion);
    const Difference difference = differenceOf(base, performed);
    std::printf("%-28s mean %.3f deg, worst %s %.2f deg; %s\n", GetParam(), difference.mean_deg,
                difference.worst.c_str(), difference.worst_deg, describe(*motion).c_str());
    for (const auto& list : {motion->notes, motion->warnings})
        for (const std::string& sentence : list)
            std::printf("    %s\n", sentence.c_str());
    EXPECT_EQ(base.poses.size(), performed.poses.size());
    EXPECT_LT(difference.mean_deg, 1);
    EXPECT_LT(difference.worst_deg, 4) << difference.worst;
    EXPECT_NEAR(motion->measures.height_m, 1.84, 0.006);
    EXPECT_NEAR(motion->measures.shoulder_width_m, 0.36, 0.005);
    EXPECT_NEAR(motion->measures.forearm_m, 0.25, 0.002);
    EXPECT_NEAR(motion->measures.shin_m, 0.41, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Files, FieldMotion,
                         testing::Values("base.bvh", "z_up_blender.bvh", "bones_along_x.bvh",
                                         "zero_pose_toes_down.bvh", "zero_pose_sitting.bvh",
                                         "zero_pose_a.bvh", "names_biped.bvh", "names_lower_case.bvh",
                                         "names_asf.bvh", "names_rigify_def.bvh", "names_robot_prefix.bvh",
                                         "names_japanese.bvh", "names_smpl.bvh", "reference_12_m_away.bvh",
                                         "dropouts_zero_rows.bvh"));

TEST_F(FieldMotion, AChildStaysAChildAndIsToldOf) {
    const UnderstoodMotion motion = readField("child_85_cm.bvh").value();
    EXPECT_NEAR(motion.measures.height_m, 0.90, 0.01);
    EXPECT_TRUE(saysAny(motion, "--height M"));
    MotionHints hints;
    hints.height_m = 1.84;
    EXPECT_NEAR(readField("child_85_cm.bvh", hints)->measures.forearm_m, 0.25, 0.001);
}

TEST_F(FieldMotion, LostFramesAreCounted) {
    const UnderstoodMotion motion = readField("dropouts_zero_rows.bvh").value();
    EXPECT_EQ(motion.lost.bridged, 4u);
    EXPECT_EQ(motion.lost.longest, 3u);
    EXPECT_TRUE(saysAny(motion, "lost in 4 frames"));
}

TEST_F(FieldMotion, ZUpIsFoundAndSaid) {
    const UnderstoodMotion motion = readField("z_up_blender.bvh").value();
    EXPECT_EQ(motion.up, UpAxis::kZ);
    EXPECT_TRUE(saysAny(motion, "+Z points up"));
    MotionHints hints;
    hints.up = UpAxis::kY;
    EXPECT_TRUE(saysAny(readField("z_up_blender.bvh", hints).value(), "--up z"));
}

}  // namespace
}  // namespace noctule::figure
