#version 330 core
// Lines as wide as one asks for: four corners for each line, spread out in pixels.

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
layout(location = 3) in vec2 style;  // width and dash in pixels

uniform mat4 view_projection;
uniform vec2 viewport;  // pixels
uniform float scale;    // of widths and dashes: pixels of this picture per pixel of the screen
uniform float nearer;   // depth (device coordinates) by which lines come before the surfaces that they lie on

out vec4 line_colour;
out float across;       // pixels from the middle of the line
out float along;        // pixels from its beginning
flat out float half_width;
flat out float dash;

void main() {
  vec4 a = view_projection * vec4(from, 1.0);
  vec4 b = view_projection * vec4(to, 1.0);
  // What lies before the near plane is cut off here, since its place on the screen has no meaning.
  float a_room = a.w + a.z;
  float b_room = b.w + b.z;
  if (a_room < 0.0 && b_room > 0.0) a = mix(a, b, a_room / (a_room - b_room));
  else if (b_room < 0.0 && a_room > 0.0) b = mix(b, a, b_room / (b_room - a_room));

  vec2 a_pixel = a.xy / a.w * 0.5 * viewport;
  vec2 b_pixel = b.xy / b.w * 0.5 * viewport;
  vec2 line = b_pixel - a_pixel;
  float length_in_pixels = length(line);
  vec2 direction = length_in_pixels > 1e-6 ? line / length_in_pixels : vec2(1.0, 0.0);
  vec2 normal = vec2(-direction.y, direction.x);

  bool at_end = gl_VertexID >= 2;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  half_width = 0.5 * style.x * scale;
  dash = style.y * scale;
  float reach = half_width + 1.0;  // one pixel more, in which the line fades out
  across = side * reach;
  along = at_end ? length_in_pixels + half_width : -half_width;
  line_colour = colour;

  vec4 p = at_end ? b : a;
  p.xy += (normal * across + direction * (at_end ? half_width : -half_width)) / (0.5 * viewport) * p.w;
  p.z -= nearer * p.w;
  if (a_room < 0.0 && b_room < 0.0) p = vec4(0.0, 0.0, 2.0, 1.0);
  gl_Position = p;
}
