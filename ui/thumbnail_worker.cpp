#include "ui/thumbnail_worker.h"

#include <exception>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/io/read_shape.h"
#include "render/gl/headless_context.h"
#include "render/thumbnails.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view plain_kind = "surface";

class ThumbnailMaker {
 public:
  explicit ThumbnailMaker(const fs::path& shaders) : renderer_(shaders) {}

  Picture make(const fs::path& path, const WantedThumbnail& wanted) {
    if (!project_ || project_->path() != path) project_.emplace(Project::open(path));
    const std::string kind(wanted.fitted ? parts_thumbnail : plain_kind);
    const std::optional<PartTemplate> coloured = coloured_template(wanted);
    // Colours that were chosen by hand change without a fit: such pictures are not kept.
    if (coloured) return draw(wanted, &*coloured);
    if (const auto kept = project_->thumbnail(wanted.shape, kind); kept && kept->width == thumbnail_size)
      return *kept;
    const ThumbnailSource source = thumbnail_source(*project_, wanted.shape);
    Picture picture = draw(wanted, nullptr);
    try {
      keep_thumbnail(*project_, wanted.shape, kind, picture, source);
    } catch (const Error&) {
      // The picture is shown all the same; it is made again next time.
    }
    return picture;
  }

 private:
  // The template that the shape is fitted with, if its parts were given colours by hand.
  std::optional<PartTemplate> coloured_template(const WantedThumbnail& wanted) {
    if (!wanted.fitted || !wanted.colours) return std::nullopt;
    const auto fit = project_->fit(wanted.shape);
    const auto record = fit ? project_->find_template(fit->part_template) : std::nullopt;
    if (!record) return std::nullopt;
    PartTemplate part_template = record->part_template;
    const auto colours = wanted.colours->find(part_template.name);
    if (colours == wanted.colours->end() || colours->second.size() != part_template.parts.size())
      return std::nullopt;
    for (std::size_t i = 0; i < part_template.parts.size(); ++i)
      part_template.parts[i].colour = colours->second[i];
    return part_template;
  }

  Picture draw(const WantedThumbnail& wanted, const PartTemplate* part_template) {
    const auto record = project_->find_shape(wanted.shape);
    if (!record) return {};
    std::shared_ptr<const Colours> colours;
    if (wanted.fitted)
      if (const auto labels = project_->labels(wanted.shape))
        colours = colours_of_labels(*labels, part_template);
    const ShapeFile file = read_shape(record->path);
    if (colours && colours->size() != file.mesh.element_count()) colours.reset();
    const ThumbnailOptions options{.size = thumbnail_size};
    if (file.mesh.is_point_set()) {
      const auto points =
          std::make_shared<const PointGeometry>(make_point_geometry(file.mesh, record->frame));
      return point_thumbnail(renderer_, points, colours, options);
    }
    const auto geometry = std::make_shared<const MeshGeometry>(make_mesh_geometry(file.mesh, record->frame));
    return mesh_thumbnail(renderer_, geometry, colours, options);
  }

  Renderer renderer_;
  std::optional<Project> project_;
};

}  // namespace

ThumbnailSource thumbnail_source(const Project& project, ShapeId shape) {
  ThumbnailSource source;
  if (const auto record = project.find_shape(shape)) source.file = record->hash;
  if (const auto fit = project.fit(shape)) source.fit = fit->state;
  return source;
}

bool keep_thumbnail(Project& project, ShapeId shape, const std::string& kind, const Picture& picture,
                    const ThumbnailSource& source) {
  Project::Transaction transaction(project);  // nobody else writes between the look and the picture
  if (thumbnail_source(project, shape) != source) return false;
  project.store_thumbnail(shape, kind, picture);
  transaction.commit();
  return true;
}

ThumbnailWorker::ThumbnailWorker(fs::path shaders, std::function<void()> wake)
    : shaders_(std::move(shaders)),
      wake_(std::move(wake)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

ThumbnailWorker::~ThumbnailWorker() {
  thread_.request_stop();
}

void ThumbnailWorker::want(const fs::path& project, std::vector<WantedThumbnail> wanted) {
  {
    const std::lock_guard lock(mutex_);
    project_ = project;
    wanted_ = std::move(wanted);
  }
  changed_.notify_one();
}

std::vector<MadeThumbnail> ThumbnailWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(made_, {});
}

bool ThumbnailWorker::idle() const {
  const std::lock_guard lock(mutex_);
  return (wanted_.empty() && !working_ && made_.empty()) || !problem_.empty();
}

std::string ThumbnailWorker::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

void ThumbnailWorker::run(const std::stop_token& stop) {
  try {
    std::optional<gl::HeadlessContext> context;  // opened when the first picture is wanted
    std::optional<ThumbnailMaker> maker;
    for (;;) {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return !wanted_.empty(); }) || stop.stop_requested()) return;
      const fs::path project = project_;
      const WantedThumbnail wanted = wanted_.front();
      wanted_.erase(wanted_.begin());
      working_ = true;
      lock.unlock();
      if (!maker) {
        context.emplace();
        maker.emplace(shaders_);
      }
      MadeThumbnail made{project, wanted, {}};
      try {
        made.picture = maker->make(project, wanted);
      } catch (const std::exception&) {
        // A file that is gone, broken or too large: its cell stays without a picture, and the view says why.
      }
      lock.lock();
      working_ = false;
      made_.push_back(std::move(made));
      lock.unlock();
      if (wake_) wake_();
    }
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    problem_ = std::string("no pictures can be made: ") + error.what();
    working_ = false;
  }
}

}  // namespace archetype
