// Collections of made-up shapes with exact ground truth, for tests, scale and teaching: chairs, lamps,
// planes, tables.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/job_control.h"
#include "core/generate/faults.h"
#include "core/geometry/polygon_mesh.h"
#include "core/geometry/shape_frame.h"
#include "core/io/labels.h"

namespace archetype {

enum class YawChoice { none, quarters, any };  // about up: 0; 0, 90, 180 or 270 degrees; any angle
enum class ShapeEnding { off, obj };

struct GenerateOptions {
  std::size_t count = 20;
  std::uint64_t seed = 1;
  std::vector<std::string> styles;  // of the family; empty: all
  double noise = 0;                 // standard deviation of every coordinate, over the diagonal of the shape
  double missing_parts = 0;  // probability that all parts of one label are left out; the main part stays
  SoupFaults faults;
  YawChoice yaw = YawChoice::none;
  double scale_spread = 0;             // the size is multiplied by exp(u), u uniform in ± this
  double offset = 0;                   // moved by up to this many diagonals along each axis
  std::vector<UpAxis> ups{UpAxis::y};  // the up axes of the files, each as likely
  bool triangles = false;              // all faces cut into triangles, else quads beside triangles
  ShapeEnding ending = ShapeEnding::off;
  unsigned threads = 0;  // 0: all
};

struct FamilyNames {
  std::string name;
  std::vector<std::string> labels;     // index = label
  std::vector<std::string> landmarks;  // in the order of GeneratedShape::landmarks
  std::vector<std::string> styles;
};

struct GeneratedShape {
  std::string name;  // chair_00012
  std::string style;
  PolygonMesh mesh;         // file coordinates
  std::vector<int> labels;  // one per face
  // One per name of the family; exact marks on the surface, absent where the shape has no such place.
  std::vector<Landmark> landmarks;
  std::vector<std::pair<std::string, double>>
      parameters;          // as drawn, in the units that generator.json states
  double yaw_degrees = 0;  // turned by this about up
  UpAxis up = UpAxis::y;
  double scale = 1;  // file units per metre
};

// The names of the families, as the functions below take them.
std::vector<std::string> families();

// Throws PreconditionError for an unknown family; its message lists the known ones. So do the functions
// below.
FamilyNames family_names(const std::string& family);

// Shape number `index` of the collection that the options describe. It depends on nothing but family, options
// and index (not on `count` or `threads`). Throws PreconditionError for an unknown style or an option out of
// its range. About 0.3 ms.
GeneratedShape generate_shape(const std::string& family, const GenerateOptions& options, std::size_t index);

struct GenerateReport {
  std::size_t written = 0;
  bool cancelled = false;
};

// The content of generator.json: what each parameter is drawn from. Another text, another collection.
std::string describe_collection(const std::string& family, const GenerateOptions& options);

// Writes shapes/NAME.off (or .obj), labels/NAME.seg, labels/names.txt, landmarks/NAME.vts,
// landmarks/names.txt, styles.csv and generator.json (what each parameter is drawn from). A cancelled or
// killed call leaves a folder without styles.csv, and the same call goes on from it: files that are there
// stay. Throws FileError if
// something cannot be written, and if the folder holds other things than an unfinished or finished collection
// of the same family and options.
GenerateReport write_collection(const std::string& family, const GenerateOptions& options,
                                const std::filesystem::path& folder, const JobControl& control);

}  // namespace archetype
