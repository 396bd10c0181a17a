// SPDX-License-Identifier: Apache-2.0
// Reading: files of other programs and odd but valid texts.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/job/atomic_file.h"
#include "core/math/rotation.h"
#include "tests/core/formats/bvh_texts.h"

namespace noctule {
namespace {

using test::changed, test::kSmall, test::parsed;

const std::string kShared = NOCTULE_SOURCE_DIR "/../shared/data/bvh/";

bool sameContent(const BvhDocument& a, const BvhDocument& b) {
    const auto sameJoint = [](const BvhJoint& x, const BvhJoint& y) {
        return x.name == y.name && x.parent == y.parent && x.offset == y.offset && x.channels == y.channels &&
               x.end_site == y.end_site;
    };
    return a.values == b.values && a.frame_time_s == b.frame_time_s &&
           std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(), sameJoint);
}

struct KnownFile {
    const char* path;
    size_t joints, channels, declared_frames, frames;
    double frame_time_s;
    BvhUnit unit;
};

/// How GoogleTest names the case.
void PrintTo(const KnownFile& file, std::ostream* out) {
    *out << file.path;
}

class BvhFiles : public testing::TestWithParam<KnownFile> {};

TEST_P(BvhFiles, HasTheKnownShape) {
    const KnownFile& known = GetParam();
    if (!std::filesystem::exists(kShared + known.path))
        GTEST_SKIP() << kShared << known.path << " is missing";
    const Result<BvhDocument> read = readBvh(kShared + known.path);
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(read->joints.size(), known.joints);
    EXPECT_EQ(read->channel_count, known.channels);
    EXPECT_EQ(read->declared_frames, known.declared_frames);
    EXPECT_EQ(read->frameCount(), known.frames);
    EXPECT_EQ(read->frame_time_s, known.frame_time_s);
    EXPECT_EQ(read->warnings.empty(), known.frames == known.declared_frames);
    EXPECT_EQ(toText(chooseUnit(*read).unit), toText(known.unit)) << chooseUnit(*read).height_m;
    const Result<MotionClip> clip = toClip(*read);
    ASSERT_TRUE(clip.ok()) << clip.error().text();
    EXPECT_EQ(clip->frames.size(), known.frames);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, BvhFiles,
    testing::Values(
        KnownFile{"cmu/02_01.bvh", 31, 96, 343, 343, 0.008333, BvhUnit::kCmu},
        KnownFile{"cmu/05_06.bvh", 31, 96, 885, 885, 0.008333, BvhUnit::kCmu},
        KnownFile{"cmu/Boxing_Toes.bvh", 21, 66, 3069, 3070, 0.01, BvhUnit::kCentimetre},
        KnownFile{"cmu/131_01.bvh", 31, 96, 994, 994, .0083333, BvhUnit::kCmu},
        KnownFile{"cmu/01_01_hop_turn.bvh", 31, 96, 2752, 2752, .0083333, BvhUnit::kCmu},
        KnownFile{"cmu/pair_salsa/60_05_scaled.bvh", 43, 132, 1678, 1678, 0.008333, BvhUnit::kMetre},
        KnownFile{"cmu/pair_salsa/61_05_scaled.bvh", 43, 132, 1678, 1678, 0.008333, BvhUnit::kMetre},
        KnownFile{"peers/pybvh/bvh_data__standard_skeleton.bvh", 24, 75, 1, 1, 0.008333, BvhUnit::kInch},
        KnownFile{"peers/pybvh/bvh_data__bvh_test3.bvh", 60, 183, 100, 100, 0.008333, BvhUnit::kInch},
        KnownFile{"peers/pybvh/bvh_data__bvh_test2.bvh", 23, 72, 61, 61, 0.008333, BvhUnit::kCentimetre},
        KnownFile{"peers/pybvh/tests__fixtures__rotation_first_root.bvh", 4, 15, 4, 4, 0.04, BvhUnit::kCmu},
        KnownFile{"peers/pybvh/tests__fixtures__full_precision_frame_time.bvh", 2, 9, 3, 3, 0.0417083750417,
                  BvhUnit::kDecimetre},
        KnownFile{"peers/pybvh/bvh_data__bvh_test1.bvh", 24, 75, 75, 75, 0.033333, BvhUnit::kInch},
        KnownFile{"peers/pybvh/bvh_data__bvh_example.bvh", 24, 75, 75, 75, 0.033333, BvhUnit::kInch},
        KnownFile{"peers/makehuman/dance1.bvh", 75, 228, 1, 1, 0.041667, BvhUnit::kDecimetre},
        KnownFile{"peers/makehuman/benchmark.bvh", 163, 891, 1, 1, 0.041667, BvhUnit::kDecimetre},
        KnownFile{"peers/makehuman/zombieWalk1.bvh", 75, 228, 31, 31, 0.041667, BvhUnit::kDecimetre},
        KnownFile{"peers/makehuman/walk1.bvh", 75, 228, 14, 14, 0.041667, BvhUnit::kDecimetre},
        KnownFile{"peers/makehuman/face-poseunits.bvh", 163, 492, 60, 60, 0.041667, BvhUnit::kDecimetre},
        KnownFile{"peers/makehuman/tpose.bvh", 173, 951, 1, 1, 0.041667, BvhUnit::kDecimetre},
        KnownFile{"peers/bvh-toolbox/walk01.bvh", 19, 60, 101, 101, 0.0416667, BvhUnit::kCentimetre},
        KnownFile{"peers/bvh-toolbox/test_freebvh.bvh", 55, 168, 69, 69, 0.0333333, BvhUnit::kCentimetre},
        KnownFile{"peers/bvh-toolbox/test_mocapbank.bvh", 19, 60, 455, 455, 0.033333, BvhUnit::kCentimetre}));

TEST(Bvh, PositionsEqualThoseOfAnIndependentProgram) {
    const std::string folder = kShared + "peers/bvh-toolbox/";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << folder << " is missing";
    const MotionClip clip = toClip(readBvh(folder + "walk01.bvh").value(), BvhUnit::kCentimetre).value();

    std::ifstream table(folder + "walk01_pos.csv");
    std::string line, cell;
    ASSERT_TRUE(std::getline(table, line));
    std::vector<std::string> columns;
    for (std::istringstream header(line); std::getline(header, cell, ',');)
        columns.push_back(cell);
    ASSERT_EQ(columns.size(), 1u + 3 * 24);  // 19 joints and 5 end sites
    size_t rows = 0;
    for (; std::getline(table, line); ++rows) {
        const GlobalPose global = globalPose(clip, rows);
        std::istringstream cells(line);
        std::getline(cells, cell, ',');
        for (size_t c = 1; std::getline(cells, cell, ','); ++c) {
            std::string name = columns[c].substr(0, columns[c].size() - 2);
            const bool tip = name.ends_with("_End");
            if (tip)
                name.resize(name.size() - 4);
            const int joint = clip.skeleton.find(name);
            ASSERT_GE(joint, 0) << name;
            const size_t j = static_cast<size_t>(joint);
            Vector3d p_m = global.p_world_joint[j];
            if (tip)
                p_m += global.q_world_joint[j] * clip.skeleton.joint(joint).end_m.value();
            const int axis = columns[c].back() - 'x';
            ASSERT_NEAR(p_m[axis] * 100, std::stod(cell), 1e-4) << columns[c] << " in row " << rows;
        }
    }
    EXPECT_EQ(rows, clip.frames.size());
}

TEST(Bvh, SaysThatTheBoxerHasARowMore) {
    const std::string path = "/usr/share/assimp/models/BVH/Boxing_Toes.bvh";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << path << " is missing (package assimp-testmodels)";
    const BvhDocument document = readBvh(path).value();
    EXPECT_EQ(document.name, "Boxing_Toes");
    EXPECT_EQ(document.frameCount(), 3070u);
    ASSERT_EQ(document.warnings.size(), 1u);
    EXPECT_EQ(document.warnings[0].line, 128u);
    EXPECT_EQ(document.warnings[0].text, "Frames is 3069, but 3070 complete rows follow; these are used");
    EXPECT_EQ(document.values.capacity(), document.values.size());  // one row more costs no second block
}

TEST(Bvh, HoldsAllThatTheTextSays) {
    const BvhDocument document = parsed(kSmall);
    ASSERT_EQ(document.joints.size(), 2u);
    EXPECT_EQ(document.joints[0].name, "Hips");
    EXPECT_EQ(document.joints[0].parent, -1);
    EXPECT_EQ(document.joints[0].offset, Vector3d(0, 90, 0));
    EXPECT_FALSE(document.joints[0].end_site);
    EXPECT_EQ(document.joints[1].parent, 0);
    EXPECT_EQ(document.joints[1].first_channel, 6u);
    EXPECT_EQ(document.joints[1].channels,
              (std::vector{BvhChannel::kZrotation, BvhChannel::kXrotation, BvhChannel::kYrotation}));
    EXPECT_EQ(*document.joints[1].end_site, Vector3d(0, 20, 0));
    EXPECT_EQ(document.frame_time_s, 0.01);
    EXPECT_EQ(document.values,
              (std::vector<double>{1, 2, 3, 10, 20, 30, 40, 50, 60, 4, 5, 6, 11, 21, 31, 41, 51, 61}));
    EXPECT_TRUE(document.warnings.empty());
}

TEST(Bvh, LayoutAndCaseDoNotMatter) {
    const BvhDocument plain = parsed(kSmall);
    std::string crlf, cr, tabs, lower;
    for (const char c : kSmall) {
        crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
        tabs += c == ' ' ? std::string(" \t  ") : std::string(1, c);
    }
    for (const std::string& text : {crlf, cr, "\xEF\xBB\xBF" + kSmall, kSmall + "\n\n  \n", "\n \n" + kSmall,
                                    kSmall.substr(0, kSmall.size() - 1),
                                    changed("ROOT Hips\n{", "ROOT Hips {"), changed("MOTION\n", "MOTION\n\n"),
                                    changed("Frames: 2", "frames :2"), changed("Frame Time: ", "FRAME TIME:"),
                                    changed("19\n", "19\n", kSmall + "19\n").substr(0, kSmall.size()),
                                    changed("HIERARCHY", "hierarchy"), changed("Zrotation", "ZROTATION"),
                                    changed("End Site", "end site"), changed("1 2 3 10", "+1 2.0 3e0 1.0E+1"),
                                    changed("0 20 0\n    }", "0 20 0 }"), changed("\n4 5", "  \n\n4 5")})
        EXPECT_TRUE(sameContent(parsed(text), plain)) << text;
    tabs = tabs.replace(tabs.find("End \t  Site"), 11, "End\tSite");
    EXPECT_TRUE(sameContent(parsed(tabs), plain));
}

TEST(Bvh, NamesMayHoldColonsDotsAndBlanks) {
    for (const std::string name :
         {"mixamorig:LeftArm", "upperarm.L", "Bip01 L Thigh", "JOINT", "\xC3\xA9paule"})
        EXPECT_EQ(parsed(changed("Head", name)).joints[1].name, name);
}

TEST(Bvh, RepeatedNamesAreToldApartWithAWarning) {
    const BvhDocument document = parsed(changed("Head", "Hips"));
    EXPECT_EQ(document.joints[1].name, "Hips_2");
    ASSERT_EQ(document.warnings.size(), 1u);
    EXPECT_EQ(document.warnings[0].line, 6u);
    EXPECT_TRUE(toClip(document).ok());
}

TEST(Bvh, RotationsComposeInFileOrderWhereverPositionsStand) {
    const std::string text = changed("Xposition Yposition Zposition Zrotation Xrotation Yrotation",
                                     "Yrotation Zposition Xrotation Xposition Zrotation Yposition");
    const MotionClip clip = toClip(parsed(text), BvhUnit::kCentimetre).value();
    EXPECT_LT((clip.frames[0].p_world_root - Vector3d(0.10, 0.30, 0.02)).norm(), 1e-15);
    EXPECT_LT(angleBetween(clip.frames[0].q_parent_joint[0],
                           rotationFromEuler(kEulerYXZ, {radians(1), radians(3), radians(20)})),
              1e-12);
    EXPECT_LT(angleBetween(clip.frames[1].q_parent_joint[1],
                           rotationFromEuler(kEulerZXY, {radians(41), radians(51), radians(61)})),
              1e-12);
}

TEST(Bvh, PositionChannelsReplaceTheOffset) {
    const std::string text =
        changed("CHANNELS 3 Zrotation Xrotation Yrotation", "CHANNELS 2 Yposition Zrotation",
                changed("40 50 60", "70 90", changed("41 51 61", "60 0")));
    const MotionClip clip = toClip(parsed(text), BvhUnit::kCentimetre).value();
    ASSERT_EQ(clip.p_parent_joint_m.size(), 2u);
    EXPECT_LT((clip.p_parent_joint_m[0][1] - Vector3d(0, 0.7, 0)).norm(), 1e-15);
    const GlobalPose global = globalPose(clip, 0);
    EXPECT_NEAR((global.p_world_joint[1] - global.p_world_joint[0]).norm(), 0.7, 1e-15);
    EXPECT_LT((global.p_world_joint[0] - Vector3d(0.01, 0.02, 0.03)).norm(), 1e-15);
    EXPECT_LT(angleBetween(clip.frames[0].q_parent_joint[1], axisAngle(Vector3d::UnitZ(), radians(90))),
              1e-12);
}

TEST(Bvh, PositionChannelsThatRepeatTheOffsetAreNoMotion) {
    const std::string text = changed("CHANNELS 3 Zrotation Xrotation Yrotation", "CHANNELS 1 Yposition",
                                     changed("40 50 60", "60", changed("41 51 61", "60.0")));
    EXPECT_TRUE(toClip(parsed(text), BvhUnit::kCentimetre)->p_parent_joint_m.empty());
}

TEST(Bvh, AJointMayHaveNoChannels) {
    const std::string rows = changed(" 40 50 60", "", changed(" 41 51 61", ""));
    for (const char* line : {"    CHANNELS 0\n", ""}) {
        const BvhDocument document =
            parsed(changed("    CHANNELS 3 Zrotation Xrotation Yrotation\n", line, rows));
        EXPECT_EQ(document.channel_count, 6u);
        EXPECT_EQ(toClip(document)->frames[1].q_parent_joint[1].w(), 1);
    }
}

TEST(Bvh, ALongRowIsReadWhole) {
    std::string text = "HIERARCHY\nROOT j0\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n",
                row = "1 1 1";
    for (int j = 1; j < 400; ++j) {
        text +=
            "JOINT j" + std::to_string(j) + "\n{\nOFFSET 0 1 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n";
        row += " 2 2 2";
    }
    for (int j = 0; j < 400; ++j)
        text += "}\n";
    const BvhDocument document = parsed(text + "MOTION\nFrames: 1\nFrame Time: 0.04\n" + row);
    EXPECT_EQ(document.channel_count, 1200u);
    EXPECT_EQ(document.values.back(), 2);
}

TEST(Bvh, TheUnitFollowsFromTheHeight) {
    BvhDocument figure = parsed(kSmall);
    const auto choiceAt = [&](double height) {
        figure.joints[1].offset = Vector3d(0, height * 2 / 3, 0);
        figure.joints[1].end_site = Vector3d(0, height / 3, 0);
        return chooseUnit(figure);
    };
    for (const auto& [height, word] :
         {std::pair(1.75, "m"), {175.0, "cm"}, {1750.0, "mm"}, {69.0, "inch"}, {31.0, "cmu"}, {17.5, "dm"}}) {
        EXPECT_EQ(toText(choiceAt(height).unit), word);
        EXPECT_TRUE(choiceAt(height).plausible);
        EXPECT_NEAR(choiceAt(height).height_m, 1.75, 0.01);
        EXPECT_NEAR(toClip(figure)->skeleton.joint(1).offset_m.y(), 1.75 * 2 / 3, 0.01);
    }
    EXPECT_EQ(toText(choiceAt(100).unit), "cm");  // a child rather than a giant in inches
    EXPECT_FALSE(choiceAt(100).plausible);
    EXPECT_FALSE(choiceAt(8).plausible);
    EXPECT_FALSE(choiceAt(0).plausible);
}

TEST(Bvh, PlacesGivenByPositionChannelsCountForTheHeight) {
    BvhDocument figure =
        parsed(changed("CHANNELS 3 Zrotation Xrotation Yrotation", "CHANNELS 3 Xposition Yposition Zposition",
                       changed("40 50 60", "0 170 0")));
    figure.joints[1].offset.setZero();
    EXPECT_EQ(chooseUnit(figure).unit, BvhUnit::kCentimetre);
    EXPECT_TRUE(chooseUnit(figure).plausible);
}

TEST(Bvh, UnitsHaveTheirWords) {
    for (const BvhUnit unit : {BvhUnit::kMetre, BvhUnit::kCentimetre, BvhUnit::kMillimetre, BvhUnit::kInch,
                               BvhUnit::kCmu, BvhUnit::kDecimetre, BvhUnit::kAuto})
        EXPECT_EQ(bvhUnitFromText(toText(unit)).value(), unit);
    EXPECT_NEAR(metresPer(BvhUnit::kCmu), 0.05644, 1e-5);
    EXPECT_EQ(bvhUnitFromText("foot").error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace noctule
