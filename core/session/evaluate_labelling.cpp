// Reads ground truth and faces shape by shape and keeps only what overlaps what.
#include "core/session/evaluate_labelling.h"

#include <map>

#include "core/base/error.h"
#include "core/io/labels.h"
#include "core/session/ordered_pipeline.h"
#include "core/session/read_imported.h"

namespace archetype {

namespace {

enum class Outcome { measured, without_truth, without_labels, refused };

struct Work {
  ShapeRecord shape;
  std::vector<int> parts;  // per element, of the collection
  PartOverlap overlap;
  std::vector<std::string> label_names;  // of the label file, if it names its labels
  Outcome outcome = Outcome::measured;
  std::string reason;  // of a refusal
};

// An element's share of the area; points of a point set all count the same.
std::vector<double> element_areas(const PolygonMesh& mesh) {
  std::vector<double> areas(mesh.element_count(), 1.0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) areas[f] = 0.5 * face_area_vector(mesh, f).norm();
  return areas;
}

void compare(Work& work, const std::filesystem::path& label_folder, const JobControl& control) {
  const auto label_file = find_labels(label_folder, work.shape.name);
  if (!label_file) {
    work.outcome = Outcome::without_truth;
    return;
  }
  const std::vector<int> truth = read_labels(*label_file, work.shape.element_count, work.label_names);
  if (control.cancelled()) return;
  const PolygonMesh mesh = read_imported(work.shape);
  if (control.cancelled()) return;
  work.overlap = measure_overlap(work.parts, truth, element_areas(mesh));
}

class Evaluation {
 public:
  Evaluation(const Project& project, const std::filesystem::path& label_folder)
      : project_(project), label_folder_(label_folder) {
    for (const TemplateRecord& record : project.templates(false)) {
      first_part_[record.id] = static_cast<int>(result_.parts.size());
      for (const TemplatePart& part : record.part_template.parts) {
        result_.parts.push_back({record.part_template.name, part.name, part.label});
      }
    }
  }

  LabellingEvaluation run(unsigned threads, const JobControl& control) {
    const std::vector<ShapeId> ids = project_.shape_ids();
    ring_.resize(pipeline_window(threads));
    const auto compute = [&, this](std::size_t i) {
      Work& work = slot(i);
      try {
        if (work.outcome == Outcome::measured) compare(work, label_folder_, control);
      } catch (const std::exception& error) {
        work.outcome = Outcome::refused;
        work.reason = error.what();
      }
    };
    const bool all = ordered_pipeline(ids.size(), threads, control, "evaluating",
                                      {.prepare = [&](std::size_t i) { load(slot(i) = {}, ids[i]); },
                                       .compute = compute,
                                       .finish = [this](std::size_t i) { take(slot(i)); }});
    result_.cancelled = !all || control.cancelled();
    if (result_.cancelled) {
      result_.shapes.clear();
      return std::move(result_);
    }
    if (result_.label_names.empty()) result_.label_names = read_numbered_names(label_folder_);
    std::vector<int> labels;
    for (const EvaluatedPart& part : result_.parts) labels.push_back(part.label);
    result_.report = measure_labelling(shapes_, labels);
    return std::move(result_);
  }

 private:
  Work& slot(std::size_t i) { return ring_[i % ring_.size()]; }

  void load(Work& work, ShapeId id) const {
    work.shape = project_.find_shape(id).value();
    const std::optional<FitRecord> fit = project_.fit(id);
    const auto labels = project_.labels(id);
    if (!fit || !labels) {
      work.outcome = Outcome::without_labels;
      return;
    }
    const int first = first_part_.at(fit->part_template);
    for (const std::int16_t label : *labels) work.parts.push_back(label < 0 ? -1 : first + label);
  }

  void take(Work& work) {
    switch (work.outcome) {
      case Outcome::measured:
        shapes_.push_back({work.shape.name, renumbered(work)});
        result_.shapes.push_back(work.shape.id);
        break;
      case Outcome::without_truth:
        result_.without_truth.push_back(work.shape.name);
        break;
      case Outcome::without_labels:
        result_.without_labels.push_back(work.shape.name);
        break;
      case Outcome::refused:
        result_.refused.push_back({work.shape.path, work.reason});
        break;
    }
  }

  // With the labels of a file that names them numbered as those of all such files.
  PartOverlap renumbered(const Work& work) {
    if (work.label_names.empty()) return work.overlap;
    std::vector<int> numbers;
    for (const std::string& name : work.label_names) {
      const auto next = static_cast<int>(result_.label_names.size());
      const auto [entry, is_new] = label_numbers_.try_emplace(name, next);
      if (is_new) result_.label_names.push_back(name);
      numbers.push_back(entry->second);
    }
    PartOverlap overlap;
    for (const auto& [pair, share] : work.overlap) {
      overlap[{pair.first, numbers[static_cast<std::size_t>(pair.second)]}] += share;
    }
    return overlap;
  }

  const Project& project_;
  const std::filesystem::path& label_folder_;
  std::map<TemplateId, int> first_part_;
  std::map<std::string, int> label_numbers_;
  std::vector<Work> ring_;
  std::vector<ShapeOverlap> shapes_;
  LabellingEvaluation result_;
};

}  // namespace

LabellingEvaluation evaluate_labelling(const Project& project, const std::filesystem::path& label_folder,
                                       unsigned threads, const JobControl& control) {
  if (!std::filesystem::is_directory(label_folder)) {
    throw FileError(label_folder, "is no folder; give the folder that the label files are in");
  }
  return Evaluation(project, label_folder).run(threads, control);
}

}  // namespace archetype
