// SPDX-License-Identifier: Apache-2.0
// OpenGL's objects as values that own them. All need the context current in which they were made.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <utility>

#include "core/job/result.h"
#include "core/render/camera.h"

namespace noctule {

/// Owns one name; `Delete` is a function of the name.
template <void (*Delete)(GLuint)>
class GlName {
public:
    GlName() = default;
    explicit GlName(GLuint name) : name_(name) {}
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlName() {
        if (name_)
            Delete(name_);
    }
    operator GLuint() const { return name_; }

private:
    GLuint name_ = 0;
};

inline void deleteProgram(GLuint name) {
    glDeleteProgram(name);
}
inline void deleteShader(GLuint name) {
    glDeleteShader(name);
}
inline void deleteBuffer(GLuint name) {
    glDeleteBuffers(1, &name);
}
inline void deleteVertexArray(GLuint name) {
    glDeleteVertexArrays(1, &name);
}
inline void deleteTexture(GLuint name) {
    glDeleteTextures(1, &name);
}
inline void deleteRenderbuffer(GLuint name) {
    glDeleteRenderbuffers(1, &name);
}
inline void deleteFramebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}

using GlProgramName = GlName<deleteProgram>;
using GlBuffer = GlName<deleteBuffer>;
using GlTexture = GlName<deleteTexture>;
using GlVertexArray = GlName<deleteVertexArray>;

GlBuffer makeBuffer();
GlVertexArray makeVertexArray();

/// A linked pair of shaders.
class GlProgram {
public:
    GlProgram() = default;
    /// kUnusable with the driver's words. The version line is added here.
    static Result<GlProgram> link(const std::string& name, const std::string& vertex,
                                  const std::string& fragment);
    void use() const { glUseProgram(program_); }
    GLint at(const char* uniform) const { return glGetUniformLocation(program_, uniform); }

private:
    GlProgramName program_;
};

/// What is drawn into before it is copied to where the picture goes: colour and depth, smoothed or not. A
/// second depth serves what is drawn into the same colours without being hidden and without hiding; it is
/// made when it is first asked for.
class GlTarget {
public:
    /// Made anew when size or samples differ; samples are capped at what the card can do.
    void fit(const PictureSize& size, int samples);
    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }
    void bindApart();
    void copyTo(GLuint framebuffer) const;

private:
    GlName<deleteFramebuffer> makeFramebuffer(GLuint depth) const;

    PictureSize size_{0, 0};
    int samples_ = -1;
    GlName<deleteRenderbuffer> color_, depth_, depth_apart_;
    GlName<deleteFramebuffer> framebuffer_, framebuffer_apart_;
};

}  // namespace noctule
