// Tables, JSON and CSV of one evaluation.
#include "app/batch/landmark_report.h"

#include <algorithm>
#include <array>
#include <iostream>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "app/batch/table.h"
#include "core/io/file.h"

namespace archetype {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array table_steps{2, 4, 6, 10, 15, 20, 30, 40, 50};
constexpr int near_step = 10;  // 0.05
constexpr int far_step = 20;   // 0.10

std::string threshold_text(int step) {
  return fixed(step * ErrorCurve::step, 3);
}

Json curve_json(const ErrorCurve& curve) {
  Json shares = Json::array();
  for (int i = 0; i <= ErrorCurve::steps; ++i) shares.push_back(curve.within(i));
  return shares;
}

Json curves_json(const CorrespondenceCurves& curves) {
  return {{"pairs", curves.by_diameter.count()},
          {"by_diameter", curve_json(curves.by_diameter)},
          {"by_diagonal", curve_json(curves.by_diagonal)}};
}

Json marks_json(const CorrespondenceCurves& curves) {
  return {{"pairs", curves.by_diameter.count()},
          {"within_0.05", curves.by_diameter.within(near_step)},
          {"within_0.10", curves.by_diameter.within(far_step)}};
}

std::string landmark_name(const LandmarkEvaluation& evaluation, std::size_t i) {
  return i < evaluation.landmark_names.size() ? evaluation.landmark_names[i] : std::to_string(i);
}

std::string share(const ErrorCurve& curve, int step) {
  return curve.count() == 0 ? "-" : percent(curve.within(step));
}

void print_curves(const LandmarkEvaluation& evaluation) {
  std::vector<std::vector<std::string>> rows{
      {"within", "all, of diameter", "of diagonal", "same template, of diameter", "of diagonal"}};
  for (const int step : table_steps) {
    rows.push_back({threshold_text(step), share(evaluation.all.by_diameter, step),
                    share(evaluation.all.by_diagonal, step),
                    share(evaluation.same_template.by_diameter, step),
                    share(evaluation.same_template.by_diagonal, step)});
  }
  print_table(std::cout, rows);
}

}  // namespace

nlohmann::ordered_json landmark_json(const LandmarkEvaluation& evaluation) {
  Json thresholds = Json::array();
  for (int i = 0; i <= ErrorCurve::steps; ++i) thresholds.push_back(i * ErrorCurve::step);
  Json landmarks = Json::array();
  for (std::size_t i = 0; i < evaluation.landmarks.size(); ++i) {
    Json entry = marks_json(evaluation.landmarks[i]);
    entry["name"] = landmark_name(evaluation, i);
    landmarks.push_back(std::move(entry));
  }
  Json shapes = Json::array();
  for (const ShapeCorrespondences& shape : evaluation.shapes) {
    shapes.push_back({{"name", shape.name}, {"from", marks_json(shape.from)}, {"to", marks_json(shape.to)}});
  }
  return {{"thresholds", thresholds},
          {"all", curves_json(evaluation.all)},
          {"same_template", curves_json(evaluation.same_template)},
          {"as_marked", curves_json(evaluation.as_marked)},
          {"turnable_shapes", evaluation.turnable},
          {"without_counterpart", evaluation.unmapped},
          {"landmarks", landmarks},
          {"shapes", shapes},
          {"without_landmarks", evaluation.without_landmarks},
          {"without_labels", evaluation.without_labels},
          {"refused", refused_json(evaluation.refused)}};
}

void print_landmark_report(const LandmarkEvaluation& evaluation) {
  std::cout << "Correspondences: percent of the " << evaluation.all.by_diameter.count() << " landmarks of "
            << evaluation.shapes.size() << " shapes, carried to every other shape, that come to lie within\n"
            << "a share of the target's diameter, or of the diagonal of its bounding box; "
            << evaluation.unmapped << " found no counterpart.\n\n";
  print_curves(evaluation);
  if (evaluation.turnable > 0) {
    std::cout
        << "\n"
        << evaluation.turnable
        << " shapes look the same turned about up, so that nobody can tell where their front is: pairs "
           "with them\ncount by the turn that suits all landmarks together best. Taken as marked, within "
           "0.05 of the\ndiameter: "
        << share(evaluation.as_marked.by_diameter, near_step)
        << ", 0.10: " << share(evaluation.as_marked.by_diameter, far_step) << ".\n";
  }

  std::cout << "\nBy landmark, of diameter:\n\n";
  std::vector<std::vector<std::string>> rows{{"landmark", "pairs", "within 0.05", "within 0.10"}};
  for (std::size_t i = 0; i < evaluation.landmarks.size(); ++i) {
    const ErrorCurve& curve = evaluation.landmarks[i].by_diameter;
    rows.push_back({landmark_name(evaluation, i), std::to_string(curve.count()), share(curve, near_step),
                    share(curve, far_step)});
  }
  print_table(std::cout, rows);

  std::cout << "\nBy shape, of diameter, worst first:\n\n";
  std::vector<const ShapeCorrespondences*> shapes;
  for (const ShapeCorrespondences& shape : evaluation.shapes) shapes.push_back(&shape);
  std::ranges::stable_sort(shapes, {},
                           [](const auto* shape) { return shape->to.by_diameter.within(near_step); });
  rows = {{"shape", "to it, within 0.05", "0.10", "from it, within 0.05", "0.10"}};
  for (const ShapeCorrespondences* shape : shapes) {
    rows.push_back({shape->name, share(shape->to.by_diameter, near_step),
                    share(shape->to.by_diameter, far_step), share(shape->from.by_diameter, near_step),
                    share(shape->from.by_diameter, far_step)});
  }
  print_table(std::cout, rows);
  for (const std::string& name : evaluation.without_landmarks)
    std::cerr << "left out: " << name << ": no landmark file\n";
  for (const std::string& name : evaluation.without_labels)
    std::cerr << "left out: " << name << ": not labelled by a fit\n";
  print_refused(evaluation.refused);
}

void write_curves(const std::filesystem::path& path, const LandmarkEvaluation& evaluation) {
  std::string text =
      "threshold,all_by_diameter,all_by_diagonal,same_template_by_diameter,same_template_by_diagonal\n";
  for (int i = 0; i <= ErrorCurve::steps; ++i) {
    text += threshold_text(i);
    for (const CorrespondenceCurves* curves : {&evaluation.all, &evaluation.same_template}) {
      text += ',' + fixed(curves->by_diameter.within(i), 6) + ',' + fixed(curves->by_diagonal.within(i), 6);
    }
    text += '\n';
  }
  replace_file(path, text);
}

}  // namespace archetype
