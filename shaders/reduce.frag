#version 330 core
// The mean of factor x factor pixels. What was blended over nothing is darkened by its opacity; what comes out is not.

uniform sampler2D picture;
uniform int factor;
out vec4 result;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * factor;
  vec3 colour = vec3(0.0);
  float alpha = 0.0;
  for (int y = 0; y < factor; ++y)
    for (int x = 0; x < factor; ++x) {
      vec4 texel = texelFetch(picture, first + ivec2(x, y), 0);
      colour += texel.rgb;
      alpha += texel.a;
    }
  result = vec4(colour / max(alpha, 1e-4), alpha / float(factor * factor));
}
