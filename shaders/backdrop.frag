#version 330 core
// A soft fall of light from top to bottom.

in vec2 place;
uniform vec3 top;
uniform vec3 bottom;
out vec4 result;

void main() {
  float t = place.y * place.y * (3.0 - 2.0 * place.y);
  // Half a step of noise, the same in every picture: without it the steps of 8 bits show as bands.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  result = vec4(mix(bottom, top, t) + noise / 255.0, 1.0);
}
