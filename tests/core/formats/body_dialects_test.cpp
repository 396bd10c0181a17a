// SPDX-License-Identifier: Apache-2.0
// The same person in the dialects of many programs wears the same motion: GLB and FBX hold every block of it
// where the plain body has it. What cannot be read is refused in words.
#include "tests/core/formats/body_dialects.h"

namespace noctule {
namespace {

TEST_F(BodyDialects, BlocksStandOnTheirBones) {
    const PointsOfFrames points = plain();
    ASSERT_EQ(points.size(), kDialectFrames);
    EXPECT_EQ(points[0].size(), 21U * 8);
    EXPECT_GT(largestGap(points[0], points[kDialectFrames - 1]), 0.01) << "it moves";
}

TEST_F(BodyDialects, UnitsAxesAndPlacesOfNodes) {
    const PointsOfFrames as = plain();
    const auto dialect = [](const Eigen::Affine3d& T_armature, const Eigen::Affine3d& T_mesh,
                            const Eigen::Affine3d& T_file_skin, bool below) {
        GlbDialect made;
        made.T_armature = T_armature;
        made.T_mesh = T_mesh;
        made.T_file_skin = T_file_skin;
        made.mesh_below_armature = below;
        return made;
    };
    const Eigen::Affine3d same = Eigen::Affine3d::Identity();
    const Eigen::Affine3d aside(Eigen::Translation3d(3, 1, -2) * axisAngle(Vector3d::UnitY(), 1));
    const std::pair<const char*, GlbDialect> dialects[] = {
        {"an armature of 0.01 with the mesh below it", dialect(scaledBy(0.01), same, same, true)},
        {"an armature of 100", dialect(scaledBy(100), same, same, true)},
        {"bound in centimetres of the mesh's own space",
         dialect(scaledBy(0.01), scaledBy(0.01), scaledBy(0.01), false)},
        {"bound in centimetres that no node tells", dialect(scaledBy(0.01), same, scaledBy(0.01), false)},
        {"an armature with Z up", dialect(zUp(1), same, same, true)},
        {"bound with Z up, centimetres", dialect(zUp(0.01), zUp(0.01), zUp(0.01), false)},
        {"a mesh node that stands elsewhere", dialect(same, aside, same, false)},
        {"bound in a space turned like nothing else", dialect(same, same, aside, false)}};
    for (const auto& [what, how] : dialects)
        expectSameAs(as, written(GlbBody(how).glb()), what);
}

TEST_F(BodyDialects, TheFileMayStandInAnotherPoseThanTheBind) {
    GlbDialect bent;
    bent.turned = {{"LeftArm", axisAngle(Vector3d::UnitZ(), -1.2)},
                   {"RightForeArm", axisAngle(Vector3d::UnitY(), 1)},
                   {"LeftUpLeg", axisAngle(Vector3d::UnitX(), -0.8)},
                   {"LeftLeg", axisAngle(Vector3d::UnitX(), 1.2)}};
    expectSameAs(plain(), written(GlbBody(bent).glb()), "a frame of a walk");
}

TEST_F(BodyDialects, NumbersOfOtherKinds) {
    const PointsOfFrames as = plain();
    GlbBody quantised;
    std::vector<uint8_t> weights(4 * 21 * 8, 0);
    std::vector<uint16_t> joints(4 * 21 * 8, 0);
    for (size_t v = 0; v < 21 * 8; ++v) {
        weights[4 * v + 2] = 255;
        joints[4 * v + 2] = static_cast<uint16_t>(v / 8);
    }
    quantised.primitive()["attributes"]["WEIGHTS_0"] = quantised.accessor(weights, "VEC4", true);
    quantised.primitive()["attributes"]["JOINTS_0"] = quantised.accessor(joints, "VEC4");
    expectSameAs(as, written(quantised.glb()), "weights of a byte");

    GlbBody second_set;
    const nlohmann::json first = second_set.primitive()["attributes"];
    second_set.primitive()["attributes"]["JOINTS_1"] = first["JOINTS_0"];
    second_set.primitive()["attributes"]["WEIGHTS_1"] = first["WEIGHTS_0"];
    second_set.primitive()["attributes"]["WEIGHTS_0"] =
        second_set.accessor(std::vector<float>(4 * 21 * 8, 0), "VEC4");
    expectSameAs(as, written(second_set.glb()), "the weights in a second set");

    GlbBody strided;
    const size_t position = strided.primitive()["attributes"]["POSITION"];
    const size_t from =
        strided.json["bufferViews"][strided.json["accessors"][position]["bufferView"].get<size_t>()]
                    ["byteOffset"];
    std::vector<float> wide;
    for (size_t v = 0; v < 21 * 8; ++v) {
        float p[3];
        std::memcpy(p, strided.binary.data() + from + 12 * v, sizeof p);
        wide.insert(wide.end(), {9, p[0], p[1], p[2], 9});
    }
    const size_t view = strided.view(wide);
    strided.json["bufferViews"][view]["byteStride"] = 20;
    strided.json["accessors"][position]["bufferView"] = view;
    strided.json["accessors"][position]["byteOffset"] = 4;
    expectSameAs(as, written(strided.glb()), "interleaved");

    GlbBody sparse;
    float right_place[3];
    std::memcpy(right_place, sparse.binary.data() + from, sizeof right_place);
    std::memset(sparse.binary.data() + from, 0x41, sizeof right_place);
    sparse.json["accessors"][position]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", sparse.view(std::vector<uint16_t>{0})}, {"componentType", 5123}}},
        {"values", {{"bufferView", sparse.view(std::vector<float>(right_place, right_place + 3))}}}};
    expectSameAs(as, written(sparse.glb()), "a point replaced");
}

TEST_F(BodyDialects, DataBesideAndWithinTheFile) {
    const PointsOfFrames as = plain();
    const GlbBody body;
    test::writeBytes(folder_.file("daten ü%.bin"), body.binary);
    expectSameAs(as, written(body.gltf("daten%20%C3%BC%25.bin"), "percent.gltf"), "percent-encoded");
    std::string base64;
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < body.binary.size(); i += 3) {
        uint32_t bits = 0;
        const size_t count = std::min<size_t>(3, body.binary.size() - i);
        for (size_t b = 0; b < 3; ++b)
            bits = bits << 8 | (b < count ? static_cast<uint8_t>(body.binary[i + b]) : 0U);
        for (size_t d = 0; d < 4; ++d)
            base64 += d <= count ? kDigits[bits >> (18 - 6 * d) & 63] : '=';
    }
    expectSameAs(as, written(body.gltf("data:application/octet-stream;base64," + base64), "data.gltf"),
                 "within");
}

TEST_F(BodyDialects, NamesThatRepeatOrMislead) {
    const PointsOfFrames as = plain();
    GlbBody repeated;
    repeated.json["nodes"].insert(repeated.json["nodes"].end(),
                                  {{"name", "Head"}, {"translation", {0, 3, 0}}});
    repeated.json["scenes"][0]["nodes"].push_back(repeated.json["nodes"].size() - 1);
    repeated.node("Body")["name"] = "Hips";
    repeated.node("Armature")["name"] = "LeftHand";
    expectSameAs(as, written(repeated.glb()), "a mesh and an armature that are called as bones are");
    GlbDialect numbered;
    numbered.name = [](const std::string& joint) { return "Char_" + joint + ".001"; };
    expectSameAs(as, written(GlbBody(numbered).glb()), "numbers behind the names");
    GlbDialect cats;
    cats.name = [](const std::string& joint) {
        static const std::map<std::string, std::string> names = {
            {"Arm", "arm"},  {"ForeArm", "elbow"}, {"Hand", "wrist"},  {"UpLeg", "leg"},
            {"Leg", "knee"}, {"Foot", "ankle"},    {"ToeBase", "toe"}, {"Shoulder", "shoulder"}};
        for (const std::string side : {"Left", "Right"})
            if (joint.starts_with(side))
                return side + " " + names.at(joint.substr(side.size()));
        return joint;
    };
    expectSameAs(as, written(GlbBody(cats).glb()), "legs that are thighs");
}

std::map<std::string, std::string> vrmNames() {
    std::map<std::string, std::string> names = {
        {"Hips", "hips"}, {"Spine", "spine"}, {"Chest", "upperChest"}, {"Neck", "neck"}, {"Head", "head"}};
    for (const auto& [side, vrm] : {std::pair{"Left", "left"}, {"Right", "right"}})
        for (const auto& [joint, bone] : {std::pair{"Shoulder", "Shoulder"},
                                          {"Arm", "UpperArm"},
                                          {"ForeArm", "LowerArm"},
                                          {"Hand", "Hand"},
                                          {"UpLeg", "UpperLeg"},
                                          {"Leg", "LowerLeg"},
                                          {"Foot", "Foot"},
                                          {"ToeBase", "Toes"}})
            names[std::string(side) + joint] = std::string(vrm) + bone;
    return names;
}

/// Bones have the names of others: the table counts.
TEST_F(BodyDialects, TheTableOfAnAvatarComesBeforeNames) {
    const PointsOfFrames as = plain();
    const auto names = vrmNames();
    GlbDialect misleading;
    misleading.name = [](const std::string& joint) {
        return joint.starts_with("Left")    ? "Right" + joint.substr(4)
               : joint.starts_with("Right") ? "Left" + joint.substr(5)
                                            : joint;
    };
    for (const bool is_first_version : {true, false}) {
        GlbBody avatar(misleading);
        nlohmann::json bones = is_first_version ? nlohmann::json::array() : nlohmann::json::object();
        for (const auto& [joint, bone] : names)
            for (size_t n = 0; n < avatar.json["nodes"].size(); ++n) {
                if (avatar.json["nodes"][n]["name"] != misleading.name(joint))
                    continue;
                if (is_first_version)
                    bones.push_back({{"bone", bone}, {"node", n}});
                else
                    bones[bone] = {{"node", n}};
            }
        avatar.json["extensions"][is_first_version ? "VRM" : "VRMC_vrm"]["humanoid"]["humanBones"] = bones;
        expectSameAs(as, written(avatar.glb(), "avatar.vrm"), is_first_version ? "VRM 0" : "VRM 1");
    }
}

TEST_F(BodyDialects, ClothesWithAnArmatureOfTheirOwnGoAlong) {
    for (const char* suffix : {"", ".001", "_outfit", "_cloth"}) {
        GlbBody dressed;
        GlbDialect clothes;
        clothes.name = [&](const std::string& joint) { return joint + suffix; };
        dressed.add(clothes);
        expectSameAs(plain(), written(dressed.glb()), std::string("clothes ") + suffix);
    }
}

/// The first body's points are those of the plain one; the other's stay.
TEST_F(BodyDialects, OfTwoPeopleOneMovesAndTheOtherStands) {
    const PointsOfFrames as = plain();
    for (const char* prefix : {"B:", "B_", ""}) {
        GlbBody partners;
        GlbDialect other;
        other.name = [&](const std::string& joint) { return prefix + joint; };
        other.T_armature = Eigen::Affine3d(Eigen::Translation3d(0, 0, 0));
        partners.add(other);
        // The other one's armature is moved as a whole: its skin is bound where the first one stands.
        for (size_t n = 1; n < partners.json["nodes"].size(); ++n)
            if (partners.json["nodes"][n]["name"] == "Armature")
                partners.json["nodes"][n]["matrix"][12] = 1.5;
        for (const SceneFormat format : {SceneFormat::kGlb, SceneFormat::kFbx}) {
            const PointsOfFrames points = exported(written(partners.glb()), format);
            ASSERT_EQ(points.size(), kDialectFrames);
            EXPECT_EQ(points[0].size(), 2U * 21 * 8);
            const std::vector<Vector3d> standing(points[0].begin() + 21 * 8, points[0].end());
            for (size_t f = 0; f < kDialectFrames; ++f) {
                const std::vector<Vector3d> moving(points[f].begin(), points[f].begin() + 21 * 8);
                EXPECT_LT(largestGap(PointsOfFrames{moving}, PointsOfFrames{as[f]}), 2e-4) << prefix << f;
                const std::vector<Vector3d> now(points[f].begin() + 21 * 8, points[f].end());
                EXPECT_LT(largestGap(standing, now), 2e-4) << prefix << f;
            }
            EXPECT_NEAR(heightOfPoints(standing), heightOfPoints(as[0]), 0.1);
        }
    }
}

TEST_F(BodyDialects, BodiesOfEverySize) {
    const PointsOfFrames as = plain();
    for (const double size : {0.1, 0.01, 200.0}) {
        GlbDialect scaled;
        scaled.size = size;
        expectSameAs(as, written(GlbBody(scaled).glb()), "of size " + std::to_string(size), size);
    }
}

/// assimp's exporter drops what moves a node by less than 10 mm.
TEST_F(BodyDialects, BonesOfMillimetresKeepTheirLength) {
    for (const double length_m : {0.008, 0.0005}) {
        GlbBody close;
        nlohmann::json& chest = close.node("Chest")["matrix"];
        const double lower = chest[13].get<double>() - length_m;
        chest[13] = length_m;
        close.json["skins"][0].erase("inverseBindMatrices");  // the skin stands where its joints are
        const PointsOfFrames points = exported(written(close.glb()), SceneFormat::kGlb);
        ASSERT_FALSE(points.empty());
        EXPECT_LT(largestGap(points, exported(folder_.file("body.glb"), SceneFormat::kFbx)), 1e-4);
        EXPECT_GT(lower, 0.05);
    }
}

TEST_F(BodyDialects, WhatCannotBeReadIsRefusedInWords) {
    const auto complaint = [&](const std::function<void(GlbBody&)>& change,
                               const std::string& name = "bad.glb") {
        GlbBody body;
        change(body);
        const auto read = bodyOf(written(name.ends_with(".glb") ? body.glb() : body.gltf("gone.bin"), name));
        return read ? std::string() : read.error().text();
    };
    const auto has = [](const std::string& text, const char* words) {
        return text.find(words) != std::string::npos;
    };
    EXPECT_PRED2(has, complaint([](GlbBody& b) { b.primitive()["attributes"].erase("WEIGHTS_0"); }),
                 "hang on no bone");
    EXPECT_PRED2(has, complaint([](GlbBody& b) {
                     b.primitive()["attributes"]["WEIGHTS_0"] =
                         b.accessor(std::vector<float>(4 * 21 * 8, 0), "VEC4");
                 }),
                 "168 of 168 vertices of blocks hang on no bone");
    EXPECT_PRED2(has, complaint([](GlbBody& b) {
                     std::vector<float> weights;
                     for (size_t v = 0; v < 21 * 8; ++v)
                         weights.insert(weights.end(), {0, 1, 0, 0});  // all on the first joint
                     b.primitive()["attributes"]["WEIGHTS_0"] = b.accessor(weights, "VEC4");
                 }),
                 "no part of its surface hangs on the bone LeftUpLeg");
    EXPECT_PRED2(has, complaint([](GlbBody&) {}, "bad.gltf"), "gone.bin");
    EXPECT_PRED2(has,
                 complaint([](GlbBody& b) { b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
                 "KHR_draco_mesh_compression");
    EXPECT_PRED2(has, complaint([](GlbBody& b) { b.node("Head")["children"] = {0}; }), "circle");
    EXPECT_PRED2(has, complaint([](GlbBody& b) { b.node("Head")["children"] = {3}; }), "hangs on two");
    EXPECT_PRED2(has, complaint([](GlbBody& b) { b.json["skins"][0]["joints"][0] = 4000; }),
                 "does not exist");
    EXPECT_PRED2(has, complaint([](GlbBody& b) { b.json["asset"]["version"] = "1.0"; }), "version 1.0");
    EXPECT_PRED2(has, complaint([](GlbBody& b) { b.json["accessors"][0]["count"] = 1'000'000; }), "outside");
    EXPECT_PRED2(has, complaint([](GlbBody& b) { b.json["skins"][0]["joints"].push_back(0); }),
                 "fewer matrices");
}

}  // namespace
}  // namespace noctule
