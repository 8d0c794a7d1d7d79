#include "ui/thumbnail_worker.h"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/priority.h"
#include "core/io/read_shape.h"
#include "render/convert.h"
#include "render/gl/headless_context.h"
#include "render/thumbnails.h"
#include "ui/cluster_pictures.h"
#include "ui/picture_marks.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view plain_kind = "shape";

glm::mat4 turned_into_frame(const ShapeFit& fit) {
  const Vec3 origin = fit.to_template(Vec3::Zero());
  glm::mat4 matrix(1);
  for (int k = 0; k < 3; ++k) matrix[k] = glm::vec4(to_glm(Vec3(fit.to_template(Vec3::Unit(k)) - origin)), 0);
  matrix[3] = glm::vec4(to_glm(origin), 1);
  return matrix;
}

class ThumbnailMaker {
 public:
  explicit ThumbnailMaker(const fs::path& shaders) : renderer_(shaders) {}

  Picture make(const fs::path& path, const WantedThumbnail& wanted) {
    if (!project_ || project_->path() != path) {
      project_.emplace(Project::open(path));
      templates_.clear();
    }
    if (!wanted.fitted) return kept_or_drawn(wanted.shape, plain_kind);
    // Colours that were chosen by hand change without a fit: such pictures are not kept.
    const std::optional<PartTemplate> coloured = coloured_template(wanted);
    Picture picture = coloured ? draw(wanted.shape, parts_thumbnail, &*coloured)
                               : kept_or_drawn(wanted.shape, parts_thumbnail);
    if (wanted.highlighted >= 0)
      highlight_part(picture, kept_or_drawn(wanted.shape, part_mask_thumbnail), wanted.highlighted);
    if (wanted.place) mark_place(picture, wanted);
    return picture;
  }

 private:
  Picture kept_or_drawn(ShapeId shape, std::string_view kind) {
    const std::string name(kind);
    if (auto kept = project_->thumbnail(shape, name); kept && kept->width == thumbnail_size)
      return *std::move(kept);
    const ThumbnailSource source = thumbnail_source(*project_, shape);
    Picture picture = draw(shape, kind, nullptr);
    try {
      if (picture.width > 0) keep_thumbnail(*project_, shape, name, picture, source);
    } catch (const Error&) {
      // The picture is shown all the same; it is made again next time.
    }
    return picture;
  }

  // On the surface, at the sample of the part that is nearest to where the place is on the fitted box.
  void mark_place(Picture& picture, const WantedThumbnail& wanted) {
    const auto record = project_->find_shape(wanted.shape);
    const auto fit = project_->fit(wanted.shape);
    if (!record || !fit) return;
    const PartTemplate& part_template = template_of(fit->part_template);
    const auto part = static_cast<std::size_t>(wanted.highlighted);
    if (part >= fit->fit.parts.size() || !fit->fit.parts[part].present) return;
    const Box mean = part_template.parts[part].mean_box();
    const Vec3 on_box = fit->fit.parts[part].box.to_world(mean.to_local(*wanted.place));
    const ShapeSamples samples = project_->samples(wanted.shape);
    std::optional<Vec3> nearest;
    for (std::size_t i = 0; i < std::min(samples.size(), fit->fit.labels.size()); ++i) {
      if (fit->fit.labels[i] != wanted.highlighted) continue;
      const Vec3 point = fit->fit.to_template(samples.points[i]);
      if (!nearest || (point - on_box).squaredNorm() < (*nearest - on_box).squaredNorm()) nearest = point;
    }
    if (!nearest) return;
    ThumbnailOptions options{.size = thumbnail_size};
    options.transform = turned_into_frame(fit->fit);
    options.framed = framed_corners(part_template);
    const std::vector<glm::vec3> positions = positions_of(*record);
    const Viewport size{thumbnail_size, thumbnail_size};
    if (const auto at = to_screen(shape_camera(positions, options), size, to_glm(*nearest)))
      draw_ring(picture, at->x, at->y);
  }

  // The template that the shape is fitted with, if its parts were given colours by hand.
  std::optional<PartTemplate> coloured_template(const WantedThumbnail& wanted) {
    if (!wanted.colours) return std::nullopt;
    const auto fit = project_->fit(wanted.shape);
    if (!fit) return std::nullopt;
    PartTemplate part_template = template_of(fit->part_template);
    const auto colours = wanted.colours->find(part_template.name);
    if (colours == wanted.colours->end() || colours->second.size() != part_template.parts.size())
      return std::nullopt;
    for (std::size_t i = 0; i < part_template.parts.size(); ++i)
      part_template.parts[i].colour = colours->second[i];
    return part_template;
  }

  // `coloured`: null, or the template of the fit with other colours.
  Picture draw(ShapeId shape, std::string_view kind, const PartTemplate* coloured) {
    const auto record = project_->find_shape(shape);
    if (!record) return {};
    const ShapeFile file = read_shape(record->path);
    ThumbnailOptions options{.size = thumbnail_size, .mask = kind == part_mask_thumbnail};
    std::shared_ptr<const Colours> colours;
    if (kind != plain_kind) colours = pose(shape, file.mesh.element_count(), coloured, options);
    if (file.mesh.is_point_set()) {
      const auto points =
          std::make_shared<const PointGeometry>(make_point_geometry(file.mesh, record->frame));
      return point_thumbnail(renderer_, points, colours, options);
    }
    const auto geometry = std::make_shared<const MeshGeometry>(make_mesh_geometry(file.mesh, record->frame));
    return mesh_thumbnail(renderer_, geometry, colours, options);
  }

  // As the fit has the shape stand in the template's frame; the colours of its elements, null without labels.
  std::shared_ptr<const Colours> pose(ShapeId shape, std::size_t elements, const PartTemplate* coloured,
                                      ThumbnailOptions& options) {
    const auto fit = project_->fit(shape);
    if (!fit) return nullptr;
    const PartTemplate& part_template = template_of(fit->part_template);
    options.transform = turned_into_frame(fit->fit);
    options.framed = framed_corners(part_template);
    const auto labels = project_->labels(shape);
    if (!labels || labels->size() != elements) return nullptr;
    if (!options.mask) return colours_of_labels(*labels, coloured ? coloured : &part_template);
    auto colours = std::make_shared<Colours>();
    for (const std::int16_t label : *labels) colours->push_back(mask_colour(label));
    return colours;
  }

  // What a picture of the shape was drawn of.
  static std::vector<glm::vec3> positions_of(const ShapeRecord& record) {
    const ShapeFile file = read_shape(record.path);
    if (file.mesh.is_point_set()) return make_point_geometry(file.mesh, record.frame).positions;
    return make_mesh_geometry(file.mesh, record.frame).positions;
  }

  const PartTemplate& template_of(TemplateId id) {
    const auto known = templates_.find(id);
    if (known != templates_.end()) return known->second;
    const std::optional<TemplateRecord> record = project_->find_template(id);
    return templates_.emplace(id, record ? record->part_template : PartTemplate{}).first->second;
  }

  Renderer renderer_;
  std::optional<Project> project_;
  std::map<TemplateId, PartTemplate> templates_;  // they never change
};

struct Drawing {
  explicit Drawing(const fs::path& shaders) : Drawing(gl::HeadlessTurn(), shaders) {}
  Picture make(const fs::path& project, const WantedThumbnail& wanted) {
    const gl::HeadlessTurn turn;
    return maker.make(project, wanted);
  }
  gl::HeadlessContext context;
  ThumbnailMaker maker;

 private:
  Drawing(const gl::HeadlessTurn&, const fs::path& shaders) : maker(shaders) {}
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

std::function<Picture(ShapeId)> thumbnail_drawer(fs::path project, fs::path shaders) {
  return [project = std::move(project), shaders = std::move(shaders), failed = false,
          drawing = std::shared_ptr<Drawing>()](ShapeId shape) mutable -> Picture {
    if (failed) return {};
    try {
      if (!drawing) drawing = std::make_shared<Drawing>(shaders);
    } catch (const std::exception&) {  // no OpenGL beside the window
      failed = true;
      return {};
    }
    try {
      WantedThumbnail wanted;
      wanted.shape = shape;
      wanted.fitted = true;
      return drawing->make(project, wanted);
    } catch (const std::exception&) {  // a file that is gone, broken or too large
      return {};
    }
  };
}

ThumbnailWorker::ThumbnailWorker(fs::path shaders, std::function<void()> wake)
    : shaders_(std::move(shaders)), wake_(std::move(wake)), thread_([this](const std::stop_token& stop) {
        lower_priority(Priority::answer);
        run(stop);
      }) {}

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
    std::optional<Drawing> drawing;  // from the first wanted picture on
    for (;;) {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return !wanted_.empty(); }) || stop.stop_requested()) return;
      const fs::path project = project_;
      const WantedThumbnail wanted = wanted_.front();
      wanted_.erase(wanted_.begin());
      working_ = true;
      lock.unlock();
      if (!drawing) drawing.emplace(shaders_);
      MadeThumbnail made{project, wanted, {}};
      try {
        made.picture = drawing->make(project, wanted);
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
