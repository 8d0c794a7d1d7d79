// Edits that add parts to the active template, or take some away.
#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/learning/mirror_symmetry.h"
#include "core/model/part_colours.h"
#include "core/session/mirror_pairs.h"
#include "core/session/template_edit.h"

namespace archetype {
namespace {

constexpr double own_image = 0.03;  // a part nearer to its mirror image than this is it, in units of its size

// Which of the part_colour_count colours a part is drawn in.
int colour_number(const PartTemplate& part_template, std::size_t part) {
  const int own = part_template.parts[part].colour;
  return own >= 0 ? own : static_cast<int>(part % std::size_t{part_colour_count});
}

// Parts that come to another place of the list, as those from a place on will, keep the colours that they
// have been seen in: who has learned that the back is orange need not look again.
void keep_colours(PartTemplate& part_template, std::size_t from) {
  for (std::size_t i = from; i < part_template.parts.size(); ++i)
    part_template.parts[i].colour = colour_number(part_template, i);
}

// Another colour for a part whose own is that of another part, as long as there is one.
void give_free_colour(PartTemplate& part_template, std::size_t part) {
  std::set<int> used;
  for (std::size_t i = 0; i < part_template.parts.size(); ++i)
    if (i != part) used.insert(colour_number(part_template, i));
  if (!used.contains(colour_number(part_template, part))) return;
  for (int colour = 0; colour < part_colour_count; ++colour)
    if (!used.contains(colour)) {
      part_template.parts[part].colour = colour;
      return;
    }
}

// Puts them at a place of the list with free names and colours; without links, as what they came from may be
// linked elsewhere.
PartList insert_parts(PartTemplate& part_template, std::vector<TemplatePart> added, std::size_t at) {
  expect_room(part_template, added.size());
  keep_colours(part_template, at);
  PartList places;
  for (TemplatePart& part : added) {
    part.name = free_part_name(part_template, part.name);
    part.mirror = {};
    places.push_back(at);
    part_template.parts.insert(part_template.parts.begin() + static_cast<std::ptrdiff_t>(at),
                               std::move(part));
    give_free_colour(part_template, at++);
  }
  return places;
}

// Pairs among the originals are pairs among the copies.
void link_copies(PartTemplate& part_template, const std::vector<MirrorLink>& links, const PartList& copies) {
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t j = i + 1; j < links.size(); ++j)
      if (links[i].pair > 0 && links[i] == links[j] && part_template.parts[copies[i]].mirror.pair == 0 &&
          part_template.parts[copies[j]].mirror.pair == 0)
        link_mirror(part_template, copies[i], copies[j], links[i].axis);
}

std::vector<MirrorLink> links_of(const std::vector<TemplatePart>& parts) {
  std::vector<MirrorLink> links;
  links.reserve(parts.size());
  for (const TemplatePart& part : parts) links.push_back(part.mirror);
  return links;
}

std::vector<TemplatePart> parts_at(const PartTemplate& part_template, const PartList& parts) {
  std::vector<TemplatePart> taken;
  for (const std::size_t part : parts) taken.push_back(part_template.parts[part]);
  return taken;
}

// "right arm" for "left arm".
std::string other_side(std::string name) {
  for (const auto& [side, other] :
       {std::pair{"left", "right"}, {"right", "left"}, {"Left", "Right"}, {"Right", "Left"}})
    if (const std::size_t at = name.find(side); at != std::string::npos)
      return name.replace(at, std::string_view(side).size(), other);
  return name;
}

void erase_parts(PartTemplate& part_template, const PartList& sorted) {
  keep_colours(part_template, sorted.front());
  for (auto part = sorted.rbegin(); part != sorted.rend(); ++part)
    part_template.parts.erase(part_template.parts.begin() + static_cast<std::ptrdiff_t>(*part));
  drop_lone_links(part_template);
}

// The first part with the box around all of them, along its own axes.
TemplatePart merged(const PartTemplate& part_template, const PartList& parts) {
  TemplatePart result = part_template.parts[parts[0]];
  const Eigen::Quaterniond turn = result.orientation;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (const std::size_t part : parts) {
    const TemplatePart& each = part_template.parts[part];
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 local((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
      const Vec3 place = turn.conjugate() * each.mean_box().to_world(local);
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
    result.must_exist = result.must_exist || each.must_exist;
    result.existence = std::max(result.existence, each.existence);
  }
  set_box(result, {turn * Vec3(0.5 * (low + high)), 0.5 * (high - low), turn});
  result.has_features = false;  // those of the whole are not known
  result.features = {};
  result.mirror = {};
  return result;
}

// The partners of all of them, in their order, if each has one outside of the list.
std::optional<PartList> partners_outside(const PartTemplate& part_template, const PartList& parts) {
  PartList partners;
  for (const std::size_t part : parts) {
    const auto partner = mirror_partner(part_template, part);
    if (!partner || std::find(parts.begin(), parts.end(), *partner) != parts.end()) return std::nullopt;
    if (part_template.parts[part].mirror.axis != part_template.parts[parts[0]].mirror.axis)
      return std::nullopt;
    partners.push_back(*partner);
  }
  return partners;
}

// The half of a part on the lower (-1) or upper (1) side of an axis of its box.
TemplatePart half_of(const TemplatePart& part, int axis, int side) {
  TemplatePart half = part;
  Box box = part.mean_box();
  box.half_extent[axis] *= 0.5;
  box.centre += box.orientation * Vec3(side * box.half_extent[axis] * Vec3::Unit(axis));
  set_box(half, box);
  half.mirror = {};
  return half;
}

}  // namespace

std::size_t add_part(History& history, const Box& box, const std::string& name) {
  PartTemplate changed = active_copy(history);
  TemplatePart part;
  part.name = name;
  for (const TemplatePart& other : changed.parts)
    if (other.label < std::numeric_limits<int>::max()) part.label = std::max(part.label, other.label + 1);
  set_box(part, box);
  const std::size_t index = insert_parts(changed, {part}, changed.parts.size())[0];
  const std::string message = "Add " + changed.parts[index].name;
  put(history, std::move(changed), Stage::done, message);
  return index;
}

PartList duplicate_parts(History& history, const PartList& parts) {
  PartTemplate changed = active_copy(history);
  const PartList sorted = checked_parts(changed, parts);
  std::vector<TemplatePart> copies = parts_at(changed, sorted);
  const std::vector<MirrorLink> links = links_of(copies);
  const std::string message = "Duplicate " + names_of(changed, sorted);
  // Beside the originals, where they can be seen and taken.
  double width = 0;
  for (const TemplatePart& copy : copies) width = std::max(width, 2 * copy.scale.mean.x());
  for (TemplatePart& copy : copies) {
    Box box = copy.mean_box();
    box.centre.x() += width;
    set_box(copy, box);
  }
  PartList places = insert_parts(changed, std::move(copies), sorted.back() + 1);
  link_copies(changed, links, places);
  put(history, std::move(changed), Stage::done, message);
  return places;
}

PartList add_mirror_images(History& history, const PartList& parts, int axis) {
  PartTemplate changed = active_copy(history);
  PartList originals;
  for (const std::size_t part : checked_parts(changed, parts)) {
    const Box box = changed.parts[part].mean_box();
    const bool own = box_distance(box, mirrored(box, axis)) < own_image * box.half_extent.norm();
    if (!own && !mirror_partner(changed, part)) originals.push_back(part);
  }
  if (originals.empty())
    throw Error("nothing to mirror: " + names_of(changed, checked_parts(changed, parts)) +
                (parts.size() == 1 ? " is" : " are") + " linked already or the same in the mirror");
  const std::string message = "Mirror " + names_of(changed, originals);
  std::vector<TemplatePart> images = parts_at(changed, originals);
  for (TemplatePart& image : images) image.name = other_side(image.name);
  PartList places = insert_parts(changed, std::move(images), originals.back() + 1);
  for (std::size_t i = 0; i < places.size(); ++i) link_mirror(changed, originals[i], places[i], axis);
  put(history, std::move(changed), Stage::done, message);
  return places;
}

void link_parts(History& history, std::size_t leader, std::size_t follower, int axis) {
  if (leader == follower) throw PreconditionError("a part is no pair with itself");
  PartTemplate changed = active_copy(history);
  part_of(changed, leader).mirror = {};
  part_of(changed, follower).mirror = {};
  drop_lone_links(changed);
  link_mirror(changed, leader, follower, axis);
  const std::string message = "Link " + changed.parts[leader].name + " and " + changed.parts[follower].name;
  put(history, std::move(changed), Stage::done, message);
}

void unlink_parts(History& history, const PartList& parts) {
  PartTemplate changed = active_copy(history);
  const PartList sorted = checked_parts(changed, parts);
  for (const std::size_t part : sorted) changed.parts[part].mirror = {};
  drop_lone_links(changed);
  const std::string message = "Unlink " + names_of(changed, sorted);
  put(history, std::move(changed), Stage::done, message);
}

void remove_parts(History& history, const PartList& parts) {
  PartTemplate changed = active_copy(history);
  const PartList sorted = checked_parts(changed, parts);
  const std::string message = "Delete " + names_of(changed, sorted);
  erase_parts(changed, sorted);
  put(history, std::move(changed), Stage::done, message);
}

std::size_t merge_parts(History& history, const PartList& parts) {
  PartTemplate changed = active_copy(history);
  PartList gone = checked_parts(changed, parts);
  if (gone.size() < 2) throw Error("select two or more parts to merge");
  const std::size_t first = parts[0];
  const std::string message = "Merge " + names_of(changed, gone);
  const auto partners = partners_outside(changed, parts);
  const int axis = changed.parts[first].mirror.axis;
  const TemplatePart whole = merged(changed, parts);
  std::optional<std::size_t> follower;
  if (partners) {
    follower = (*partners)[0];
    changed.parts[*follower] = merged(changed, *partners);
    gone.insert(gone.end(), partners->begin(), partners->end());
  }
  changed.parts[first] = whole;
  std::erase_if(gone, [&](std::size_t part) { return part == first || part == follower; });
  gone = checked_parts(changed, gone);
  erase_parts(changed, gone);
  const auto place = [&](std::size_t part) {
    const auto before =
        std::count_if(gone.begin(), gone.end(), [&](std::size_t each) { return each < part; });
    return part - static_cast<std::size_t>(before);
  };
  if (follower) link_mirror(changed, place(first), place(*follower), axis);
  put(history, std::move(changed), Stage::done, message);
  return place(first);
}

PartList split_part(History& history, std::size_t part, int axis) {
  if (axis < 0 || axis > 2) throw PreconditionError("a box has the axes 0 to 2");
  PartTemplate changed = active_copy(history);
  const TemplatePart whole = part_of(changed, part);
  const std::string message = "Split " + whole.name;
  auto partner = mirror_partner(changed, part);
  expect_room(changed, partner ? 2 : 1);
  changed.parts[part] = half_of(whole, axis, -1);
  std::size_t upper = insert_parts(changed, {half_of(whole, axis, 1)}, part + 1)[0];
  if (partner) {
    if (*partner > part) ++*partner;
    changed.parts[*partner].mirror = {};
    const std::size_t second = insert_parts(changed, {changed.parts[*partner]}, *partner + 1)[0];
    if (*partner < part) {
      ++part;
      ++upper;
    }
    link_mirror(changed, part, *partner, whole.mirror.axis);
    link_mirror(changed, upper, second, whole.mirror.axis);
  }
  put(history, std::move(changed), Stage::done, message);
  return {part, upper};
}

PartList paste_parts(History& history, const std::vector<TemplatePart>& parts) {
  if (parts.empty()) throw PreconditionError("there is nothing to paste");
  PartTemplate changed = active_copy(history);
  PartList places = insert_parts(changed, parts, changed.parts.size());
  link_copies(changed, links_of(parts), places);
  const std::string message = "Paste " + names_of(changed, places);
  put(history, std::move(changed), Stage::done, message);
  return places;
}

}  // namespace archetype
