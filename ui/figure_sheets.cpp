// The row of templates, the sheet of clusters, and templates before and after learning.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/session/cluster_size.h"
#include "core/session/measure_starts.h"
#include "ui/figure.h"
#include "ui/figure_scenes.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr double margin = 16;
constexpr double gap = 10;
constexpr double text = 13;  // height of a line
constexpr double small_text = 11;

struct Cluster {
  std::shared_ptr<const PartTemplate> part_template;
  std::vector<FitSummary> members;  // best first
  ClusterSize size;
};

// The current templates in their order, then others that fits still have.
std::vector<Cluster> clusters_of(const Project& project, const std::vector<PartTemplate>& otherwise,
                                 std::vector<FitSummary>* outliers) {
  std::vector<TemplateRecord> records = project.templates();
  std::vector<FitSummary> fits = project.fits();
  for (const FitSummary& fit : fits) {
    const bool known = std::ranges::any_of(records, [&](const auto& r) { return r.id == fit.part_template; });
    if (known) continue;
    if (auto older = project.find_template(fit.part_template)) records.push_back(std::move(*older));
  }
  std::vector<Cluster> clusters;
  for (const TemplateRecord& record : records) {
    Cluster& cluster = clusters.emplace_back();
    cluster.part_template = std::make_shared<const PartTemplate>(record.part_template);
    for (const FitSummary& fit : fits) {
      if (fit.part_template != record.id) continue;
      cluster.size.add(fit.status);
      const bool outlier = outliers && fit.status == FitStatus::outlier;
      (outlier ? *outliers : cluster.members).push_back(fit);
    }
    std::ranges::stable_sort(cluster.members, {}, [](const FitSummary& f) { return f.energy.total(); });
  }
  if (clusters.empty())
    for (const PartTemplate& part_template : otherwise)
      clusters.push_back({std::make_shared<const PartTemplate>(part_template), {}, {}});
  if (outliers)
    std::ranges::stable_sort(*outliers, {}, [](const FitSummary& f) { return -f.energy.total(); });
  std::erase_if(clusters, [](const Cluster& c) { return c.part_template->parts.empty(); });
  return clusters;
}

std::string about(const Cluster& cluster) {
  std::string line = plural(cluster.part_template->parts.size(), "part");
  if (cluster.size != ClusterSize{}) line += ", " + to_string(cluster.size);
  return line;
}

bool draw_template(FigurePage& page, const PartTemplate& part_template, bool spread, double left, double top,
                   double width, double height, const JobControl& control) {
  const Scene scene = template_scene(part_template, {.spread = spread});
  return page.draw_scene(scene, figure_camera(scene, page.viewport(width, height)), left, top, width, height,
                         control);
}

// Cells of shapes from left to right, in lines; what has no room is told in the last one.
struct CellGrid {
  double left = 0;
  double top = 0;
  double cell = 0;
  std::size_t columns = 1;
  std::size_t lines = 1;
};

bool draw_members(FigurePage& page, const Project& project, const std::vector<FitSummary>& members,
                  const CellGrid& grid, const JobControl& control) {
  const std::size_t room = grid.columns * grid.lines;
  const std::size_t drawn = members.size() <= room ? members.size() : room - 1;
  const auto place = [&](std::size_t i) {
    const std::size_t line = i / grid.columns;
    return std::pair(grid.left + grid.cell * static_cast<double>(i % grid.columns),
                     grid.top + grid.cell * static_cast<double>(line));
  };
  for (std::size_t i = 0; i < drawn; ++i) {
    if (control.cancelled()) return false;
    const auto shape = load_figure_shape(project, members[i].shape);
    if (!shape) continue;
    Scene scene;
    add_shape(scene, *shape, true);
    const double side = grid.cell - gap / 2;
    const auto [x, y] = place(i);
    if (!page.draw_scene(scene, figure_camera(scene, page.viewport(side, side)), x, y, side, side, control))
      return false;
  }
  if (drawn < members.size()) {
    const auto [x, y] = place(room - 1);
    page.write("and " + std::to_string(members.size() - drawn), x + gap, y + grid.cell / 2 - small_text,
               small_text, FigurePage::Style::muted);
    page.write("more", x + gap, y + grid.cell / 2, small_text, FigurePage::Style::muted);
  }
  return true;
}

}  // namespace

std::optional<Picture> templates_figure(const FigureRequest& request, const JobControl& control) {
  const Project project = Project::open(request.project);
  const std::vector<Cluster> clusters = clusters_of(project, request.templates, nullptr);
  if (clusters.empty()) throw Error("there is no template to show; make one, or learn some first");
  FigurePage page(request);
  const auto columns = static_cast<double>(std::clamp<std::size_t>(clusters.size(), 2, 4));
  const double width = (1000 - 2 * margin - (columns - 1) * gap) / columns;
  const double height = 0.85 * width;
  const double line = height + 2 * text + 2 * gap;
  page.set_height(2 * margin + line * std::ceil(static_cast<double>(clusters.size()) / columns));
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Cluster& cluster = clusters[i];
    const double column = std::fmod(static_cast<double>(i), columns);
    // One alone stands in the middle.
    const double left = clusters.size() == 1 ? (1000 - width) / 2 : margin + column * (width + gap);
    const double top = margin + line * std::floor(static_cast<double>(i) / columns);
    if (!draw_template(page, *cluster.part_template, true, left, top, width, height, control))
      return std::nullopt;
    page.write(cluster.part_template->name, left, top + height, text, FigurePage::Style::bold, width);
    page.write(about(cluster), left, top + height + text, small_text, FigurePage::Style::muted, width);
  }
  return page.picture();
}

namespace {

constexpr std::size_t sheet_columns = 8;  // of members, beside the template
constexpr std::size_t fewest_lines = 2;   // as high as the template

// Of a cluster with that many members, at most `most`.
std::size_t member_lines(std::size_t members, std::size_t most) {
  return std::clamp((members + sheet_columns - 1) / sheet_columns, fewest_lines, most);
}

std::optional<Picture> sheet(const FigureRequest& request, std::size_t most_lines,
                             const JobControl& control) {
  const Project project = Project::open(request.project);
  std::vector<FitSummary> outliers;
  std::vector<Cluster> clusters = clusters_of(project, request.templates, &outliers);
  std::erase_if(clusters, [](const Cluster& cluster) { return cluster.members.empty(); });
  if (clusters.empty() && outliers.empty())
    throw Error("no shape is fitted yet; fit a template to all shapes, or learn from them, first");
  constexpr double cell = (1000 - 2 * margin) / (sheet_columns + 2);
  constexpr double titles = text + small_text + 2 * gap;
  FigurePage page(request);
  double height = 2 * margin;
  for (const Cluster& cluster : clusters)
    height += cell * static_cast<double>(member_lines(cluster.members.size(), most_lines)) + titles;
  if (!outliers.empty()) height += cell + titles;
  page.set_height(height);
  double top = margin;
  for (const Cluster& cluster : clusters) {
    page.write(cluster.part_template->name, margin, top, text, FigurePage::Style::bold, 700);
    const std::size_t lines = member_lines(cluster.members.size(), most_lines);
    double energy = 0;
    for (const FitSummary& fit : cluster.members)
      energy += fit.energy.total() / static_cast<double>(cluster.members.size());
    char line[64];
    std::snprintf(line, sizeof line, ", mean energy %.3f; best first", energy);
    page.write(about(cluster) + line, margin, top + text, small_text, FigurePage::Style::muted);
    const double below = top + text + small_text + gap / 2;
    if (!draw_template(page, *cluster.part_template, true, margin, below, 2 * cell - gap, 2 * cell - gap,
                       control) ||
        !draw_members(page, project, cluster.members, {margin + 2 * cell, below, cell, sheet_columns, lines},
                      control))
      return std::nullopt;
    top += cell * static_cast<double>(lines) + titles;
  }
  if (outliers.empty()) return page.picture();
  page.write("Outliers", margin, top, text, FigurePage::Style::bold);
  page.write(plural(outliers.size(), "shape") + " that no template explains; worst first", margin, top + text,
             small_text, FigurePage::Style::muted);
  if (!draw_members(page, project, outliers,
                    {margin, top + text + small_text + gap / 2, cell, sheet_columns + 2, 1}, control))
    return std::nullopt;
  return page.picture();
}

std::string result_text(double energy, const TruthShares& shares) {
  char line[64];
  std::snprintf(line, sizeof line, "energy %.3f", energy);
  std::string result = line;
  if (!shares.best_labelling) return result;
  std::snprintf(line, sizeof line, ", %.1f %% right", 100 * *shares.best_labelling);
  return result + line;
}

}  // namespace

std::optional<Picture> clusters_figure(const FigureRequest& request, const JobControl& control) {
  return sheet(request, fewest_lines, control);
}

std::optional<Picture> members_figure(const FigureRequest& request, const JobControl& control) {
  return sheet(request, std::numeric_limits<std::size_t>::max(), control);
}

std::optional<Picture> starts_figure(const FigureRequest& request, const JobControl& control) {
  const std::vector<StartMeasure> starts = stored_start_measures(Project::open(request.project));
  if (starts.empty())
    throw Error("nothing was learned from several starts yet; \"Learn from several starts\" does it");
  FigurePage page(request);
  const auto columns = static_cast<double>(starts.size());
  const double width = std::min((1000 - 2 * margin - (columns - 1) * gap) / columns, 300.0);
  const double height = 1.1 * width;
  const double row = height + text + small_text + 2 * gap;
  page.set_height(2 * margin + 2 * (row + text + gap));
  const auto draw_row = [&](double top, const char* title, auto template_of, auto line_of) {
    page.write(title, margin, top, text, FigurePage::Style::bold);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const double left = margin + static_cast<double>(i) * (width + gap);
      const double below = top + text + gap / 2;
      const PartTemplate* shown = template_of(starts[i]);
      if (shown && !draw_template(page, *shown, true, left, below, width, height, control)) return false;
      page.write(shown ? shown->name : "", left, below + height, small_text, FigurePage::Style::plain, width);
      page.write(line_of(starts[i]), left, below + height + small_text, small_text * 0.9,
                 FigurePage::Style::muted, width);
    }
    return true;
  };
  const auto before = [](const StartMeasure& start) { return &start.initial; };
  const auto after = [](const StartMeasure& start) {
    return start.learned.empty() ? nullptr : &start.learned.front();
  };
  const auto line_before = [](const StartMeasure& start) {
    return result_text(start.energy_before, start.before);
  };
  const auto line_after = [](const StartMeasure& start) {
    const std::string more =
        start.learned.size() > 1 ? "first of " + std::to_string(start.learned.size()) + ", " : "";
    return more + result_text(start.energy_after, start.after);
  };
  if (!draw_row(margin,
                "Templates to begin with; mean energy of the fits, share of the surface labelled right",
                before, line_before) ||
      !draw_row(margin + row + text + gap, "Learned from them", after, line_after))
    return std::nullopt;
  return page.picture();
}

}  // namespace archetype
