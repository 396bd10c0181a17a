// SPDX-License-Identifier: Apache-2.0
#include "core/render/renderer.h"

#include <epoxy/gl.h>

#include "core/render/body_painter.h"
#include "core/render/gizmo.h"
#include "core/render/shape_painter.h"

namespace noctule {

struct Renderer::Parts {
    std::unique_ptr<ShapePainter> shapes;
    std::unique_ptr<BodyPainter> bodies;
    GlTarget target;
    std::string description;
};

namespace {

constexpr int kNeeded = 33;  // OpenGL 3.3, as libepoxy counts

std::string textOf(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

std::string versionText(int version) {
    return std::to_string(version / 10) + "." + std::to_string(version % 10);
}

void setState(const PictureSize& size) {
    glViewport(0, 0, size.width_px, size.height_px);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    // The picture stays opaque whatever is blended onto it.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDepthMask(GL_TRUE);
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void leaveState() {
    glBindVertexArray(0);
    glUseProgram(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
}

}  // namespace

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create() {
    const int version = epoxy_gl_version();
    if (!epoxy_is_desktop_gl() || version < kNeeded)
        return Error{ErrorKind::kUnusable,
                     "The 3D view needs OpenGL 3.3, and this computer offers " +
                         (version > 0 ? versionText(version) : std::string("none")),
                     "Install the driver of the graphics card; everything but the 3D view works without it"};
    auto parts = std::make_unique<Parts>();
    auto shapes = ShapePainter::create();
    if (!shapes)
        return shapes.error();
    auto bodies = BodyPainter::create();
    if (!bodies)
        return bodies.error();
    parts->shapes = std::move(*shapes);
    parts->bodies = std::move(*bodies);
    parts->description = textOf(GL_RENDERER) + ", OpenGL " + versionText(version);
    return std::unique_ptr<Renderer>(new Renderer(std::move(parts)));
}

const std::string& Renderer::description() const {
    return parts_->description;
}

void Renderer::draw(const Scene& scene, const Camera& camera, const PictureSize& size,
                    const RenderOptions& options) {
    if (size.width_px < 1 || size.height_px < 1)
        return;
    const ScreenView view{camera, size, options.pixel_ratio};
    ShapePainter& shapes = *parts_->shapes;
    parts_->target.fit(size, options.samples);
    parts_->target.bind();
    setState(size);
    shapes.drawBackground(scene.background);
    if (scene.grid)
        shapes.drawLines(gridLines(*scene.grid), view, Hiding::kNone);
    shapes.drawDiscs(scene.discs, view);
    parts_->bodies->drawSolids(scene.bodies, view);
    if (BodyPainter::hasOutlines(scene.bodies)) {
        parts_->target.bindApart();
        parts_->bodies->drawOutlines(scene.bodies, view);
        parts_->target.bind();
    }

    std::vector<LineShape> seen_through, hidden;
    for (const SceneLine& bone : scene.bones)
        appendLine(bone, view.ratio, seen_through);
    for (const SceneTrail& trail : scene.trails)
        appendTrail(trail, view.ratio, hidden);
    for (const SceneLine& ray : scene.rays)
        appendLine(ray, view.ratio, hidden);
    shapes.drawLines(seen_through, view, Hiding::kNone);
    shapes.drawMarkers(jointMarkers(scene, view), view, Hiding::kNone);
    shapes.drawLines(hidden, view, Hiding::kPale);
    shapes.drawMarkers(deviceMarkers(scene, view), view, Hiding::kPale);
    shapes.drawMarkers(ringMarkers(scene, view), view, Hiding::kNone);
    if (scene.gizmo)
        shapes.drawLines(gizmoLines(*scene.gizmo, view), view, Hiding::kNone);
    leaveState();
    parts_->target.copyTo(options.framebuffer);
}

}  // namespace noctule
