// Makes the pictures of the grid on a thread of its own, with an OpenGL context of its own: the window never
// waits.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/picture.h"
#include "core/io/project.h"

namespace archetype {

// Of the templates with parts that were given a colour by hand: by name, TemplatePart::colour of each part.
using HandColours = std::map<std::string, std::vector<int>>;

struct WantedThumbnail {
  ShapeId shape = 0;
  std::uint64_t stamp = 0;         // of the file and the fit that it shows
  bool fitted = false;             // false: the plain surface
  int highlighted = -1;            // the part whose colours are kept while all others are dimmed; -1: none is
  std::optional<Vec3> place = {};  // of the highlighted part's mean box, in its template: marked by a ring
  std::shared_ptr<const HandColours> colours = {};  // null: nobody chose one
  friend bool operator==(const WantedThumbnail&, const WantedThumbnail&) = default;
};

struct MadeThumbnail {
  std::filesystem::path project;
  WantedThumbnail wanted;
  Picture picture;  // empty if the shape cannot be drawn
};

inline constexpr int no_such_part = 1 << 20;  // highlighted in a shape that lacks the part: all is dimmed

inline constexpr int thumbnail_size = 192;  // pixels

// What a picture was drawn from.
struct ThumbnailSource {
  ContentHash file;
  std::optional<ContentHash> fit;  // nothing: there is none
  friend bool operator==(const ThumbnailSource&, const ThumbnailSource&) = default;
};
ThumbnailSource thumbnail_source(const Project& project, ShapeId shape);
// Puts the picture into the project unless the shape was read or fitted anew while it was drawn: then it
// shows what was, and would never be made again. Whether it did.
bool keep_thumbnail(Project& project, ShapeId shape, const std::string& kind, const Picture& picture,
                    const ThumbnailSource& source);

// Draws fitted shapes of a project on the thread that calls, with an OpenGL context of its own that is opened
// for the first of them; keeps the pictures as the worker does. An empty picture where one cannot be drawn.
std::function<Picture(ShapeId)> thumbnail_drawer(std::filesystem::path project,
                                                 std::filesystem::path shaders);

// Pictures that the project has already are taken from there; new ones are kept there.
class ThumbnailWorker {
 public:
  ThumbnailWorker(std::filesystem::path shaders, std::function<void()> wake);
  ThumbnailWorker(const ThumbnailWorker&) = delete;
  ThumbnailWorker& operator=(const ThumbnailWorker&) = delete;
  ~ThumbnailWorker();

  // Replaces what was wanted before; the first ones are made first.
  void want(const std::filesystem::path& project, std::vector<WantedThumbnail> wanted);
  std::vector<MadeThumbnail> take();
  bool idle() const;
  // Why no pictures can be made ("" if they can): no OpenGL beside the window, say.
  std::string problem() const;

 private:
  void run(const std::stop_token& stop);

  std::filesystem::path shaders_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards the five below
  std::filesystem::path project_;
  std::vector<WantedThumbnail> wanted_;
  std::vector<MadeThumbnail> made_;
  bool working_ = false;
  std::string problem_;
  std::condition_variable_any changed_;
  std::jthread thread_;  // last: it is joined before the rest goes
};

}  // namespace archetype
