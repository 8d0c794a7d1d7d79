// The strip: up to eight other shapes beside the one in view, fitted and drawn again while a box is dragged,
// so that a template that gets better on one shape and worse on others is noticed at once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/session/latest_worker.h"
#include "render/renderer.h"
#include "ui/latency.h"
#include "ui/strip_shape.h"

namespace archetype {

struct Studio;

inline constexpr std::size_t most_strip_shapes = 8;

// Everything that the picture of a tile depends on.
struct TilePicture {
  std::shared_ptr<const StripShape> shape;
  std::shared_ptr<const StripFit> fit;
  double yaw = 0;  // of the camera
  double pitch = 0;
  PictureSize size;
  Backdrop backdrop = Backdrop::dark;
  friend bool operator==(const TilePicture&, const TilePicture&) = default;
};

struct StripTile {
  ShapeId id = 0;
  std::shared_ptr<const StripShape> shape;  // null until it is read
  std::shared_ptr<const StripFit> fit;      // null: none yet
  std::optional<double> energy_before;      // when the drag, or the last edit, began
  RenderTarget target;
  std::optional<TilePicture> drawn;  // what the target shows
};

using StripLoader = LatestWorker<LoadStripShape, LoadedStripShape>;
using StripFitter = LatestWorker<StripFitRequest, StripFitResult>;

// Needs the window's OpenGL context when it dies.
struct ShapeStrip {
  ShapeStrip(std::shared_ptr<ExpectedFeatures> expected, const std::function<void()>& wake)
      : loader(load_strip_shape, wake),
        fitter([fitters = std::make_shared<StripFitters>(std::move(expected))](
                   const StripFitRequest& request,
                   const JobControl& control) { return fitters->run(request, control); },
               wake) {}

  std::vector<StripTile> tiles;  // those of ui.strip, in its order
  std::filesystem::path project;
  LatencyMeter latency;  // of the whole strip

  std::optional<ShapeId> loading;
  std::uint64_t tiles_revision = 0;  // changes when a shape comes or goes
  std::uint64_t asked_tiles = 0;     // of the newest request
  std::uint64_t asked_document = 0;
  std::shared_ptr<const PartTemplate> asked_look;
  bool asked_dragging = false;
  std::uint64_t seen_document = 0;  // the newest revision that was looked at
  bool seen_preview = false;
  std::uint64_t shown_document = 0;  // of the fits that the next frame shows
  bool newly_shown = false;          // the frame being drawn is the first with them
  double fit_milliseconds = 0;       // of the newest result

  StripLoader loader;
  StripFitter fitter;
};

// It is in sight: only then its shapes are read and fitted.
bool strip_in_sight(const Studio& studio);

// Which shapes it shows. "Worst": of those that are fitted, with the highest energies; random ones where none
// is. Neither takes the shape in view. The others throw Error with a line for a person.
void fill_strip_with_worst(Studio& studio);
void fill_strip_at_random(Studio& studio);  // others each time
void add_to_strip(Studio& studio, ShapeId shape);
void remove_from_strip(Studio& studio, ShapeId shape);
void clear_strip(Studio& studio);

// Before the panels of a frame: takes over what the workers have ready.
void begin_strip(Studio& studio);
// After them: asks for what is missing.
void end_strip(Studio& studio);
// Once the frame is on the screen.
void strip_shown(Studio& studio, LatencyMeter::Clock::time_point now);
bool strip_settled(const Studio& studio);

// How far the energy of a tile has changed since the drag, or the last edit, began; nothing if that is not
// known. A part that must exist and is lacking does not count.
std::optional<double> energy_change(const StripTile& tile);

}  // namespace archetype
