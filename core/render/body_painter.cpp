// SPDX-License-Identifier: Apache-2.0
#include "core/render/body_painter.h"

#include <algorithm>
#include <cstddef>

#include "core/render/shaders.h"

namespace noctule {

namespace {

struct CardVertex {
    float p_m[3], normal[3];
    uint16_t bones[4];
    float weights[4];
    float uv[2];
};

std::vector<CardVertex> forCard(const SkinnedMesh& mesh) {
    std::vector<CardVertex> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const SkinnedVertex& from : mesh.vertices) {
        CardVertex vertex{};
        std::copy_n(from.p_m.data(), 3, vertex.p_m);
        std::copy_n(from.normal.data(), 3, vertex.normal);
        std::copy_n(from.bones.data(), 4, vertex.bones);
        std::copy_n(from.weights.data(), 4, vertex.weights);
        std::copy_n(from.uv.data(), 2, vertex.uv);
        vertices.push_back(vertex);
    }
    return vertices;
}

void describeVertex() {
    constexpr auto kStride = static_cast<GLsizei>(sizeof(CardVertex));
    const auto offset = [](size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    for (GLuint location = 0; location < 5; ++location)
        glEnableVertexAttribArray(location);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(CardVertex, p_m)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(CardVertex, normal)));
    glVertexAttribIPointer(2, 4, GL_UNSIGNED_SHORT, kStride, offset(offsetof(CardVertex, bones)));
    glVertexAttribPointer(3, 4, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(CardVertex, weights)));
    glVertexAttribPointer(4, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(CardVertex, uv)));
}

template <class T>
void fillBuffer(GLenum kind, GLuint buffer, const std::vector<T>& values) {
    glBindBuffer(kind, buffer);
    glBufferData(kind, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

/// Repeats beyond its edges, as other programs let it. Nothing without pixels.
GlTexture uploadedTexture(const SurfaceTexture& texture) {
    if (texture.rgba.empty())
        return {};
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.width_px, texture.height_px, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texture.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return GlTexture(name);
}

/// The part's own where it has one; on the screen linear light is about the power 1/2.2.
Rgba surfaceColor(const SceneBody& body, const SurfacePart& part) {
    if (!part.look)
        return {body.color.r, body.color.g, body.color.b, body.opacity};
    const Eigen::Array3f color = part.look->base_color.array().pow(1 / 2.2F);
    return {color.x(), color.y(), color.z(), body.opacity};
}

/// Three texels for each bone: the rows of its matrix.
std::vector<float> linearTexels(const std::vector<Eigen::Matrix4f>& skin) {
    std::vector<float> texels;
    texels.reserve(skin.size() * 12);
    for (const Eigen::Matrix4f& matrix : skin)
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                texels.push_back(matrix(row, column));
    return texels;
}

/// Five texels for each bone: the rows of its stretch, then the two parts of its dual quaternion.
std::vector<float> dualTexels(const std::vector<Eigen::Matrix4f>& skin) {
    std::vector<float> texels;
    texels.reserve(skin.size() * 20);
    for (const DualBone& bone : dualBones(skin)) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                texels.push_back(bone.stretch(row, column));
            texels.push_back(0);
        }
        texels.insert(texels.end(), bone.real.data(), bone.real.data() + 4);
        texels.insert(texels.end(), bone.dual.data(), bone.dual.data() + 4);
    }
    return texels;
}

bool canBeDrawn(const SceneBody& body) {
    return body.mesh && !body.mesh->triangles.empty() && !body.skin.empty() &&
           body.skin.size() == body.mesh->bones.size() && body.skin.size() <= shaders::kMaxBones;
}

bool isOutlined(const SceneBody& body) {
    return body.style == BodyStyle::kOutline && canBeDrawn(body);
}

void beginBodies() {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glEnable(GL_CULL_FACE);
}

void endBodies() {
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
}

void drawElements(size_t first_triangle, size_t triangles) {
    const size_t byte = first_triangle * 3 * sizeof(uint32_t);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles * 3), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(byte));
}

void setColor(const GlProgram& program, const Rgba& color) {
    glUniform4f(program.at("color"), color.r, color.g, color.b, color.a);
}

}  // namespace

Result<std::unique_ptr<BodyPainter>> BodyPainter::create() {
    std::unique_ptr<BodyPainter> painter(new BodyPainter);
    auto surface = GlProgram::link("body", shaders::kBodyVertex, shaders::kBodyFragment);
    if (!surface)
        return surface.error();
    auto contour = GlProgram::link("contour", shaders::kBodyVertex, shaders::kContourFragment);
    if (!contour)
        return contour.error();
    painter->surface_ = std::move(*surface);
    painter->contour_ = std::move(*contour);
    return painter;
}

void BodyPainter::forgetDeadMeshes() {
    std::erase_if(uploads_, [](const Upload& upload) { return upload.mesh.expired(); });
}

const BodyPainter::Upload& BodyPainter::uploaded(const std::shared_ptr<const SkinnedMesh>& mesh) {
    for (const Upload& upload : uploads_)
        if (upload.mesh.lock() == mesh)
            return upload;
    Upload upload{mesh, makeVertexArray(), makeBuffer(), makeBuffer(), surfaceParts(*mesh), {}, {}};
    upload.pictures = texturesOf(upload.surface);
    for (const auto& picture : upload.pictures)
        upload.textures.push_back(uploadedTexture(*picture));
    glBindVertexArray(upload.vertex_array);
    fillBuffer(GL_ARRAY_BUFFER, upload.vertices, forCard(*mesh));
    fillBuffer(GL_ELEMENT_ARRAY_BUFFER, upload.indices, mesh->triangles);
    describeVertex();
    uploads_.push_back(std::move(upload));
    return uploads_.back();
}

void BodyPainter::uploadBones(const SceneBody& body) {
    if (!bones_) {
        bones_ = makeBuffer();
        GLuint name = 0;
        glGenTextures(1, &name);
        bone_texture_ = GlTexture(name);
    }
    glBindBuffer(GL_TEXTURE_BUFFER, bones_);
    const std::vector<float> texels =
        body.blending == Blending::kLinear ? linearTexels(body.skin) : dualTexels(body.skin);
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(texels.size() * sizeof(float)), texels.data(),
                 GL_STREAM_DRAW);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_BUFFER, bone_texture_);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, bones_);
}

const BodyPainter::Upload& BodyPainter::prepare(const GlProgram& program, const SceneBody& body,
                                                const ScreenView& view, float outwards_px) {
    program.use();
    uploadBones(body);
    glUniform1i(program.at("bones"), 0);
    glUniform1i(program.at("dual_quaternions"), body.blending == Blending::kDualQuaternion);
    const Eigen::Matrix4f view_from_world = view.camera.viewMatrix().cast<float>();
    const Eigen::Matrix4f clip_from_view = view.camera.projectionMatrix(view.size).cast<float>();
    glUniformMatrix4fv(program.at("view_from_world"), 1, GL_FALSE, view_from_world.data());
    glUniformMatrix4fv(program.at("clip_from_view"), 1, GL_FALSE, clip_from_view.data());
    glUniform2f(program.at("outline_ndc"), 2 * outwards_px / static_cast<float>(view.size.width_px),
                2 * outwards_px / static_cast<float>(view.size.height_px));
    const Upload& upload = uploaded(body.mesh);
    glBindVertexArray(upload.vertex_array);
    return upload;
}

void BodyPainter::drawWhole(const GlProgram& program, const SceneBody& body, const ScreenView& view,
                            float outwards_px) {
    prepare(program, body, view, outwards_px);
    drawElements(0, body.mesh->triangles.size());
}

void BodyPainter::drawPart(const Upload& upload, const SurfacePart& part, const SceneBody& body) {
    const auto picture = textureIndex(part, upload.pictures);
    const GLuint texture = picture ? GLuint{upload.textures[*picture]} : 0;
    glBindTexture(GL_TEXTURE_2D, texture);
    glUniform1i(surface_.at("has_picture"), texture != 0);
    setColor(surface_, surfaceColor(body, part));
    drawElements(part.first_triangle, part.triangles);
}

void BodyPainter::drawDepth(const SceneBody& body, const ScreenView& view) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawWhole(contour_, body, view, 0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void BodyPainter::drawSolid(const SceneBody& body, const ScreenView& view) {
    if (body.opacity < 1)  // first the depth alone: then only the nearest surface is blended
        drawDepth(body, view);
    const Upload& upload = prepare(surface_, body, view, 0);
    glUniform1f(surface_.at("parallel"), view.camera.parallel ? 1.0F : 0.0F);
    glUniform1i(surface_.at("picture"), 1);
    glActiveTexture(GL_TEXTURE1);
    for (const SurfacePart& part : upload.surface)
        drawPart(upload, part, body);
    glActiveTexture(GL_TEXTURE0);
}

/// The back of the body, grown by the width of the line, shows beside its own front.
void BodyPainter::drawOutline(const SceneBody& body, const ScreenView& view) {
    drawDepth(body, view);
    glCullFace(GL_FRONT);
    contour_.use();
    setColor(contour_, body.color);
    glDepthMask(GL_FALSE);
    drawWhole(contour_, body, view, body.outline_px * static_cast<float>(view.ratio));
    glDepthMask(GL_TRUE);
    glCullFace(GL_BACK);
}

void BodyPainter::drawSolids(const std::vector<SceneBody>& bodies, const ScreenView& view) {
    forgetDeadMeshes();
    beginBodies();
    for (const SceneBody& body : bodies)
        if (body.style == BodyStyle::kSolid && canBeDrawn(body))
            drawSolid(body, view);
    endBodies();
}

bool BodyPainter::hasOutlines(const std::vector<SceneBody>& bodies) {
    return std::any_of(bodies.begin(), bodies.end(), isOutlined);
}

void BodyPainter::drawOutlines(const std::vector<SceneBody>& bodies, const ScreenView& view) {
    beginBodies();
    for (const SceneBody& body : bodies)
        if (isOutlined(body)) {
            glClear(GL_DEPTH_BUFFER_BIT);
            drawOutline(body, view);
        }
    endBodies();
}

}  // namespace noctule
