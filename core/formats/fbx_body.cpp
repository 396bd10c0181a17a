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

bool isTextured(const SkinnedMesh& body) {
    return !texturesOf(body.surface).empty();
}

FbxNode fbxLayers(const SkinnedMesh& body) {
    FbxNode layer("Layer", int32_t{0});
    layer.add(FbxNode("Version", int32_t{100}));
    std::vector<std::string> elements{"LayerElementNormal", "LayerElementMaterial"};
    if (isTextured(body))
        elements.push_back("LayerElementUV");
    for (const std::string& element : elements)
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

/// One place in the texture per vertex, which every corner of it names.
FbxNode fbxTexturePlaces(const SkinnedMesh& body) {
    std::vector<double> places;
    for (const SkinnedVertex& vertex : body.vertices)
        places.insert(places.end(), {static_cast<double>(vertex.uv.x()), static_cast<double>(vertex.uv.y())});
    std::vector<int32_t> corners;
    for (const auto& triangle : body.triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    FbxNode element =
        fbxLayerElement("LayerElementUV", 101, "ByPolygonVertex", "IndexToDirect", FbxNode("UV", places));
    element.add(FbxNode("UVIndex", corners));
    return element;
}

/// Which material a triangle has, by their order.
FbxNode fbxMaterialChoice(const SkinnedMesh& body) {
    const bool is_one = body.surface.size() <= 1;
    std::vector<int32_t> choice(is_one ? 1 : 0, 0);
    for (size_t p = 0; !is_one && p < body.surface.size(); ++p)
        choice.insert(choice.end(), body.surface[p].triangles, static_cast<int32_t>(p));
    return fbxLayerElement("LayerElementMaterial", 101, is_one ? "AllSame" : "ByPolygon", "IndexToDirect",
                           FbxNode("Materials", choice));
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
    std::vector<FbxNode> content{
        fbxProperties({}),
        FbxNode("GeometryVersion", int32_t{124}),
        FbxNode("Vertices", points),
        FbxNode("PolygonVertexIndex", corners),
        fbxLayerElement("LayerElementNormal", 101, "ByVertice", "Direct", FbxNode("Normals", normals)),
        fbxMaterialChoice(body)};
    if (isTextured(body))
        content.push_back(fbxTexturePlaces(body));
    content.push_back(fbxLayers(body));
    return content;
}

std::vector<FbxNode> fbxMaterial(const SurfaceLook& look) {
    const Eigen::Vector3d color = look.base_color.cast<double>();
    return {FbxNode("Version", int32_t{102}), FbxNode("ShadingModel", "phong"),
            FbxNode("MultiLayer", int32_t{0}),
            fbxProperties({fbxProperty("DiffuseColor", "Color", "", "A", color.x(), color.y(), color.z()),
                           fbxProperty("SpecularFactor", "Number", "", "A", 0.1),
                           fbxProperty("ShininessExponent", "Number", "", "A", 10.0)})};
}

/// The picture stands within the file; its name is for programs that want to put it beside.
int64_t addFbxTexture(FbxScene& scene, const SurfaceTexture& texture, const std::string& object) {
    const std::string name = object + "." + textureEnding(texture);
    const int64_t video = scene.add(
        "Video", object, "Video", "Clip",
        {FbxNode("Type", "Clip"), fbxProperties({fbxProperty("Path", "KString", "XRefUrl", "", name)}),
         FbxNode("UseMipMap", int32_t{0}), FbxNode("Filename", name), FbxNode("RelativeFilename", name),
         FbxNode("Content", FbxBytes{texture.file})});
    const int64_t picture =
        scene.add("Texture", object, "Texture", "",
                  {FbxNode("Type", "TextureVideoClip"), FbxNode("Version", int32_t{202}),
                   FbxNode("TextureName", fbxObjectName(object, "Texture")),
                   FbxNode("Media", fbxObjectName(object, "Video")), FbxNode("FileName", name),
                   FbxNode("RelativeFilename", name), FbxNode("ModelUVTranslation", 0.0, 0.0),
                   FbxNode("ModelUVScaling", 1.0, 1.0), FbxNode("Texture_Alpha_Source", "None"),
                   FbxNode("Cropping", int32_t{0}, int32_t{0}, int32_t{0}, int32_t{0})});
    scene.connect(video, picture);
    return picture;
}

/// One material per part of the surface, in that order.
void addFbxMaterials(FbxScene& scene, const SkinnedMesh& body, int64_t mesh) {
    const std::vector<SurfacePart> surface = surfaceParts(body);
    const auto textures = texturesOf(surface);
    std::vector<int64_t> pictures;
    for (size_t t = 0; t < textures.size(); ++t)
        pictures.push_back(addFbxTexture(scene, *textures[t], surfaceName(t)));
    for (size_t p = 0; p < surface.size(); ++p) {
        const int64_t material = scene.add("Material", surfaceName(p), "Material", "",
                                           fbxMaterial(surface[p].look.value_or(SurfaceLook())));
        scene.connect(material, mesh);
        if (const auto texture = textureIndex(surface[p], textures))
            scene.connect(pictures[*texture], material, "DiffuseColor");
    }
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
    const std::string name = bodyName(figure);
    const int64_t mesh = scene.add("Model", nameBesideJoints(figure.clip.skeleton, name), "Model", "Mesh",
                                   {FbxNode("Version", int32_t{232}), fbxProperties({}),
                                    FbxNode("Shading", true), FbxNode("Culling", "CullingOff")});
    scene.connect(mesh, FbxScene::kTop);
    scene.connect(geometry, mesh);
    addFbxMaterials(scene, body, mesh);
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
