// Walks folders for shapes in an order that depends on nothing but the names in them.
#include "core/session/scan_shapes.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/io/read_shape.h"

namespace archetype {

namespace fs = std::filesystem;

namespace {

bool is_hidden(const fs::path& path) {
  return path.filename().native().starts_with('.');
}

// The path below the imported folder without its ending, "/" written as "__".
std::string shape_name(const fs::path& relative) {
  std::string name;
  for (const fs::path& step : relative.parent_path()) name += step.native() + "__";
  return name + relative.stem().native();
}

class Scanner {
 public:
  explicit Scanner(const JobControl& control) : control_(control) {}

  void add_argument(const fs::path& argument) {
    std::error_code error;
    const fs::path path = fs::absolute(argument).lexically_normal();
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
      refuse(path, "does not exist; check the name");
    } else if (fs::is_directory(status)) {
      add_tree(path);
    } else if (!fs::is_regular_file(status)) {
      refuse(path, "is neither a file nor a folder");
    } else if (!has_shape_ending(path)) {
      refuse(path,
             "has no ending of a shape format; expected .obj, .off, .ply, .stl, .gltf, .glb, .xyz, .pts, "
             ".ac or .binvox");
    } else {
      add_file(path, path.filename());
    }
  }

  ShapeScan result() {
    ShapeScan scan;
    for (const auto& [canonical, input] : files_) scan.inputs.push_back(input);
    std::ranges::sort(scan.inputs, [](const ShapeInput& a, const ShapeInput& b) {
      return std::tie(a.name, a.path.native()) < std::tie(b.name, b.path.native());
    });
    for (const auto& [path, reason] : refused_) scan.refused.push_back({path, reason});
    return scan;
  }

 private:
  void refuse(const fs::path& path, const std::string& reason) { refused_.emplace(path, reason); }

  void add_file(const fs::path& path, const fs::path& relative) {
    std::error_code error;
    const fs::path canonical = fs::canonical(path, error);
    if (error) return refuse(path, "cannot be reached: " + error.message());
    const ShapeInput input{shape_name(relative), path};
    const auto rank = [](const ShapeInput& i) {
      return std::tuple(-std::ssize(i.name), i.name, i.path.native());
    };
    const auto [slot, is_new] = files_.emplace(canonical, input);
    if (!is_new && rank(input) < rank(slot->second)) slot->second = input;
  }

  // Linked folders come last, so that one that is also reached without a link is named by where it is.
  void add_tree(const fs::path& root) {
    visited_.clear();
    linked_.clear();
    add_folder(root, {});
    for (std::size_t i = 0; i < linked_.size(); ++i) {
      const auto [folder, relative] = linked_[i];
      add_folder(folder, relative);
    }
  }

  void add_folder(const fs::path& folder, const fs::path& relative) {
    std::error_code error;
    if (control_.cancelled() || !visited_.insert(fs::canonical(folder, error)).second) return;
    std::vector<fs::directory_entry> entries;
    fs::directory_iterator iterator(folder, error);
    for (; !error && iterator != fs::directory_iterator(); iterator.increment(error))
      entries.push_back(*iterator);
    if (error) refuse(folder, "cannot be searched: " + error.message());
    std::ranges::sort(entries);
    for (const fs::directory_entry& entry : entries) {
      if (is_hidden(entry.path())) continue;
      const fs::path below = relative / entry.path().filename();
      if (entry.is_directory(error)) {
        if (entry.is_symlink(error)) {
          linked_.emplace_back(entry.path(), below);
        } else {
          add_folder(entry.path(), below);
        }
      } else if (entry.is_regular_file(error) && has_shape_ending(entry.path())) {
        add_file(entry.path(), below);
      }
    }
  }

  const JobControl& control_;
  std::set<fs::path> visited_;                         // canonical
  std::vector<std::pair<fs::path, fs::path>> linked_;  // with the path below the root
  std::map<fs::path, ShapeInput> files_;               // by canonical path
  std::map<fs::path, std::string> refused_;
};

}  // namespace

ShapeScan scan_shapes(const std::vector<fs::path>& paths, const JobControl& control) {
  Scanner scanner(control);
  for (const fs::path& path : paths) scanner.add_argument(path);
  return scanner.result();
}

}  // namespace archetype
