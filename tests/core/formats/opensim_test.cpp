// SPDX-License-Identifier: Apache-2.0
// OpenSim's tables: coordinates of known poses, a model turned by them, orientations, and damaged files.
#include "core/formats/opensim.h"

#include "core/job/atomic_file.h"
#include "core/math/rotation.h"
#include "tests/core/formats/sample_figure.h"
#include "tests/support/files.h"

namespace noctule {
namespace {

MotionClip standing() {
    MotionClip clip;
    clip.name = "standing";
    clip.skeleton = defaultActor().skeleton;
    Pose pose = bindPose(clip.skeleton);
    const auto hang = [&](const char* arm, double rad) {
        pose.q_parent_joint[static_cast<size_t>(clip.skeleton.find(arm))] = axisAngle(Vector3d::UnitZ(), rad);
    };
    hang("LeftArm", -M_PI / 2);
    hang("RightArm", M_PI / 2);
    clip.frames = {pose};
    return clip;
}

void turn(MotionClip& clip, const char* joint, const Vector3d& axis, double deg) {
    Quaterniond& q = clip.frames[0].q_parent_joint[static_cast<size_t>(clip.skeleton.find(joint))];
    q = q * axisAngle(axis, radians(deg));
}

std::map<std::string, double> coordinates(const MotionClip& clip, size_t row = 0) {
    const auto table = openSimAngles(clip);
    EXPECT_TRUE(table) << table.error().text();
    std::map<std::string, double> values;
    for (size_t c = 0; c < table->width; ++c)
        values[table->columns[c]] = table->values[row * table->width + c];
    return values;
}

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

TEST(OpenSim, StandingWithHangingArmsAndPalmsInwards) {
    const double height_m = bindPose(defaultActor().skeleton).p_world_root.y();
    for (const auto& [name, value] : coordinates(standing()))
        EXPECT_NEAR(value,
                    name == "pelvis_ty"           ? height_m
                    : name.starts_with("pro_sup") ? 90
                                                  : 0,
                    1e-9)
            << name;
    EXPECT_EQ(coordinates(standing()).size(), 1U + 6 + 2 * (3 + 1 + 2) + 3 + 2 * (3 + 2 + 2));
}

/// One movement each, as an anatomist names it. Everything else stays where it was.
TEST(OpenSim, EveryMovementHasItsCoordinateAndSign) {
    struct Case {
        const char* joint;
        Vector3d axis;
        double deg;
        const char* coordinate;
        double expected_deg;
    };
    const Case cases[] = {
        {"LeftLeg", kX, 40, "knee_angle_l", 40},  // the shin goes back
        {"RightLeg", kX, 40, "knee_angle_r", 40},
        {"LeftUpLeg", -kX, 30, "hip_flexion_l", 30},  // the thigh goes forward
        {"RightUpLeg", -kX, 30, "hip_flexion_r", 30},
        {"LeftUpLeg", -kZ, 20, "hip_adduction_l", 20},  // the thigh goes inwards
        {"RightUpLeg", kZ, 20, "hip_adduction_r", 20},
        {"LeftUpLeg", -kY, 15, "hip_rotation_l", 15},  // the toes go inwards
        {"RightUpLeg", kY, 15, "hip_rotation_r", 15},
        {"LeftFoot", -kX, 10, "ankle_angle_l", 10},     // the toes go up
        {"RightFoot", kZ, 10, "subtalar_angle_r", 10},  // the sole looks inwards
        {"LeftFoot", -kZ, 10, "subtalar_angle_l", 10},
        {"Chest", -kX, 12, "lumbar_extension", 12},  // backwards
        {"Chest", kY, 25, "lumbar_rotation", 25},    // to the left
        {"Hips", kY, 35, "pelvis_rotation", 35},
        {"LeftForeArm", -kY, 50, "elbow_flex_l", 50},
        {"RightForeArm", kY, 50, "elbow_flex_r", 50},
        {"LeftForeArm", kX, 45, "pro_sup_l", 45},
        {"RightForeArm", kX, 45, "pro_sup_r", 45},
        {"LeftHand", -kZ, 20, "wrist_flex_l", 20},  // towards the palm
        {"RightHand", kZ, 20, "wrist_flex_r", 20},
        {"LeftHand", kY, 10, "wrist_dev_l", 10},  // towards the little finger
        {"RightHand", -kY, 10, "wrist_dev_r", 10},
    };
    for (const Case& c : cases) {
        MotionClip clip = standing();
        turn(clip, c.joint, c.axis, c.deg);
        auto all = coordinates(clip);
        all["pelvis_ty"] = 0;
        for (const char* forearm : {"pro_sup_l", "pro_sup_r"})
            all[forearm] -= 90;
        for (const auto& [name, value] : all)
            EXPECT_NEAR(value, name == c.coordinate ? c.expected_deg : 0, 1e-6) << c.joint << " " << name;
    }
}

TEST(OpenSim, ArmsRaisedForwardAndAside) {
    MotionClip clip = standing();
    clip.frames[0] = clip.skeleton.zeroPose();  // T: both arms aside
    EXPECT_NEAR(coordinates(clip)["arm_add_r"], -90, 1e-6);
    EXPECT_NEAR(coordinates(clip)["arm_add_l"], -90, 1e-6);
    clip = standing();
    for (const char* arm : {"LeftArm", "RightArm"}) {
        Quaterniond& q = clip.frames[0].q_parent_joint[static_cast<size_t>(clip.skeleton.find(arm))];
        q = axisAngle(-kX, radians(60)) * q;
    }
    EXPECT_NEAR(coordinates(clip)["arm_flex_r"], 60, 1e-6);
    EXPECT_NEAR(coordinates(clip)["arm_flex_l"], 60, 1e-6);
}

/// The model's joints, turned by the coordinates as OpenSim turns them, point its bodies where the
/// orientations say.
TEST(OpenSim, CoordinatesAndOrientationsAgree) {
    const MotionClip clip = test::sampleClip(40);
    const auto orientations = openSimOrientations(clip);
    ASSERT_TRUE(orientations) << orientations.error().text();
    const auto deg = [](double value, const Vector3d& axis) { return axisAngle(axis, radians(value)); };
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        auto c = coordinates(clip, f);
        const auto body = [&](const std::string& name) {
            const auto column =
                std::find(orientations->columns.begin(), orientations->columns.end(), name + "_imu");
            EXPECT_NE(column, orientations->columns.end()) << name;
            const double* v =
                &orientations->values[f * orientations->width + 1 +
                                      4 * static_cast<size_t>(column - orientations->columns.begin() - 1)];
            return Quaterniond(v[0], v[1], v[2], v[3]);
        };
        const Quaterniond pelvis =
            deg(c["pelvis_tilt"], kZ) * deg(c["pelvis_list"], kX) * deg(c["pelvis_rotation"], kY);
        EXPECT_LT(angleBetween(pelvis, body("pelvis")), 1e-9);
        const Quaterniond torso = pelvis * deg(c["lumbar_extension"], kZ) * deg(c["lumbar_bending"], kX) *
                                  deg(c["lumbar_rotation"], kY);
        EXPECT_LT(angleBetween(torso, body("torso")), 1e-9);
        for (const std::string side : {"_r", "_l"}) {
            const double mirrored = side == "_l" ? -1 : 1;
            const Quaterniond femur = pelvis * deg(c["hip_flexion" + side], kZ) *
                                      deg(c["hip_adduction" + side], mirrored * kX) *
                                      deg(c["hip_rotation" + side], mirrored * kY);
            EXPECT_LT(angleBetween(femur, body("femur" + side)), 1e-9);
            EXPECT_LT(angleBetween(femur * deg(c["knee_angle" + side], -kZ), body("tibia" + side)), 1e-9);
            const Quaterniond humerus = torso * deg(c["arm_flex" + side], kZ) *
                                        deg(c["arm_add" + side], mirrored * kX) *
                                        deg(c["arm_rot" + side], mirrored * kY);
            EXPECT_LT(angleBetween(humerus, body("humerus" + side)), 1e-9);
            const Quaterniond radius =
                humerus * deg(c["elbow_flex" + side], kZ) * deg(c["pro_sup" + side], mirrored * kY);
            EXPECT_LT(angleBetween(radius, body("radius" + side)), 1e-6);
        }
    }
}

TEST(OpenSim, FilesReadBackAndHaveTheirHeaders) {
    test::Folder folder;
    const MotionClip clip = test::sampleClip(40);
    for (const auto& table : {openSimAngles(clip), openSimOrientations(clip)}) {
        ASSERT_TRUE(table);
        const Status written = writeOpenSimTable(folder.file("a"), *table, true);
        ASSERT_TRUE(written) << written.error().text();
        const auto read = parseOpenSimTable(*readWholeFile(folder.file("a")), "a");
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->columns, table->columns);
        EXPECT_EQ(read->rows(), clip.frames.size());
        EXPECT_NEAR(read->values[read->width], clip.frame_time_s, 1e-9);
    }
    const std::string text = *readWholeFile(folder.file("a"));
    EXPECT_NE(text.find("DataType=Quaternion\n"), std::string::npos);
    EXPECT_NE(text.find("endheader\ntime\tpelvis_imu\ttorso_imu\tfemur_r_imu"), std::string::npos);
    const auto angles = openSimAngles(clip);
    EXPECT_NE(std::find(angles->header.begin(), angles->header.end(), "inDegrees=yes"), angles->header.end());
}

TEST(OpenSim, DamageIsToldByLine) {
    const auto line = [](const std::string& text) {
        const auto table = parseOpenSimTable(text, "a.mot");
        EXPECT_FALSE(table) << text;
        return table ? std::string() : table.error().message;
    };
    EXPECT_NE(line("").find("a.mot"), std::string::npos);
    EXPECT_NE(line("Coordinates\nendheader\ntime\tx\n0\t1\n1\n").find("line 5"), std::string::npos);
    EXPECT_NE(line("endheader\ntime\tx\n0\tfar\n").find("\"far\""), std::string::npos);
    EXPECT_NE(line("endheader\nx\n0\n").find("time"), std::string::npos);
    EXPECT_TRUE(parseOpenSimTable("endheader\ntime\tq\n0\t1,0,0,0\n", "a.sto"));
}

TEST(OpenSim, ABodyWithoutAPelvisIsRefused) {
    MotionClip clip;
    clip.skeleton = Skeleton::make({{"Root", -1, Vector3d::Zero(), JointType::kFree, {}, {}, {}}}).value();
    clip.frames = {clip.skeleton.zeroPose()};
    EXPECT_EQ(openSimAngles(clip).error().kind, ErrorKind::kUnusable);
    clip = standing();
    clip.frames[0].p_world_root.y() = NAN;
    EXPECT_EQ(openSimAngles(clip).error().kind, ErrorKind::kUnusable);
}

}  // namespace
}  // namespace noctule
