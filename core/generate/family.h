// What a family of generated shapes consists of. Each family has its own file; all are listed in
// generate.cpp. Families build upright shapes in metres: y up, the floor (or the lowest point) near y = 0,
// the front towards +z, so that +x is the object's left.
#pragma once

#include <string_view>
#include <vector>

#include "core/generate/distribution.h"
#include "core/generate/solids.h"

namespace archetype {

struct FamilyLabel {
  std::string_view name;
  bool may_miss = true;  // whether GenerateOptions::missing_parts may take it away
};

struct FamilyStyle {
  std::string_view name;
  double weight = 1;  // how often it is drawn, relative to the other styles
  std::vector<Parameter> parameters;
  Assembly (*build)(const ParameterValues& parameters) = nullptr;
};

struct Family {
  std::string_view name;   // as the command line calls it: chairs
  std::string_view shape;  // what one of them is called: chair
  std::vector<FamilyLabel> labels;
  std::vector<std::string_view> landmarks;
  std::vector<FamilyStyle> styles;
};

Family chairs();
Family lamps();
Family planes();
Family tables();

}  // namespace archetype
