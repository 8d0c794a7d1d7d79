// A shape with very many faces, for tests of what takes long.
#pragma once

#include <cstddef>
#include <filesystem>

namespace archetype::test {

// Writes a generated chair whose faces are cut into small ones, at least so many in all, as
// the only one of a collection as write_collection() makes them.
void write_big_chair(const std::filesystem::path& folder, std::size_t faces);

}  // namespace archetype::test
