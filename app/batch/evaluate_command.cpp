// archetype evaluate PROJECT [--labels DIR] [--landmarks DIR]
#include <algorithm>
#include <iostream>
#include <set>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "app/batch/landmark_report.h"
#include "app/batch/progress.h"
#include "app/batch/table.h"
#include "core/base/error.h"
#include "core/session/evaluate_labelling.h"

namespace archetype {

namespace {

using Json = nlohmann::ordered_json;
using Confusion = std::map<std::pair<int, int>, ElementShare>;

struct Arguments {
  std::filesystem::path project;
  std::filesystem::path labels;     // empty: not asked for
  std::filesystem::path landmarks;  // the same
  std::filesystem::path curves;     // where to write them; empty: nowhere
};

std::vector<ShapeAccuracy> worst_first(std::vector<ShapeAccuracy> shapes) {
  std::ranges::stable_sort(shapes, {}, [](const ShapeAccuracy& s) { return s.own.by_area; });
  return shapes;
}

Json accuracy_json(const ShapeAccuracy& shape) {
  return {{"name", shape.name},
          {"own_by_area", shape.own.by_area},
          {"own_by_faces", shape.own.by_count},
          {"best_by_area", shape.best.by_area},
          {"best_by_faces", shape.best.by_count}};
}

Json confusion_json(const Confusion& confusion) {
  Json list = Json::array();
  for (const auto& [pair, share] : confusion) {
    list.push_back(
        {{"predicted", pair.first}, {"truth", pair.second}, {"area", share.area}, {"faces", share.count}});
  }
  return list;
}

Json labelling_json(const LabellingEvaluation& evaluation) {
  const LabellingReport& report = evaluation.report;
  Json shapes = Json::array();
  for (const ShapeAccuracy& shape : worst_first(report.shapes)) shapes.push_back(accuracy_json(shape));
  Json parts = Json::array();
  for (std::size_t i = 0; i < evaluation.parts.size(); ++i) {
    const EvaluatedPart& part = evaluation.parts[i];
    parts.push_back({{"template", part.part_template},
                     {"part", part.part},
                     {"own_label", part.label},
                     {"best_label", report.best_labels[i]}});
  }
  return {{"mean", accuracy_json(report.mean)},
          {"total", accuracy_json(report.total)},
          {"shapes", shapes},
          {"label_names", evaluation.label_names},
          {"parts", parts},
          {"own_confusion", confusion_json(report.own_confusion)},
          {"best_confusion", confusion_json(report.best_confusion)},
          {"without_truth", evaluation.without_truth},
          {"without_labels", evaluation.without_labels},
          {"refused", refused_json(evaluation.refused)}};
}

std::vector<std::string> accuracy_row(const ShapeAccuracy& shape) {
  return {shape.name, percent(shape.own.by_area), percent(shape.own.by_count), percent(shape.best.by_area),
          percent(shape.best.by_count)};
}

std::string label_text(int label, const std::vector<std::string>& names) {
  if (label < 0) return "none";
  const auto i = static_cast<std::size_t>(label);
  return i < names.size() ? std::to_string(label) + " " + names[i] : std::to_string(label);
}

// Rows: truth; columns: what was predicted; in percent of the true label's area.
void print_confusion(const Confusion& confusion, const std::vector<std::string>& names) {
  std::set<int> predicted;
  std::map<int, double> truth_area;
  for (const auto& [pair, share] : confusion) {
    predicted.insert(pair.first);
    truth_area[pair.second] += share.area;
  }
  std::vector<std::vector<std::string>> rows{{"true label"}};
  for (const int label : predicted) rows[0].push_back(label_text(label, names));
  for (const auto& [truth, area] : truth_area) {
    rows.push_back({label_text(truth, names)});
    for (const int label : predicted) {
      const auto found = confusion.find({label, truth});
      rows.back().push_back(found == confusion.end() ? ""
                                                     : percent(found->second.area / std::max(area, 1e-300)));
    }
  }
  print_table(std::cout, rows);
}

void print_report(const LabellingEvaluation& evaluation) {
  const LabellingReport& report = evaluation.report;
  std::cout << "Labelling accuracy in percent, worst shapes first: with the templates' own labels, and with "
               "the best\n"
               "assignment of parts to labels over the collection.\n\n";
  std::vector<std::vector<std::string>> rows{
      {"shape", "own, area", "own, faces", "best, area", "best, faces"}};
  for (const ShapeAccuracy& shape : worst_first(report.shapes)) rows.push_back(accuracy_row(shape));
  rows.push_back(accuracy_row(report.mean));
  rows.back().front() = "mean over " + std::to_string(report.shapes.size()) + " shapes";
  rows.push_back(accuracy_row(report.total));
  rows.back().front() = "all of their surface";
  print_table(std::cout, rows);

  std::cout << "\nWhat became of each true label, in percent of its area (own labels):\n\n";
  print_confusion(report.own_confusion, evaluation.label_names);

  std::cout << "\nParts and their labels:\n\n";
  rows = {{"template", "part", "own", "best"}};
  for (std::size_t i = 0; i < evaluation.parts.size(); ++i) {
    const EvaluatedPart& part = evaluation.parts[i];
    const int best = report.best_labels[i];
    rows.push_back({part.part_template, part.part, std::to_string(part.label),
                    best < 0 ? "-" : label_text(best, evaluation.label_names)});
  }
  print_table(std::cout, rows);
  for (const std::string& name : evaluation.without_truth)
    std::cerr << "left out: " << name << ": no label file\n";
  for (const std::string& name : evaluation.without_labels)
    std::cerr << "left out: " << name << ": not labelled by a fit\n";
  print_refused(evaluation.refused);
}

LabellingEvaluation measure_labels(const Project& project, const std::filesystem::path& folder,
                                   const Invocation& invocation) {
  LabellingEvaluation evaluation;
  {
    Progress progress;
    evaluation = evaluate_labelling(project, folder, invocation.threads, progress.control(invocation.stop));
  }
  if (evaluation.cancelled || !evaluation.report.shapes.empty()) return evaluation;
  print_refused(evaluation.refused);
  throw FileError(
      folder, "no shape of " + project.path().string() + " has both a labelled fit and a label file here (" +
                  std::to_string(evaluation.without_labels.size()) + " lack the fit, " +
                  std::to_string(evaluation.without_truth.size()) +
                  " the file); run `archetype fit` first, or give the folder with SHAPE.seg files");
}

LandmarkEvaluation measure_landmarks(const Project& project, const std::filesystem::path& folder,
                                     const Invocation& invocation) {
  LandmarkEvaluation evaluation;
  {
    Progress progress;
    evaluation = evaluate_landmarks(project, folder, invocation.threads, progress.control(invocation.stop));
  }
  if (evaluation.cancelled || evaluation.all.by_diameter.count() > 0) return evaluation;
  print_refused(evaluation.refused);
  throw FileError(folder,
                  "no two shapes of " + project.path().string() +
                      " have labelled fits and landmarks in common here (" +
                      std::to_string(evaluation.without_labels.size()) + " lack the fit, " +
                      std::to_string(evaluation.without_landmarks.size()) +
                      " the file); run `archetype fit` first, or give the folder with SHAPE.vts files");
}

int run_evaluate(const Arguments& arguments, const Invocation& invocation) {
  const Project project = Project::open(arguments.project);
  bool refused = false;
  Json json = Json::object();
  if (!arguments.labels.empty()) {
    const LabellingEvaluation evaluation = measure_labels(project, arguments.labels, invocation);
    if (evaluation.cancelled) return exit_code::stopped;
    refused = !evaluation.refused.empty();
    if (invocation.json) {
      json = labelling_json(evaluation);
    } else {
      print_report(evaluation);
    }
  }
  if (!arguments.landmarks.empty()) {
    const LandmarkEvaluation evaluation = measure_landmarks(project, arguments.landmarks, invocation);
    if (evaluation.cancelled) return exit_code::stopped;
    refused = refused || !evaluation.refused.empty();
    if (!arguments.curves.empty()) write_curves(arguments.curves, evaluation);
    if (invocation.json) {
      json["landmarks"] = landmark_json(evaluation);
    } else {
      if (!arguments.labels.empty()) std::cout << '\n';
      print_landmark_report(evaluation);
    }
  }
  if (invocation.json) print_json(json);
  return refused ? exit_code::some_refused : exit_code::done;
}

}  // namespace

void add_evaluate_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("evaluate", "Measure labels and correspondences against ground truth");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file")->required();
  command->add_option("--labels", arguments->labels, "Folder with SHAPE.seg or SHAPE_labels.txt files")
      ->type_name("DIR");
  command->add_option("--landmarks", arguments->landmarks, "Folder with SHAPE.vts files")->type_name("DIR");
  command->add_option("--curves", arguments->curves, "Write the curves of correspondences as CSV")
      ->type_name("FILE")
      ->needs("--landmarks");
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    if (arguments->labels.empty() && arguments->landmarks.empty()) {
      throw CLI::RequiredError("--labels DIR or --landmarks DIR");
    }
    invocation.run = [&invocation, arguments] { return run_evaluate(*arguments, invocation); };
  });
}

}  // namespace archetype
