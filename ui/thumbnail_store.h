// The pictures of the cells in sight, as textures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/session/document.h"
#include "render/gl/framebuffer.h"
#include "ui/collection.h"
#include "ui/thumbnail_worker.h"

namespace archetype {

// What the picture of a row has to show: it changes when the file is read anew or the shape is fitted anew.
WantedThumbnail wanted_thumbnail(const ShapeRow& row);

class ThumbnailStore {
 public:
  ThumbnailStore(std::filesystem::path shaders, std::function<void()> wake);

  // The texture to draw now, or 0 where there is none yet; an older picture stands in until the new one is
  // there. What is not used in a frame is not made, and goes once there are too many.
  std::uint32_t use(WantedThumbnail wanted);
  // It may be wanted soon: made when nothing else is.
  void expect(WantedThumbnail wanted);
  // The colours that parts were given by hand are those of the document from then on.
  void follow_colours(const Document& document);
  // Once a frame, before its panels: takes over what was made, and forgets what is of another project. Needs
  // the window's OpenGL context.
  void begin_frame(const std::filesystem::path& project);
  // After the panels: asks for what was used and is not there. What the frame draws stays.
  void end_frame();
  bool idle() const { return worker_.idle() && missing_.empty(); }
  std::string problem() const { return worker_.problem(); }
  // The same, but only once: for a message.
  std::string take_problem();

 private:
  struct Entry {
    std::optional<gl::Texture> texture;  // nothing: the shape has no picture
    WantedThumbnail wanted;
    std::uint64_t used = 0;  // the frame
  };
  void forget_unused();

  std::unordered_map<ShapeId, Entry> entries_;
  std::vector<WantedThumbnail> missing_;  // of this frame, in the order of the cells
  std::vector<WantedThumbnail> expected_;
  std::vector<WantedThumbnail> asked_;
  std::filesystem::path project_;
  std::shared_ptr<const HandColours> colours_;
  std::uint64_t frame_ = 0;
  bool problem_taken_ = false;
  ThumbnailWorker worker_;
};

}  // namespace archetype
