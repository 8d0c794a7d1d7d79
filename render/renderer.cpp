// The passes of a picture: backdrop, opaque things, ground, lines that are hidden, translucent faces from the
// back to the front, lines in front.
#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "core/base/error.h"
#include "render/gl/draw.h"
#include "render/splat.h"
#include "render/translucent.h"

namespace archetype {
namespace {

// In device coordinates; about a five-hundredth of the distance to the target. Faces of boxes often lie on
// the surface they were fitted to, and outlines on both.
constexpr float faces_nearer = 0.8e-4F;
constexpr float lines_nearer = 1.6e-4F;

constexpr float mesh_edge_width = 1.0F;  // pixels

struct Theme {
  glm::vec3 top;
  glm::vec3 bottom;
  glm::vec3 ink;  // of grids and wireframes
};

constexpr Theme light_theme{{0.965F, 0.97F, 0.976F}, {0.86F, 0.872F, 0.89F}, {0.16F, 0.18F, 0.22F}};
constexpr Theme dark_theme{{0.205F, 0.216F, 0.235F}, {0.106F, 0.113F, 0.125F}, {0.78F, 0.82F, 0.88F}};

const Theme& theme_of(const Scene& scene) {
  return scene.backdrop == Backdrop::dark ? dark_theme : light_theme;
}

glm::vec4 unit_colour(const Rgb& colour) {
  return glm::vec4(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                   static_cast<float>(colour[2]), 255.F) /
         255.F;
}

// Pixels drawn of the whole picture, where this is a piece of it.
Viewport whole_picture(const gl::Framebuffer& drawn, const PictureSize& size) {
  if (size.piece.whole_width == 0) return {drawn.width(), drawn.height()};
  return {size.piece.whole_width * size.supersample, size.piece.whole_height * size.supersample};
}

// Takes what the whole picture shows, in clip space, to what the piece shows.
glm::dmat4 piece_of(const Viewport& whole, const gl::Framebuffer& drawn, const PictureSize& size) {
  glm::dmat4 matrix(1);
  if (size.piece.whole_width == 0) return matrix;
  const double finer = size.supersample;
  matrix[0][0] = static_cast<double>(whole.width) / drawn.width();
  matrix[1][1] = static_cast<double>(whole.height) / drawn.height();
  matrix[3][0] = (whole.width - 2 * finer * size.piece.left) / drawn.width() - 1;
  matrix[3][1] = 1 - (whole.height - 2 * finer * size.piece.top) / drawn.height();
  return matrix;
}

}  // namespace

// What all passes of a picture need.
struct Renderer::View {
  Camera camera;
  glm::mat4 view_projection;
  glm::vec4 eye;
  glm::vec3 key_direction;
  glm::vec3 fill_direction;
  glm::vec2 pixels;
  float finer;            // the supersampling
  float line_scale;       // pixels drawn per unit of line widths
  float pixels_per_unit;  // at w = 1
  float splat_scale;      // of the largest splats: large pictures, which come in pieces, have larger ones

  View(const Camera& c, const gl::Framebuffer& drawn, const PictureSize& size)
      : View(c, whole_picture(drawn, size), drawn, size) {}
  View(const Camera& c, const Viewport& viewport, const gl::Framebuffer& drawn, const PictureSize& size)
      : camera(c),
        view_projection(piece_of(viewport, drawn, size) * projection_matrix(c, viewport) * view_matrix(c)),
        eye(c.orthographic ? glm::vec4(back_axis(c), 0) : glm::vec4(archetype::eye(c), 1)),
        key_direction(glm::normalize(-0.45 * right_axis(c) + 0.75 * up_axis(c) + 0.85 * back_axis(c))),
        fill_direction(glm::normalize(0.9 * right_axis(c) - 0.1 * up_axis(c) + 0.45 * back_axis(c))),
        pixels(drawn.width(), drawn.height()),
        finer(static_cast<float>(size.supersample)),
        line_scale(finer * size.line_scale),
        pixels_per_unit(static_cast<float>((c.orthographic ? 1.0 : c.distance) / pixel_size(c, viewport))),
        splat_scale(size.piece.whole_width > 0 ? size.line_scale : 1.F) {}

  void set(const gl::Program& program) const {
    program.use();
    program.set("view_projection", view_projection);
    program.set("eye", eye);
    program.set("key_direction", key_direction);
    program.set("fill_direction", fill_direction);
  }
};

Renderer::Renderer(const std::filesystem::path& shader_folder)
    : mesh_(shader_folder / "mesh.vert", shader_folder / "mesh.frag"),
      points_(shader_folder / "points.vert", shader_folder / "points.frag"),
      lines_(shader_folder / "line.vert", shader_folder / "line.frag"),
      faces_(shader_folder / "face.vert", shader_folder / "face.frag"),
      grid_(shader_folder / "grid.vert", shader_folder / "grid.frag"),
      backdrop_(shader_folder / "screen.vert", shader_folder / "backdrop.frag"),
      reduce_(shader_folder / "screen.vert", shader_folder / "reduce.frag") {
  using gl::Component;
  face_vertices_.attach(face_buffer_,
                        {0, 3, Component::float32, sizeof(FaceVertex), offsetof(FaceVertex, position)});
  face_vertices_.attach(face_buffer_,
                        {1, 3, Component::float32, sizeof(FaceVertex), offsetof(FaceVertex, normal)});
  face_vertices_.attach(face_buffer_,
                        {2, 4, Component::unorm8, sizeof(FaceVertex), offsetof(FaceVertex, colour)});
  using Line = LineInstance;
  line_vertices_.attach(line_buffer_, {0, 3, Component::float32, sizeof(Line), offsetof(Line, from), true});
  line_vertices_.attach(line_buffer_, {1, 3, Component::float32, sizeof(Line), offsetof(Line, to), true});
  line_vertices_.attach(line_buffer_, {2, 4, Component::unorm8, sizeof(Line), offsetof(Line, colour), true});
  line_vertices_.attach(line_buffer_, {3, 2, Component::float32, sizeof(Line), offsetof(Line, width), true});
}

void Renderer::resize(const PictureSize& wanted, RenderTarget& target) const {
  PictureSize size = wanted;
  const int largest = gl::largest_framebuffer_side();
  size.width = std::clamp(size.width, 1, largest);
  size.height = std::clamp(size.height, 1, largest);
  size.supersample = std::clamp(size.supersample, 1, 4);
  while (size.supersample > 1 && std::max(size.width, size.height) * size.supersample > largest)
    --size.supersample;
  if (target.drawn_ && target.size_ == size) return;
  target.size_ = size;
  target.drawn_.emplace(size.width * size.supersample, size.height * size.supersample);
  target.reduced_.reset();
  if (size.supersample > 1) target.reduced_.emplace(size.width, size.height);
}

void Renderer::draw(const Scene& scene, const Camera& camera, const PictureSize& size, RenderTarget& target) {
  resize(size, target);
  const gl::Framebuffer& drawn = *target.drawn_;
  const View view(camera, drawn, target.size_);
  {
    const gl::DrawInto here(drawn);
    gl::clear(glm::vec4(0));
    draw_backdrop(scene);
    draw_points(scene, view, true);
    draw_meshes(scene, view);
    draw_points(scene, view, false);
    draw_grid(scene, view);
    draw_faces(scene, view);
    draw_lines(scene, view);
  }
  if (target.reduced_) {
    const gl::DrawInto here(*target.reduced_);
    gl::apply({.depth_test = gl::DepthTest::off, .depth_write = false});
    reduce_.use();
    reduce_.set("picture", 0);
    reduce_.set("factor", target.size_.supersample);
    drawn.colour().bind(0);
    gl::draw_triangles(nothing_, 3);
  }
  uploads_.end_picture();
  gl::check_errors("drawing a scene");
}

void Renderer::draw_more_points(const Scene& scene, const Camera& camera, RenderTarget& target) {
  if (!target.drawn_ || target.reduced_)
    throw PreconditionError("more points need a picture that was drawn without supersampling");
  {
    const gl::DrawInto here(*target.drawn_);
    draw_points(scene, View(camera, *target.drawn_, target.size_), false);
  }
  uploads_.end_picture();
  gl::check_errors("drawing points");
}

void Renderer::draw_backdrop(const Scene& scene) const {
  if (scene.backdrop == Backdrop::transparent) return;
  gl::apply({.depth_test = gl::DepthTest::off, .depth_write = false});
  backdrop_.use();
  backdrop_.set("top", theme_of(scene).top);
  backdrop_.set("bottom", theme_of(scene).bottom);
  gl::draw_triangles(nothing_, 3);
}

void Renderer::draw_meshes(const Scene& scene, const View& view) {
  if (scene.meshes.empty()) return;
  gl::apply({});
  view.set(mesh_);
  mesh_.set("edge_colour", theme_of(scene).ink);
  for (const SceneMesh& mesh : scene.meshes) {
    if (!mesh.geometry || mesh.geometry->faces.empty() || (!mesh.surface && !mesh.edges)) continue;
    const gl::VertexArray& vertices = uploads_.mesh(mesh);
    mesh_.set("transform", mesh.transform);
    mesh_.set("colour", mesh.face_colours ? glm::vec4(0) : unit_colour(mesh.colour));
    mesh_.set("lit", mesh.lit ? 1 : 0);
    mesh_.set("surface", mesh.surface ? 1 : 0);
    mesh_.set("edge_width", mesh.edges ? mesh_edge_width * view.line_scale : 0.F);
    gl::draw_triangles(vertices, 3 * mesh.geometry->triangle_count());
  }
}

void Renderer::draw_points(const Scene& scene, const View& view, bool behind) {
  const auto wanted = [&](const ScenePoints& points) { return points.behind == behind; };
  if (std::ranges::none_of(scene.points, wanted)) return;
  if (behind)
    gl::apply({.depth_test = gl::DepthTest::off, .depth_write = false});
  else
    gl::apply({});
  view.set(points_);
  points_.set("scale", view.pixels_per_unit);
  points_.set("diameters",
              glm::vec2(least_splat_diameter, largest_splat_diameter * view.splat_scale) * view.finer);
  for (const ScenePoints& points : scene.points) {
    if (!wanted(points) || !points.geometry || points.geometry->positions.empty()) continue;
    const gl::VertexArray& vertices = uploads_.points(points);
    points_.set("transform", points.transform);
    points_.set("colour", points.colours ? glm::vec4(0) : unit_colour(points.colour));
    points_.set("lit", points.lit && !points.geometry->normals.empty() ? 1 : 0);
    points_.set("radius", splat_radius(points));
    points_.set("blend", points.geometry->moved.empty() ? 0.F : points.blend);
    if (const std::size_t last = last_drawn(points); last > points.first)
      gl::draw_points(vertices, points.first, last - points.first);
  }
}

void Renderer::draw_grid(const Scene& scene, const View& view) const {
  if (!scene.grid) return;
  gl::apply({.depth_write = false, .blend = true});
  view.set(grid_);
  // As large as the view needs, in steps of ten, so that cells do not change while the camera moves a little.
  const double decade = std::pow(10.0, std::floor(std::log10(view.camera.distance / 2.0)));
  const glm::dvec3& target = view.camera.target;
  grid_.set("centre", glm::vec3(target.x, scene.ground, target.z));
  grid_.set("reach", static_cast<float>(1.6 * view.camera.distance));
  grid_.set("cell", static_cast<float>(0.2 * decade));
  grid_.set("ink", theme_of(scene).ink);
  gl::draw_quads(nothing_, 1);
}

void Renderer::draw_faces(const Scene& scene, const View& view) {
  const std::vector<FaceVertex> vertices = sorted_faces(scene, view.camera);
  if (vertices.empty()) return;
  gl::apply({.depth_write = false, .blend = true});
  view.set(faces_);
  faces_.set("nearer", faces_nearer);
  face_buffer_.upload(std::span(vertices));
  gl::draw_triangles(face_vertices_, vertices.size());
}

void Renderer::draw_lines(const Scene& scene, const View& view) {
  const std::vector<LineInstance> lines = collect_lines(scene);
  if (lines.empty()) return;
  view.set(lines_);
  lines_.set("viewport", view.pixels);
  lines_.set("scale", view.line_scale);
  lines_.set("nearer", lines_nearer);
  line_buffer_.upload(std::span(lines));
  if (scene.hidden_lines > 0) {
    gl::apply({.depth_test = gl::DepthTest::behind, .depth_write = false, .blend = true});
    lines_.set("opacity", scene.hidden_lines);
    gl::draw_quads(line_vertices_, lines.size());
  }
  gl::apply({.depth_write = false, .blend = true});
  lines_.set("opacity", 1.F);
  gl::draw_quads(line_vertices_, lines.size());
}

}  // namespace archetype
