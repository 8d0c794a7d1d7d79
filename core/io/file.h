// Whole files in and out of memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace archetype {

// Larger files are refused. It keeps every count of vertices, corners and faces that a file can hold within
// 32 bits.
inline constexpr std::uint64_t max_file_bytes = std::uint64_t{2} << 30;

// All bytes of a regular file. Throws FileError with the system's reason, or if it holds more than
// `max_bytes`; folders, pipes and devices are refused without waiting on them.
std::string read_file(const std::filesystem::path& path, std::uint64_t max_bytes = max_file_bytes);

// Writes or replaces a file in one step: whatever happens in between (crash, full disk), afterwards there is
// either the old file or the whole new one. Throws FileError and leaves no temporary file behind.
void replace_file(const std::filesystem::path& path, std::string_view content);

}  // namespace archetype
