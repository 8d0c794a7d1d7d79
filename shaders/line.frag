#version 330 core
// Soft edges make lines smooth without multisampling.

in vec4 line_colour;
in float across;
in float along;
flat in float half_width;
flat in float dash;

uniform float opacity;

out vec4 result;

void main() {
  float alpha = clamp(half_width + 0.5 - abs(across), 0.0, 1.0);
  if (dash > 0.0) {
    float phase = mod(along, 2.0 * dash);
    alpha *= clamp(min(phase, dash - phase) + 0.5, 0.0, 1.0);
  }
  alpha *= line_colour.a * opacity;
  if (alpha < 0.004) discard;
  result = vec4(line_colour.rgb, alpha);
}
