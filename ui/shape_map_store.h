// The map of the collection, made beside the window and only while it is shown.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "core/session/latest_worker.h"
#include "core/session/shape_map.h"

namespace archetype {

struct Studio;

struct MapRequest {
  std::shared_ptr<const FitTable> table;
  std::optional<TemplateId> of;  // nothing: all templates
  friend bool operator==(const MapRequest&, const MapRequest&) = default;
};
struct MadeMap {
  std::shared_ptr<const FitTable> table;
  std::optional<TemplateId> of;
  ShapeMap map;
};
using MapMaker = LatestWorker<MapRequest, std::shared_ptr<const MadeMap>>;

struct ShapeMapStore {
  explicit ShapeMapStore(std::function<void()> wake);

  std::shared_ptr<const MadeMap> newest;
  MapRequest asked;
  MapMaker maker;
};

// The newest map of the open project's fits; null while there is none. Asks for a newer one where needed.
std::shared_ptr<const MadeMap> use_shape_map(Studio& studio);
// Once a frame, before its panels.
void begin_shape_map(Studio& studio);

}  // namespace archetype
