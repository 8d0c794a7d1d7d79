// Figures for papers and pages: drawn beside the window from what the project holds, at any size, with an
// OpenGL context of their own.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/io/project.h"
#include "render/gl/headless_context.h"
#include "render/lettering.h"
#include "render/renderer.h"
#include "ui/cloud_choice.h"

namespace archetype {

struct FigureOptions {
  int width = 2400;          // pixels, from least_figure_width
  bool transparent = false;  // else white
};
inline constexpr int least_figure_width = 200;
inline constexpr int most_figure_side = 32'000;
// Throws Error, with the bounds, for a width that no figure can have.
void check_figure_width(double width);
inline constexpr std::size_t most_figure_pixels = 150'000'000;  // 600 MB while it is made

// What a figure is made from.
struct FigureRequest {
  std::filesystem::path project;
  std::filesystem::path shaders;
  FigureOptions options;
  std::vector<ShapeId> shapes;          // that it shows, or whose points it does
  std::vector<PartTemplate> templates;  // where the project has none of its own
  // Of co-aligned points: what they are coloured by, and of what they are: a template, the selection, …
  CloudColour cloud_colour = CloudColour::part;
  std::string cloud_of;
  std::size_t outliers = 0;  // that were left out
};

// A page that grows row by row, and what draws on it. Lengths are in units of which the page has 1,000 in
// its width.
class FigurePage {
 public:
  // Throws Error where OpenGL is missing or the width is out of bounds.
  explicit FigurePage(const FigureRequest& request);

  // Makes the page that high. Throws Error where it would have more pixels than can be held.
  void set_height(double height);
  // Fills the rectangle. False if cancelled.
  bool draw_scene(const Scene& scene, const Camera& camera, double left, double top, double width,
                  double height, const JobControl& control);
  enum class Style { plain, bold, muted };
  void write(const std::string& text, double left, double top, double size, Style style = Style::plain,
             double most_width = 1000);
  void fill(double left, double top, double width, double height, const Rgb& colour);
  // How wide the text is that write() writes.
  double width_of(const std::string& text, double size) const;
  // Of a scene drawn into a rectangle, for the camera.
  Viewport viewport(double width, double height) const;
  const Picture& picture() const { return picture_; }

 private:
  int pixels(double length) const;

  gl::HeadlessContext context_;
  Renderer renderer_;
  Lettering plain_;
  Lettering bold_;
  FigureOptions options_;
  Picture picture_;
};

// Each throws Error with a line for a person where there is nothing to show, and returns nothing if
// cancelled. The templates in a row, as in the figures of the paper: mean boxes, an ellipsoid for the spread
// of each position and dashed lines for that of each size.
std::optional<Picture> templates_figure(const FigureRequest& request, const JobControl& control);
// A sheet of clusters: each template with its members, best first, as many as stand beside it; outliers
// below, worst first.
std::optional<Picture> clusters_figure(const FigureRequest& request, const JobControl& control);
// The same with all of the members.
std::optional<Picture> members_figure(const FigureRequest& request, const JobControl& control);
// Templates that learning began with, above those that it ended with (measure_starts.h).
std::optional<Picture> starts_figure(const FigureRequest& request, const JobControl& control);
// All points of request.shapes: rigid beside deformed, in the colours of the view, with how sharp they are.
std::optional<Picture> coalignment_figure(const FigureRequest& request, const JobControl& control);
// The fit of the first of request.shapes: shape, parts, boxes and correspondences.
std::optional<Picture> fit_figure(const FigureRequest& request, const JobControl& control);

}  // namespace archetype
