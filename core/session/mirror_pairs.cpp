#include "core/session/mirror_pairs.h"

#include <algorithm>

#include "core/learning/mirror_symmetry.h"

namespace archetype {

std::optional<std::size_t> mirror_partner(const PartTemplate& part_template, std::size_t part) {
  const MirrorLink& link = part_template.parts[part].mirror;
  if (link.pair <= 0) return std::nullopt;
  std::optional<std::size_t> partner;
  for (std::size_t i = 0; i < part_template.parts.size(); ++i) {
    if (i == part || part_template.parts[i].mirror != link) continue;
    if (partner) return std::nullopt;
    partner = i;
  }
  return partner;
}

int free_pair_number(const PartTemplate& part_template) {
  const auto taken = [&](int number) {
    return std::any_of(part_template.parts.begin(), part_template.parts.end(),
                       [&](const TemplatePart& part) { return part.mirror.pair == number; });
  };
  int number = 1;
  while (taken(number)) ++number;
  return number;
}

void link_mirror(PartTemplate& part_template, std::size_t leader, std::size_t follower, int axis) {
  const MirrorLink link{free_pair_number(part_template), axis};
  part_template.parts[leader].mirror = link;
  part_template.parts[follower].mirror = link;
  keep_in_step(part_template, leader);
}

void keep_in_step(PartTemplate& part_template, std::size_t leader) {
  const std::optional<std::size_t> follower = mirror_partner(part_template, leader);
  if (!follower) return;
  const TemplatePart& from = part_template.parts[leader];
  TemplatePart& to = part_template.parts[*follower];
  const Box image = mirrored(from.mean_box(), from.mirror.axis);
  to.position = {image.centre, from.position.stddev};
  to.scale = {image.half_extent, from.scale.stddev};
  to.orientation = image.orientation;
  to.existence = from.existence;
  to.must_exist = from.must_exist;
}

void average_pairs(PartTemplate& part_template) {
  for (std::size_t i = 0; i < part_template.parts.size(); ++i) {
    const std::optional<std::size_t> other = mirror_partner(part_template, i);
    if (!other || *other < i) continue;
    TemplatePart& part = part_template.parts[i];
    const Box image = mirrored(part_template.parts[*other].mean_box(), part.mirror.axis);
    part.position.mean = 0.5 * (part.position.mean + image.centre);
    part.scale.mean = 0.5 * (part.scale.mean + image.half_extent);
    part.orientation = part.orientation.slerp(0.5, image.orientation);
    keep_in_step(part_template, i);
  }
}

void drop_lone_links(PartTemplate& part_template) {
  for (std::size_t i = 0; i < part_template.parts.size(); ++i)
    if (!mirror_partner(part_template, i)) part_template.parts[i].mirror = {};
}

}  // namespace archetype
