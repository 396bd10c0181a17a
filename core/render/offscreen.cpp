// SPDX-License-Identifier: Apache-2.0
#include "core/render/offscreen.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>

#include "core/render/gl_objects.h"
#include "core/render/renderer.h"

namespace noctule {

namespace {

constexpr int kLargest_px = 8192;

Error noContext(const std::string& what) {
    return {ErrorKind::kUnusable, "Pictures cannot be drawn without a window: " + what,
            "Install Mesa's EGL (libegl1 and libgl1-mesa-dri)"};
}

}  // namespace

struct Offscreen::Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    std::unique_ptr<Renderer> renderer;
    GlName<deleteRenderbuffer> color;
    GlName<deleteFramebuffer> framebuffer;
    PictureSize size{0, 0};

    bool enter() const {
        return eglBindAPI(EGL_OPENGL_API) && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    }
    void leave() const { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

    void fit(const PictureSize& wanted) {
        if (wanted.width_px != size.width_px || wanted.height_px != size.height_px) {
            size = wanted;
            GLuint name = 0;
            glGenRenderbuffers(1, &name);
            color = GlName<deleteRenderbuffer>(name);
            glBindRenderbuffer(GL_RENDERBUFFER, color);
            glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width_px, size.height_px);
            glGenFramebuffers(1, &name);
            framebuffer = GlName<deleteFramebuffer>(name);
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
        }
    }

    Picture read() const {
        Picture picture{size.width_px, size.height_px, {}};
        const size_t row = 4 * static_cast<size_t>(size.width_px);
        picture.rgba.resize(row * static_cast<size_t>(size.height_px));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glReadPixels(0, 0, size.width_px, size.height_px, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
        for (int y = 0; y < size.height_px / 2; ++y)  // OpenGL counts rows from below
            std::swap_ranges(picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y,
                             picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (y + 1),
                             picture.rgba.end() - static_cast<std::ptrdiff_t>(row) * (y + 1));
        return picture;
    }

    ~Context() {
        if (context == EGL_NO_CONTEXT)
            return;
        if (enter()) {
            renderer.reset();
            framebuffer = {};
            color = {};
        }
        leave();
        eglDestroyContext(display, context);
    }
};

Offscreen::Offscreen(std::unique_ptr<Context> context) : context_(std::move(context)) {}
Offscreen::~Offscreen() = default;

Result<std::unique_ptr<Offscreen>> Offscreen::create() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        return noContext("EGL's surfaceless platform is missing");
    auto own = std::make_unique<Context>();
    own->display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    // The display is one per process and stays: closing it would end every other context on it.
    if (own->display == EGL_NO_DISPLAY || !eglInitialize(own->display, nullptr, nullptr))
        return noContext("EGL does not start");
    if (!eglBindAPI(EGL_OPENGL_API))
        return noContext("EGL offers no OpenGL");
    constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
    own->context = eglCreateContext(own->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
    if (own->context == EGL_NO_CONTEXT)
        return noContext("there is no OpenGL 3.3");
    if (!own->enter())
        return noContext("another OpenGL context is in use in this thread");
    auto renderer = Renderer::create();
    own->leave();
    if (!renderer)
        return renderer.error();
    own->renderer = std::move(*renderer);
    return std::unique_ptr<Offscreen>(new Offscreen(std::move(own)));
}

Result<Picture> Offscreen::render(const Scene& scene, const Camera& camera, const PictureSize& size,
                                  int samples, double pixel_ratio) {
    if (std::min(size.width_px, size.height_px) < 1 || std::max(size.width_px, size.height_px) > kLargest_px)
        return Error{ErrorKind::kUsage,
                     "A picture of " + std::to_string(size.width_px) + " x " +
                         std::to_string(size.height_px) + " pixels cannot be drawn",
                     "Choose 1 to " + std::to_string(kLargest_px) + " pixels"};
    if (!context_->enter())
        return noContext("another OpenGL context is in use in this thread");
    context_->fit(size);
    context_->renderer->draw(scene, camera, size, {samples, pixel_ratio, context_->framebuffer});
    Picture picture = context_->read();
    context_->leave();
    return picture;
}

}  // namespace noctule
