// Twice over the shapes: first all landmarks are put into the boxes of their parts, then each shape in turn
// is the target of all others, so that only one surface per thread is held.
#include "core/session/evaluate_landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "core/evaluation/alike_turns.h"
#include "core/evaluation/surface_map.h"
#include "core/io/file.h"
#include "core/io/labels.h"
#include "core/session/ordered_pipeline.h"
#include "core/session/read_imported.h"

namespace archetype {

namespace {

// A shape that takes part.
struct Marked {
  ShapeId id = 0;
  std::string name;
  TemplateId part_template = 0;
  std::vector<Landmark> landmarks;
  std::vector<int> turns;                                     // by which it looks the same
  std::vector<std::vector<std::optional<PartPoint>>> places;  // by turn and landmark
};

using Errors = std::vector<std::pair<std::size_t, double>>;  // by landmark, file units

// Share of the diameter from which on errors are equally bad.
constexpr double farthest = ErrorCurve::steps * ErrorCurve::step;

enum class Outcome { located, without_landmarks, without_labels, refused };

// One shape on its way through.
struct Work {
  ShapeRecord shape;
  ShapeSamples samples;
  ShapeFit fit;
  std::vector<std::int16_t> labels;
  Marked marked;
  Outcome outcome = Outcome::located;
  std::string reason;  // of a refusal
  // Of the second pass:
  std::vector<CorrespondenceCurves> from;  // by source
  std::vector<CorrespondenceCurves> as_marked;
  std::vector<CorrespondenceCurves> landmarks;
  std::uint64_t unmapped = 0;
};

Vec3 position(const Landmark& landmark) {
  return {landmark.position[0], landmark.position[1], landmark.position[2]};
}

class Evaluation {
 public:
  Evaluation(const Project& project, const std::filesystem::path& folder, const JobControl& control)
      : project_(project), folder_(folder), control_(control) {
    for (TemplateRecord& record : project.templates(false)) {
      templates_[record.id] = std::move(record.part_template);
    }
    result_.landmark_names = read_numbered_names(folder);
  }

  LandmarkEvaluation run(unsigned threads) {
    ring_.resize(pipeline_window(threads));
    const std::vector<ShapeId> ids = project_.shape_ids();
    bool all = ordered_pipeline(ids.size(), threads, control_, "locating landmarks",
                                {.prepare = [&](std::size_t i) { load(slot(i) = {}, ids[i]); },
                                 .compute = [this](std::size_t i) { guarded(slot(i), &Evaluation::locate); },
                                 .finish = [this](std::size_t i) { take_located(slot(i)); }});
    for (const Marked& marked : marked_) {
      result_.shapes.push_back({marked.name, {}, {}});
      result_.landmarks.resize(std::max(result_.landmarks.size(), marked.landmarks.size()));
    }
    all =
        all && ordered_pipeline(marked_.size(), threads, control_, "comparing landmarks",
                                {.prepare = [&](std::size_t i) { load(slot(i) = {}, marked_[i].id); },
                                 .compute = [this](std::size_t i) { guarded(slot(i), &Evaluation::compare); },
                                 .finish = [this](std::size_t i) { take_compared(slot(i), i); }});
    result_.cancelled = !all || control_.cancelled();
    return std::move(result_);
  }

 private:
  Work& slot(std::size_t i) { return ring_[i % ring_.size()]; }

  void load(Work& work, ShapeId id) const {
    work.shape = project_.find_shape(id).value();
    work.marked.id = id;
    work.marked.name = work.shape.name;
    std::optional<FitRecord> fit = project_.fit(id);
    std::optional<std::vector<std::int16_t>> labels = project_.labels(id);
    if (!fit || !labels) {
      work.outcome = Outcome::without_labels;
      return;
    }
    work.marked.part_template = fit->part_template;
    work.fit = std::move(fit->fit);
    work.labels = std::move(*labels);
    work.samples = project_.samples(id);
  }

  void guarded(Work& work, void (Evaluation::*step)(Work&) const) const {
    if (work.outcome != Outcome::located) return;
    try {
      (this->*step)(work);
    } catch (const std::exception& error) {
      work.outcome = Outcome::refused;
      work.reason = error.what();
    }
  }

  void locate(Work& work) const {
    const std::optional<std::filesystem::path> file = find_landmarks(folder_, work.shape.name);
    if (!file) {
      work.outcome = Outcome::without_landmarks;
      return;
    }
    work.marked.landmarks = read_landmarks(*file);
    const PolygonMesh mesh = read_imported(work.shape);
    if (control_.cancelled()) return;
    const SurfaceToTemplate to_template({mesh, work.shape.frame, work.fit, work.labels},
                                        templates_.at(work.marked.part_template));
    work.marked.turns = alike_turns(work.samples, to_template.search());
    for (const int turn : work.marked.turns) {
      auto& places = work.marked.places.emplace_back();
      for (const Landmark& landmark : work.marked.landmarks) {
        const Vec3 turned = turn_about_up(work.shape.frame, position(landmark), turn);
        places.push_back(landmark.present ? to_template.locate(turned) : std::nullopt);
      }
    }
  }

  void take_located(Work& work) {
    switch (work.outcome) {
      case Outcome::located:
        if (work.marked.turns.size() > 1) ++result_.turnable;
        marked_.push_back(std::move(work.marked));
        break;
      case Outcome::without_landmarks:
        result_.without_landmarks.push_back(work.shape.name);
        break;
      case Outcome::without_labels:
        result_.without_labels.push_back(work.shape.name);
        break;
      case Outcome::refused:
        result_.refused.push_back({work.shape.path, work.reason});
        break;
    }
  }

  void compare(Work& work) const {
    const PolygonMesh mesh = read_imported(work.shape);
    if (control_.cancelled()) return;
    const PartTemplate& own_template = templates_.at(work.marked.part_template);
    const TemplateToSurface to_surface({mesh, work.shape.frame, work.fit, work.labels}, own_template);
    const double diameter = work.shape.radius / work.shape.frame.scale;
    const double diagonal = 2 * bounds(mesh).half_extent().norm();
    work.from.resize(marked_.size());
    work.as_marked.resize(marked_.size());
    work.landmarks.resize(result_.landmarks.size());
    const Marked& self = *std::ranges::find(marked_, work.marked.id, &Marked::id);
    for (std::size_t s = 0; s < marked_.size(); ++s) {
      if (marked_[s].id == self.id) continue;
      if (control_.cancelled()) return;
      const std::vector<Errors> errors = pair_errors(marked_[s], self, work.shape.frame, to_surface);
      const auto sum = [&](const Errors& each) {
        double result = 0;
        for (const auto& [landmark, error] : each) result += std::min(error, farthest * diameter);
        return result;
      };
      for (const auto& [landmark, error] : errors.front()) {
        work.as_marked[s].by_diameter.add(error / diameter);
        work.as_marked[s].by_diagonal.add(error / diagonal);
      }
      for (const auto& [landmark, error] : *std::ranges::min_element(errors, {}, sum)) {
        if (std::isinf(error)) ++work.unmapped;
        for (CorrespondenceCurves* curves : {&work.from[s], &work.landmarks[landmark]}) {
          curves->by_diameter.add(error / diameter);
          curves->by_diagonal.add(error / diagonal);
        }
      }
    }
  }

  // The errors of all landmarks that two shapes have in common, for each turn by which the target looks the
  // same, or, if there is none, by which the source does; that of 0 first.
  std::vector<Errors> pair_errors(const Marked& source, const Marked& target, const ShapeFrame& target_frame,
                                  const TemplateToSurface& to_surface) const {
    const PartTemplate& from = templates_.at(source.part_template);
    const PartTemplate& to = templates_.at(target.part_template);
    const std::size_t count = std::min(source.landmarks.size(), target.landmarks.size());
    const bool target_turns = target.turns.size() > 1;
    std::vector<Errors> result(target_turns ? target.turns.size() : source.turns.size());
    for (std::size_t i = 0; i < count; ++i) {
      if (!source.landmarks[i].present || !target.landmarks[i].present) continue;
      std::optional<TemplateToSurface::Found> found;
      for (std::size_t turn = 0; turn < result.size(); ++turn) {
        if (turn == 0 || !target_turns) {
          std::optional<PartPoint> place = source.places[turn][i];
          if (place) place->part = counterpart(from, place->part, to);
          found = place ? to_surface.find(*place) : std::nullopt;
        }
        Vec3 truth = position(target.landmarks[i]);
        if (target_turns) truth = turn_about_up(target_frame, truth, target.turns[turn]);
        const double error =
            found ? (found->position - truth).norm() : std::numeric_limits<double>::infinity();
        result[turn].emplace_back(i, error);
      }
    }
    return result;
  }

  void take_compared(Work& work, std::size_t target) {
    if (work.outcome != Outcome::located) {
      result_.refused.push_back({work.shape.path, work.reason});
      return;
    }
    result_.unmapped += work.unmapped;
    for (std::size_t s = 0; s < work.from.size(); ++s) {
      result_.all += work.from[s];
      result_.as_marked += work.as_marked[s];
      result_.shapes[s].from += work.from[s];
      result_.shapes[target].to += work.from[s];
      if (marked_[s].part_template == marked_[target].part_template) result_.same_template += work.from[s];
    }
    for (std::size_t i = 0; i < work.landmarks.size(); ++i) result_.landmarks[i] += work.landmarks[i];
  }

  const Project& project_;
  const std::filesystem::path& folder_;
  const JobControl& control_;
  std::map<TemplateId, PartTemplate> templates_;
  std::vector<Work> ring_;
  std::vector<Marked> marked_;  // by name
  LandmarkEvaluation result_;
};

}  // namespace

LandmarkEvaluation evaluate_landmarks(const Project& project, const std::filesystem::path& folder,
                                      unsigned threads, const JobControl& control) {
  if (!std::filesystem::is_directory(folder)) {
    throw FileError(folder, "is no folder; give the folder that the landmark files are in");
  }
  return Evaluation(project, folder, control).run(threads);
}

}  // namespace archetype
