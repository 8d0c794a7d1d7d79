#include "ui/cloud_picture.h"

#include <algorithm>
#include <cmath>

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

// So long nothing has to have moved before all points are drawn.
constexpr std::chrono::milliseconds rest{120};

// Fewer points are drawn larger, so that surfaces do not fall apart, but not so large that they blur.
float radius_for(const ScenePoints& points, std::size_t drawn) {
  const auto all = static_cast<float>(points.geometry->positions.size());
  const float thinner = std::sqrt(all / static_cast<float>(std::max<std::size_t>(drawn, 1)));
  return 0.5F * points.geometry->spacing * std::min(thinner, 1.6F);
}

void draw_first(Renderer& renderer, CloudPicture& picture, const CloudPictureKey& key, std::size_t most) {
  Scene scene = cloud_scene(key);
  const std::size_t all = key.points->positions.size();
  scene.points[0].most = most;
  scene.points[0].radius = radius_for(scene.points[0], std::min(most, all));
  renderer.draw(scene, key.camera, key.size, picture.shown);
  picture.swapped = false;
  picture.drawn = key;
  picture.whole = all <= most;
  picture.come = 0;
}

void draw_next(Renderer& renderer, CloudPicture& picture, const CloudPictureKey& key, std::size_t most) {
  Scene scene = cloud_scene(key);
  scene.points[0].first = picture.come;
  scene.points[0].most = most;
  if (picture.come == 0)
    renderer.draw(scene, key.camera, key.size, picture.coming);
  else
    renderer.draw_more_points(scene, key.camera, picture.coming);
  picture.come += most;
  if (picture.come < key.points->positions.size()) return;
  picture.swapped = picture.whole = true;
}

}  // namespace

// Frames take a + b N for N points. N = K / (time of the frame before) comes to rest where N (a + b N) = K,
// without jumping to and fro, since each step is smaller than the one before.
std::size_t points_for_frame(double milliseconds_before, bool moving) {
  const double milliseconds = std::clamp(milliseconds_before, 2.0, 500.0);
  const double points = (moving ? 3e6 : 16e6) / milliseconds;
  return static_cast<std::size_t>(std::clamp(points, 20'000.0, moving ? 500'000.0 : 1'000'000.0));
}

Scene cloud_scene(const CloudPictureKey& key) {
  Scene scene;
  scene.backdrop = key.backdrop;
  scene.points.push_back({.geometry = key.points, .colours = key.colours, .blend = key.blend});
  scene.points[0].radius = radius_for(scene.points[0], key.points->positions.size());
  return scene;
}

void draw_cloud_picture(Renderer& renderer, CloudPicture& picture, const CloudPictureKey& key, bool moving,
                        std::size_t most_points) {
  const Clock::time_point now = Clock::now();
  if (picture.drawn != key) {
    draw_first(renderer, picture, key, most_points);
    picture.changed_at = now;
  } else if (!picture.whole && !moving && now - picture.changed_at > rest) {
    draw_next(renderer, picture, key, most_points);
  } else {
    return;
  }
  if (picture.whole)
    picture.milliseconds_to_whole =
        std::chrono::duration<double, std::milli>(Clock::now() - picture.changed_at).count();
}

void draw_cloud_marks(Renderer& renderer, CloudPicture& picture, const CloudPictureKey& key,
                      const MarkedPoints& marks) {
  if (!marks.points) {
    picture.marked.reset();
    return;
  }
  if (picture.marked && picture.marked->first == key && picture.marked->second == marks) return;
  Scene scene;
  scene.backdrop = Backdrop::transparent;
  scene.points.push_back(
      {.geometry = marks.points, .colour = marks.colour, .lit = false, .blend = key.blend});
  scene.points[0].radius = 0.7F * marks.points->spacing;
  renderer.draw(scene, key.camera, key.size, picture.marks);
  picture.marked = {key, marks};
}

}  // namespace archetype
