// Discs with a depth buffer, drawn twice as fine and averaged.
#include "core/report/report_pictures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/model/part_colours.h"

namespace archetype {
namespace {

const Mat3 view = (Mat3() << 0.80, 0, -0.60, -0.23, 0.92, -0.31, 0.55, 0.39, 0.74).finished();
constexpr int fine = 2;

struct Canvas {
  explicit Canvas(int pixels)
      : side(pixels),
        colours(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels)),
        depths(colours.size(), -std::numeric_limits<double>::infinity()) {}

  void disc(double x, double y, double depth, double radius, const Rgb& colour) {
    const auto low = [](double value) { return std::max(0, static_cast<int>(std::floor(value))); };
    const auto high = [&](double value) { return std::min(side - 1, static_cast<int>(std::ceil(value))); };
    for (int py = low(y - radius); py <= high(y + radius); ++py)
      for (int px = low(x - radius); px <= high(x + radius); ++px) {
        const double dx = px + 0.5 - x;
        const double dy = py + 0.5 - y;
        if (dx * dx + dy * dy > radius * radius) continue;
        const auto at =
            static_cast<std::size_t>(py) * static_cast<std::size_t>(side) + static_cast<std::size_t>(px);
        if (depth <= depths[at]) continue;
        depths[at] = depth;
        colours[at] = colour;
      }
  }

  int side;
  std::vector<Rgb> colours;
  std::vector<double> depths;  // minus infinity: nothing there
};

Picture averaged(const Canvas& canvas) {
  const int side = canvas.side / fine;
  Picture picture{side, side, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      int sum[3] = {0, 0, 0};
      int count = 0;
      for (int k = 0; k < fine * fine; ++k) {
        const auto at =
            static_cast<std::size_t>(fine * y + k / fine) * static_cast<std::size_t>(canvas.side) +
            static_cast<std::size_t>(fine * x + k % fine);
        if (!std::isfinite(canvas.depths[at])) continue;
        ++count;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += canvas.colours[at][c];
      }
      for (const int channel : sum)
        picture.pixels.push_back(static_cast<std::uint8_t>(count > 0 ? channel / count : 0));
      picture.pixels.push_back(static_cast<std::uint8_t>(255 * count / (fine * fine)));
    }
  return picture;
}

}  // namespace

Picture sample_picture(const ShapeSamples& samples, const PartTemplate* part_template, const ShapeFit* fit,
                       int side) {
  Canvas canvas(fine * std::max(side, 1));
  std::vector<Vec3> seen;
  Bounds bounds;
  const int yaw = fit ? fit->yaw_quarters : 0;
  for (const Vec3& p : samples.points) {
    seen.emplace_back(view * turn_quarters(p, -yaw));
    bounds.add(seen.back());
  }
  if (bounds.empty()) return averaged(canvas);
  const Vec3 middle = 0.5 * (bounds.low + bounds.high);
  const Vec3 size = bounds.high - bounds.low;
  const double scale = 0.88 * canvas.side / std::max({size.x(), size.y(), 1e-9});
  const double area = size.x() * size.y() * scale * scale;
  const double radius = std::max(2.0, 0.95 * std::sqrt(area / static_cast<double>(seen.size())));
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const bool labelled = fit && part_template && i < fit->labels.size();
    Rgb colour = labelled ? part_colour(*part_template, fit->labels[i]) : Rgb{190, 188, 184};
    double light = 1;
    if (i < samples.normals.size()) {
      const Vec3 normal = view * turn_quarters(samples.normals[i], -yaw);
      const double side_of = normal.z() < 0 ? -1 : 1;  // their sign has no meaning
      light = 0.6 + 0.4 * std::max(0.0, side_of * normal.dot(Vec3(-0.3, 0.6, 0.74)));
    }
    for (std::uint8_t& channel : colour) channel = static_cast<std::uint8_t>(light * channel);
    const Vec3 at = scale * (seen[i] - middle);
    canvas.disc(0.5 * canvas.side + at.x(), 0.5 * canvas.side - at.y(), at.z(), radius, colour);
  }
  return averaged(canvas);
}

Picture report_picture(const Project& project, ShapeId shape, int side, const DrawShape& draw) {
  if (auto kept = project.thumbnail(shape, std::string(parts_thumbnail)); kept && kept->width > 0)
    return *kept;
  if (draw)
    if (Picture drawn = draw(shape); drawn.width > 0) return drawn;
  const std::optional<FitRecord> fit = project.fit(shape);
  std::optional<TemplateRecord> of;
  if (fit) of = project.find_template(fit->part_template);
  return sample_picture(project.samples(shape), of ? &of->part_template : nullptr, fit ? &fit->fit : nullptr,
                        side);
}

}  // namespace archetype
