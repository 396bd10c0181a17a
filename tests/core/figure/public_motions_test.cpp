// SPDX-License-Identifier: Apache-2.0
// Every motion of the public sets in ../shared/data/bvh: understood rightly, or refused with a reason.
#include <filesystem>
#include <set>

#include "tests/core/figure/dialects.h"

namespace noctule::figure {
namespace {

/// Files that hold no whole person: parts of a figure for tests of readers.
const std::set<std::string> kNoPersons = {"tests__fixtures__full_precision_frame_time.bvh",
                                          "tests__fixtures__rotation_first_root.bvh"};

/// Files whose figure stands along Z, as the places of its feet and head say.
bool standsAlongZ(const std::filesystem::path& path) {
    static const std::set<std::string> pybvh = {"bvh_data__bvh_example.bvh", "bvh_data__bvh_test1.bvh",
                                                "bvh_data__bvh_test3.bvh", "bvh_data__standard_skeleton.bvh"};
    return path.parent_path().filename() == "makehuman" || pybvh.contains(path.filename().string());
}

TEST(PublicMotions, AreUnderstoodOrRefusedWithAReason) {
    const std::string folder = NOCTULE_SOURCE_DIR "/../shared/data/bvh";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no folder " << folder;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".bvh")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& path : files) {
        const std::string name = path.filename().string();
        Result<BvhDocument> document = readBvh(path.string());
        ASSERT_TRUE(document) << document.error().text();
        const auto motion = understandMotion(std::move(document).value());
        if (kNoPersons.contains(name)) {
            ASSERT_FALSE(motion) << name;
            EXPECT_NE(motion.error().text().find("--bones"), std::string::npos);
            std::printf("%-48s refused: %s\n", name.c_str(), motion.error().message.c_str());
            continue;
        }
        ASSERT_TRUE(motion) << name << ": " << motion.error().text();
        std::printf("%s\n", describe(*motion).c_str());
        for (const auto& list : {motion->notes, motion->warnings})
            for (const std::string& sentence : list)
                std::printf("    %s\n", sentence.c_str());
        EXPECT_EQ(toText(motion->up), standsAlongZ(path) ? "+Z" : "+Y") << name;
        EXPECT_GT(motion->measures.height_m, 1.2) << name;
        EXPECT_LT(motion->measures.height_m, 2.3) << name;
        EXPECT_TRUE(missingMainJoints(motion->joints).empty()) << missingMainJoints(motion->joints).front();
        for (const std::string& warning : motion->warnings)
            EXPECT_EQ(warning.find("exchanged"), std::string::npos) << name << ": " << warning;
    }
}

/// Limbs of a public motion with all bones along one axis point where they did. Its T pose is lost with the
/// frames, and with it how far collar bones, hips and spine are from it: these differ by what they are bent
/// in the T pose, and are printed.
TEST(PublicMotions, KeepTheirLimbsWithAllBonesAlongX) {
    const std::string folder = NOCTULE_SOURCE_DIR "/../shared/data/bvh/";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no folder " << folder;
    for (const char* name : {"cmu/02_01.bvh", "peers/bvh-toolbox/walk01.bvh", "cmu/131_01.bvh"}) {
        const UnderstoodMotion motion = understandMotion(readBvh(folder + name).value()).value();
        const Performed plain = perform(motion);
        const UnderstoodMotion other = understood(alongAxis(
            motion.clip, Vector3d::UnitX(), [](int) { return 0.0; }, true));
        const Difference difference = differenceOf(plain, perform(other));
        std::printf("%s: mean %.2f deg, worst %s %.2f deg\n", name, difference.mean_deg,
                    difference.worst.c_str(), difference.worst_deg);
        for (const auto& [bone, deg] : difference.bones_deg)
            if (deg > 5)
                std::printf("    %s %.1f deg\n", bone.c_str(), deg);
        for (const std::string side : {"Left", "Right"})
            for (const char* bone : {"ForeArm", "Hand", "Leg", "Foot"})
                EXPECT_LT(difference.bones_deg.at(side + bone), 4) << name << ": " << side << bone;
    }
}

}  // namespace
}  // namespace noctule::figure
