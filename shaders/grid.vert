#version 330 core
// The ground: a square about the point below the camera's target.

uniform mat4 view_projection;
uniform vec3 centre;
uniform float reach;

out vec2 ground;

void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  ground = centre.xz + reach * corner;
  gl_Position = view_projection * vec4(ground.x, centre.y, ground.y, 1.0);
}
