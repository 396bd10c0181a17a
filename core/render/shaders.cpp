// SPDX-License-Identifier: Apache-2.0
#include "core/render/shaders.h"

namespace noctule::shaders {

const char* const kBackgroundVertex = R"(
uniform vec3 top, bottom;
out vec3 color;
void main() {  // one triangle that covers the picture
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    color = mix(bottom, top, 0.5 + 0.5 * corner.y);
    gl_Position = vec4(corner, 1.0, 1.0);
}
)";

const char* const kBackgroundFragment = R"(
in vec3 color;
out vec4 result;
void main() {  // an ordered half step of noise: 8 bits would show bands in a dark gradient
    float bayer = fract(dot(vec2(floor(mod(gl_FragCoord.xy, 4.0))), vec2(0.5, 0.8125)));
    result = vec4(color + (bayer - 0.5) / 255.0, 1.0);
}
)";

const char* const kDiscVertex = R"(
uniform mat4 clip_from_world;
layout(location = 0) in vec3 centre;
layout(location = 1) in vec3 radii_softness;
layout(location = 2) in vec4 color_in;
out vec2 local;
flat out float softness;
flat out vec4 color;
void main() {
    local = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    local *= 1.1;
    softness = radii_softness.z;
    color = color_in;
    gl_Position = clip_from_world * vec4(centre + vec3(local.x * radii_softness.x, 0.0,
                                                       local.y * radii_softness.y), 1.0);
}
)";

const char* const kDiscFragment = R"(
in vec2 local;
flat in float softness;
flat in vec4 color;
out vec4 result;
void main() {
    float r = length(local);
    float edge = clamp(0.5 + (1.0 - r) / max(fwidth(r), 1e-5), 0.0, 1.0);
    float soft = r < 1.0 ? (1.0 - r * r) * (1.0 - r * r) : 0.0;
    result = vec4(color.rgb, color.a * mix(edge, soft, softness));
}
)";

// The same as mesh/skinning.cpp.
const char* const kBodyVertex = R"(
uniform samplerBuffer bones;  // linear: three rows of each bone's matrix; else of its stretch, then real and dual part
uniform bool dual_quaternions;
uniform mat4 view_from_world, clip_from_view;
uniform vec2 outline_ndc;  // how far the surface is moved outwards on the screen
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in uvec4 bone;
layout(location = 3) in vec4 weight;
layout(location = 4) in vec2 uv_in;
out vec2 uv;
out vec3 normal_view;
out vec3 normal_world;
out vec3 p_view;
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
void main() {
    int stride = dual_quaternions ? 5 : 3;
    uv = vec2(uv_in.x, 1.0 - uv_in.y);  // pictures begin at the top
    vec4 r0 = vec4(0.0), r1 = vec4(0.0), r2 = vec4(0.0), real = vec4(0.0), dual = vec4(0.0);
    vec4 first = dual_quaternions ? texelFetch(bones, int(bone[0]) * stride + 3) : vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        int b = int(bone[i]) * stride;
        r0 += weight[i] * texelFetch(bones, b);
        r1 += weight[i] * texelFetch(bones, b + 1);
        r2 += weight[i] * texelFetch(bones, b + 2);
        if (dual_quaternions) {
            vec4 q = texelFetch(bones, b + 3);
            float turned_weight = dot(q, first) < 0.0 ? -weight[i] : weight[i];
            real += turned_weight * q;
            dual += turned_weight * texelFetch(bones, b + 4);
        }
    }
    vec4 p = vec4(position, 1.0);
    vec4 world = vec4(dot(r0, p), dot(r1, p), dot(r2, p), 1.0);
    normal_world = vec3(dot(r0.xyz, normal_in), dot(r1.xyz, normal_in), dot(r2.xyz, normal_in));
    if (dual_quaternions) {
        float norm = length(real);
        real /= norm;
        dual /= norm;
        world.xyz = turned(real, world.xyz)
                  + 2.0 * (real.w * dual.xyz - dual.w * real.xyz + cross(real.xyz, dual.xyz));
        normal_world = turned(real, normal_world);
    }
    normal_view = mat3(view_from_world) * normal_world;
    vec4 view = view_from_world * world;
    p_view = view.xyz;
    gl_Position = clip_from_view * view;
    vec2 outward = (clip_from_view * vec4(normal_view, 0.0)).xy;
    gl_Position.xy += normalize(outward + vec2(1e-9)) * outline_ndc * gl_Position.w;
}
)";

// Matte, lit from beside the viewer so that every view is calm: soft key from the upper left, sky and ground
// as fill, a pale rim where the surface turns away.
const char* const kBodyFragment = R"(
uniform vec4 color;
uniform float parallel;
uniform sampler2D picture;
uniform bool has_picture;
in vec2 uv;
in vec3 normal_view;
in vec3 normal_world;
in vec3 p_view;
out vec4 result;
void main() {
    vec3 n = normalize(normal_view);
    vec3 to_eye = mix(normalize(-p_view), vec3(0.0, 0.0, 1.0), parallel);
    float facing = clamp(dot(n, to_eye), 0.0, 1.0);
    float key = clamp(dot(n, vec3(-0.42, 0.62, 0.66)) * 0.75 + 0.25, 0.0, 1.0);
    float sky = 0.5 + 0.5 * normalize(normal_world).y;
    float rim = pow(1.0 - facing, 3.0);
    vec3 surface = has_picture ? color.rgb * texture(picture, uv).rgb : color.rgb;
    vec3 lit = surface * (0.36 + 0.22 * sky + 0.62 * key * key)
             + vec3(0.34, 0.37, 0.42) * rim * (0.35 + 0.65 * sky);
    result = vec4(lit, mix(color.a, min(1.0, color.a + 0.25), rim));
}
)";

const char* const kContourFragment = R"(
uniform vec4 color;
out vec4 result;
void main() { result = color; }
)";

const char* const kLineVertex = R"(
uniform mat4 view_from_world, clip_from_view;
uniform vec2 size_px;
uniform float nearer_m;  // how much nearer the line counts when the body hides it
layout(location = 0) in vec3 from_m;
layout(location = 1) in vec3 to_m;
layout(location = 2) in vec4 from_color;
layout(location = 3) in vec4 to_color;
layout(location = 4) in vec2 width_dash;
noperspective out vec4 color;
noperspective out vec2 place_px;  // along and across
flat out vec2 width_dash_px;
void main() {
    vec4 a = view_from_world * vec4(from_m, 1.0), b = view_from_world * vec4(to_m, 1.0);
    vec4 ca = clip_from_view * a, cb = clip_from_view * b;
    vec4 color_a = from_color, color_b = to_color;
    float da = ca.z + ca.w, db = cb.z + cb.w;  // before the near plane when positive
    if (da < 0.0 && db < 0.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (da < 0.0 || db < 0.0) {
        float t = da / (da - db);
        vec4 cut = mix(a, b, t), cut_color = mix(color_a, color_b, t);
        if (da < 0.0) { a = cut; color_a = cut_color; ca = clip_from_view * a; }
        else { b = cut; color_b = cut_color; cb = clip_from_view * b; }
    }
    bool at_end = (gl_VertexID & 1) == 1;
    float side = (gl_VertexID >> 1) == 1 ? 1.0 : -1.0;
    vec2 from_px = ca.xy / ca.w * 0.5 * size_px, to_px = cb.xy / cb.w * 0.5 * size_px;
    vec2 along = to_px - from_px;
    float length_px = length(along);
    along = length_px > 1e-4 ? along / length_px : vec2(1.0, 0.0);
    float half_px = 0.5 * max(width_dash.x, 1.0) + 1.0;
    vec4 end = at_end ? b : a;
    vec4 nearer = clip_from_view * (end + vec4(0.0, 0.0, nearer_m, 0.0));
    vec2 px = (at_end ? to_px : from_px) + side * half_px * vec2(-along.y, along.x);
    gl_Position = vec4(px / (0.5 * size_px), clamp(nearer.z / nearer.w, -1.0, 1.0), 1.0);
    color = at_end ? color_b : color_a;
    place_px = vec2(at_end ? length_px : 0.0, side * half_px);
    width_dash_px = width_dash;
}
)";

const char* const kLineFragment = R"(
uniform float strength;
noperspective in vec4 color;
noperspective in vec2 place_px;
flat in vec2 width_dash_px;
out vec4 result;
void main() {
    float width = width_dash_px.x, dash = width_dash_px.y;
    float cover = clamp(0.5 * max(width, 1.0) + 0.5 - abs(place_px.y), 0.0, 1.0) * min(width, 1.0);
    if (dash > 0.0) {
        float at = mod(place_px.x, 1.75 * dash);
        cover *= clamp(0.5 + min(at, dash - at), 0.0, 1.0);
    }
    result = vec4(color.rgb, color.a * cover * strength);
}
)";

const char* const kMarkerVertex = R"(
uniform vec2 size_px;
layout(location = 0) in vec4 centre_depth_radius;  // centre in px from the top left corner
layout(location = 1) in vec4 corners01;
layout(location = 2) in vec4 corners23;
layout(location = 3) in vec4 axis_minor_edge;
layout(location = 4) in vec4 fill_in;
layout(location = 5) in vec4 edge_in;
noperspective out vec2 local;
flat out vec4 c01, c23, shape;
flat out float radius;
flat out vec4 fill, edge;
void main() {
    radius = centre_depth_radius.w;
    c01 = corners01;
    c23 = corners23;
    shape = axis_minor_edge;
    fill = fill_in;
    edge = edge_in;
    vec2 reach = max(max(abs(c01.xy), abs(c01.zw)), max(abs(c23.xy), abs(c23.zw))) + radius;
    if (radius == 0.0)
        reach = vec2(length(shape.xy));
    local = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0) * (reach + 1.5);
    vec2 px = centre_depth_radius.xy + local;
    gl_Position = vec4(px.x / size_px.x * 2.0 - 1.0, 1.0 - px.y / size_px.y * 2.0, centre_depth_radius.z, 1.0);
}
)";

const char* const kMarkerFragment = R"(
uniform float strength;
noperspective in vec2 local;
flat in vec4 c01, c23, shape;
flat in float radius;
flat in vec4 fill, edge;
out vec4 result;

float toQuadrangle(vec2 p) {  // signed distance; winding decides what is inside
    vec2 v[4] = vec2[4](c01.xy, c01.zw, c23.xy, c23.zw);
    float nearest = 1e9, inside = 1.0;
    bool inner = true;
    float sense = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 e = v[(i + 1) & 3] - v[i], w = p - v[i];
        vec2 off = w - e * clamp(dot(w, e) / max(dot(e, e), 1e-6), 0.0, 1.0);
        nearest = min(nearest, dot(off, off));
        float turn = e.x * w.y - e.y * w.x;
        if (i == 0) sense = turn;
        inner = inner && turn * sense > 0.0;
    }
    return inner ? -sqrt(nearest) : sqrt(nearest);
}

float toEllipse(vec2 p) {  // first-order distance, exact on circles and on the contour
    float major = length(shape.xy);
    vec2 u = shape.xy / max(major, 1e-6);
    vec2 q = vec2(dot(p, u), dot(p, vec2(-u.y, u.x)));
    vec2 r = vec2(major, shape.z);
    float k0 = length(q / r), k1 = length(q / (r * r));
    return k1 > 1e-6 ? k0 * (k0 - 1.0) / k1 : -shape.z;
}

void main() {
    float d = radius > 0.0 ? toQuadrangle(local) - radius : toEllipse(local);
    float cover = clamp(0.5 - d, 0.0, 1.0);
    if (cover <= 0.0)
        discard;
    vec4 color = mix(edge, fill, clamp(0.5 - (d + shape.w), 0.0, 1.0));
    result = vec4(color.rgb, color.a * cover * strength);
}
)";

}  // namespace noctule::shaders
