// What is chosen in the view of co-aligned clouds: plain data.
#pragma once

#include "core/io/project.h"

namespace archetype {

enum class CloudScope { collection, cluster, selection };
enum class CloudColour { part, shape, displacement };

struct CloudChoice {
  CloudScope scope = CloudScope::collection;
  TemplateId cluster = 0;  // of CloudScope::cluster
  CloudColour colour = CloudColour::part;
  bool pair = true;    // rigid beside deformed; else one cloud between the two
  float blend = 1;     // of the one: 0 rigid, 1 deformed
  bool boxes = false;  // the outlines of the mean boxes over it
  friend bool operator==(const CloudChoice&, const CloudChoice&) = default;
};

}  // namespace archetype
