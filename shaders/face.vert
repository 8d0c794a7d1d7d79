#version 330 core
// Translucent faces: boxes and ellipsoids.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;

uniform mat4 view_projection;
uniform vec4 eye;
uniform float nearer;  // depth (device coordinates) by which faces come before the surfaces that they lie on

out vec4 face_colour;

void main() {
  vec3 to_eye = normalize(eye.xyz - eye.w * position);
  float facing = abs(dot(normal, to_eye));
  // Like glass: a face seen at a slant is less clear, and the upper ones are lighter.
  float shade = 0.92 + 0.14 * normal.y;
  face_colour = vec4(min(colour.rgb * shade, vec3(1.0)), min(1.0, colour.a * (1.35 - 0.45 * facing)));
  gl_Position = view_projection * vec4(position, 1.0);
  gl_Position.z -= nearer * gl_Position.w;
}
