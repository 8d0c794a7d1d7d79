// What people said of single shapes.
#include "core/base/error.h"
#include "core/io/correction_text.h"
#include "core/io/project.h"
#include "core/io/project_connection.h"

namespace archetype {

ContentHash sampling_of(const ShapeRecord& record) {
  const std::string text = record.hash.to_hex() + " " + std::string(to_string(record.up)) + " " +
                           std::to_string(record.requested_points) + " " + std::to_string(record.seed);
  return hash_content(std::as_bytes(std::span(text)));
}

bool same_corrections(const std::shared_ptr<const Corrections>& a,
                      const std::shared_ptr<const Corrections>& b) {
  const std::size_t count_a = a ? a->size() : 0;
  const std::size_t count_b = b ? b->size() : 0;
  if (a == b || count_a + count_b == 0) return true;
  if (count_a != count_b) return false;
  return std::equal(a->begin(), a->end(), b->begin(), [](const auto& x, const auto& y) {
    return x.first == y.first && (x.second == y.second || *x.second == *y.second);
  });
}

Corrections Project::corrections() const {
  Database& database = *connection_->database;
  Corrections corrections;
  // An older project that could not be migrated, being on a read-only medium, has none.
  if (database.number("SELECT count(*) FROM sqlite_schema WHERE name = 'corrections'") == 0)
    return corrections;
  Statement rows(database, "SELECT shape, json FROM corrections ORDER BY shape");
  while (rows.step()) {
    const ShapeId shape = rows.integer(0);
    try {
      corrections[shape] = std::make_shared<const ShapeCorrection>(
          parse_correction(rows.text(1), "the correction of shape " + std::to_string(shape)));
    } catch (const InputError& error) {
      database.fail_damaged(error.what());
    }
  }
  return corrections;
}

void Project::set_corrections(const Corrections& corrections) {
  Database& database = *connection_->database;
  WriteScope scope(database);
  database.execute("DELETE FROM corrections");
  Statement insert(database, "INSERT INTO corrections (shape, json) SELECT id, ? FROM shapes WHERE id = ?");
  for (const auto& [shape, correction] : corrections) {
    if (!correction->empty()) insert.bind(std::string_view(format_correction(*correction))).bind(shape).run();
  }
  scope.commit();
}

}  // namespace archetype
