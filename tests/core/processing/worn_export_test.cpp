// SPDX-License-Identifier: Apache-2.0
// A take on the body of another program, as files, pictures and films: written, read again, held against the
// take by a check of its own, which sees what is wrong.
#include <unistd.h>

#include "core/job/atomic_file.h"
#include "core/media/picture_file.h"
#include "core/media/video_file.h"
#include "core/processing/check_export.h"
#include "tests/core/processing/made_export.h"
#include "tests/support/named_rig.h"

namespace noctule {
namespace {

/// As the body is, and neither ground nor axes are.
bool isGrey(const uint8_t* rgba) {
    return rgba[0] > 70 && std::abs(rgba[0] - rgba[2]) < 35;
}

/// Faces +X in its file, in an A pose, under Rigify's names.
std::shared_ptr<const WearableBody> sidewaysBody() {
    const std::map<std::string, std::string> trunk{{"Hips", "spine"},
                                                   {"Spine", "spine.001"},
                                                   {"Chest", "spine.003"},
                                                   {"Neck", "spine.004"},
                                                   {"Head", "spine.006"}};
    const std::map<std::string, std::string> limbs{
        {"Shoulder", "shoulder"}, {"Arm", "upper_arm"}, {"ForeArm", "forearm"}, {"Hand", "hand"},
        {"UpLeg", "thigh"},       {"Leg", "shin"},      {"Foot", "foot"},       {"ToeBase", "toe"}};
    RiggedMesh rig = test::namedRig(
        [&](const std::string& joint) {
            for (const std::string side : {"Left", "Right"})
                if (joint.starts_with(side))
                    return limbs.at(joint.substr(side.size())) + "." + side[0];
            return trunk.at(joint);
        },
        [](const std::string& joint) {
            return joint == "Hips"       ? axisAngle(Vector3d::UnitY(), M_PI / 2)
                   : joint == "LeftArm"  ? axisAngle(Vector3d::UnitZ(), -0.8)
                   : joint == "RightArm" ? axisAngle(Vector3d::UnitZ(), 0.8)
                                         : Quaterniond::Identity();
        },
        0.6, axisAngle(Vector3d(2, 1, 0).normalized(), 0.9));
    test::giveSkin(rig);
    return std::make_shared<const WearableBody>(wearable(std::move(rig), "sideways").value());
}

class WornExport : public test::MadeExport {
protected:
    void SetUp() override {
        MadeExport::SetUp();
        request_.worn = sidewaysBody();
        request_.film.size = {160, 96};
        request_.film.frames_per_second = 25;
    }
};

TEST_F(WornExport, EveryFileIsHeldAgainstItsTake) {
    request_.fbx_path = file("w.fbx");
    request_.glb_path = file("w.glb");
    request_.overwrite = true;
    for (const RootMotion root : {RootMotion::kMoving, RootMotion::kInPlace, RootMotion::kHeading}) {
        request_.root = root;
        const auto summary = exportTake(request_, {});
        ASSERT_TRUE(summary) << summary.error().text();
        const auto checks = checkExport(request_, {});
        ASSERT_TRUE(checks) << checks.error().text();
        ASSERT_EQ(checks->size(), 2U);
        for (const ExportCheck& check : *checks) {
            EXPECT_TRUE(check.ok()) << check.path << ": " << check.faults.front();
            EXPECT_EQ(check.frames, 55U);
            EXPECT_EQ(check.joints, 21);
            EXPECT_NEAR(check.facing_rad, 0, 1e-4) << "turned to face +Z";
            EXPECT_NEAR(check.height_m, 0.6 * 1.5, 0.15) << "its own size";
        }
    }
}

TEST_F(WornExport, TheCheckSeesAnotherTimeBodyAndRoot) {
    request_.glb_path = file("w.glb");
    ASSERT_TRUE(exportTake(request_, {}));
    ExportRequest later = request_;
    later.from_s = *later.from_s + 0.02;
    later.to_s = *later.to_s + 0.02;
    EXPECT_FALSE(checkExport(later, {})->front().ok());
    ExportRequest held = request_;
    held.root = RootMotion::kHeading;
    EXPECT_FALSE(checkExport(held, {})->front().ok());
    ExportRequest ours = request_;
    ours.worn = nullptr;
    EXPECT_FALSE(checkExport(ours, {})->front().ok());
    WearableBody other = *request_.worn;
    for (RigNode& node : other.mesh.nodes)
        if (node.name == "forearm.L")
            node.T_world_rest.translation().x() += 0.01;
    ExportRequest changed = request_;
    changed.worn = std::make_shared<const WearableBody>(other);
    EXPECT_FALSE(checkExport(changed, {})->front().ok());
}

TEST_F(WornExport, PicturesAndFilmsAreDrawnAndChecked) {
    for (const bool worn : {true, false}) {
        if (!worn)
            request_.worn = nullptr;
        for (const CameraMove camera : {CameraMove::kFront, CameraMove::kFollow, CameraMove::kTurn}) {
            request_.film.camera = camera;
            request_.overwrite = true;
            request_.png_path = file("p.png");
            request_.video_path = file("f.mp4");
            const auto summary = exportTake(request_, {});
            ASSERT_TRUE(summary) << summary.error().text();
            EXPECT_EQ(summary->film_frames, 31U) << "1.2 s at 25 a second, both ends";
            const auto checks = checkExport(request_, {});
            ASSERT_TRUE(checks);
            for (const ExportCheck& check : *checks)
                EXPECT_TRUE(check.ok()) << check.path << ": " << check.faults.front();
            const auto facts = readVideo(request_.video_path);
            ASSERT_TRUE(facts);
            EXPECT_EQ(facts->frames, 31U);
            EXPECT_NEAR(facts->frames_per_second, 25, 0.01);
            const auto picture = readPicture(request_.png_path);
            ASSERT_TRUE(picture);
            EXPECT_EQ(picture->width_px, 160);
            int body = 0;
            for (int y = 0; y < picture->height_px; ++y)
                for (int x = 0; x < picture->width_px; ++x)
                    body += isGrey(picture->at(x, y));
            EXPECT_GT(body, worn ? 5 : 100) << "somebody is in the picture";
        }
    }
    ExportRequest other = request_;
    other.film.size = {96, 96};
    other.film.frames_per_second = 24;
    const auto checks = checkExport(other, {});
    ASSERT_TRUE(checks);
    for (const ExportCheck& check : *checks)
        EXPECT_FALSE(check.ok()) << check.path;
}

TEST_F(WornExport, ASkeletonAloneIsDrawnAsLines) {
    request_.with_body = false;
    request_.png_path = file("s.png");
    request_.film.size = {320, 240};
    const auto summary = exportTake(request_, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_TRUE(checkExport(request_, {})->front().ok());
    const auto grey = [&] {
        const auto picture = readPicture(request_.png_path).value();
        int count = 0;
        for (int y = 0; y < picture.height_px; ++y)
            for (int x = 0; x < picture.width_px; ++x)
                count += isGrey(picture.at(x, y));
        return count;
    };
    const int lines = grey();
    EXPECT_GT(lines, 60);
    request_.with_body = true;
    request_.worn = nullptr;
    request_.overwrite = true;
    ASSERT_TRUE(exportTake(request_, {}));
    EXPECT_LT(lines, grey() / 2) << "thinner than a body";
}

TEST_F(WornExport, WhatAKilledFilmLeftGoesWithTheNext) {
    request_.png_path = file("p.png");
    const std::string aside = asidePath(request_.png_path);  // FOLDER/.p.png.HOST.NUMBER-0.partial
    const std::string ours = aside.substr(0, aside.find("." + std::to_string(::getpid()) + "-"));
    const std::string mine = ours + "." + std::to_string(::getpid()) + "-77.partial",
                      dead = ours + ".999999999-0.partial.png",
                      elsewhere = file(".p.png.another-computer.999999999-0.partial"),
                      other = file(".q.png" + ours.substr(ours.rfind('.')) + ".999999999-0.partial");
    for (const std::string& path : {mine, dead, elsewhere, other})
        ASSERT_TRUE(writeFileAtomically(path, "half", false));
    ASSERT_TRUE(exportTake(request_, {}));
    EXPECT_TRUE(std::filesystem::exists(mine)) << "somebody writes it";
    EXPECT_FALSE(std::filesystem::exists(dead));
    EXPECT_TRUE(std::filesystem::exists(elsewhere)) << "its process may live on that computer";
    EXPECT_TRUE(std::filesystem::exists(other)) << "of another name";
}

TEST_F(WornExport, ACancelledFilmLeavesNothing) {
    request_.video_path = file("f.avi");
    CancelFlag flag;
    struct : ProgressSink {
        CancelFlag* flag = nullptr;
        void progress(double fraction, const std::string&) override {
            if (fraction > 0.6)
                flag->cancel();
        }
    } sink;
    sink.flag = &flag;
    const auto summary = exportTake(request_, {&sink, &flag});
    ASSERT_FALSE(summary);
    EXPECT_EQ(summary.error().kind, ErrorKind::kCancelled);
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(path()).parent_path()))
        EXPECT_EQ(entry.path().filename(), "made_001.noctule");
}

TEST_F(WornExport, OddSizesAndOtherEndingsAreRefused) {
    request_.video_path = file("f.mp4");
    request_.film.size = {161, 96};
    const auto odd = exportTake(request_, {});
    ASSERT_FALSE(odd);
    EXPECT_EQ(odd.error().kind, ErrorKind::kUsage);
    request_.film.size = {160, 96};
    request_.video_path = file("f.gif");
    const auto ending = exportTake(request_, {});
    ASSERT_FALSE(ending);
    EXPECT_NE(ending.error().remedy.find(".mp4"), std::string::npos);
}

}  // namespace
}  // namespace noctule
