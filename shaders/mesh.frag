#version 330 core
// Surfaces, their wireframe over them, or the wireframe alone.
#include "lighting.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 edge;
flat in vec3 albedo;

uniform vec4 eye;         // w = 1: a point; w = 0: the direction to it (parallel view)
uniform int lit;
uniform int surface;
uniform float edge_width;  // pixels; 0: no edges
uniform vec3 edge_colour;  // display

out vec4 result;

void main() {
  vec3 shown = to_display(albedo);
  if (lit != 0) {
    vec3 to_eye = normalize(eye.xyz - eye.w * world_position);
    vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);
    shown = to_display(light(albedo, normal, to_eye));
  }
  if (edge_width > 0.0) {
    vec3 pixels = edge / max(fwidth(edge), 1e-6);
    float nearest = min(pixels.x, min(pixels.y, pixels.z));
    float ink = clamp(0.5 * edge_width + 0.5 - nearest, 0.0, 1.0);
    if (surface != 0) {
      shown = mix(shown, edge_colour, 0.55 * ink);
    } else {
      if (ink < 0.3) discard;
      shown = mix(shown, edge_colour, 0.35);
    }
  }
  result = vec4(shown, 1.0);
}
