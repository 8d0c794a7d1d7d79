#include "core/session/correction_actions.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "core/base/error.h"
#include "core/base/sort_unique.h"

namespace archetype {
namespace {

using Samples = std::vector<std::uint32_t>;
using Edit = std::function<void(ShapeCorrection&)>;

void edit_in(Document& document, std::span<const NamedShape> shapes, const Edit& edit) {
  Corrections changed = document.corrections ? *document.corrections : Corrections{};
  for (const NamedShape& shape : shapes) {
    const auto found = changed.find(shape.id);
    ShapeCorrection correction = found == changed.end() ? ShapeCorrection{} : *found->second;
    edit(correction);
    if (correction.empty())
      changed.erase(shape.id);
    else if (found == changed.end() || !(correction == *found->second))
      changed[shape.id] = std::make_shared<const ShapeCorrection>(std::move(correction));
  }
  document.corrections = changed.empty() ? nullptr : std::make_shared<const Corrections>(std::move(changed));
}

void edit_shapes(History& history, std::span<const NamedShape> shapes, Stage stage, const Edit& edit,
                 const std::string& message) {
  if (shapes.empty()) throw PreconditionError("there is no shape to correct");
  Document document = history.committed();
  edit_in(document, shapes, edit);
  if (stage == Stage::live)
    history.preview(std::move(document));
  else
    history.commit(std::move(document), message);
}

std::string names_of(std::span<const NamedShape> shapes) {
  return shapes.size() == 1 ? shapes[0].name : std::to_string(shapes.size()) + " shapes";
}

void check_yaw(int quarters) {
  if (quarters < 0 || quarters > 3) throw PreconditionError("a yaw has 0 to 3 quarters");
}

Samples sorted(std::span<const std::uint32_t> samples) {
  Samples result(samples.begin(), samples.end());
  sort_unique(result);
  return result;
}

// Takes the samples, ascending, from all parts.
void take_away(ShapeCorrection& correction, const Samples& samples) {
  for (auto& [part, pinned] : correction.pinned) {
    Samples rest;
    std::ranges::set_difference(pinned, samples, std::back_inserter(rest));
    pinned = std::move(rest);
  }
  std::erase_if(correction.pinned, [](const auto& each) { return each.second.empty(); });
}

void begin_pinning(ShapeCorrection& correction, const ContentHash& sampling) {
  if (correction.sampling != sampling) correction.pinned.clear();
  correction.sampling = sampling;
}

void end_pinning(ShapeCorrection& correction) {
  if (correction.pinned.empty()) correction.sampling = {};
}

std::string points(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " point" : " points");
}

}  // namespace

void pin_yaw(History& history, const NamedShape& shape, std::optional<int> quarters) {
  if (quarters) check_yaw(*quarters);
  edit_shapes(
      history, {&shape, 1}, Stage::done, [&](ShapeCorrection& each) { each.yaw_quarters = quarters; },
      quarters ? "Pin the yaw of " + shape.name + " to " + std::to_string(*quarters * 90) + "°"
               : "Free the yaw of " + shape.name);
}

void pin_template(History& history, const NamedShape& shape, const std::string& template_name) {
  edit_shapes(
      history, {&shape, 1}, Stage::done, [&](ShapeCorrection& each) { each.part_template = template_name; },
      template_name.empty() ? "Free the template of " + shape.name
                            : "Pin " + shape.name + " to template " + template_name);
}

void pin_yaw_and_template(History& history, const NamedShape& shape, int quarters,
                          const std::string& template_name) {
  check_yaw(quarters);
  edit_shapes(
      history, {&shape, 1}, Stage::done,
      [&](ShapeCorrection& each) {
        each.yaw_quarters = quarters;
        each.part_template = template_name;
      },
      "Pin " + shape.name + " to " + template_name + " at " + std::to_string(quarters * 90) + "°");
}

void mark_shapes(History& history, std::span<const NamedShape> shapes, ShapeMark mark) {
  const std::string names = names_of(shapes);
  edit_shapes(
      history, shapes, Stage::done, [&](ShapeCorrection& each) { each.mark = mark; },
      mark == ShapeMark::outlier ? "Mark " + names + " as outlier"
      : mark == ShapeMark::learn ? "Learn from " + names
                                 : "Unmark " + names);
}

void pin_samples(History& history, const NamedShape& shape, const ContentHash& sampling,
                 std::span<const std::uint32_t> samples, const std::string& part, Stage stage) {
  const Samples more = sorted(samples);
  edit_shapes(
      history, {&shape, 1}, stage,
      [&](ShapeCorrection& each) {
        begin_pinning(each, sampling);
        take_away(each, more);
        if (!more.empty()) {
          Samples& pinned = each.pinned[part];
          Samples all;
          std::ranges::merge(pinned, more, std::back_inserter(all));
          pinned = std::move(all);
        }
        end_pinning(each);
      },
      "Paint " + points(more.size()) + " of " + shape.name + " as " + (part.empty() ? "no part" : part));
}

void unpin_samples(History& history, const NamedShape& shape, const ContentHash& sampling,
                   std::span<const std::uint32_t> samples, Stage stage) {
  const Samples freed = sorted(samples);
  edit_shapes(
      history, {&shape, 1}, stage,
      [&](ShapeCorrection& each) {
        begin_pinning(each, sampling);
        take_away(each, freed);
        end_pinning(each);
      },
      "Free " + points(freed.size()) + " of " + shape.name);
}

void unpin_all_samples(History& history, const NamedShape& shape) {
  edit_shapes(
      history, {&shape, 1}, Stage::done,
      [&](ShapeCorrection& each) {
        each.pinned.clear();
        end_pinning(each);
      },
      "Free all points of " + shape.name);
}

void clear_corrections(History& history, std::span<const NamedShape> shapes) {
  edit_shapes(
      history, shapes, Stage::done, [](ShapeCorrection& each) { each = {}; },
      "Clear the corrections of " + names_of(shapes));
}

void rename_in_corrections(Document& document, const Renaming& renaming) {
  if (!document.corrections) return;
  std::vector<NamedShape> named;
  for (const auto& [shape, correction] : *document.corrections) {
    const bool has_template =
        !renaming.template_from.empty() && correction->part_template == renaming.template_from;
    const bool has_part = !renaming.part_from.empty() && correction->pinned.contains(renaming.part_from);
    if (has_template || has_part) named.push_back({shape, {}});
  }
  if (named.empty()) return;
  edit_in(document, named, [&](ShapeCorrection& each) {
    if (!renaming.template_from.empty() && each.part_template == renaming.template_from)
      each.part_template = renaming.template_to;
    if (renaming.part_from.empty()) return;
    auto pinned = each.pinned.extract(renaming.part_from);
    if (pinned.empty()) return;
    Samples& target = each.pinned[renaming.part_to];
    Samples all;
    std::ranges::merge(target, pinned.mapped(), std::back_inserter(all));
    target = std::move(all);
  });
}

}  // namespace archetype
