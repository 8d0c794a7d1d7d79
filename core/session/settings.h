// What the program remembers of its user from one start to the next.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace archetype {

struct Settings {
  std::string theme = "dark";            // dark | light
  std::string navigation = "archetype";  // archetype | blender | maya: which buttons orbit, pan and zoom
  double ui_scale = 0;                   // 0: that of the screen; else 0.5 to 4
  int threads = 0;                       // of jobs; 0: all of the machine
  int window_width = 1440;               // screen units
  int window_height = 860;
  double left_width = 300;   // of the collection, at scale 1
  double right_width = 340;  // of the inspector
  double bottom_height = 170;
  bool show_bottom = true;
  double cell_size = 112;              // of the thumbnails
  std::string map_tool = "rectangle";  // rectangle | lasso: what selects on the map of the collection
  bool map_pictures = true;
  bool map_sliders = true;
  std::string plot = "members";         // that is shown
  std::string inspect_colour = "part";  // part | plain | distance | features | smoothness
  // What is drawn of a single fit.
  bool inspect_fitted_boxes = true;
  bool inspect_mean_boxes = false;
  bool inspect_template_points = false;
  bool inspect_correspondences = false;
  bool inspect_samples = false;
  std::vector<std::string> recent;  // projects and folders, newest first
  std::string last_folder;          // of the file browser
  std::map<std::string, std::string>
      keys;  // command name -> key, where it differs from the default; "" is none

  friend bool operator==(const Settings&, const Settings&) = default;
};

struct LoadedSettings {
  Settings settings;
  std::string problem;  // not empty: the file was broken and why; what could be read is kept
};

// No file: the defaults. A broken file or value never stops the program.
LoadedSettings load_settings(const std::filesystem::path& path);
// Makes the folder and replaces the file in one step. Throws FileError.
void save_settings(const std::filesystem::path& path, const Settings& settings);

// For `--set name=value` and the command `set`: everything but the lists. Returns what is wrong with it, or
// "".
std::string set_setting(Settings& settings, std::string_view name, std::string_view value);
// The same settings by name: for one that was for a run only. An unknown name changes nothing.
void copy_setting(Settings& to, const Settings& from, std::string_view name);
std::vector<std::string> setting_names();

// Puts a path first in the recent list, once, and keeps the newest twelve.
void remember_recent(Settings& settings, const std::filesystem::path& path);

}  // namespace archetype
