// binvox grids as point sets.
#include <doctest/doctest.h>

#include "tests/io/shape_reading.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// A grid of given sizes along x, y and z; occupied(x, y, z) says what is in it.
template <typename Occupied>
std::string binvox(int nx, int ny, int nz, const std::string& placement, Occupied occupied) {
  std::string bytes = "#binvox 1\ndim " + std::to_string(nx) + " " + std::to_string(ny) + " " +
                      std::to_string(nz) + "\n" + placement + "data\n";
  for (int x = 0; x < nx; ++x) {
    for (int z = 0; z < nz; ++z) {
      for (int y = 0; y < ny; ++y) bytes += std::string{occupied(x, y, z) ? '\1' : '\0', '\1'};
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("binvox: occupied voxels at the surface, in the file's coordinates, with normals outwards") {
  // A block of 3 x 3 x 3 in the middle of 5 x 5 x 5: all but its innermost voxel.
  const auto block = [](int x, int y, int z) { return std::min({x, y, z}) >= 1 && std::max({x, y, z}) <= 3; };
  const PolygonMesh mesh = read_as("a.binvox", binvox(5, 5, 5, "translate -1 -2 -3\nscale 10\n", block)).mesh;
  REQUIRE(mesh.vertices.size() == 26);
  REQUIRE(mesh.point_normals.size() == 26);
  CHECK(mesh.is_point_set());
  CHECK(mesh.vertices[0] == Vec3(2 * 1.5 - 1, 2 * 1.5 - 2, 2 * 1.5 - 3));
  CHECK(mesh.vertices[1] == Vec3(2 * 1.5 - 1, 2 * 2.5 - 2, 2 * 1.5 - 3));  // y runs fastest
  CHECK(mesh.vertices[3] == Vec3(2 * 1.5 - 1, 2 * 1.5 - 2, 2 * 2.5 - 3));  // then z
  const Vec3 centre = 5 * Vec3::Ones() + Vec3(-1, -2, -3);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    CHECK(mesh.point_normals[i].isApprox((mesh.vertices[i] - centre).cwiseSign().normalized()));
  }
}

TEST_CASE("binvox: the border of the grid counts as empty, a long run and a flat grid are read") {
  std::string bytes = "#binvox 1\ndim 1 300 1\ntranslate 0 0 0\nscale 300\ndata\n";
  bytes += std::string("\1\377\1\55", 4);
  const PolygonMesh mesh = read_as("a.BINVOX", bytes).mesh;
  REQUIRE(mesh.vertices.size() == 300);
  CHECK(mesh.vertices[299] == Vec3(0.5, 299.5, 0.5));
  CHECK(mesh.point_normals[0] == Vec3(0, -1, 0));
  CHECK(mesh.point_normals[1] == Vec3(0, 0, 0));
}
