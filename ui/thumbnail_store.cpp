#include "ui/thumbnail_store.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace archetype {

WantedThumbnail wanted_thumbnail(const ShapeRow& row) {
  WantedThumbnail wanted{row.id, row.hash.words[0], row.fit.has_value()};
  if (row.fit)
    wanted.stamp ^= std::bit_cast<std::uint64_t>(row.fit->energy.total()) ^
                    (static_cast<std::uint64_t>(row.fit->part_template) * 0x9e3779b97f4a7c15ULL) ^
                    row.fit->state.words[0] ^ static_cast<std::uint64_t>(row.fit->yaw_quarters);
  return wanted;
}

ThumbnailStore::ThumbnailStore(std::filesystem::path shaders, std::function<void()> wake)
    : worker_(std::move(shaders), std::move(wake)) {}

std::string ThumbnailStore::take_problem() {
  if (problem_taken_) return "";
  std::string problem = worker_.problem();
  problem_taken_ = !problem.empty();
  return problem;
}

void ThumbnailStore::follow_colours(const Document& document) {
  HandColours colours;
  for (const auto& part_template : document.templates) {
    if (std::ranges::all_of(part_template->parts, [](const TemplatePart& part) { return part.colour < 0; }))
      continue;
    std::vector<int>& own = colours[part_template->name];
    for (const TemplatePart& part : part_template->parts) own.push_back(part.colour);
  }
  if (colours.empty())
    colours_.reset();
  else if (!colours_ || *colours_ != colours)
    colours_ = std::make_shared<const HandColours>(std::move(colours));
}

std::uint32_t ThumbnailStore::use(WantedThumbnail wanted) {
  if (wanted.fitted) wanted.colours = colours_;
  const auto found = entries_.find(wanted.shape);
  if (found == entries_.end() || found->second.wanted != wanted) missing_.push_back(wanted);
  if (found == entries_.end()) return 0;
  found->second.used = frame_;
  return found->second.texture ? found->second.texture->name() : 0;
}

void ThumbnailStore::expect(WantedThumbnail wanted) {
  if (wanted.fitted) wanted.colours = colours_;
  const auto found = entries_.find(wanted.shape);
  if (found == entries_.end() || found->second.wanted != wanted) expected_.push_back(wanted);
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
    entry.wanted = made.wanted;
    entry.used = frame_;
    if (made.picture.width > 0) entry.texture.emplace(made.picture);
  }
  missing_.clear();
  expected_.clear();
}

void ThumbnailStore::end_frame() {
  std::vector<WantedThumbnail> wanted = missing_;
  wanted.insert(wanted.end(), expected_.begin(), expected_.end());
  if (wanted != asked_) {
    worker_.want(project_, wanted);
    asked_ = std::move(wanted);
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
