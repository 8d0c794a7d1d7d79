// The picture of a cloud in one pane. While something moves a part of the points is drawn, as many as stay
// fluid; once it rests all of them come in, some a frame, behind the picture, and are shown when they are
// there. So no frame takes long, however many there are.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "render/camera.h"
#include "render/renderer.h"

namespace archetype {

// How many points a frame can draw, over all panes, when the one before took so long: while the view moves so
// that it stays fluid (about 35 ms without a graphics card), more while it rests.
std::size_t points_for_frame(double milliseconds_before, bool moving);

// All that the picture depends on.
struct CloudPictureKey {
  Camera camera;
  PictureSize size;
  Backdrop backdrop = Backdrop::dark;
  float blend = 0;
  std::shared_ptr<const PointGeometry> points;
  std::shared_ptr<const Colours> colours;
  friend bool operator==(const CloudPictureKey&, const CloudPictureKey&) = default;
};

// The points over it that are marked: a small picture of their own, since they change with the mouse.
struct MarkedPoints {
  std::shared_ptr<const PointGeometry> points;  // null: none
  Rgb colour{255, 255, 255};
  friend bool operator==(const MarkedPoints&, const MarkedPoints&) = default;
};

struct CloudPicture {
  RenderTarget shown;
  RenderTarget coming;
  RenderTarget marks;
  std::optional<CloudPictureKey> drawn;  // what `shown` shows, with some points or all
  std::size_t come = 0;                  // points drawn into `coming`
  bool whole = false;                    // `shown` has all points
  bool swapped = false;                  // it is in `coming`: the two have changed places
  std::optional<std::pair<CloudPictureKey, MarkedPoints>> marked;  // what `marks` shows
  std::chrono::steady_clock::time_point changed_at{};
  double milliseconds_to_whole = 0;  // from the last change until all points were seen

  const RenderTarget& visible() const { return swapped ? coming : shown; }
};

// The scene of a cloud; `radius` from the spacing of its points.
Scene cloud_scene(const CloudPictureKey& key);

// Draws what has changed, or the next points of what rests, at most so many; `moving`: the mouse holds the
// view.
void draw_cloud_picture(Renderer& renderer, CloudPicture& picture, const CloudPictureKey& key, bool moving,
                        std::size_t most_points);
void draw_cloud_marks(Renderer& renderer, CloudPicture& picture, const CloudPictureKey& key,
                      const MarkedPoints& marks);

}  // namespace archetype
