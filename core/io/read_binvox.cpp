// binvox voxel grids, read as a point set: the centre of every occupied voxel that has an empty neighbour
// across one of its six sides, in file order, with the direction to its empty neighbours as normal. Voxels
// inside say nothing about the surface.
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/io/readers.h"
#include "core/io/text_cursor.h"

namespace archetype {
namespace {

constexpr std::int64_t largest_dimension = 1024;  // what the program binvox can make
// A run of two bytes can stand for 255 points, so that the file's size is no bound here.
constexpr std::size_t most_points = 8 << 20;

// The index of voxel (x, y, z) is (x * size[2] + z) * size[1] + y: y runs fastest, then z.
struct Grid {
  std::array<std::int64_t, 3> size{};
  Vec3 translate = Vec3::Zero();
  double scale = 1;
  std::vector<bool> occupied;

  std::array<std::int64_t, 3> strides() const { return {size[1] * size[2], 1, size[1]}; }
  std::int64_t count() const { return size[0] * size[1] * size[2]; }
};

// Returns the byte where the runs begin.
std::size_t read_header(const ShapeBytes& file, Grid& grid) {
  TextCursor cursor(file.bytes, file.path, {.comments = false});
  if (!cursor.next_line() || cursor.word() != "#binvox") cursor.fail("expected #binvox on the first line");
  for (;;) {
    cursor.require_line("data");
    const std::string_view key = cursor.word();
    if (key == "data") break;
    if (key == "dim") {
      for (std::int64_t& size : grid.size) {
        size = cursor.integer();
        if (size < 1 || size > largest_dimension) {
          cursor.fail("expected a size from 1 to " + std::to_string(largest_dimension) + " voxels, found " +
                      std::to_string(size));
        }
      }
    } else if (key == "translate") {
      for (int axis = 0; axis < 3; ++axis) grid.translate[axis] = cursor.number();
    } else if (key == "scale") {
      grid.scale = cursor.number();
      if (grid.scale <= 0) cursor.fail("expected a scale above 0");
    }
  }
  if (grid.count() == 0) cursor.fail("expected a line \"dim\" before the data");
  cursor.skip_bytes_after_line(0);
  return file.bytes.size() - cursor.bytes_left();
}

void read_runs(const ShapeBytes& file, std::size_t begin, Grid& grid) {
  const auto count = static_cast<std::size_t>(grid.count());
  if ((file.bytes.size() - begin) / 2 * 255 < count) {
    throw InputError(file.path, "byte " + std::to_string(begin),
                     "the header promises " + std::to_string(count) + " voxels, which the " +
                         std::to_string(file.bytes.size() - begin) +
                         " bytes after it cannot hold; the file is cut off");
  }
  grid.occupied.reserve(count);
  for (std::size_t i = begin; grid.occupied.size() < count; i += 2) {
    if (i + 2 > file.bytes.size()) {
      throw InputError(file.path, "byte " + std::to_string(i),
                       "the file ends after " + std::to_string(grid.occupied.size()) + " of " +
                           std::to_string(count) + " voxels; it is cut off");
    }
    const auto value = static_cast<unsigned char>(file.bytes[i]);
    const auto length = static_cast<unsigned char>(file.bytes[i + 1]);
    if (value > 1) {
      throw InputError(file.path, "byte " + std::to_string(i),
                       "expected 0 (empty) or 1 (occupied), found " + std::to_string(value));
    }
    if (length > count - grid.occupied.size()) {
      throw InputError(file.path, "byte " + std::to_string(i),
                       "the runs go beyond the " + std::to_string(count) + " voxels of the grid");
    }
    grid.occupied.insert(grid.occupied.end(), length, value == 1);
  }
}

// The sum of the directions to the empty neighbours of a voxel, and how many there are. Outside the grid all
// is empty.
int find_empty_neighbours(const Grid& grid, std::int64_t index, const std::array<std::int64_t, 3>& voxel,
                          Vec3& sum) {
  const std::array<std::int64_t, 3> strides = grid.strides();
  int found = 0;
  sum.setZero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const std::int64_t next = voxel[axis] + side;
      const bool inside = next >= 0 && next < grid.size[axis];
      if (inside && grid.occupied[static_cast<std::size_t>(index + side * strides[axis])]) continue;
      ++found;
      sum[static_cast<Eigen::Index>(axis)] += side;
    }
  }
  return found;
}

}  // namespace

void read_binvox(const ShapeBytes& file, ShapeFile& shape) {
  Grid grid;
  read_runs(file, read_header(file, grid), grid);
  // Voxels are cubes: a grid that is not one is measured along its longest side.
  const double edge = grid.scale / static_cast<double>(std::max({grid.size[0], grid.size[1], grid.size[2]}));
  std::int64_t index = 0;
  std::array<std::int64_t, 3> voxel{};
  Vec3 normal;
  for (voxel[0] = 0; voxel[0] < grid.size[0]; ++voxel[0]) {
    for (voxel[2] = 0; voxel[2] < grid.size[2]; ++voxel[2]) {
      for (voxel[1] = 0; voxel[1] < grid.size[1]; ++voxel[1], ++index) {
        if (!grid.occupied[static_cast<std::size_t>(index)]) continue;
        if (find_empty_neighbours(grid, index, voxel, normal) == 0) continue;
        if (shape.mesh.vertices.size() == most_points) {
          throw InputError(file.path, "",
                           "the grid has more than " + std::to_string(most_points) + " surface voxels");
        }
        const Vec3 centre =
            Eigen::Map<const Eigen::Matrix<std::int64_t, 3, 1>>(voxel.data()).cast<double>().array() + 0.5;
        shape.mesh.vertices.emplace_back(edge * centre + grid.translate);
        shape.mesh.point_normals.push_back(normal.normalized());
      }
    }
  }
  if (shape.mesh.vertices.empty()) throw InputError(file.path, "", "no voxel of the grid is occupied");
}

}  // namespace archetype
