// The templates, fits and element labels of a project file.
#include "core/base/error.h"
#include "core/io/project.h"
#include "core/io/project_connection.h"
#include "core/io/template_file.h"

namespace archetype {

namespace {

constexpr std::string_view energy_columns =
    "shape_to_template, template_to_shape, features, deformation, smoothness, existence";

// A missing number reads as 0, as SQLite gives it: an energy is only ever shown and compared.
FitEnergy read_energy(const Statement& row, int first) {
  FitEnergy energy;
  for (double* term : {&energy.shape_to_template, &energy.template_to_shape, &energy.features,
                       &energy.deformation, &energy.smoothness, &energy.existence}) {
    *term = row.real(first++);
  }
  return energy;
}

void bind_energy(Statement& statement, const FitEnergy& energy) {
  for (const double term : {energy.shape_to_template, energy.template_to_shape, energy.features,
                            energy.deformation, energy.smoothness, energy.existence}) {
    statement.bind(term);
  }
}

FitStatus read_status(Database& database, const std::string& text) {
  for (const FitStatus status : {FitStatus::fitted, FitStatus::learned, FitStatus::outlier}) {
    if (text == to_string(status)) return status;
  }
  database.fail_damaged("a fit has the status " + text);
}

int read_yaw(Database& database, std::int64_t quarters) {
  if (quarters < 0 || quarters > 3) database.fail_damaged("a fit has a yaw of " + std::to_string(quarters));
  return static_cast<int>(quarters);
}

TemplateRecord read_template_record(Database& database, const Statement& row) {
  TemplateRecord record;
  record.id = row.integer(0);
  const std::string what = "template " + std::to_string(record.id);
  try {
    record.part_template = parse_template(row.text(1), what);
  } catch (const InputError& error) {
    database.fail_damaged(error.what());
  }
  if (record.part_template.parts.size() != count_column(database, row, 2)) {
    database.fail_damaged(what + ": its parts are not all there");
  }
  record.iteration = static_cast<int>(count_column(database, row, 3));
  if (!row.is_null(4)) record.parent = row.integer(4);
  record.current = !row.is_null(5);
  return record;
}

}  // namespace

std::vector<TemplateRecord> Project::templates(bool current_only) const {
  Statement rows(*connection_->database,
                 std::string("SELECT id, json, part_count, iteration, parent, position FROM templates ") +
                     (current_only ? "WHERE position IS NOT NULL ORDER BY position, id" : "ORDER BY id"));
  std::vector<TemplateRecord> records;
  while (rows.step()) records.push_back(read_template_record(*connection_->database, rows));
  return records;
}

std::optional<TemplateRecord> Project::find_template(TemplateId id) const {
  Statement row(*connection_->database,
                "SELECT id, json, part_count, iteration, parent, position FROM templates WHERE id = ?");
  row.bind(id);
  if (!row.step()) return std::nullopt;
  return read_template_record(*connection_->database, row);
}

TemplateId Project::add_template(const TemplateRecord& record) {
  Database& database = *connection_->database;
  WriteScope scope(database);
  Statement insert(
      database,
      "INSERT INTO templates (json, part_count, iteration, parent, position) VALUES (?, ?, ?, ?, "
      "CASE WHEN ? THEN (SELECT coalesce(max(position) + 1, 0) FROM templates) END)");
  insert.bind(std::string_view(format_template(record.part_template)))
      .bind(record.part_template.parts.size())
      .bind(record.iteration);
  if (record.parent) {
    insert.bind(*record.parent);
  } else {
    insert.bind_null();
  }
  insert.bind(record.current).run();
  scope.commit();
  return database.last_row_id();
}

void Project::set_current_templates(const std::vector<TemplateId>& ids) {
  Database& database = *connection_->database;
  WriteScope scope(database);
  database.execute("UPDATE templates SET position = NULL");
  Statement update(database, "UPDATE templates SET position = ? WHERE id = ?");
  for (std::size_t i = 0; i < ids.size(); ++i) update.bind(i).bind(ids[i]).run();
  scope.commit();
}

void Project::store_fit(const FitRecord& record) {
  Database& database = *connection_->database;
  WriteScope scope(database);
  Statement(database, "DELETE FROM labels WHERE shape = ?").bind(record.shape).run();
  Statement(database, "DELETE FROM thumbnails WHERE shape = ? AND kind LIKE ?")
      .bind(record.shape)
      .bind(fit_thumbnails)
      .run();
  Statement insert(database, "INSERT OR REPLACE INTO fits (shape, template, status, state, yaw_quarters, " +
                                 std::string(energy_columns) +
                                 ", data) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(record.shape)
      .bind(record.part_template)
      .bind(to_string(record.status))
      .bind(encode_hash(record.state))
      .bind(record.fit.yaw_quarters);
  bind_energy(insert, record.fit.energy);
  insert.bind(encode_fit(record.fit)).run();
  scope.commit();
}

void Project::set_fit_status(ShapeId id, FitStatus status) {
  WriteScope scope(*connection_->database);
  Statement(*connection_->database, "UPDATE fits SET status = ? WHERE shape = ?")
      .bind(to_string(status))
      .bind(id)
      .run();
  scope.commit();
}

std::optional<FitRecord> Project::fit(ShapeId id) const {
  Database& database = *connection_->database;
  Statement row(database,
                "SELECT fits.template, status, state, yaw_quarters, data, part_count, sample_count, " +
                    std::string(energy_columns) +
                    " FROM fits JOIN templates ON templates.id = fits.template"
                    " JOIN shapes ON shapes.id = fits.shape WHERE fits.shape = ?");
  row.bind(id);
  if (!row.step()) return std::nullopt;
  const std::string what = "the fit of shape " + std::to_string(id);
  FitRecord record;
  record.shape = id;
  record.part_template = row.integer(0);
  record.status = read_status(database, row.text(1));
  record.state = decode_for(database, what, [&] { return decode_hash(row.blob(2)); });
  record.fit = decode_for(database, what, [&] {
    return decode_fit(row.blob(4), count_column(database, row, 5), count_column(database, row, 6));
  });
  record.fit.yaw_quarters = read_yaw(database, row.integer(3));
  record.fit.energy = read_energy(row, 7);
  return record;
}

std::vector<FitSummary> Project::fits() const {
  Database& database = *connection_->database;
  Statement rows(database, "SELECT fits.shape, template, status, state, yaw_quarters, labels.shape, " +
                               std::string(energy_columns) +
                               " FROM shapes JOIN fits ON fits.shape = shapes.id"
                               " LEFT JOIN labels ON labels.shape = fits.shape ORDER BY shapes.name");
  std::vector<FitSummary> fits;
  while (rows.step()) {
    FitSummary fit;
    fit.shape = rows.integer(0);
    fit.part_template = rows.integer(1);
    fit.status = read_status(database, rows.text(2));
    fit.state = decode_for(database, "a fit", [&] { return decode_hash(rows.blob(3)); });
    fit.yaw_quarters = read_yaw(database, rows.integer(4));
    fit.has_labels = !rows.is_null(5);
    fit.energy = read_energy(rows, 6);
    fits.push_back(fit);
  }
  return fits;
}

void Project::clear_fits() {
  WriteScope scope(*connection_->database);
  connection_->database->execute("DELETE FROM fits");
  Statement(*connection_->database, "DELETE FROM thumbnails WHERE kind LIKE ?").bind(fit_thumbnails).run();
  scope.commit();
}

void Project::store_labels(ShapeId id, const std::vector<std::int16_t>& labels) {
  WriteScope scope(*connection_->database);
  Statement(*connection_->database, "INSERT OR REPLACE INTO labels (shape, data) VALUES (?, ?)")
      .bind(id)
      .bind(encode_labels(labels))
      .run();
  scope.commit();
}

std::optional<std::vector<std::int16_t>> Project::labels(ShapeId id) const {
  Database& database = *connection_->database;
  Statement row(
      database,
      "SELECT labels.data, part_count, element_count FROM labels JOIN fits ON fits.shape = labels.shape"
      " JOIN templates ON templates.id = fits.template JOIN shapes ON shapes.id = labels.shape"
      " WHERE labels.shape = ?");
  row.bind(id);
  if (!row.step()) return std::nullopt;
  return decode_for(database, "the labels of shape " + std::to_string(id), [&] {
    return decode_labels(row.blob(0), count_column(database, row, 1), count_column(database, row, 2));
  });
}

}  // namespace archetype
