#include "ui/thumbnail_store.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace archetype {

std::uint64_t thumbnail_stamp(const ShapeRow& row) {
  if (!row.fit) return 0;
  const std::uint64_t stamp = std::bit_cast<std::uint64_t>(row.fit->energy.total()) ^
                              (static_cast<std::uint64_t>(row.fit->part_template) * 0x9e3779b97f4a7c15ULL);
  return stamp | 1;
}

ThumbnailStore::ThumbnailStore(std::filesystem::path shaders, std::function<void()> wake)
    : worker_(std::move(shaders), std::move(wake)) {}

std::uint32_t ThumbnailStore::use(ShapeId shape, std::uint64_t stamp) {
  const auto found = entries_.find(shape);
  if (found == entries_.end() || found->second.stamp != stamp) missing_.push_back({shape, stamp});
  if (found == entries_.end()) return 0;
  found->second.used = frame_;
  return found->second.texture ? found->second.texture->name() : 0;
}

void ThumbnailStore::begin_frame(const std::filesystem::path& project) {
  ++frame_;
  if (project != project_) {
    entries_.clear();
    asked_.clear();
    project_ = project;
  }
  for (MadeThumbnail& made : worker_.take()) {
    if (made.project != project_) continue;
    Entry& entry = entries_[made.wanted.shape];
    entry.stamp = made.wanted.stamp;
    entry.used = frame_;
    if (made.picture.width > 0) entry.texture.emplace(made.picture);
  }
  missing_.clear();
}

void ThumbnailStore::end_frame() {
  if (missing_ != asked_) {
    worker_.want(project_, missing_);
    asked_ = missing_;
  }
  forget_unused();
}

// About 150 KB each.
void ThumbnailStore::forget_unused() {
  constexpr std::size_t kept = 600;
  if (entries_.size() <= kept) return;
  std::vector<std::pair<std::uint64_t, ShapeId>> by_use;
  for (const auto& [shape, entry] : entries_) by_use.emplace_back(entry.used, shape);
  const auto drop = static_cast<std::ptrdiff_t>(entries_.size() - kept);
  std::nth_element(by_use.begin(), by_use.begin() + drop, by_use.end());
  for (auto it = by_use.begin(); it != by_use.begin() + drop; ++it)
    if (it->first != frame_) entries_.erase(it->second);
}

}  // namespace archetype
