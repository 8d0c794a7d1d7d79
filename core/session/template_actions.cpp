// Edits of the list of templates; the edits of parts stand in part_actions.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/session/actions.h"
#include "core/session/correction_actions.h"
#include "core/session/mirror_pairs.h"

namespace archetype {
namespace {

const PartTemplate& active_of(const Document& document) {
  const PartTemplate* active = document.active_template();
  if (!active) throw PreconditionError("there is no active template");
  return *active;
}

void commit_active(History& history, PartTemplate part_template, const std::string& message) {
  Document document = history.committed();
  document.templates[document.active] = std::make_shared<const PartTemplate>(std::move(part_template));
  history.commit(std::move(document), message);
}

}  // namespace

std::string unique_template_name(const Document& document, const std::string& name, std::size_t except) {
  const auto taken = [&](const std::string& candidate) {
    for (std::size_t i = 0; i < document.templates.size(); ++i)
      if (i != except && document.templates[i]->name == candidate) return true;
    return false;
  };
  std::string candidate = name.empty() ? "template" : name;
  for (int number = 2; taken(candidate); ++number)
    candidate = (name.empty() ? "template" : name) + " " + std::to_string(number);
  return candidate;
}

void add_template(History& history, PartTemplate part_template, const std::string& message) {
  Document document = history.committed();
  part_template.name = unique_template_name(document, part_template.name, document.templates.size());
  document.templates.push_back(std::make_shared<const PartTemplate>(std::move(part_template)));
  document.active = document.templates.size() - 1;
  history.commit(std::move(document), message);
}

void take_learned(History& history, std::vector<PartTemplate> learned, std::span<const std::size_t> replaced,
                  const std::string& message) {
  if (learned.empty()) throw PreconditionError("nothing was learned");
  Document document = history.committed();
  auto& templates = document.templates;
  for (auto each = replaced.rbegin(); each != replaced.rend(); ++each)
    templates.erase(templates.begin() + static_cast<std::ptrdiff_t>(*each));
  document.active = replaced.empty() ? templates.size() : replaced.front();
  for (std::size_t i = 0; i < learned.size(); ++i) {
    learned[i].name = unique_template_name(document, learned[i].name, templates.size());
    templates.insert(templates.begin() + static_cast<std::ptrdiff_t>(document.active + i),
                     std::make_shared<const PartTemplate>(std::move(learned[i])));
  }
  history.commit(std::move(document), message);
}

void duplicate_active_template(History& history) {
  PartTemplate copy = active_of(history.committed());
  const std::string message = "Duplicate template " + copy.name;
  add_template(history, std::move(copy), message);
}

void remove_active_template(History& history) {
  Document document = history.committed();
  const std::string message = "Delete template " + active_of(document).name;
  document.templates.erase(document.templates.begin() + static_cast<std::ptrdiff_t>(document.active));
  if (document.active >= document.templates.size())
    document.active = document.templates.empty() ? 0 : document.templates.size() - 1;
  history.commit(std::move(document), message);
}

void rename_active_template(History& history, const std::string& name) {
  PartTemplate renamed = active_of(history.committed());
  renamed.name = unique_template_name(history.committed(), name, history.committed().active);
  const std::string message = "Rename template to " + renamed.name;
  Document document = history.committed();
  rename_in_corrections(document, {.template_from = active_of(document).name, .template_to = renamed.name});
  document.templates[document.active] = std::make_shared<const PartTemplate>(std::move(renamed));
  history.commit(std::move(document), message);
}

void move_active_template(History& history, int places) {
  Document document = history.committed();
  const std::string message = "Reorder template " + active_of(document).name;
  auto& templates = document.templates;
  const auto last = static_cast<std::ptrdiff_t>(templates.size()) - 1;
  const auto from = static_cast<std::ptrdiff_t>(document.active);
  const std::ptrdiff_t to = std::clamp<std::ptrdiff_t>(from + places, 0, last);
  const std::shared_ptr<const PartTemplate> moved = templates[document.active];
  templates.erase(templates.begin() + from);
  templates.insert(templates.begin() + to, moved);
  document.active = static_cast<std::size_t>(to);
  history.commit(std::move(document), message);
}

void select_template(History& history, std::size_t index) {
  Document document = history.committed();
  if (index >= document.templates.size()) throw PreconditionError("there is no such template");
  document.active = index;
  const std::string message = "Switch to template " + document.templates[index]->name;
  history.commit(std::move(document), message);
}

void adopt_fitted_boxes(History& history, const ShapeFit& fit) {
  PartTemplate adopted = active_of(history.committed());
  if (fit.parts.size() != adopted.parts.size()) throw PreconditionError("the fit is of another template");
  for (std::size_t i = 0; i < adopted.parts.size(); ++i) {
    if (!fit.parts[i].present) continue;
    adopted.parts[i].position.mean = fit.parts[i].box.centre;
    adopted.parts[i].scale.mean = fit.parts[i].box.half_extent.cwiseMax(min_half_extent);
    adopted.parts[i].orientation = fit.parts[i].box.orientation;
  }
  average_pairs(adopted);
  commit_active(history, std::move(adopted), "Take the boxes of the fit");
}

void learn_features(History& history, const ShapeSamples& samples, const ShapeFit& fit) {
  PartTemplate learned = active_of(history.committed());
  if (fit.parts.size() != learned.parts.size() || fit.labels.size() != samples.size())
    throw PreconditionError("the fit is of another template or shape");
  const std::vector<Features>& features = fit.yaw_quarters % 2 == 0 ? samples.features_x : samples.features_z;
  constexpr int fewest = 5;
  constexpr double smallest_stddev = 0.05;  // one shape says little about the spread over a collection
  for (std::size_t p = 0; p < learned.parts.size(); ++p) {
    Features sum{};
    Features squares{};
    int count = 0;
    for (std::size_t i = 0; i < features.size(); ++i) {
      if (fit.labels[i] != static_cast<std::int16_t>(p)) continue;
      ++count;
      for (int k = 0; k < feature_count; ++k) {
        sum[k] += features[i][k];
        squares[k] += features[i][k] * features[i][k];
      }
    }
    if (count < fewest) continue;
    FeatureGaussian& gaussian = learned.parts[p].features;
    for (int k = 0; k < feature_count; ++k) {
      gaussian.mean[k] = sum[k] / count;
      const double variance = std::max(0.0, squares[k] / count - gaussian.mean[k] * gaussian.mean[k]);
      gaussian.stddev[k] = std::max(smallest_stddev, std::sqrt(variance));
    }
    learned.parts[p].has_features = true;
  }
  commit_active(history, std::move(learned), "Learn features from the shape");
}

void forget_features(History& history) {
  PartTemplate plain = active_of(history.committed());
  for (TemplatePart& part : plain.parts) {
    part.has_features = false;
    part.features = {};
  }
  commit_active(history, std::move(plain), "Forget features");
}

}  // namespace archetype
