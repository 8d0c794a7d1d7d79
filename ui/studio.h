// Everything that the window shows and edits, put together. The one argument of panels and commands.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/furniture_catalog.h"
#include "core/session/history.h"
#include "core/session/jobs.h"
#include "core/session/messages.h"
#include "core/session/session_mark.h"
#include "core/session/settings.h"
#include "core/session/user_folders.h"
#include "ui/autosave.h"
#include "ui/cloud_view.h"
#include "ui/cluster_pictures.h"
#include "ui/collection.h"
#include "ui/command.h"
#include "ui/corrected_shapes.h"
#include "ui/directory_reader.h"
#include "ui/fit_tables.h"
#include "ui/fonts.h"
#include "ui/inspection.h"
#include "ui/keys.h"
#include "ui/latency.h"
#include "ui/live_fit.h"
#include "ui/scripted_drag.h"
#include "ui/scripted_scroll.h"
#include "ui/shape_in_view.h"
#include "ui/shape_loader.h"
#include "ui/shape_map_store.h"
#include "ui/shape_strip.h"
#include "ui/surface_regions.h"
#include "ui/theme.h"
#include "ui/thumbnail_store.h"
#include "ui/ui_state.h"
#include "ui/viewport.h"

namespace archetype {

struct StudioOptions {
  UserFolders folders;
  std::filesystem::path assets;  // templates/*.json
  std::filesystem::path shaders;
  std::filesystem::path furniture = furniture_folder;  // the archives of the bundled collection
  std::function<void()> wake = {};  // brings the window's loop to draw a frame; called from other threads
};

// A job that writes to a project file.
struct ProjectWriter {
  JobId job = 0;
  std::filesystem::path project;
  bool fits = false;
  bool learns = false;
  std::size_t rounds_before = 0;  // that a learning goes on from
};

// Where something stands in the window that can be clicked; for tests and scripts.
struct Target {
  std::string name;
  float low_x, low_y, high_x, high_y;  // screen units
};

// Made and destroyed with the window's OpenGL context current: it holds textures.
struct Studio {
  explicit Studio(StudioOptions options);

  StudioOptions options;
  std::vector<Command> commands;
  Settings settings;
  Fonts fonts;
  Theme theme = Theme::dark;

  Collection collection;
  History history{{}, "Start"};
  UiState ui;
  ShapeInView shape;
  std::vector<Credit> credits;  // of the shapes of the open collection, where they are known
  Messages messages;
  ViewportState viewport;
  CloudView cloud;
  ClusterPictures cluster_pictures;
  CorrectedShapes corrected;
  LatencyMeter latency;
  FrameMeter frames;
  OpeningMeter opening;
  std::vector<Target> targets;         // of the frame drawn last
  std::vector<KeyChord> pressed_keys;  // since the last frame, in order
  std::vector<std::string>
      output;  // lines of commands for standard output; the program prints and clears them
  std::optional<std::filesystem::path> wanted_picture;  // of the whole window, once the next frame is drawn
  bool wanted_fonts = true;  // the fonts have to be loaded anew before the next frame
  std::optional<ScriptedDrag> drag;
  std::optional<ScriptedScroll> scroll;
  bool quit = false;
  bool attended = true;  // somebody is there to answer questions: no script or screenshot is under way
  std::optional<SessionMark> session;
  std::vector<LostSession> lost;  // what earlier sessions left, still to be offered

  // Beside the window. Last, so that they are stopped before what they tell of goes.
  ShapeLoader shape_loader;
  RowsReader rows_reader;
  FitTables fit_tables;
  ShapeMapStore shape_map;
  Autosave autosave;
  DirectoryReader directory_reader;
  std::shared_ptr<ExpectedFeatures> expected_features = std::make_shared<ExpectedFeatures>();
  LiveFit live_fit;
  ShapeStrip strip;
  Inspection inspection;
  RegionWorker region_worker;
  ThumbnailStore thumbnails;
  Jobs jobs;
  std::vector<ProjectWriter> writers;  // those of the jobs that write to a project, until they have ended

  std::optional<std::pair<RegionKind, std::uint64_t>> asked_regions;  // and the shape revision they are of
  std::optional<DirectoryListing> directory;                          // of the file browser
  std::chrono::steady_clock::time_point rows_asked_at{};
  bool rows_are_of_pause = false;  // asked for while all jobs were paused
  std::chrono::steady_clock::time_point frame_start{};
};

// Before the panels of a frame: takes over what jobs and workers have ready.
void begin_frame(Studio& studio);
// After its panels: hands on what they changed, while the frame is still being drawn.
void end_frame(Studio& studio);
// Once the frame is on the screen: for the measurement of the live fit.
void frame_shown(Studio& studio);
// Something that a script or a screenshot should wait for, in a few words; "" where there is nothing.
std::string_view under_way(const Studio& studio);
// Nothing is.
bool settled(const Studio& studio);
// Something changes by itself (a job reports, a fit comes in), so that frames go on without events.
bool wants_frames(const Studio& studio);

const Palette& colours(const Studio& studio);
// Shows the shape; nothing clears the view.
void show_shape(Studio& studio, std::optional<ShapeId> shape);
void say(Studio& studio, Severity severity, std::string text);  // in the messages and the status line

}  // namespace archetype
