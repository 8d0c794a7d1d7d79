// A generated collection and a template for it, for tests that need something to import and fit.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/model/part_template.h"

namespace archetype::test {

// Writes `count` chairs in OFF, turned by quarters, to FOLDER/shapes and their ground truth to FOLDER/labels.
void write_chairs(const std::filesystem::path& folder, std::size_t count, std::uint64_t seed = 1);

// Seat, back and four legs, labelled as the generated chairs are.
PartTemplate chair_template();

// One part, which looks the same from the front and from behind.
PartTemplate drum_template();

}  // namespace archetype::test
