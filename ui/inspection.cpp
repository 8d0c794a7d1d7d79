#include "ui/inspection.h"

#include <algorithm>
#include <utility>

#include "core/session/fit_state.h"
#include "core/session/same_part.h"
#include "ui/project_actions.h"
#include "ui/studio.h"

namespace archetype {
namespace {

bool is_shown(const Studio& studio) {
  return studio.ui.centre == CentreView::inspect && studio.collection.open();
}

// The fit that the row of the shape tells of: when another one comes, the shape is read again.
std::optional<LoadInspected> wanted_shape(const Studio& studio, std::optional<ShapeId> shape) {
  if (!shape || !is_shown(studio)) return std::nullopt;
  const std::optional<std::size_t> row = find_row(studio.collection, *shape);
  if (!row) return std::nullopt;
  LoadInspected wanted{studio.collection.path, *shape};
  if (const auto& fit = studio.collection.rows()[*row].fit) {
    wanted.part_template = fit->part_template;
    wanted.state = fit->state;
    wanted.energy = fit->energy.total();
  }
  return wanted;
}

void ask_for_shape(InspectSide& side, const std::optional<LoadInspected>& wanted) {
  if (!wanted) {
    if (!side.asked) return;
    side.loader.cancel();
    side.looker.cancel();
    side.asked.reset();
    side.shape.reset();
    side.look.reset();
    side.asked_fit.reset();
    return;
  }
  if (side.asked == wanted) return;
  side.asked = wanted;
  side.loader.request(*wanted, true);
}

struct ShownFit {
  std::shared_ptr<const PartTemplate> part_template;
  std::shared_ptr<const ShapeFit> fit;
};

ShownFit stored_fit(const InspectSide& side) {
  if (!side.shape || !side.shape->fit || !side.shape->part_template) return {};
  return {side.shape->part_template, {side.shape, &side.shape->fit->fit}};
}

// Of the main side.
ShownFit fit_to_show(const Studio& studio) {
  const Inspection& inspection = studio.inspection;
  ShownFit shown = stored_fit(inspection.main);
  if (const auto chosen = shown_alternative(studio)) {
    const Alternatives& all = *inspection.alternatives;
    if (const FitAlternative* alternative = find_alternative(all, *chosen))
      shown = {all.templates[alternative->part_template], {inspection.alternatives, &alternative->fit}};
  }
  const std::vector<ShapeFit>* steps = shown_steps(studio);
  const auto step = studio.ui.inspect.step;
  if (steps && step && *step + 1 < steps->size()) shown.fit = {inspection.alternatives, &(*steps)[*step]};
  return shown;
}

void ask_for_look(InspectSide& side, const ShownFit& shown, const ShapeCorrection& correction, bool places) {
  if (!side.shape || !shown.fit || side.asked_fit == shown.fit) return;
  if (shown.fit->labels.size() != side.shape->samples->size()) return;
  side.asked_fit = shown.fit;
  LookRequest request{side.shape, shown.part_template, shown.fit, {}, places};
  if (correction.sampling == sampling_of(side.shape->record))
    request.pinned = pinned_labels(correction.pinned, *shown.part_template, side.shape->samples->size());
  side.looker.request(std::move(request), false);
}

PinnedParts pins_in_view(const Studio& studio) {
  const InspectSide& main = studio.inspection.main;
  const ShapeCorrection correction = correction_in_view(studio);
  return main.shape && correction.sampling == sampling_of(main.shape->record) ? correction.pinned
                                                                              : PinnedParts{};
}

void ask_for_alternatives(Studio& studio) {
  Inspection& inspection = studio.inspection;
  if (!inspection.main.shape || studio.history.has_preview()) return;  // once the stroke is done
  AlternativesRequest wanted{studio.collection.path, inspection.main.shape, pins_in_view(studio)};
  if (inspection.asked_alternatives == wanted) return;
  const bool other_shape =
      !inspection.asked_alternatives || inspection.asked_alternatives->shape != wanted.shape;
  if (other_shape) inspection.alternatives.reset();
  inspection.asked_alternatives = wanted;
  inspection.alternatives_maker.request(std::move(wanted), true);
}

void ask_for_cluster(Studio& studio) {
  Inspection& inspection = studio.inspection;
  const std::shared_ptr<const InspectedShape> shape = inspection.main.shape;
  const bool being_changed = is_written(studio, studio.collection.path) && !studio.jobs.resting();
  if (!shape || !shape->fit || being_changed) return;
  const ClusterRequest wanted{studio.collection.path, shape->fit->part_template, studio.collection.revision};
  if (inspection.asked_cluster == wanted) return;
  inspection.asked_cluster = wanted;
  inspection.cluster_reader.request(wanted, true);
}

void take_over(InspectSide& side) {
  if (auto loaded = side.loader.poll(); loaded && side.asked == loaded->of) {
    side.shape = std::move(loaded->shape);
    side.problem = std::move(loaded->problem);
    side.asked_fit.reset();
    if (!side.shape || !side.shape->fit) side.look.reset();
  }
  if (auto result = side.looker.poll(); result && result->of.shape == side.shape)
    side.look = std::move(result->look);
}

// The same samples and templates, if another fit.
bool same_but_fit(const InspectedShape& a, const InspectedShape& b) {
  return a.record.id == b.record.id && sampling_of(a.record) == sampling_of(b.record) && a.state == b.state &&
         std::ranges::equal(a.templates, b.templates, {}, &TemplateRecord::id, &TemplateRecord::id);
}

// What else the shape could be does not depend on the fit that it has: nothing is tried again, and nothing
// jumps in the window, when it was fitted anew.
void keep_alternatives(Inspection& inspection) {
  const std::shared_ptr<const InspectedShape>& shape = inspection.main.shape;
  if (!shape) return;
  auto& asked = inspection.asked_alternatives;
  if (asked && asked->shape != shape && same_but_fit(*asked->shape, *shape)) asked->shape = shape;
  const std::shared_ptr<const Alternatives>& newest = inspection.alternatives;
  if (!newest || newest->of.shape == shape || !same_but_fit(*newest->of.shape, *shape)) return;
  auto kept = std::make_shared<Alternatives>(*newest);
  kept->of.shape = shape;
  inspection.alternatives = std::move(kept);
}

// What was chosen for one shape says nothing of the next.
void forget_choices(Studio& studio) {
  InspectOptions& options = studio.ui.inspect;
  options.chosen.reset();
  options.step.reset();
}

}  // namespace

ShapeCorrection correction_in_view(const Studio& studio) {
  if (!studio.ui.shape) return {};
  const ShapeCorrection* correction = correction_of(studio.history.current(), *studio.ui.shape);
  return correction ? *correction : ShapeCorrection{};
}

const Alternatives* alternatives_of_view(const Studio& studio) {
  const Inspection& inspection = studio.inspection;
  const bool fits = inspection.alternatives && inspection.alternatives->of.shape == inspection.main.shape;
  return fits ? inspection.alternatives.get() : nullptr;
}

const FitAlternative* find_alternative(const Alternatives& alternatives, const ChosenAlternative& wanted) {
  for (const FitAlternative& each : alternatives.fits) {
    const TemplateId id = alternatives.of.shape->templates[each.part_template].id;
    if (ChosenAlternative{id, each.fit.yaw_quarters} == wanted) return &each;
  }
  return nullptr;
}

std::optional<ChosenAlternative> coming_fit(const Studio& studio) {
  const Alternatives* all = alternatives_of_view(studio);
  if (!all) return std::nullopt;
  const InspectedShape& shape = *all->of.shape;
  const ShapeCorrection correction = correction_in_view(studio);
  if (shape.fit && shape.fit->state == corrected_fit_state(shape.state, &correction)) return std::nullopt;
  const FitAlternative* best = decided_alternative(*all, correction);
  if (!best) return std::nullopt;
  return ChosenAlternative{shape.templates[best->part_template].id, best->fit.yaw_quarters};
}

std::optional<ChosenAlternative> shown_alternative(const Studio& studio) {
  const Alternatives* all = alternatives_of_view(studio);
  if (!all) return std::nullopt;
  const auto chosen = studio.ui.inspect.chosen;
  if (chosen && find_alternative(*all, *chosen)) return chosen;
  return coming_fit(studio);
}

const std::vector<ShapeFit>* shown_steps(const Studio& studio) {
  const Alternatives* all = alternatives_of_view(studio);
  if (!all) return nullptr;
  std::optional<ChosenAlternative> of = shown_alternative(studio);
  const auto& stored = all->of.shape->fit;
  if (!of && stored) of = ChosenAlternative{stored->part_template, stored->fit.yaw_quarters};
  const FitAlternative* found = of ? find_alternative(*all, *of) : nullptr;
  return found ? &found->steps : nullptr;
}

std::optional<std::size_t> inspected_part(const Studio& studio, const FitLook& look) {
  const auto& part = studio.ui.selection.part;
  if (!part) return std::nullopt;
  for (const TemplateRecord& each : look.shape->templates)
    if (each.id == part->part_template)
      return find_same_part(each.part_template, part->part, *look.part_template);
  return std::nullopt;
}

void pick_inspected_part(Studio& studio, std::optional<std::size_t> part) {
  ExplorerSelection& selection = studio.ui.selection;
  selection.part.reset();
  selection.place.reset();
  if (part && studio.inspection.main.shape && studio.inspection.main.shape->fit)
    selection.part = PartOfTemplate{inspected_template(studio, 0), *part};
}

TemplateId inspected_template(const Studio& studio, std::size_t side) {
  if (side == 0)
    if (const auto shown = shown_alternative(studio)) return shown->part_template;
  return studio.inspection.side(side).shape->fit->part_template;
}

std::size_t outdated_fits(const Studio& studio) {
  const std::shared_ptr<const InspectedShape>& shape = studio.inspection.main.shape;
  if (!shape) return 0;
  const Document& document = studio.history.committed();
  return static_cast<std::size_t>(std::ranges::count_if(studio.collection.rows(), [&](const ShapeRow& row) {
    return row.fit && row.fit->state != corrected_fit_state(shape->state, correction_of(document, row.id));
  }));
}

void begin_inspection(Studio& studio) {
  Inspection& inspection = studio.inspection;
  take_over(inspection.main);
  take_over(inspection.beside);
  if (auto made = inspection.alternatives_maker.poll()) inspection.alternatives = std::move(*made);
  keep_alternatives(inspection);
  if (auto read = inspection.cluster_reader.poll()) inspection.cluster = std::move(read);
  for (const std::string& problem :
       {inspection.main.loader.take_problem(), inspection.main.looker.take_problem(),
        inspection.beside.loader.take_problem(), inspection.beside.looker.take_problem(),
        inspection.alternatives_maker.take_problem(), inspection.cluster_reader.take_problem()})
    if (!problem.empty()) say(studio, Severity::error, problem);
}

void end_inspection(Studio& studio) {
  Inspection& inspection = studio.inspection;
  if (!is_shown(studio) && !inspection.main.asked && !inspection.beside.asked) return;
  const auto wanted = wanted_shape(studio, studio.ui.shape);
  if (!wanted || !inspection.main.asked || inspection.main.asked->shape != wanted->shape)
    forget_choices(studio);
  ask_for_shape(inspection.main, wanted);
  auto& beside = studio.ui.inspect.beside;
  if (beside == studio.ui.shape || (beside && !find_row(studio.collection, *beside))) beside.reset();
  ask_for_shape(inspection.beside, wanted_shape(studio, beside));
  if (!wanted) return;
  ask_for_alternatives(studio);
  ask_for_cluster(studio);
  ask_for_look(inspection.main, fit_to_show(studio), correction_in_view(studio), !studio.ui.inspect.step);
  const ShapeCorrection* other = beside ? correction_of(studio.history.current(), *beside) : nullptr;
  ask_for_look(inspection.beside, stored_fit(inspection.beside), other ? *other : ShapeCorrection{}, true);
}

bool inspection_settled(const Studio& studio) {
  const Inspection& inspection = studio.inspection;
  const auto idle = [](const InspectSide& side) { return side.loader.idle() && side.looker.idle(); };
  if (!idle(inspection.main) || !idle(inspection.beside)) return false;
  if (!inspection.alternatives_maker.idle() || !inspection.cluster_reader.idle()) return false;
  if (!is_shown(studio)) return true;
  if (inspection.main.asked != wanted_shape(studio, studio.ui.shape)) return false;
  // The finer picture is still to come.
  const auto refined = [&](const InspectSide& side) {
    return !side.shape || !side.drawn || side.drawn_fine || inspection.stroking ||
           inspection.mouse.action != MouseAction::none;
  };
  return refined(inspection.main) && refined(inspection.beside);
}

}  // namespace archetype
