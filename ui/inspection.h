// A single fit under the magnifying glass: what it is, what else it could have been, and what a person says
// of it. What the view keeps from frame to frame, and the workers that make it.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/renderer.h"
#include "ui/camera_mouse.h"
#include "ui/inspect_options.h"
#include "ui/inspected_fit.h"
#include "ui/viewport_scene.h"

namespace archetype {

struct Studio;

// Everything that the picture of a side depends on.
struct InspectPicture {
  Camera camera;
  PictureSize size;
  Backdrop backdrop = Backdrop::dark;
  std::shared_ptr<const FitLook> look;
  std::shared_ptr<const InspectedShape> shape;
  InspectColour colour = InspectColour::part;
  std::array<bool, 5> shown{};
  std::shared_ptr<const Corrections> corrections;
  std::optional<std::size_t> part;
  friend bool operator==(const InspectPicture&, const InspectPicture&) = default;
};

// One of the two shapes.
struct InspectSide {
  explicit InspectSide(const std::function<void()>& wake)
      : loader(load_inspected, wake),
        looker(
            [fitter = std::make_shared<FitLooker>()](const LookRequest& request, const JobControl& control) {
              return fitter->run(request, control);
            },
            wake) {}

  std::shared_ptr<const InspectedShape> shape;  // null until it is read
  std::string problem;                          // why it could not be
  std::shared_ptr<const FitLook> look;          // null: none yet
  std::optional<LoadInspected> asked;
  std::shared_ptr<const ShapeFit> asked_fit;  // the one that was asked to be taken apart

  ShapeColours colours;
  std::shared_ptr<const FitLook> coloured;
  InspectColour coloured_by = InspectColour::part;
  std::optional<std::size_t> coloured_part;  // that keeps its colours while others are dimmed

  RenderTarget target;
  std::optional<InspectPicture> drawn;
  bool drawn_fine = false;
  std::chrono::steady_clock::time_point changed_at{};

  LatestWorker<LoadInspected, LoadedInspected> loader;
  LatestWorker<LookRequest, LookResult> looker;
};

// A place on a shape that the mouse points at, or pointed at.
struct InspectedPlace {
  std::size_t side = 0;
  Vec3 point = Vec3::Zero();     // normalised coordinates of the shape
  std::uint32_t sample = 0;      // the nearest one
  std::optional<Vec3> on_other;  // where it is on the other shape
};

// Needs the window's OpenGL context when it dies.
struct Inspection {
  explicit Inspection(const std::function<void()>& wake)
      : main(wake),
        beside(wake),
        alternatives_maker(make_alternatives, wake),
        cluster_reader(read_cluster, wake) {}

  InspectSide main;
  InspectSide beside;
  InspectSide& side(std::size_t index) { return index == 0 ? main : beside; }
  const InspectSide& side(std::size_t index) const { return index == 0 ? main : beside; }

  std::shared_ptr<const Alternatives> alternatives;  // may be of another shape: see alternatives_of_view()
  std::optional<AlternativesRequest> asked_alternatives;
  std::optional<ClusterResult> cluster;
  std::optional<ClusterRequest> asked_cluster;

  Camera camera;  // of both sides: the shapes stand in the frame of the template
  bool framed = false;
  WholeView seen;  // of all that is shown
  CameraMouse mouse;
  std::size_t held = 0;               // the side that the mouse button went down on
  bool stroking = false;              // the brush is down
  std::vector<std::uint32_t> stroke;  // the samples painted since the button went down
  bool stroke_previewed = false;
  std::optional<InspectedPlace> hovered;  // of the frame drawn last

  LatestWorker<AlternativesRequest, std::shared_ptr<const Alternatives>> alternatives_maker;
  LatestWorker<ClusterRequest, ClusterResult> cluster_reader;
};

// What was corrected of the shape in view; nothing of it where that is nothing.
ShapeCorrection correction_in_view(const Studio& studio);
// The newest alternatives of the shape in view; null while they are made.
const Alternatives* alternatives_of_view(const Studio& studio);
// The one of a template and yaw; null if there is none.
const FitAlternative* find_alternative(const Alternatives& alternatives, const ChosenAlternative& wanted);
// The number that decides which one a shape takes: choice_energy(), and what other shapes say of the yaw,
// where that is known and no yaw is pinned. Infinite for a yaw that they rule out.
double deciding_energy(const Alternatives& alternatives, const FitAlternative& alternative,
                       const ShapeCorrection& correction);
// The one that a fit of the shape takes: each template its best yaw, and of those the least
// deciding_energy(). Where other shapes' say is not known, the shape keeps the yaw that it has. Null if what
// was corrected allows none.
const FitAlternative* decided_alternative(const Alternatives& alternatives,
                                          const ShapeCorrection& correction);
// In words, where decided_alternative() is not the one with the least deciding_energy(), or the fit of the
// project not that one, or an outlier: why. Empty where there is nothing to explain.
std::string why_decided(const Alternatives& alternatives, const ShapeCorrection& correction);
// Where the fit that the project holds does not heed what was corrected since: what the next fit will
// find. Nothing where it does, or the alternatives are not there.
std::optional<ChosenAlternative> coming_fit(const Studio& studio);
// What is shown: the one that was chosen, what comes, or the fit of the project (nothing).
std::optional<ChosenAlternative> shown_alternative(const Studio& studio);
// The alternations of what is shown; null where they are not known.
const std::vector<ShapeFit>* shown_steps(const Studio& studio);
// The explorer's part in the template of a look; nothing where none is picked, or the template lacks it.
std::optional<std::size_t> inspected_part(const Studio& studio, const FitLook& look);
// Picks a part of what is shown, for all views; nothing lets go of it.
void pick_inspected_part(Studio& studio, std::optional<std::size_t> part);
// The template of what a side shows. The side has a shape with a fit.
TemplateId inspected_template(const Studio& studio, std::size_t side);
// Shapes whose fit in the project is not of its templates and of what was corrected.
std::size_t outdated_fits(const Studio& studio);

// Once a frame, before and after its panels. Nothing is asked for while the view is not shown.
void begin_inspection(Studio& studio);
void end_inspection(Studio& studio);
bool inspection_settled(const Studio& studio);

}  // namespace archetype
