#include "core/session/history.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/error.h"

namespace archetype {
namespace {

std::size_t bytes_of(const PartTemplate& part_template) {
  std::size_t bytes = sizeof(PartTemplate) + part_template.name.size() + part_template.extra_json.size();
  for (const TemplatePart& part : part_template.parts)
    bytes += sizeof(TemplatePart) + part.name.size() + part.extra_json.size();
  return bytes;
}

// What corrections take beyond those that they share with the ones before.
std::size_t bytes_of(const Corrections& corrections, const Corrections* before) {
  constexpr std::size_t node = sizeof(Corrections::value_type) + 4 * sizeof(void*);
  std::size_t bytes = sizeof(Corrections);
  for (const auto& [shape, correction] : corrections) {
    bytes += node;
    if (before) {
      const auto same = before->find(shape);
      if (same != before->end() && same->second == correction) continue;
    }
    bytes += sizeof(ShapeCorrection) + correction->part_template.size();
    for (const auto& [part, samples] : correction->pinned)
      bytes += node + part.size() + samples.size() * sizeof(samples[0]);
  }
  return bytes;
}

// What `document` takes beyond the templates that it shares with `before`.
std::size_t cost(const Document& document, const Document* before) {
  std::size_t bytes = sizeof(History::Entry) + document.templates.size() * sizeof(document.templates[0]);
  for (const auto& part_template : document.templates) {
    const bool shared = before && std::find(before->templates.begin(), before->templates.end(),
                                            part_template) != before->templates.end();
    if (!shared) bytes += bytes_of(*part_template);
  }
  if (document.corrections && (!before || before->corrections != document.corrections))
    bytes += bytes_of(*document.corrections, before ? before->corrections.get() : nullptr);
  return bytes;
}

}  // namespace

History::History(Document start, std::string message, HistoryLimits limits) : limits_(limits) {
  costs_.push_back(cost(start, nullptr));
  entries_.push_back({std::move(start), std::move(message)});
}

void History::preview(Document document) {
  if (document == current()) return;
  preview_ = std::move(document);
  ++revision_;
}

void History::cancel_preview() {
  if (!preview_) return;
  preview_.reset();
  ++revision_;
}

bool History::commit(Document document, std::string message) {
  const bool shown = preview_ && *preview_ == document;  // the end of a drag changes nothing that is seen
  preview_.reset();
  if (document == committed()) {
    if (!shown) ++revision_;
    return false;
  }
  entries_.resize(position_ + 1, {});
  costs_.resize(position_ + 1);
  costs_.push_back(cost(document, &entries_.back().document));
  entries_.push_back({std::move(document), std::move(message)});
  ++position_;
  ++revision_;
  ++committed_revision_;
  forget_oldest();
  return true;
}

bool History::undo() {
  if (preview_) {
    cancel_preview();
    return true;
  }
  if (!can_undo()) return false;
  jump(position_ - 1);
  return true;
}

bool History::redo() {
  if (!can_redo()) return false;
  jump(position_ + 1);
  return true;
}

void History::jump(std::size_t entry) {
  if (entry >= entries_.size()) throw PreconditionError("history: no such entry");
  preview_.reset();
  position_ = entry;
  ++revision_;
  ++committed_revision_;
}

void History::forget_oldest() {
  std::size_t bytes = std::accumulate(costs_.begin(), costs_.end(), std::size_t{0});
  std::size_t drop = 0;
  while (drop < position_ && (entries_.size() - drop > limits_.entries || bytes > limits_.bytes)) {
    bytes -= costs_[drop];
    ++drop;
  }
  entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(drop));
  costs_.erase(costs_.begin(), costs_.begin() + static_cast<std::ptrdiff_t>(drop));
  position_ -= drop;
  if (drop > 0) costs_.front() = cost(entries_.front().document, nullptr);
}

}  // namespace archetype
