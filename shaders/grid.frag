#version 330 core
// Lines a unit and a tenth of it apart that fade out with the distance from the centre.

in vec2 ground;
uniform vec3 centre;
uniform float reach;
uniform float cell;   // of the fine lines; every fifth is stronger
uniform vec3 ink;
out vec4 result;

// Coverage by lines `step` apart; fades where they would lie closer than two pixels.
float lines(vec2 p, float step, vec2 pixel) {
  vec2 w = pixel / step;
  vec2 d = abs(fract(p / step - 0.5) - 0.5) / max(w, vec2(1e-6));
  vec2 ink_of = clamp(1.0 - d, 0.0, 1.0) * clamp(1.5 - 3.0 * w, 0.0, 1.0);
  return max(ink_of.x, ink_of.y);
}

void main() {
  vec2 pixel = fwidth(ground);
  float r = length(ground - centre.xz) / reach;
  float fade = clamp(1.0 - r, 0.0, 1.0);
  float alpha = max(0.16 * lines(ground, cell, pixel), 0.34 * lines(ground, 5.0 * cell, pixel)) * fade * fade;
  if (alpha < 0.004) discard;
  result = vec4(ink, alpha);
}
