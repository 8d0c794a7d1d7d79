#version 330 core
// Surfaces and wireframes.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 edge_distance;
layout(location = 3) in vec4 face_colour;

uniform mat4 transform;  // to the world
uniform mat4 view_projection;
uniform vec4 colour;     // alpha 0: the faces' own

out vec3 world_position;
out vec3 world_normal;
out vec3 edge;
flat out vec3 albedo;

void main() {
  vec4 world = transform * vec4(position, 1.0);
  world_position = world.xyz;
  world_normal = mat3(transform) * normal;
  edge = edge_distance.xyz;
  vec3 chosen = colour.a > 0.0 ? colour.rgb : face_colour.rgb;
  albedo = chosen * chosen;
  gl_Position = view_projection * world;
}
