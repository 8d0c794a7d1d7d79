// Malformed and hostile files for every reader, each with what its refusal has to say.
#pragma once

#include <string>
#include <vector>

namespace archetype::test {

struct HostileFile {
  std::string name;  // its ending decides which reader gets it
  std::string bytes;
  std::string expected;  // part of the error message
};

std::vector<HostileFile> hostile_meshes();  // OBJ, OFF, STL, AC3D
std::vector<HostileFile> hostile_ply();
std::vector<HostileFile> hostile_gltf();
std::vector<HostileFile> hostile_points();      // XYZ, PTS, binvox
std::vector<HostileFile> hostile_side_files();  // templates, labels, landmarks

}  // namespace archetype::test
