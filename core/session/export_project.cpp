// Writes the files of an export shape by shape, several at once; the tables in the order of names.
#include "core/session/export_project.h"

#include <map>

#include "core/base/error.h"
#include "core/evaluation/coalign.h"
#include "core/io/export_files.h"
#include "core/io/file.h"
#include "core/io/labels.h"
#include "core/io/template_file.h"
#include "core/session/export_manifest.h"
#include "core/session/ordered_pipeline.h"

namespace archetype {

namespace fs = std::filesystem;

namespace {

struct Work {
  std::string name;  // of its files
  ShapeRecord shape;
  std::optional<FitRecord> fit;
  ShapeSamples samples;
  std::optional<std::vector<std::int16_t>> labels;
};

struct ExportedTemplate {
  std::string name;  // of its file and in tables
  PartTemplate part_template;
};

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, "cannot be made (" + error.message() + "); choose another folder");
}

class Export {
 public:
  Export(const Project& project, const fs::path& folder, const ExportOptions& options)
      : project_(project), folder_(folder), options_(options) {}

  ExportReport run(const JobControl& control) {
    make_folder(folder_);
    std::error_code none_there;
    fs::remove(folder_ / "manifest.json", none_there);
    if (options_.labels) make_folder(folder_ / "labels");
    if (options_.coaligned) make_folder(folder_ / "coaligned");
    export_templates();
    const std::vector<ShapeId> ids = project_.shape_ids();
    ring_.resize(pipeline_window(options_.threads));
    report_.cancelled = !ordered_pipeline(ids.size(), options_.threads, control, "exporting",
                                          {.prepare = [&](std::size_t i) { load(slot(i) = {}, ids[i]); },
                                           .compute = [this](std::size_t i) { write_files(slot(i)); },
                                           .finish = [this](std::size_t i) { add_rows(slot(i)); }});
    if (report_.cancelled) return report_;
    if (options_.fits) replace_file(folder_ / "fits.csv", fits_);
    if (options_.boxes) replace_file(folder_ / "boxes.csv", boxes_);
    replace_file(folder_ / "manifest.json", export_manifest(project_, options_, report_));
    return report_;
  }

 private:
  Work& slot(std::size_t i) { return ring_[i % ring_.size()]; }

  // The current templates, and those of older fits that are still in the project.
  void export_templates() {
    std::set<TemplateId> used;
    for (const FitSummary& fit : project_.fits()) used.insert(fit.part_template);
    std::vector<TemplateRecord> records = project_.templates();
    for (const TemplateRecord& record : records) used.erase(record.id);
    for (const TemplateId id : used) records.push_back(project_.find_template(id).value());
    std::set<std::string> taken;
    std::string parts = parts_header();
    if (options_.templates) make_folder(folder_ / "templates");
    for (TemplateRecord& record : records) {
      const std::string name = unique_export_name(record.part_template.name, taken);
      parts += parts_rows(name, record.part_template);
      if (options_.templates) write_template(folder_ / "templates" / (name + ".json"), record.part_template);
      templates_[record.id] = {name, std::move(record.part_template)};
    }
    if (options_.templates) replace_file(folder_ / "parts.csv", parts);
  }

  void load(Work& work, ShapeId id) const {
    work.shape = project_.find_shape(id).value();
    work.name = export_file_name(work.shape.name);
    work.fit = project_.fit(id);
    if (!work.fit) return;
    work.labels = project_.labels(id);
    if (options_.coaligned) work.samples = project_.samples(id);
  }

  void write_files(const Work& work) const {
    if (!work.fit) return;
    const PartTemplate& part_template = templates_.at(work.fit->part_template).part_template;
    if (options_.labels && work.labels) {
      std::vector<int> labels;
      labels.reserve(work.labels->size());
      for (const std::int16_t part : *work.labels) {
        labels.push_back(part < 0 ? -1 : part_template.parts[static_cast<std::size_t>(part)].label);
      }
      write_labels(folder_ / "labels" / (work.name + ".seg"), labels);
    }
    if (options_.coaligned) {
      const std::vector<Vec3> canonical = coalign(part_template, work.samples, work.fit->fit);
      replace_file(folder_ / "coaligned" / (work.name + ".ply"),
                   coaligned_ply(part_template, work.samples, canonical, work.fit->fit));
    }
  }

  void add_rows(const Work& work) {
    if (!work.fit) {
      ++report_.without_fit;
      return;
    }
    ++report_.shapes;
    if (!work.labels) ++report_.without_labels;
    fits_ += fits_row(work.name, work.shape, templates_.at(work.fit->part_template).name, *work.fit);
    boxes_ += boxes_rows(work.name, work.shape.frame, work.fit->fit);
  }

  const Project& project_;
  const fs::path& folder_;
  const ExportOptions& options_;
  std::map<TemplateId, ExportedTemplate> templates_;
  std::vector<Work> ring_;
  std::string fits_ = fits_header();
  std::string boxes_ = boxes_header();
  ExportReport report_;
};

}  // namespace

ExportReport export_project(const Project& project, const fs::path& folder, const ExportOptions& options,
                            const JobControl& control) {
  return Export(project, folder, options).run(control);
}

}  // namespace archetype
