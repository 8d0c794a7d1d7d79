#include "ui/shape_map_store.h"

#include "ui/studio.h"

namespace archetype {
namespace {

std::optional<std::shared_ptr<const MadeMap>> make_map(const MapRequest& request, const JobControl& control) {
  std::optional<std::size_t> part_template;
  for (std::size_t t = 0; request.of && t < request.table->templates.size(); ++t)
    if (request.table->templates[t].id == *request.of) part_template = t;
  std::optional<ShapeMap> map = map_of_shapes(*request.table, part_template, control);
  if (!map) return std::nullopt;
  const std::optional<TemplateId> of = part_template ? request.of : std::nullopt;  // it may have gone
  return std::make_shared<const MadeMap>(MadeMap{request.table, of, std::move(*map)});
}

}  // namespace

ShapeMapStore::ShapeMapStore(std::function<void()> wake) : maker(make_map, std::move(wake)) {}

std::shared_ptr<const MadeMap> use_shape_map(Studio& studio) {
  ShapeMapStore& store = studio.shape_map;
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (!table) return nullptr;
  MapRequest wanted{table, studio.ui.map.of};
  if (!(wanted == store.asked)) {
    store.asked = wanted;
    store.maker.request(std::move(wanted), true);
  }
  // The map of another project would show shapes that are not there.
  const bool same_project = store.newest && studio.fit_tables.newest.of.project == studio.ui.map.project;
  return same_project ? store.newest : nullptr;
}

void begin_shape_map(Studio& studio) {
  if (studio.ui.map.project != studio.collection.path) {
    studio.ui.map = {};
    studio.ui.map.project = studio.collection.path;
    studio.shape_map.newest.reset();
    studio.shape_map.maker.cancel();
    studio.shape_map.asked = {};
  }
  auto made = studio.shape_map.maker.poll();
  if (!made) return;
  // Another map is looked at as a whole first.
  if (!studio.shape_map.newest || studio.shape_map.newest->of != (*made)->of) studio.ui.map.whole = true;
  studio.shape_map.newest = std::move(*made);
}

}  // namespace archetype
