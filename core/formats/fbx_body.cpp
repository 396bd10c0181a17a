// SPDX-License-Identifier: Apache-2.0
// The mesh of an FBX file, the clusters that bind it to the bones, and the pose in which they do.
#include <cmath>

#include "core/formats/fbx_scene.h"

namespace noctule {
namespace {

/// 16 numbers, column after column: the translation comes last.
std::vector<double> fbxMatrix(const Eigen::Matrix4d& matrix) {
    return {matrix.data(), matrix.data() + 16};
}

/// Where a bone stood when the skin was bound, in the file's unit.
Eigen::Matrix4d boundAt(const SkinBone& bone, const FbxOptions& options) {
    Eigen::Matrix4d matrix = bone.bind_inverse.cast<double>().inverse();
    matrix.topRightCorner<3, 1>() /= options.metres_per_unit;
    matrix.bottomRows<1>() << 0, 0, 0, 1;
    return matrix;
}

FbxNode fbxLayers() {
    FbxNode layer("Layer", int32_t{0});
    layer.add(FbxNode("Version", int32_t{100}));
    for (const char* element : {"LayerElementNormal", "LayerElementMaterial"})
        layer.add(std::move(
            FbxNode("LayerElement").add(FbxNode("Type", element)).add(FbxNode("TypedIndex", int32_t{0}))));
    return layer;
}

FbxNode fbxLayerElement(const std::string& name, int32_t version, const char* mapping, const char* reference,
                        FbxNode values) {
    FbxNode element(name, int32_t{0});
    element.add(FbxNode("Version", version))
        .add(FbxNode("Name", ""))
        .add(FbxNode("MappingInformationType", mapping))
        .add(FbxNode("ReferenceInformationType", reference))
        .add(std::move(values));
    return element;
}

/// The last corner of a polygon is marked by its complement.
std::vector<FbxNode> fbxGeometry(const SkinnedMesh& body, const FbxOptions& options) {
    std::vector<double> points, normals;
    for (const SkinnedVertex& vertex : body.vertices)
        for (int axis = 0; axis < 3; ++axis) {
            points.push_back(static_cast<double>(vertex.p_m[axis]) / options.metres_per_unit);
            normals.push_back(static_cast<double>(vertex.normal[axis]));
        }
    std::vector<int32_t> corners;
    for (const auto& [a, b, c] : body.triangles)
        corners.insert(corners.end(),
                       {static_cast<int32_t>(a), static_cast<int32_t>(b), ~static_cast<int32_t>(c)});
    return {fbxProperties({}),
            FbxNode("GeometryVersion", int32_t{124}),
            FbxNode("Vertices", points),
            FbxNode("PolygonVertexIndex", corners),
            fbxLayerElement("LayerElementNormal", 101, "ByVertice", "Direct", FbxNode("Normals", normals)),
            fbxLayerElement("LayerElementMaterial", 101, "AllSame", "IndexToDirect",
                            FbxNode("Materials", std::vector<int32_t>{0})),
            fbxLayers()};
}

std::vector<FbxNode> fbxMaterial() {
    return {FbxNode("Version", int32_t{102}), FbxNode("ShadingModel", "phong"),
            FbxNode("MultiLayer", int32_t{0}),
            fbxProperties({fbxProperty("DiffuseColor", "Color", "", "A", 0.62, 0.66, 0.72),
                           fbxProperty("SpecularFactor", "Number", "", "A", 0.1),
                           fbxProperty("ShininessExponent", "Number", "", "A", 10.0)})};
}

std::vector<FbxNode> fbxCluster(const SkinnedMesh& body, size_t bone, const FbxOptions& options) {
    std::vector<int32_t> indices;
    std::vector<double> weights;
    for (size_t v = 0; v < body.vertices.size(); ++v)
        if (const float weight = weightOn(body.vertices[v], bone); weight > 0) {
            indices.push_back(static_cast<int32_t>(v));
            weights.push_back(static_cast<double>(weight));
        }
    const Eigen::Matrix4d bound = boundAt(body.bones[bone], options);
    return {FbxNode("Version", int32_t{100}),
            FbxNode("UserData", "", ""),
            FbxNode("Indexes", indices),
            FbxNode("Weights", weights),
            FbxNode("Transform", fbxMatrix(bound.inverse())),
            FbxNode("TransformLink", fbxMatrix(bound))};
}

FbxNode fbxPoseNode(int64_t model, const Eigen::Matrix4d& matrix) {
    FbxNode node("PoseNode");
    node.add(FbxNode("Node", model)).add(FbxNode("Matrix", fbxMatrix(matrix)));
    return node;
}

void addFbxBindPose(FbxScene& scene, const SkinnedMesh& body, const FbxOptions& options, int64_t mesh,
                    const std::vector<int64_t>& models) {
    std::vector<FbxNode> content{FbxNode("Type", "BindPose"), FbxNode("Version", int32_t{100}),
                                 FbxNode("NbPoseNodes", static_cast<int32_t>(models.size() + 1)),
                                 fbxPoseNode(mesh, Eigen::Matrix4d::Identity()),
                                 fbxPoseNode(models[0], Eigen::Matrix4d::Identity())};
    for (size_t b = 0; b < body.bones.size(); ++b)
        content.push_back(fbxPoseNode(models[b + 1], boundAt(body.bones[b], options)));
    scene.add("Pose", "BindPose", "Pose", "BindPose", content);
}

}  // namespace

void addFbxBody(FbxScene& scene, const Figure& figure, const FbxOptions& options,
                const std::vector<int64_t>& models) {
    if (!figure.body)
        return;
    const SkinnedMesh& body = *figure.body;
    const int64_t geometry = scene.add("Geometry", "Body", "Geometry", "Mesh", fbxGeometry(body, options));
    const int64_t mesh = scene.add("Model", nameBesideJoints(figure.clip.skeleton, "Body"), "Model", "Mesh",
                                   {FbxNode("Version", int32_t{232}), fbxProperties({}),
                                    FbxNode("Shading", true), FbxNode("Culling", "CullingOff")});
    scene.connect(mesh, FbxScene::kTop);
    scene.connect(geometry, mesh);
    scene.connect(scene.add("Material", "Body", "Material", "", fbxMaterial()), mesh);
    const int64_t skin = scene.add("Deformer", "Body", "Deformer", "Skin",
                                   {FbxNode("Version", int32_t{101}), FbxNode("Link_DeformAcuracy", 50.0),
                                    FbxNode("SkinningType", "Linear")});
    scene.connect(skin, geometry);
    for (size_t b = 0; b < body.bones.size(); ++b) {
        const int64_t cluster = scene.add("Deformer", body.bones[b].joint, "SubDeformer", "Cluster",
                                          fbxCluster(body, b, options));
        scene.connect(cluster, skin);
        scene.connect(models[b + 1], cluster);
    }
    addFbxBindPose(scene, body, options, mesh, models);
}

}  // namespace noctule
