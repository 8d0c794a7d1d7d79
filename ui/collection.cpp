#include "ui/collection.h"

#include <algorithm>
#include <locale>
#include <span>
#include <sstream>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/io/file.h"
#include "core/session/actions.h"
#include "core/session/current_templates.h"
#include "core/session/document_text.h"
#include "ui/shape_strip.h"

namespace archetype {
namespace {

constexpr const char* document_setting = "studio.document";
// The project's current templates when the document was stored.
constexpr const char* known_templates_setting = "studio.templates";
constexpr const char* strip_setting = "studio.strip";

// With blanks between.
std::string text_of(std::span<const std::int64_t> ids) {
  std::string text;
  for (const std::int64_t id : ids) {
    if (!text.empty()) text += ' ';
    text += std::to_string(id);
  }
  return text;
}

std::string ids_of_current_templates(const Project& project) {
  return text_of(current_templates(project).ids);
}

void store(Project project, const Document& document, const std::string& text,
           const std::vector<ShapeId>& strip) {
  const auto change = [&](const char* setting, const std::string& value) {
    if (project.setting(setting) != value) project.set_setting(setting, value);
  };
  Project::Transaction transaction(project);
  project.set_setting(document_setting, text);
  store_corrections(project, document);
  change(strip_setting, text_of(strip));
  change(known_templates_setting, ids_of_current_templates(project));
  transaction.commit();
}

// Since the document was stored. Not while learning can be gone on with: it is from what is edited.
bool has_other_templates(const Project& project) {
  const auto known = project.setting(known_templates_setting);
  if (!known || *known == ids_of_current_templates(project)) return false;
  const std::optional<LearningRecord> learning = learning_record(project);
  return !learning || is_over(*learning, {});
}

}  // namespace

std::filesystem::path untitled_project_path(const std::filesystem::path& data_folder,
                                            const std::filesystem::path& shapes_folder) {
  std::filesystem::path absolute = std::filesystem::absolute(shapes_folder).lexically_normal();
  if (!absolute.has_filename())
    absolute = absolute.parent_path();  // a slash at the end means the same folder
  const std::string text = absolute.string();
  const std::string name = absolute.filename().string();
  const ContentHash hash = hash_content(std::as_bytes(std::span(text)));
  return data_folder / "projects" / (name + "-" + hash.to_hex().substr(0, 8) + ".archetype");
}

CollectionRows read_rows(const Project& project) {
  CollectionRows content;
  for (ShapeRecord& record : project.shapes())
    content.rows.push_back(
        {record.id, std::move(record.name), record.element_count, record.hash, std::nullopt});
  // Fits are ordered as the shapes are, but not every shape has one.
  std::size_t row = 0;
  for (const FitSummary& fit : project.fits()) {
    while (row < content.rows.size() && content.rows[row].id != fit.shape) ++row;
    if (row < content.rows.size()) content.rows[row].fit = fit;
  }
  content.templates = current_templates(project).templates;
  content.refused = project.refused();
  content.truth = ground_truth_folders(project);
  content.subsets = stored_subset_measures(project);
  if (auto starts = stored_start_measures(project); !starts.empty())
    content.starts = std::make_shared<const std::vector<StartMeasure>>(std::move(starts));
  if (std::optional<LearningRecord> learning = learning_record(project))
    content.learning = std::make_shared<const LearningRecord>(std::move(*learning));
  content.learning_can_go_on = can_go_on(project, {}, {}, learning_seed);
  content.corrections = std::make_shared<const Corrections>(project.corrections());
  return content;
}

std::optional<CollectionRows> reread_rows(const std::filesystem::path& project, const JobControl&) {
  try {
    return read_rows(Project::open(project));
  } catch (const std::exception&) {
    return std::nullopt;  // the job that is writing it says what is wrong
  }
}

Document read_document(const Project& project) {
  Document stored;
  const auto text = project.setting(document_setting);
  if (text) stored = parse_document(*text, project.path());
  if (!text || has_other_templates(project)) {
    // Those of the batch program, say, come before those that were edited, and keep their names.
    std::vector<std::shared_ptr<const PartTemplate>> others;
    for (TemplateRecord& record : project.templates()) {
      const auto same = [&](const auto& each) { return *each == record.part_template; };
      if (std::ranges::none_of(stored.templates, same))
        others.push_back(std::make_shared<const PartTemplate>(std::move(record.part_template)));
    }
    if (!others.empty()) stored.active = 0;
    stored.templates.insert(stored.templates.begin(), others.begin(), others.end());
  }
  // Two of one name, as other programs may write them, could not be told apart.
  Document document;
  document.active = stored.active;
  if (Corrections corrections = project.corrections(); !corrections.empty())
    document.corrections = std::make_shared<const Corrections>(std::move(corrections));
  for (const auto& part_template : stored.templates) {
    PartTemplate named = *part_template;
    named.name = unique_template_name(document, named.name, document.templates.size());
    document.templates.push_back(std::make_shared<const PartTemplate>(std::move(named)));
  }
  return document;
}

void store_corrections(Project& project, const Document& document) {
  project.set_corrections(document.corrections ? *document.corrections : Corrections{});
}

std::vector<ShapeId> read_strip(const Project& project) {
  std::vector<ShapeId> shapes;
  std::istringstream text(project.setting(strip_setting).value_or(""));
  text.imbue(std::locale::classic());
  for (ShapeId id = 0; shapes.size() < most_strip_shapes && text >> id;)
    if (project.find_shape(id) && std::ranges::count(shapes, id) == 0) shapes.push_back(id);
  return shapes;
}

std::optional<std::string> save_document(const SaveDocument& request, const JobControl&) {
  try {
    const std::string text = format_document(request.document);
    if (request.alone)
      replace_file(request.project, text);
    else
      store(Project::open(request.project), request.document, text, request.strip);
    return "";
  } catch (const std::exception& error) {
    return std::string("What you edit cannot be saved (it is tried again every few seconds): ") +
           error.what();
  }
}

std::optional<std::size_t> find_row(const Collection& collection, ShapeId id) {
  const auto found = std::find_if(collection.rows().begin(), collection.rows().end(),
                                  [&](const ShapeRow& row) { return row.id == id; });
  if (found == collection.rows().end()) return std::nullopt;
  return static_cast<std::size_t>(found - collection.rows().begin());
}

}  // namespace archetype
