// Reads and samples shapes in parallel and commits them in the order of their names.
#include "core/session/import_shapes.h"

#include <map>

#include "core/base/error.h"
#include "core/geometry/sample_shape.h"
#include "core/io/read_shape.h"
#include "core/session/commit_pace.h"
#include "core/session/ordered_pipeline.h"
#include "core/session/scan_shapes.h"
#include "core/session/stand_upright.h"

namespace archetype {

namespace fs = std::filesystem;

namespace {

// What became of one file.
struct ReadResult {
  ShapeRecord record;
  ShapeSamples samples;
  bool unchanged = false;
  bool cut_short = false;  // by a stop: nothing is known
  std::string refused;     // the reason, or empty
  std::vector<std::string> warnings;
};

// The message of an error without the path that it begins with, which a RefusedInput has beside it.
std::string reason_without_path(const std::string& message, const fs::path& path) {
  const std::string prefix = path.string();
  if (!message.starts_with(prefix)) return message;
  const std::size_t begin = message.find_first_not_of(":, ", prefix.size());
  return begin == std::string::npos ? message : message.substr(begin);
}

bool same_request(const ShapeRecord& a, const ShapeRecord& b) {
  return a.requested_points == b.requested_points && a.seed == b.seed && a.up_decided == b.up_decided &&
         (a.up_decided || a.up == b.up);
}

// Shapes of the project by name and by path.
struct KnownShapes {
  std::map<std::string, ShapeRecord> by_name;
  std::map<fs::path, std::string> name_of;

  explicit KnownShapes(const Project& project) {
    for (ShapeRecord& record : project.shapes()) {
      name_of.emplace(record.path, record.name);
      by_name.emplace(record.name, std::move(record));
    }
  }
  const ShapeRecord* find(const std::string& name) const {
    const auto found = by_name.find(name);
    return found == by_name.end() ? nullptr : &found->second;
  }
};

class Import {
 public:
  Import(Project& project, const ImportOptions& options, const JobControl& control)
      : project_(project), options_(options), control_(control), known_(project) {}

  ImportReport run(const std::vector<fs::path>& paths) {
    ShapeScan scan = scan_shapes(paths, control_);
    for (const RefusedInput& input : scan.refused) refuse(input);
    choose_names(std::move(scan.inputs));
    results_.resize(pipeline_window(options_.threads));
    const bool all = ordered_pipeline(inputs_.size(), options_.threads, control_, "reading shapes",
                                      {.prepare = {},
                                       .compute = [this](std::size_t i) { read(i); },
                                       .finish = [this](std::size_t i) { take(i); }});
    report_.cancelled = report_.cancelled || !all;
    commit();
    if (inputs_.empty() && control_.cancelled()) report_.cancelled = true;  // while it searched
    std::ranges::sort(report_.refused, {}, &RefusedInput::path);
    return std::move(report_);
  }

 private:
  void refuse(const RefusedInput& input) {
    report_.refused.push_back(input);
    pending_refused_.push_back(input);
  }

  // Shapes are told apart by name. Of several files with one name, that which the project has stays; without
  // one, the first by path. A shape whose file is gone may be replaced by another file of its name: it was
  // moved.
  void choose_names(std::vector<ShapeInput> found) {
    for (ShapeInput& input : found) {
      const auto known = known_.name_of.find(input.path);
      if (known != known_.name_of.end()) input.name = known->second;
    }
    std::map<std::string, fs::path> owner;
    for (const ShapeInput& input : found) owner.emplace(input.name, input.path);
    for (auto& [name, path] : owner) {
      const ShapeRecord* record = known_.find(name);
      std::error_code error;
      if (record != nullptr && fs::exists(record->path, error)) path = record->path;
    }
    for (ShapeInput& input : found) {
      const fs::path& path = owner.at(input.name);
      if (path == input.path) {
        inputs_.push_back(std::move(input));
      } else {
        refuse({input.path, "would be called " + input.name + " as " + path.string() +
                                " is; rename it, or import the folder above both"});
      }
    }
  }

  ReadResult& slot(std::size_t i) { return results_[i % results_.size()]; }

  void read(std::size_t i) {
    const fs::path& path = inputs_[i].path;
    ReadResult& result = slot(i) = {};
    try {
      const ShapeFile file = read_shape(path);
      result.warnings = file.warnings;
      ShapeRecord& record = result.record;
      record.name = inputs_[i].name;
      record.path = path;
      record.hash = file.hash;
      record.up = options_.up.value_or(UpAxis::y);
      record.up_decided = !options_.up;
      record.vertex_count = file.mesh.vertices.size();
      record.element_count = file.mesh.element_count();
      record.point_set = file.mesh.is_point_set();
      record.requested_points = options_.points;
      record.seed = options_.seed;
      const ShapeRecord* known = known_.find(record.name);
      if (known != nullptr && known->hash == record.hash && same_request(*known, record)) {
        result.unchanged = true;
        record.id = known->id;
        return;
      }
      result.cut_short = control_.cancelled();
      if (result.cut_short) return;
      result.samples = sample_shape(file.mesh, file.hash, {options_.points, record.up, options_.seed});
    } catch (const std::bad_alloc&) {
      result.refused = "needs more memory than there is";
    } catch (const std::exception& error) {
      result.refused = reason_without_path(error.what(), path);
    }
  }

  void take(std::size_t i) {
    ReadResult& result = slot(i);
    if (result.cut_short) {
      report_.cancelled = true;
      return;
    }
    for (const std::string& warning : result.warnings) report_.warnings.push_back(warning);
    if (!result.refused.empty()) {
      refuse({inputs_[i].path, result.refused});
    } else {
      pending_.push_back(std::move(result));
    }
    if (pace_.due(pending_.size() + pending_refused_.size(), control_)) commit();
  }

  void commit() {
    if (pending_.empty() && pending_refused_.empty()) return;
    Project::Transaction transaction(project_);
    std::vector<fs::path> accepted;
    for (const ReadResult& result : pending_) {
      accepted.push_back(result.record.path);
      if (!result.unchanged) {
        project_.add_shape(result.record, result.samples);
        ++report_.imported;
      } else {
        if (known_.find(result.record.name)->path != result.record.path) {
          project_.relocate_shape(result.record.id, result.record.path);
        }
        ++report_.unchanged;
      }
    }
    project_.forget_refused(accepted);
    project_.set_refused(pending_refused_);
    transaction.commit();
    pending_.clear();
    pending_refused_.clear();
    pace_.committed();
  }

  Project& project_;
  const ImportOptions& options_;
  const JobControl& control_;
  KnownShapes known_;
  std::vector<ShapeInput> inputs_;
  std::vector<ReadResult> results_;  // a ring
  std::vector<ReadResult> pending_;  // to be committed
  std::vector<RefusedInput> pending_refused_;
  CommitPace pace_;
  ImportReport report_;
};

}  // namespace

ImportReport import_shapes(Project& project, const std::vector<fs::path>& paths, const ImportOptions& options,
                           const JobControl& control) {
  ImportReport report = Import(project, options, control).run(paths);
  // An earlier call may have been stopped before it came to this.
  if (!options.up && !report.cancelled) {
    stand_upright(project, options.threads, control);
    report.cancelled = control.cancelled();
  }
  return report;
}

}  // namespace archetype
