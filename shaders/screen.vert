#version 330 core
// One triangle that covers the picture.

out vec2 place;  // (0, 0) lower left, (1, 1) upper right

void main() {
  place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(2.0 * place - 1.0, 1.0, 1.0);
}
