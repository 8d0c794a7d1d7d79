#version 330 core
// A disc, a little darker at its rim, so that splats of one colour stay apart.

flat in vec3 shown;
out vec4 result;

void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float r = dot(p, p);
  if (r > 1.0) discard;
  result = vec4(shown * (1.0 - 0.22 * r * r), 1.0);
}
