// Undo by snapshots: a list of documents, each with the message of the edit that led to it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/session/document.h"

namespace archetype {

struct HistoryLimits {
  std::size_t entries = 20'000;
  std::size_t bytes = std::size_t{128} << 20;  // of what the snapshots do not share with the one before
};

// A drag is many previews and one commit. A preview is what the window shows, but no step of its own: the
// next preview replaces it, cancel_preview() drops it. Undo, redo and jump drop a preview too.
class History {
 public:
  struct Entry {
    Document document;
    std::string message;  // "Move seat"; of the first entry: where the document came from
  };

  explicit History(Document start, std::string message, HistoryLimits limits = {});

  const Document& current() const { return preview_ ? *preview_ : committed(); }
  const Document& committed() const { return entries_[position_].document; }
  bool has_preview() const { return preview_.has_value(); }
  // Counts every change of current(); never the same for two different states.
  std::uint64_t revision() const { return revision_; }
  // The same of committed(): a preview does not change it.
  std::uint64_t committed_revision() const { return committed_revision_; }

  void preview(Document document);
  void cancel_preview();
  // Makes a step of it and drops what could be redone. False, and no step, if it equals committed().
  bool commit(Document document, std::string message);

  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ + 1 < entries_.size(); }
  bool undo();  // false if there is nothing to undo (a preview that was dropped counts as something)
  bool redo();
  void jump(std::size_t entry);  // entry < entries().size()

  const std::vector<Entry>& entries() const { return entries_; }
  std::size_t position() const { return position_; }

 private:
  void forget_oldest();

  std::vector<Entry> entries_;
  std::vector<std::size_t> costs_;  // bytes of each entry beyond those of the one before
  std::size_t position_ = 0;
  std::optional<Document> preview_;
  HistoryLimits limits_;
  std::uint64_t revision_ = 0;
  std::uint64_t committed_revision_ = 0;
};

}  // namespace archetype
