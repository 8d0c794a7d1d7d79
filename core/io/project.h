// The project file: one SQLite database (WAL) that holds everything a collection needs.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/hash.h"
#include "core/base/picture.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_correction.h"
#include "core/model/shape_fit.h"

namespace archetype {

class WriteScope;

using ShapeId = std::int64_t;
using TemplateId = std::int64_t;

// What is known of a shape without its samples or faces.
struct ShapeRecord {
  ShapeId id = 0;
  std::string name;            // path under the imported folder without ending, "/" written as "__"; unique
  std::filesystem::path path;  // absolute, where the file was read
  ContentHash hash;
  UpAxis up = UpAxis::y;
  std::size_t vertex_count = 0;
  std::size_t element_count = 0;  // faces, or points of a point set
  bool point_set = false;
  ShapeFrame frame;
  double radius = 0;  // R, normalised units
  // How it was sampled, so that an import of the same file with the same options can leave it alone.
  int requested_points = 1000;
  std::uint64_t seed = 1;
  bool up_decided = false;  // `up` was decided over the collection (`auto`), not given
};

// The same for samples that are the same: of the file and how it was sampled.
ContentHash sampling_of(const ShapeRecord& record);

// What was corrected by hand, of the shapes that were. Never null, and shared between snapshots.
using Corrections = std::map<ShapeId, std::shared_ptr<const ShapeCorrection>>;
// By value; null is none.
bool same_corrections(const std::shared_ptr<const Corrections>& a,
                      const std::shared_ptr<const Corrections>& b);

struct RefusedInput {
  std::filesystem::path path;
  std::string reason;
};

enum class FitStatus { fitted, learned, outlier };
std::string_view to_string(FitStatus status);

// The best template of a shape and its fit.
struct FitRecord {
  ShapeId shape = 0;
  TemplateId part_template = 0;
  FitStatus status = FitStatus::fitted;
  ShapeFit fit;
  ContentHash state;  // of the templates and options that it is the best fit of; another one: out of date
};

// The same without samples' labels and boxes, for tables of ten thousand rows.
struct FitSummary {
  ShapeId shape = 0;
  TemplateId part_template = 0;
  FitStatus status = FitStatus::fitted;
  int yaw_quarters = 0;
  FitEnergy energy;
  ContentHash state;        // as in FitRecord
  bool has_labels = false;  // the file's elements are labelled by this fit
};

struct TemplateRecord {
  TemplateId id = 0;
  PartTemplate part_template;
  int iteration = 0;                 // of learning, 0 before
  std::optional<TemplateId> parent;  // the template it was spawned or re-estimated from
  bool current = true;               // part of the template set in use (others are history)
};

using Thumbnail = Picture;

// The kinds of thumbnails that show a shape's fit: in the template's frame, in the colours of its parts, and
// the same with the number of the part at each pixel. What begins like these goes with the fit.
inline constexpr std::string_view parts_thumbnail = "parts framed";
inline constexpr std::string_view part_mask_thumbnail = "parts framed mask";
inline constexpr std::string_view fit_thumbnails = "parts%";

// One connection. Use one object per thread; several, also in several processes, may have the same file open.
// Every writing function is one transaction unless a Transaction is open. All throw FileError for a full disk
// or a broken file, with what was committed left intact.
class Project {
 public:
  // A new, empty project; throws FileError if the path exists.
  static Project create(const std::filesystem::path& path);
  // Throws FileError if it is no project, or was written by a newer version; migrates older ones. One that
  // cannot be written, being on a read-only medium say, is opened to be read: writing throws then.
  static Project open(const std::filesystem::path& path);
  static Project open_or_create(const std::filesystem::path& path);
  // Lives in memory only: the studio before anything is saved, and tests.
  static Project in_memory();

  Project(Project&&) noexcept;
  Project& operator=(Project&&) noexcept;
  ~Project();

  const std::filesystem::path& path() const;
  // A copy of all that is committed, also while others write; throws FileError if the path exists.
  void copy_to(const std::filesystem::path& path) const;

  // Groups writes: all or nothing. Rolls back unless commit() was called. One inside another is part of the
  // outer.
  class Transaction {
   public:
    explicit Transaction(Project& project);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();
    void commit();  // throws FileError (disk full): nothing of it is in the file then

   private:
    std::unique_ptr<WriteScope> scope_;
  };

  // Shapes, ordered by name (bytewise), whatever the order of import.
  std::size_t shape_count() const;
  std::vector<ShapeRecord> shapes(std::size_t offset = 0, std::size_t limit = SIZE_MAX) const;
  std::vector<ShapeId> shape_ids() const;
  std::optional<ShapeRecord> find_shape(ShapeId id) const;
  std::optional<ShapeRecord> find_shape(const std::string& name) const;
  // record.id is ignored; a shape of the same name is replaced (its fit, labels and thumbnails go, its id
  // stays).
  ShapeId add_shape(const ShapeRecord& record, const ShapeSamples& samples);
  void relocate_shape(ShapeId id, const std::filesystem::path& path);
  ShapeSamples samples(ShapeId id) const;

  void set_refused(const std::vector<RefusedInput>& refused);  // replaces entries of the same path
  void forget_refused(const std::vector<std::filesystem::path>& paths);
  std::vector<RefusedInput> refused() const;

  std::vector<TemplateRecord> templates(bool current_only = true) const;
  std::optional<TemplateRecord> find_template(TemplateId id) const;
  TemplateId add_template(const TemplateRecord& record);  // record.id is ignored
  // Makes exactly these the current set, in this order.
  void set_current_templates(const std::vector<TemplateId>& ids);

  // Replaces the shape's fit; its labels and the picture of its parts, which came from the old one, go.
  void store_fit(const FitRecord& record);
  void set_fit_status(ShapeId id, FitStatus status);  // its labels stay
  std::optional<FitRecord> fit(ShapeId id) const;
  std::vector<FitSummary> fits() const;  // ordered as shapes()
  void clear_fits();                     // and the labels

  // What fits and learning have to heed.
  Corrections corrections() const;
  // Exactly these from now on; those of shapes that are not there are left out.
  void set_corrections(const Corrections& corrections);

  // The part index of every element of the file, as label_elements() gives them.
  void store_labels(ShapeId id, const std::vector<std::int16_t>& labels);
  std::optional<std::vector<std::int16_t>> labels(ShapeId id) const;

  // `kind` is free but for those above. Kept compressed.
  void store_thumbnail(ShapeId id, const std::string& kind, const Thumbnail& thumbnail);
  std::optional<Thumbnail> thumbnail(ShapeId id, const std::string& kind) const;

  // Free-form settings and the state that a stopped run goes on from.
  void set_setting(const std::string& key, const std::string& value);
  std::optional<std::string> setting(const std::string& key) const;

 private:
  struct Connection;
  explicit Project(std::unique_ptr<Connection> connection);
  std::unique_ptr<Connection> connection_;
};

}  // namespace archetype
