#version 330 core
// Points as round splats.
#include "lighting.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 point_colour;
layout(location = 3) in vec3 moved;

uniform mat4 transform;
uniform mat4 view_projection;
uniform vec4 colour;       // alpha 0: the points' own
uniform vec4 eye;
uniform float blend;       // from the position to the moved one
uniform int lit;
uniform float radius;      // world units
uniform float scale;       // pixels per world unit at w = 1
uniform vec2 diameters;    // least and largest, pixels

flat out vec3 shown;

void main() {
  vec4 world = transform * vec4(mix(position, moved, blend), 1.0);
  vec3 chosen = colour.a > 0.0 ? colour.rgb : point_colour.rgb;
  if (lit != 0) {
    vec3 to_eye = normalize(eye.xyz - eye.w * world.xyz);
    vec3 n = normalize(mat3(transform) * normal);
    chosen = to_display(light(to_linear(chosen), dot(n, to_eye) < 0.0 ? -n : n, to_eye));
  }
  shown = chosen;
  gl_Position = view_projection * world;
  gl_PointSize = clamp(2.0 * radius * scale / gl_Position.w, diameters.x, diameters.y);
}
