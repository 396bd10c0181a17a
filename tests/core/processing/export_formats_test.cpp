// SPDX-License-Identifier: Apache-2.0
// A take as FBX, GLB and OpenSim tables: what stands in the files is what the take holds, in the range and at
// the rate that was asked for.
#include "core/formats/opensim.h"
#include "core/formats/scene_check.h"
#include "core/job/atomic_file.h"
#include "core/processing/bone_confidence.h"
#include "core/processing/check_export.h"
#include "core/processing/export_files.h"
#include "core/processing/export_program.h"
#include "tests/core/processing/made_export.h"

namespace noctule {
namespace {

class ExportFormats : public test::MadeExport {
protected:
    /// The known motion itself, walked through without the take.
    Figure expected(JointNames names, bool with_body) const {
        MotionClip clip;
        clip.name = "made_001";
        clip.skeleton = actor_.skeleton;
        clip.frame_time_s = 1 / 45.0;
        for (int f = 0; f < 55; ++f)
            clip.frames.push_back(poseAt(0.4 + f / 45.0));
        std::optional<SkinnedMesh> body;
        if (with_body)
            body = bodyFor(actor_.skeleton, {});
        return makeFigure(clip, body, names).value();
    }
};

/// Between two frames of the take, 7 ms apart, the arm's swing is not quite an arc: a few micrometres.
constexpr double kSampled_m = 5e-5;

TEST_F(ExportFormats, SceneFilesHoldTheTake) {
    for (const ExportProgram& preset : exportPrograms()) {
        ExportRequest request = request_;
        request.fbx_path = file(preset.key + ".fbx");
        request.glb_path = file(preset.key + ".glb");
        request.metres_per_unit = preset.metres_per_unit;
        request.names = preset.names;
        request.root_name = preset.root_name;
        const auto summary = exportTake(request, {});
        ASSERT_TRUE(summary) << summary.error().text();
        EXPECT_EQ(summary->files, (std::vector{request.fbx_path, request.glb_path}));
        EXPECT_EQ(summary->frames, 55U);
        const Figure figure = expected(preset.names, true);
        for (const bool is_fbx : {true, false}) {
            const auto difference = compareScene(is_fbx ? request.fbx_path : request.glb_path, preset.key,
                                                 is_fbx ? SceneFormat::kFbx : SceneFormat::kGlb, figure);
            ASSERT_TRUE(difference) << difference.error().text();
            EXPECT_NEAR(difference->frames_per_second, 45, 1e-3);
            EXPECT_LT(difference->joint_m, kSampled_m) << preset.key;
            EXPECT_LT(difference->vertex_m, kSampled_m) << preset.key;
        }
    }
}

TEST_F(ExportFormats, RootOptionsHoldForEveryFormat) {
    ExportRequest request = request_;
    request.fbx_path = file("h.fbx");
    request.mot_path = file("h.mot");
    request.with_body = false;
    request.root = RootMotion::kHeading;
    ASSERT_TRUE(exportTake(request, {}));
    const auto moving =
        compareScene(request.fbx_path, "h", SceneFormat::kFbx, expected(JointNames::kOwn, false));
    ASSERT_TRUE(moving);
    EXPECT_GT(moving->joint_m, 0.5) << "it walked a metre away";
    const auto table = parseOpenSimTable(*readWholeFile(request.mot_path), "h");
    ASSERT_TRUE(table);
    const auto column = static_cast<size_t>(
        std::find(table->columns.begin(), table->columns.end(), "pelvis_rotation") - table->columns.begin());
    for (size_t row = 0; row < table->rows(); ++row) {
        EXPECT_NEAR(table->values[row * table->width + column], 0, 1e-6) << "faces +X, OpenSim's forward";
        EXPECT_NEAR(table->values[row * table->width + 1], table->values[1], 1e-9) << "in place";
    }
}

TEST_F(ExportFormats, OpenSimTablesHoldTheTake) {
    ExportRequest request = request_;
    request.mot_path = file("m.mot");
    request.sto_path = file("m.sto");
    ASSERT_TRUE(exportTake(request, {}));
    const MotionClip clip = expected(JointNames::kOwn, false).clip;
    const auto angles = openSimAngles(clip), turns = openSimOrientations(clip);
    const auto read_angles = parseOpenSimTable(*readWholeFile(request.mot_path), "m.mot");
    const auto read_turns = parseOpenSimTable(*readWholeFile(request.sto_path), "m.sto");
    ASSERT_TRUE(read_angles && read_turns);
    ASSERT_EQ(read_angles->values.size(), angles->values.size());
    ASSERT_EQ(read_turns->values.size(), turns->values.size());
    for (size_t v = 0; v < angles->values.size(); ++v)
        EXPECT_NEAR(read_angles->values[v], angles->values[v], 0.01) << v;
    for (size_t v = 0; v < turns->values.size(); ++v)
        EXPECT_NEAR(read_turns->values[v], turns->values[v], 1e-4) << v;
}

TEST_F(ExportFormats, EveryFileIsHeldAgainstItsTake) {
    for (const RootMotion root : {RootMotion::kMoving, RootMotion::kInPlace, RootMotion::kHeading}) {
        ExportRequest request = request_;
        request.overwrite = true;
        request.root = root;
        request.names = JointNames::kHumanIk;
        request.fbx_path = file("c.fbx");
        request.glb_path = file("c.glb");
        request.mot_path = file("c.mot");
        request.sto_path = file("c.sto");
        request.bvh_path = file("c.bvh");
        ASSERT_TRUE(exportTake(request, {}));
        const auto checks = checkExport(request, {});
        ASSERT_TRUE(checks) << checks.error().text();
        ASSERT_EQ(checks->size(), 5U);
        for (const ExportCheck& check : *checks) {
            EXPECT_TRUE(check.ok()) << check.path << ": " << check.faults.front();
            EXPECT_EQ(check.frames, 55U);
            EXPECT_TRUE(check.has_angles);
            EXPECT_EQ(check.has_figure, !check.path.ends_with(".mot") && !check.path.ends_with(".sto"))
                << "a table of angles tells neither height nor floor: " << check.path;
        }
        EXPECT_NEAR((*checks)[1].height_m, (*checks)[0].height_m, 1e-4);
        EXPECT_NEAR((*checks)[1].lowest_m, (*checks)[0].lowest_m, 1e-4);
        EXPECT_NEAR((*checks)[1].facing_rad, 0, 1e-6);
    }
}

class ExportStacks : public ExportFormats, public testing::WithParamInterface<ExportFormat> {};
INSTANTIATE_TEST_SUITE_P(Formats, ExportStacks, testing::Values(ExportFormat::kFbx, ExportFormat::kGlb),
                         [](const auto& name) { return std::string(entryOf(name.param).option); });

TEST_P(ExportStacks, TakesInOneFileAreEachHeldAgainstTheirs) {
    ExportRequest first = request_, second = request_;
    const ExportFormatEntry& entry = entryOf(GetParam());
    const std::string path = first.*entry.path = second.*entry.path =
                                                     file(std::string("both.") + entry.extension);
    first.motion_name = "early";
    second.motion_name = "late";
    second.from_s = 0.9;
    const auto summary = exportStacks({first, second}, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->files, std::vector{path});
    EXPECT_EQ(summary->frames, 55U + 32U);
    for (const ExportRequest& take : {first, second}) {
        const auto checks = checkExport(take, {});
        ASSERT_TRUE(checks);
        EXPECT_TRUE(checks->front().ok()) << checks->front().faults.front();
        EXPECT_EQ(checks->front().frames, take.motion_name == "late" ? 32U : 55U);
    }
    const auto together = checkStacks({first, second}, {});
    ASSERT_TRUE(together);
    ASSERT_EQ(together->size(), 2U);
    EXPECT_TRUE((*together)[0].ok() && (*together)[1].ok());
    EXPECT_EQ((*together)[1].frames, 32U);
    second.motion_name = "early";
    EXPECT_FALSE(checkExport(second, {})->front().ok()) << "another take's stack";
    const auto exchanged = checkStacks({first, second}, {});
    ASSERT_TRUE(exchanged);
    EXPECT_TRUE((*exchanged)[0].ok());
    EXPECT_FALSE((*exchanged)[1].ok());
    second.motion_name = "nobody's";
    EXPECT_FALSE(checkExport(second, {})->front().ok());
    const auto kept = exportStacks({first, second}, {});
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().kind, ErrorKind::kUsage) << "nothing is overwritten";
}

/// Cancels when its words of that number come.
struct CancelsAt : ProgressSink {
    explicit CancelsAt(size_t number) : left(number) {}
    void progress(double fraction, const std::string& words) override {
        EXPECT_GE(fraction, last);
        last = fraction;
        told.push_back(words);
        if (left-- == 0)
            flag.cancel();
    }
    size_t left;
    double last = 0;
    std::vector<std::string> told;
    CancelFlag flag;
};

TEST_F(ExportFormats, TakesInOneFileCanBeCancelledAtAnyTime) {
    ExportRequest first = request_, second = request_;
    first.fbx_path = second.fbx_path = file("both.fbx");
    first.with_body = second.with_body = false;
    first.motion_name = "early";
    second.motion_name = "late";
    CancelsAt never(1000);
    ASSERT_TRUE(exportStacks({first, second}, {&never, &never.flag}));
    EXPECT_EQ(never.told, (std::vector<std::string>{"Writing", "Writing", "Checking", "Checking", "Done"}));
    std::filesystem::remove(first.fbx_path);
    for (size_t number = 0; number + 1 < never.told.size(); ++number) {
        CancelsAt cancels(number);
        const auto summary = exportStacks({first, second}, {&cancels, &cancels.flag});
        ASSERT_FALSE(summary) << number;
        EXPECT_EQ(summary.error().kind, ErrorKind::kCancelled) << number;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.file("")))
            EXPECT_EQ(entry.path().filename(), "made_001.noctule") << "nothing is left";
    }
}

TEST_F(ExportFormats, AFileOfAnotherRunOfTimeIsFound) {
    ExportRequest request = request_;
    request.with_body = false;
    request.fbx_path = file("o.fbx");
    request.glb_path = file("o.glb");
    request.mot_path = file("o.mot");
    request.sto_path = file("o.sto");
    ASSERT_TRUE(exportTake(request, {}));
    ExportRequest later = request;
    later.from_s = *later.from_s + 0.02;
    later.to_s = *later.to_s + 0.02;
    const auto checks = checkExport(later, {});
    ASSERT_TRUE(checks);
    for (const ExportCheck& check : *checks)
        EXPECT_FALSE(check.ok()) << check.path;
    later = request;
    later.frames_per_second = 44;
    const auto slower = checkExport(later, {});
    ASSERT_TRUE(slower);
    for (const ExportCheck& check : *slower)
        EXPECT_FALSE(check.ok()) << check.path;
}

TEST(BoneConfidence, FallsWithTheDeviation) {
    TimedMotion motion{defaultActor().skeleton, {}};
    TimedPose frame{1000, motion.skeleton.zeroPose(), {}};
    EXPECT_TRUE(boneConfidence(motion, 0).empty());
    motion.frames = {frame};
    EXPECT_TRUE(boneConfidence(motion, 0).empty()) << "not told";
    motion.frames[0].sigma_rad.assign(3 * 21, 0);
    const auto of = [&](const char* name) { return static_cast<size_t>(motion.skeleton.find(name)); };
    motion.frames[0].sigma_rad[3 * of("Chest") + 1] = radians(5);
    motion.frames[0].sigma_rad[3 * of("Head")] = radians(15);
    frame.time_ns = 2000;
    frame.sigma_rad.assign(3 * 21, 0);
    motion.frames.push_back(frame);
    const auto confidence = boneConfidence(motion, 1400);
    ASSERT_EQ(confidence.size(), 21U);
    EXPECT_NEAR(confidence[of("Hips")], 1, 1e-6);
    EXPECT_NEAR(confidence[of("Chest")], 0.5, 1e-6);
    EXPECT_NEAR(confidence[of("Neck")], 0.5, 1e-6) << "cannot move: as what it hangs on";
    EXPECT_NEAR(confidence[of("Head")], 0.1, 1e-6);
    EXPECT_NEAR(boneConfidence(motion, 1600)[of("Chest")], 1, 1e-6) << "the nearest frame";
}

}  // namespace
}  // namespace noctule
