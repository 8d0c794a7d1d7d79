// Light for surfaces and splats. A hemisphere of sky and ground for the ambient part, a key light over the viewer's
// left shoulder, a weak fill light from the right, and edges that fall off a little as if less light came in there.

uniform vec3 key_direction;  // unit, world space, towards the light
uniform vec3 fill_direction;

// Gamma 2 stands for sRGB's curve: a square and a root cost little where there is no graphics card.
vec3 to_linear(vec3 colour) { return colour * colour; }
vec3 to_display(vec3 colour) { return sqrt(colour); }

// `normal` on the viewer's side and `to_eye` are unit; `albedo` is linear.
vec3 light(vec3 albedo, vec3 normal, vec3 to_eye) {
  vec3 ambient = mix(vec3(0.20, 0.185, 0.17), vec3(0.50, 0.53, 0.57), 0.5 + 0.5 * normal.y);
  float key = max(0.0, dot(normal, key_direction));
  float fill = max(0.0, dot(normal, fill_direction));
  float facing = max(0.0, dot(normal, to_eye));
  float openness = 0.72 + 0.28 * facing;
  float shine = max(0.0, dot(normal, normalize(key_direction + to_eye)));
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  vec3 result = albedo * (ambient + vec3(0.62, 0.60, 0.57) * key + vec3(0.10, 0.115, 0.13) * fill) * openness;
  return result + vec3(0.05) * shine;
}
