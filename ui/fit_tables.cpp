#include "ui/fit_tables.h"

#include <utility>

#include "ui/studio.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

std::optional<ReadFitTable> read_table(const FitTableRequest& request, const JobControl& control) {
  ReadFitTable read{nullptr, {request.project, request.revision}};
  try {
    if (std::optional<FitTable> table =
            read_fit_table(Project::open(request.project), control, request.previous.get()))
      read.table = std::make_shared<const FitTable>(std::move(*table));
  } catch (const std::exception&) {
    // The job that is writing the project says what is wrong.
  }
  return read;
}

bool up_to_date(const FitTableRequest& request, const Collection& collection) {
  return request.project == collection.path && request.revision == collection.revision;
}

// Tables of ten thousand new fits take a third of a second: a running job, which changes the rows twice a
// second, must not be slowed down by them.
constexpr std::chrono::seconds pause_while_working{3};

}  // namespace

FitTables::FitTables(std::function<void()> wake) : reader(read_table, std::move(wake)) {}

std::shared_ptr<const FitTable> use_fit_table(Studio& studio) {
  studio.fit_tables.wanted = true;
  if (studio.fit_tables.newest.of.project != studio.collection.path) return nullptr;
  return studio.fit_tables.newest.table;
}

void begin_fit_tables(Studio& studio) {
  FitTables& tables = studio.fit_tables;
  tables.wanted = false;
  std::optional<ReadFitTable> read = tables.reader.poll();
  if (!read || read->of.project != studio.collection.path) return;
  // What could not be read just now leaves what was there.
  if (!read->table && tables.newest.of.project == read->of.project) read->table = tables.newest.table;
  tables.newest = std::move(*read);
}

void end_fit_tables(Studio& studio) {
  FitTables& tables = studio.fit_tables;
  if (!tables.wanted || !studio.collection.open() || up_to_date(tables.asked, studio.collection)) return;
  const bool same_project = tables.asked.project == studio.collection.path;
  if (same_project && !studio.jobs.idle() && Clock::now() - tables.asked_at < pause_while_working) return;
  tables.asked = {studio.collection.path, studio.collection.revision};
  tables.asked_at = Clock::now();
  FitTableRequest request = tables.asked;
  if (tables.newest.of.project == request.project) request.previous = tables.newest.table;
  tables.reader.request(std::move(request), !same_project);
}

bool fit_tables_settled(const Studio& studio) {
  const FitTables& tables = studio.fit_tables;
  return tables.reader.idle() && (!tables.wanted || !studio.collection.open() ||
                                  up_to_date(tables.asked, studio.collection) || !studio.jobs.idle());
}

}  // namespace archetype
