// Hostile point sets and voxel grids.
#include "tests/io/hostile_corpus.h"

namespace archetype::test {

std::vector<HostileFile> hostile_points() {
  const std::string small_grid = "#binvox 1\ndim 2 2 2\ntranslate 0 0 0\nscale 1\ndata\n";
  std::string slabs = "#binvox 1\ndim 510 510 510\ntranslate 0 0 0\nscale 1\ndata\n";  // every second layer
  for (int x = 0; x < 510; ++x) {
    for (int run = 0; run < 2 * 510; ++run) slabs += std::string{x % 2 == 0 ? '\1' : '\0', '\xFF'};
  }
  return {
      {"empty.xyz", "", "the file is empty"},
      {"blank.xyz", "\n# x\n", "the file holds no vertices"},
      {"molecule.xyz", "2\nwater\nO 0 0 0\nH 0 0 1\n", "line 2: expected a finite number, found \"water\""},
      {"two_columns.xyz", "1 2\n", "line 1: the line ends where a number was expected"},
      {"nan.xyz", "0 0 0\n0 0 nan\n", "line 2: expected a finite number"},
      {"comma.xyz", "0,5 0 0\n", "found \"0,5\""},
      {"promise.pts", "4000000000\n0 0 0\n",
       "line 1: promises 4000000000 points, which the 7 bytes after it cannot hold"},
      {"cut.pts", "2\n0 0 0.0000000000000\n", "the file ends after 1 of 2 points; it is cut off"},
      {"negative.pts", "-2\n0 0 0\n", "expected x y z or the number of points, found \"-2\""},
      {"fraction.pts", "2.5\n0 0 0\n", "expected x y z or the number of points"},
      {"cut_line.pts", "0 0 0\n1\n", "line 2: the line ends where a number was expected"},
      {"binary.pts", std::string("0 0 0\0", 6), "byte 5: expected text"},

      {"empty.binvox", "", "the file is empty"},
      {"magic.binvox", "binvox 1\n", "expected #binvox on the first line"},
      {"no_data.binvox", "#binvox 1\ndim 2 2 2\n", "the file ends where data was expected"},
      {"no_dim.binvox", "#binvox 1\ndata\n\1\1", "expected a line \"dim\" before the data"},
      {"dim_zero.binvox", "#binvox 1\ndim 2 0 2\ndata\n", "expected a size from 1 to 1024 voxels, found 0"},
      {"dim_huge.binvox", "#binvox 1\ndim 4294967296 2 2\ndata\n", "expected a size from 1 to 1024 voxels"},
      {"dim_two.binvox", "#binvox 1\ndim 2 2\ndata\n",
       "line 2: the line ends where a whole number was expected"},
      {"promise.binvox", "#binvox 1\ndim 1024 1024 1024\ndata\n\1\xFF",
       "the header promises 1073741824 voxels"},
      {"scale.binvox", "#binvox 1\ndim 1 1 1\nscale 0\ndata\n\1\1", "expected a scale above 0"},
      {"far.binvox", "#binvox 1\ndim 1 1 1\ntranslate 1e308 0 0\nscale 1e308\ndata\n\1\1",
       "vertex 1: a coordinate is beyond 1e30"},
      {"cut.binvox", small_grid + "\1\3", "the file ends after 3 of 8 voxels; it is cut off"},
      {"cut_run.binvox", small_grid + "\1\3\1", "the file ends after 3 of 8 voxels"},
      {"beyond.binvox", small_grid + "\1\11", "the runs go beyond the 8 voxels of the grid"},
      {"value.binvox", small_grid + "\2\10", "expected 0 (empty) or 1 (occupied), found 2"},
      {"vacant.binvox", small_grid + std::string("\0\10", 2), "no voxel of the grid is occupied"},
      {"slabs.binvox", slabs, "the grid has more than 8388608 surface voxels"},
  };
}

}  // namespace archetype::test
