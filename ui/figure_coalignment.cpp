// All points of many shapes in one space, rigid beside deformed (figure 8).
#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/error.h"
#include "ui/cloud_content.h"
#include "ui/cloud_picture.h"
#include "ui/figure.h"
#include "ui/figure_scenes.h"
#include "ui/heat_map.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr double margin = 16;
constexpr double gap = 12;
constexpr double text = 15;
constexpr double small_text = 12;
constexpr double swatch = 9;
constexpr double scale_width = 160;  // of the colour scale
constexpr double row = 1.35 * small_text;

std::string formatted(const char* format, double value) {
  char line[96];
  std::snprintf(line, sizeof line, format, value);
  return line;
}

std::string sharpness_text(const Sharpness& sharpness, double blend) {
  const double mean = sharpness.mean_at(blend);
  std::string line = formatted("mean squared distance to the canonical place %.4f", mean);
  if (blend > 0 && mean > 0) line += formatted(", %.1f times less", sharpness.mean_rigid() / mean);
  return line;
}

std::string about(const FigureRequest& request, const CloudContent& content) {
  std::string line = plural(content.shapes.size(), "shape");
  if (request.outliers > 0) line += ", " + plural(request.outliers, "outlier") + " left out";
  line += ", " + count_text(content.of.size());
  if (content.samples > content.of.size()) line += " of " + count_text(content.samples);
  return line + " points";
}

// What the colours mean, in lines from the left; without a page it is only measured.
class Legend {
 public:
  Legend(FigurePage* page, const FigurePage& measure, double top)
      : page_(page), measure_(measure), top_(top) {}

  void entry(const Rgb& colour, const std::string& name) {
    const double width = swatch + 4 + measure_.width_of(name, small_text);
    if (left_ > margin && left_ + width > 1000 - margin) {
      left_ = margin;
      top_ += row;
    }
    if (page_) {
      page_->fill(left_, top_ + (small_text - swatch) / 2 + 1, swatch, swatch, colour);
      page_->write(name, left_ + swatch + 4, top_, small_text);
    }
    left_ += width + gap;
  }

  // From nothing to `most`.
  void scale(double most) {
    if (page_) {
      constexpr int steps = 64;
      for (int i = 0; i < steps; ++i)
        page_->fill(margin + scale_width * i / steps, top_ + 2, scale_width / steps + 0.5, swatch,
                    heat_colour((i + 0.5) / steps));
      page_->write("moved by the deformation: 0 to " + formatted("%g", most) + " and more",
                   margin + scale_width + 8, top_, small_text);
    }
    left_ = margin + scale_width;
  }

  double bottom() const { return left_ > margin ? top_ + row : top_; }

 private:
  FigurePage* page_;
  const FigurePage& measure_;
  double left_ = margin;
  double top_;
};

void write_legend(Legend& legend, const CloudContent& content, CloudColour by) {
  if (by == CloudColour::displacement) legend.scale(static_cast<double>(content.largest_displacement));
  // Parts of several templates have no colours of their own, and shapes are too many.
  if (by != CloudColour::part || content.templates.size() != 1) return;
  const PartTemplate& part_template = content.templates.front().part_template;
  for (std::size_t i = 0; i < part_template.parts.size(); ++i)
    legend.entry(part_colour(part_template, static_cast<int>(i)), part_template.parts[i].name);
}

}  // namespace

std::optional<Picture> coalignment_figure(const FigureRequest& request, const JobControl& control) {
  if (request.shapes.empty()) throw Error("no shape is fitted yet; fit a template to all shapes first");
  CloudContentRequest wanted;
  wanted.project = request.project;
  wanted.what.shapes = request.shapes;
  wanted.progress = std::make_shared<CloudProgress>();
  const auto read = read_cloud(wanted, control);
  if (!read) return std::nullopt;
  const CloudContent& content = **read;
  if (content.of.empty()) throw Error("none of these shapes is fitted; fit a template to them first");
  FigurePage page(request);
  constexpr double width = (1000 - 2 * margin - gap) / 2;
  constexpr double height = 0.95 * width;
  const double clouds = margin + text + small_text + gap;
  const double captions = clouds + height + gap / 2;
  Legend measured(nullptr, page, captions + text + small_text + gap / 2);
  write_legend(measured, content, request.cloud_colour);
  page.set_height(measured.bottom() + margin);
  const std::string name = content.templates.size() == 1 ? content.templates.front().part_template.name
                                                         : plural(content.templates.size(), "template");
  page.write(request.cloud_of.empty() ? name : request.cloud_of, margin, margin, text,
             FigurePage::Style::bold, 1000 - 2 * margin);
  page.write(about(request, content), margin, margin + text, small_text, FigurePage::Style::muted,
             1000 - 2 * margin);
  CloudPictureKey key;
  key.points = content.points;
  key.colours = cloud_colours(content, request.cloud_colour);
  const std::array<std::string, 2> titles{"Rigid", "Deformed"};
  for (std::size_t i = 0; i < 2; ++i) {
    key.blend = static_cast<float>(i);
    const Scene scene = cloud_scene(key);
    const double left = margin + static_cast<double>(i) * (width + gap);
    const Camera camera = figure_camera(scene, page.viewport(width, height));
    if (!page.draw_scene(scene, camera, left, clouds, width, height, control)) return std::nullopt;
    page.write(titles[i], left, captions, text, FigurePage::Style::bold);
    page.write(sharpness_text(content.sharpness, static_cast<double>(i)), left, captions + text, small_text,
               FigurePage::Style::muted, width);
  }
  Legend legend(&page, page, captions + text + small_text + gap / 2);
  write_legend(legend, content, request.cloud_colour);
  return page.picture();
}

}  // namespace archetype
