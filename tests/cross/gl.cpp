#include "tests/cross/gl.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl31.h>
#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace sg::cross {
namespace {

// A context per API, made once; "" in `missing` or why there is none.
struct Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    std::string missing;
};

Context make_context(bool es) {
    Context out;
    auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display) out.display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (out.display == EGL_NO_DISPLAY || !eglInitialize(out.display, nullptr, nullptr)) {
        out.missing = "EGL has no surfaceless display";
        return out;
    }
    eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, es ? 3 : 4, EGL_CONTEXT_MINOR_VERSION, es ? 1 : 5,
                              EGL_NONE};
    out.context = eglCreateContext(out.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (out.context == EGL_NO_CONTEXT)
        out.missing = es ? "no OpenGL ES 3.1 context" : "no OpenGL 4.5 context";
    return out;
}

const Context& context_of(target::Language language) {
    static const Context kDesktop = make_context(false), kEmbedded = make_context(true);
    return language == target::Language::glsl ? kDesktop : kEmbedded;
}

void make_current(target::Language language) {
    const Context& context = context_of(language);
    if (!context.missing.empty()) throw std::runtime_error(context.missing);
    eglBindAPI(language == target::Language::glsl ? EGL_OPENGL_API : EGL_OPENGL_ES_API);
    if (!eglMakeCurrent(context.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context))
        throw std::runtime_error("eglMakeCurrent failed");
}

void check_gl(const char* where) {
    GLenum error = glGetError();
    if (error != GL_NO_ERROR) throw std::runtime_error(fmt::format("GL error {:#x} {}", error, where));
}

GLuint compile(GLenum kind, const std::string& text) {
    GLuint shader = glCreateShader(kind);
    const char* strings[] = {text.c_str()};
    glShaderSource(shader, 1, strings, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;
    std::string log(1024, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, 1024, &length, log.data());
    glDeleteShader(shader);
    throw std::runtime_error("Mesa: " + log.substr(0, static_cast<std::size_t>(length)));
}

GLuint link(const std::string& vertex, const std::string& fragment) {
    GLuint program = glCreateProgram();
    for (GLuint shader : {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)}) {
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (good) return program;
    std::string log(1024, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, 1024, &length, log.data());
    glDeleteProgram(program);
    throw std::runtime_error("Mesa, linking: " + log.substr(0, static_cast<std::size_t>(length)));
}

// Everything that a draw makes goes with it.
struct Objects {
    std::vector<GLuint> buffers, textures, samplers, framebuffers, renderbuffers;
    GLuint program = 0, vertex_array = 0;
    Objects() = default;
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;
    ~Objects() {
        glDeleteBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
        glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
        glDeleteSamplers(static_cast<GLsizei>(samplers.size()), samplers.data());
        glDeleteProgram(program);
        glDeleteVertexArrays(1, &vertex_array);
        glDeleteFramebuffers(static_cast<GLsizei>(framebuffers.size()), framebuffers.data());
        glDeleteRenderbuffers(static_cast<GLsizei>(renderbuffers.size()), renderbuffers.data());
    }
};

// With that many colour attachments, and what holds the depth, if anything. They are drawn into and read.
void make_target(Objects& objects, std::size_t attachments, GLuint depth) {
    objects.framebuffers.emplace_back();
    glGenFramebuffers(1, &objects.framebuffers.back());
    glBindFramebuffer(GL_FRAMEBUFFER, objects.framebuffers.back());
    std::vector<GLenum> places;
    for (std::size_t i = 0; i < attachments; ++i) {
        places.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
        objects.renderbuffers.emplace_back();
        glGenRenderbuffers(1, &objects.renderbuffers.back());
        glBindRenderbuffer(GL_RENDERBUFFER, objects.renderbuffers.back());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, kSide, kSide);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, places.back(), GL_RENDERBUFFER,
                                  objects.renderbuffers.back());
    }
    if (depth != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    if (places.empty()) places.push_back(GL_NONE);
    glDrawBuffers(static_cast<GLsizei>(places.size()), places.data());
    glReadBuffer(places[0]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("no float framebuffer");
    glViewport(0, 0, kSide, kSide);
}

GLuint make_depth(Objects& objects) {
    objects.textures.emplace_back();
    glGenTextures(1, &objects.textures.back());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, objects.textures.back());
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT32F, kSide, kSide);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return objects.textures.back();
}

// ES cannot read depth back: this copies it into colours, with alpha 1 where something was drawn.
constexpr const char* kDepthVertex = R"(#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";
constexpr const char* kDepthFragment = R"(#version 300 es
precision highp float;
uniform highp sampler2D depth;
out vec4 color;
void main() {
    float d = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).x;
    color = d < 1.0 ? vec4(d, d, d, 1.0) : vec4(0.0);
}
)";

void copy_depth(Objects& objects, GLuint depth) {
    make_target(objects, 1, 0);
    glDeleteProgram(objects.program);
    objects.program = link(kDepthVertex, kDepthFragment);
    glUseProgram(objects.program);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, depth);
    glBindSampler(0, 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

GLuint make_buffer(Objects& objects, GLenum kind, const void* data, std::size_t size) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    objects.buffers.push_back(buffer);
    glBindBuffer(kind, buffer);
    glBufferData(kind, static_cast<GLsizeiptr>(size), data, GL_STATIC_DRAW);
    return buffer;
}

void bind_vertices(Objects& objects, const Drawing& drawing) {
    glGenVertexArrays(1, &objects.vertex_array);
    glBindVertexArray(objects.vertex_array);
    for (const Attribute& attribute : drawing.attributes) {
        make_buffer(objects, GL_ARRAY_BUFFER, attribute.values.data(),
                    attribute.values.size() * sizeof(float));
        glVertexAttribPointer(attribute.location, static_cast<GLint>(attribute.components), GL_FLOAT,
                              GL_FALSE, 0, nullptr);
        glEnableVertexAttribArray(attribute.location);
    }
    make_buffer(objects, GL_ELEMENT_ARRAY_BUFFER, drawing.indices.data(),
                drawing.indices.size() * sizeof(std::uint32_t));
}

void upload(const TextureView& view) {
    for (std::size_t level = 0; level < view.chain->size(); ++level) {
        const asset::Image& image = (*view.chain)[level];
        auto width = static_cast<GLsizei>(image.width), height = static_cast<GLsizei>(image.height);
        if (image.format == asset::TexelFormat::unorm8) {
            glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), view.srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                         width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.bytes.data());
            continue;
        }
        glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), GL_RGBA32F, width, height, 0, GL_RGBA,
                     GL_FLOAT, texels_of(image).data());
    }
}

GLint wrap_word(runtime::gpu::Wrap wrap) {
    constexpr GLint kWords[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE};
    return kWords[static_cast<std::size_t>(wrap)];
}

GLint minifying(const runtime::gpu::SamplerState& state) {
    using enum runtime::gpu::MipFilter;
    if (state.mip_filter == none) return state.linear ? GL_LINEAR : GL_NEAREST;
    if (state.mip_filter == nearest)
        return state.linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
    return state.linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
}

GLuint make_sampler(Objects& objects, const runtime::gpu::SamplerState& state) {
    GLuint sampler = 0;
    glGenSamplers(1, &sampler);
    objects.samplers.push_back(sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, wrap_word(state.wrap_s));
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, wrap_word(state.wrap_t));
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, state.linear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, minifying(state));
    return sampler;
}

// Textures at the units and blocks at the points that the text itself states, which must be those of the
// manifest.
void bind_slots(Objects& objects, const Drawing& drawing, const Stage& stage) {
    for (const Slot& slot : stage.slots) {
        if (slot.kind == "uniform_buffer") {
            const auto& bytes = drawing.blocks[slot.set];
            GLuint buffer = make_buffer(objects, GL_UNIFORM_BUFFER, bytes.data(), bytes.size());
            glBindBufferBase(GL_UNIFORM_BUFFER, slot.index, buffer);
            if (glGetUniformBlockIndex(objects.program, slot.name.c_str()) == GL_INVALID_INDEX)
                throw std::runtime_error("no block " + slot.name);
            continue;
        }
        glActiveTexture(GL_TEXTURE0 + slot.index);
        GLuint texture = 0;
        glGenTextures(1, &texture);
        objects.textures.push_back(texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        upload(drawing.textures.at(slot.binding));
        glBindSampler(slot.index, make_sampler(objects, drawing.samplers.at(slot.sampler_binding)));
        if (glGetUniformLocation(objects.program, slot.name.c_str()) < 0)
            throw std::runtime_error("no sampler " + slot.name);
    }
}

void read_plane(GLenum attachment, Pixels& out) {
    constexpr std::size_t kRow = std::size_t{kSide} * 4;
    Pixels rows(kPlane);
    glReadBuffer(attachment);
    glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, rows.data());
    for (std::size_t y = kSide; y-- > 0;) out.insert(out.end(), &rows[y * kRow], &rows[y * kRow] + kRow);
}

void clear(std::size_t attachments) {
    const GLfloat color[] = {0, 0, 0, 0}, far_depth = 1;
    for (std::size_t i = 0; i < attachments; ++i) glClearBufferfv(GL_COLOR, static_cast<GLint>(i), color);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
}

}  // namespace

std::string gl_missing(target::Language language) {
    return context_of(language).missing;
}

Pixels gl_draw(const Drawing& drawing) {
    make_current(drawing.target->language);
    Objects objects;
    objects.program = link(drawing.vertex.text, drawing.fragment.text);
    const GLuint depth = make_depth(objects);
    make_target(objects, drawing.attachments, depth);
    bind_vertices(objects, drawing);
    bind_slots(objects, drawing, drawing.vertex);
    bind_slots(objects, drawing, drawing.fragment);
    glUseProgram(objects.program);
    clear(drawing.attachments);
    glEnable(GL_DEPTH_TEST);
    drawing.cull_back ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(drawing.indices.size()), GL_UNSIGNED_INT, nullptr);
    if (drawing.attachments == 0) copy_depth(objects, depth);
    Pixels out;
    for (std::size_t i = 0; i < std::max<std::size_t>(drawing.attachments, 1); ++i)
        read_plane(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), out);
    check_gl("while drawing");
    return out;
}

std::string gl_refusal(const std::string& vertex, const std::string& fragment, target::Language language) {
    try {
        make_current(language);
        glDeleteProgram(link(vertex, fragment));
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

}  // namespace sg::cross
