// The page of a figure.
#include "ui/figure.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "render/large_picture.h"

namespace archetype {
namespace {

constexpr int fine = 2;               // supersampling
constexpr double line_widths = 1000;  // a line of width 1 is a thousandth of the page at most

}  // namespace

void check_figure_width(double width) {
  if (width >= least_figure_width && width <= most_figure_side && width == std::floor(width)) return;
  throw Error("a figure can be from " + std::to_string(least_figure_width) + " to " +
              std::to_string(most_figure_side) + " pixels wide");
}

FigurePage::FigurePage(const FigureRequest& request)
    : renderer_(request.shaders),
      plain_(ARCHETYPE_FONT_REGULAR),
      bold_(ARCHETYPE_FONT_BOLD),
      options_(request.options) {
  check_figure_width(request.options.width);
}

int FigurePage::pixels(double length) const {
  return static_cast<int>(std::lround(length * options_.width / 1000));
}

Viewport FigurePage::viewport(double width, double height) const {
  return {std::max(pixels(width), 1), std::max(pixels(height), 1)};
}

void FigurePage::set_height(double height) {
  const double rows = std::max(1.0, std::round(height * options_.width / 1000));
  const double all = rows * options_.width;
  if (rows > most_figure_side || all > static_cast<double>(most_figure_pixels))
    throw Error("the figure would be " + std::to_string(options_.width) + " x " +
                std::to_string(static_cast<long long>(rows)) + " pixels; ask for a smaller width");
  picture_ = {options_.width, static_cast<int>(rows), {}};
  picture_.pixels.assign(4 * static_cast<std::size_t>(all), options_.transparent ? 0 : 255);
}

bool FigurePage::draw_scene(const Scene& scene, const Camera& camera, double left, double top, double width,
                            double height, const JobControl& control) {
  Scene drawn = scene;
  drawn.backdrop = Backdrop::transparent;
  const Viewport size = viewport(width, height);
  PictureSize wanted{size.width, size.height, fine};
  wanted.line_scale = static_cast<float>(std::max(0.5, options_.width / line_widths / 1.6));
  const gl::HeadlessTurn turn;
  const auto drawing = draw_large_picture(renderer_, std::move(drawn), camera, wanted, control);
  if (!drawing) return false;
  lay_over(picture_, *drawing, pixels(left), pixels(top));
  return true;
}

void FigurePage::fill(double left, double top, double width, double height, const Rgb& colour) {
  const int right = std::min(pixels(left + width), picture_.width);
  const int bottom = std::min(pixels(top + height), picture_.height);
  for (int y = std::max(pixels(top), 0); y < bottom; ++y)
    for (int x = std::max(pixels(left), 0); x < right; ++x) {
      std::uint8_t* const pixel = &picture_.pixels[4 * static_cast<std::size_t>(y * picture_.width + x)];
      std::copy(colour.begin(), colour.end(), pixel);
      pixel[3] = 255;
    }
}

double FigurePage::width_of(const std::string& text, double size) const {
  const double unit = options_.width / 1000.0;
  return static_cast<double>(plain_.width(text, static_cast<float>(size * unit))) / unit;
}

void FigurePage::write(const std::string& text, double left, double top, double size, Style style,
                       double most_width) {
  const Lettering& lettering = style == Style::bold ? bold_ : plain_;
  const Rgb colour = style == Style::muted ? Rgb{105, 110, 118} : Rgb{28, 30, 34};
  const double unit = options_.width / 1000.0;
  const auto line = static_cast<float>(size * unit);
  lettering.draw(picture_, lettering.fitted(text, static_cast<float>(most_width * unit), line),
                 static_cast<float>(left * unit), static_cast<float>(top * unit), line, colour);
}

}  // namespace archetype
