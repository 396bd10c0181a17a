// SPDX-License-Identifier: Apache-2.0
#include "core/render/gl_objects.h"

#include <algorithm>

namespace noctule {

namespace {

using GlShader = GlName<deleteShader>;

Result<GlShader> compile(const std::string& name, GLenum kind, const std::string& text) {
    GlShader shader(glCreateShader(kind));
    const std::string full = "#version 330 core\n" + text;
    const char* source = full.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        return shader;
    std::string words(2000, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), &length, words.data());
    words.resize(static_cast<size_t>(length));
    return Error{ErrorKind::kUnusable, "The graphics driver refused the shader \"" + name + "\": " + words,
                 "Update the graphics driver"};
}

GlName<deleteRenderbuffer> makeRenderbuffer(GLenum format, const PictureSize& size, int samples) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width_px, size.height_px);
    return GlName<deleteRenderbuffer>(name);
}

}  // namespace

GlBuffer makeBuffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return GlBuffer(name);
}

GlVertexArray makeVertexArray() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return GlVertexArray(name);
}

Result<GlProgram> GlProgram::link(const std::string& name, const std::string& vertex,
                                  const std::string& fragment) {
    auto vertex_shader = compile(name, GL_VERTEX_SHADER, vertex);
    if (!vertex_shader)
        return vertex_shader.error();
    auto fragment_shader = compile(name, GL_FRAGMENT_SHADER, fragment);
    if (!fragment_shader)
        return fragment_shader.error();
    GlProgram program;
    program.program_ = GlProgramName(glCreateProgram());
    glAttachShader(program.program_, *vertex_shader);
    glAttachShader(program.program_, *fragment_shader);
    glLinkProgram(program.program_);
    GLint linked = GL_FALSE;
    glGetProgramiv(program.program_, GL_LINK_STATUS, &linked);
    if (!linked)
        return Error{ErrorKind::kUnusable, "The graphics driver could not link the shaders \"" + name + "\"",
                     "Update the graphics driver"};
    return program;
}

void GlTarget::fit(const PictureSize& size, int samples) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    samples = std::clamp(samples, 0, most);
    if (size.width_px == size_.width_px && size.height_px == size_.height_px && samples == samples_)
        return;
    size_ = size;
    samples_ = samples;
    color_ = makeRenderbuffer(GL_RGBA8, size, samples);
    depth_ = makeRenderbuffer(GL_DEPTH_COMPONENT24, size, samples);
    framebuffer_ = makeFramebuffer(depth_);
    depth_apart_ = {};
    framebuffer_apart_ = {};
}

GlName<deleteFramebuffer> GlTarget::makeFramebuffer(GLuint depth) const {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    return GlName<deleteFramebuffer>(name);
}

void GlTarget::bindApart() {
    if (!depth_apart_) {
        depth_apart_ = makeRenderbuffer(GL_DEPTH_COMPONENT24, size_, samples_);
        framebuffer_apart_ = makeFramebuffer(depth_apart_);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_apart_);
}

void GlTarget::copyTo(GLuint framebuffer) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, size_.width_px, size_.height_px, 0, 0, size_.width_px, size_.height_px,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace noctule
