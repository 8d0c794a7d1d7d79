// Projects of any size with real fits: some chairs are read and fitted, and come again under other names.
#pragma once

#include <cstddef>
#include <filesystem>

namespace archetype::test {

// A project in the folder with so many shapes, whose files are there, fitted by one of two templates; some
// are outliers. About 2 s for 10,000.
std::filesystem::path make_sized_project(const std::filesystem::path& folder, std::size_t count);

}  // namespace archetype::test
