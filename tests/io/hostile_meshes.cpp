// Hostile OBJ, OFF, STL and AC3D files.
#include "tests/io/gltf_builder.h"
#include "tests/io/hostile_corpus.h"

namespace archetype::test {

namespace {

const std::string ac_object = "AC3Db\nOBJECT world\nnumvert 1\n0 0 0\n";

std::string binary_stl(std::uint32_t promised, const std::string& body) {
  std::string bytes(80, 'x');
  append_word(bytes, promised);
  return bytes + body;
}

}  // namespace

std::vector<HostileFile> hostile_meshes() {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  std::string not_a_number(48, '\0');
  not_a_number += std::string("\0\0", 2);
  not_a_number.replace(12, 4, "\xFF\xFF\xFF\x7F");
  return {
      {"empty.obj", "", "the file is empty"},
      {"comment.obj", "# nothing\n", "found no line that begins with v"},
      {"prose.obj", "once upon a time\n", "found no line that begins with v"},
      {"no_vertices.obj", "f 1 2 3\n", "found no line that begins with v"},
      {"beyond.obj", "v 0 0 0\nf 1 1 2\nf 1 1 1\n",
       "line 2: the face refers to vertex 2, but the file has only 1"},
      {"zero.obj", "v 0 0 0\nf 0 1 1\n", "line 2: the corner \"0\" refers to no vertex"},
      {"before_first.obj", "v 0 0 0\nf -1 -2 -1\n", "line 2: the corner \"-2\" refers to no vertex"},
      {"word_corner.obj", "v 0 0 0\n\nf 1 x 1\n",
       "line 3: expected a corner such as 3 or 3/1/2, found \"x\""},
      {"fraction_corner.obj", "v 0 0 0\nf 1.5 1 1\n", "found \"1.5\""},
      {"slash_corner.obj", "v 0 0 0\nf /1 1 1\n", "found \"/1\""},
      {"wraps_32_bits.obj", "v 0 0 0\nf 4294967297 1 1\n", "refers to vertex 4294967297"},
      {"wraps_64_bits.obj", "v 0 0 0\nf 18446744073709551617 1 1\n", "expected a corner"},
      {"lowest_index.obj", "v 0 0 0\nf -9223372036854775808 1 1\n", "refers to no vertex"},
      {"short_vertex.obj", "v 0 0 0\nv 1 2\n", "line 2: the line ends where a number was expected"},
      {"nan.obj", "v 0 nan 0\n", "line 1: expected a finite number, found \"nan\""},
      {"inf.obj", "v 0 -inf 0\n", "expected a finite number"},
      {"too_large.obj", "v 0 1e400 0\n", "expected a finite number, found \"1e400\""},
      {"far.obj", "v 0 0 0\nv 0 -1.1e30 0\n", "vertex 2: a coordinate is beyond 1e30"},
      {"comma.obj", "v 1,5 2 3\n", "expected a finite number, found \"1,5\""},
      {"two_signs.obj", "v +-1 2 3\n", "found \"+-1\""},
      {"control.obj", "v \x1b[31m" + std::string(100, 'x') + " 2 3\n",
       "found \"?[31mxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...\""},
      {"binary.obj", std::string("v 0 0 0\n\0", 9), "byte 8: expected text"},
      {"picture.obj", "\x89PNG\r\n\x1a\n", "the content is a PNG picture"},
      {"page.off", "<!DOCTYPE html><html>", "the content is a web page"},
      {"zipped.stl", "PK\x03\x04xxxxxxxx", "the content is a ZIP archive"},
      {"gzipped.ply", "\x1f\x8b\x08xxxxx", "the content is gzip data"},
      {"ply.obj", "ply\nformat ascii 1.0\n", "the content is PLY"},

      {"empty.off", "", "the file is empty"},
      {"blank.off", "\n\n  \n", "the file ends where OFF was expected"},
      {"magic_only.off", "OFF\n", "the file ends where the numbers of vertices and faces was expected"},
      {"magic.off", "OGG\n3 1 0\n", "line 1: expected OFF or the number of vertices, found \"OGG\""},
      {"binary.off", std::string("OFF BINARY\n\0\0\0\3", 15), "binary OFF is not supported"},
      {"four_d.off", "4nOFF\n5\n1 0 0\n", "(nOFF) is not supported"},
      {"no_counts.off", "OFF\nx y z\n", "line 2: expected the number of vertices, found \"x\""},
      {"one_count.off", "OFF\n8\n", "line 2: the line ends where a whole number was expected"},
      {"promise.off", "OFF\n4000000000 1 0\n0 0 0\n",
       "line 2: the header promises 4000000000 vertices and 1 faces"},
      {"promise_faces.off", "OFF\n1 4000000000 0\n0 0 0\n",
       "promises 1 vertices and 4000000000 faces, which the 8 bytes"},
      {"promise_overflow.off", "OFF\n9223372036854775807 9223372036854775807 0\n0 0 0\n",
       "the header promises"},
      {"negative.off", "OFF\n-3 1 0\n0 0 0\n", "the header promises -3 vertices"},
      {"cut_vertices.off", "OFF\n3 1 0\n0 0 0.00000000000000000\n1 0 0\n",
       "the file ends where a vertex was expected"},
      {"cut_faces.off", "OFF\n1 2 0\n0.000000 0 0\n3 0 0 0\n",
       "line 5: the file ends where a face was expected; it is cut off"},
      {"cut_within_face.off", off + "3 0 1", "line 6: the line ends where a whole number was expected"},
      {"beyond.off", off + "3 0 1 3\n", "line 6: the face refers to vertex 3, but they count from 0 to 2"},
      {"negative_index.off", off + "3 0 1 -1\n", "the face refers to vertex -1"},
      {"negative_corners.off", off + "-3 0 1 2\n", "a face cannot have -3 corners"},
      {"many_corners.off", off + "1000000000000 0 1 2\n", "the line ends where a whole number was expected"},
      {"nan.off", "OFF\n1 0 0\nnan 0 0\n", "line 3: expected a finite number"},
      {"weight_zero.off", "4OFF\n1 0 0\n1 1 1 0\n", "the fourth coordinate of a vertex must not be 0"},

      {"short.stl", "abc", "expected STL"},
      {"promise.stl", binary_stl(0xFFFFFFFF, std::string(50, 'x')),
       "byte 80: the header promises 4294967295 facets"},
      {"cut.stl", binary_stl(2, std::string(99, 'x')), "but only 99 bytes follow"},
      {"no_facets.stl", binary_stl(0, ""), "the file holds no facets"},
      {"nan.stl", binary_stl(1, not_a_number), "byte 96: a coordinate is not a finite number"},
      {"empty_solid.stl", "solid x\nendsolid x\n", "the file holds no facets"},
      {"cut_facet.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
       "the file ends within a facet; it is cut off"},
      {"stray_vertex.stl", "solid\nvertex 0 0 0\n", "line 2: expected facet or endsolid, found \"vertex\""},
      {"nested_facet.stl", "solid\nfacet\nfacet\n", "line 3: expected vertex or endfacet, found \"facet\""},
      {"nan_ascii.stl", "solid\nfacet\nvertex 0 nan 0\n", "line 3: expected a finite number"},
      {"prose.stl", "solid\nonce upon a time\n", "line 2: expected facet or endsolid, found \"once\""},

      {"magic.ac", "AC4Db\n", "expected AC3D on the first line"},
      {"empty_scene.ac", "AC3Db\nMATERIAL x\n", "the file holds no vertices"},
      {"promise.ac", "AC3Db\nOBJECT world\nnumvert 4000000000000\n0 0 0\n",
       "the file ends where a vertex was expected"},
      {"promise_surfaces.ac", ac_object + "numsurf 4000000000000\n",
       "the file ends where a surface was expected"},
      {"promise_corners.ac", ac_object + "numsurf 1\nrefs 4000000000000\n0\n",
       "the file ends where a corner was expected"},
      {"promise_data.ac", "AC3Db\nOBJECT world\ndata 4000000000000\nkids 0\n",
       "the file ends within an object"},
      {"negative.ac", "AC3Db\nOBJECT world\nnumvert -1\n",
       "line 3: expected a number of 0 or more, found -1"},
      {"beyond.ac", ac_object + "numsurf 1\nSURF 0\nrefs 1\n1 0 0\n",
       "line 8: the surface refers to vertex 1, but the object has only 1"},
      {"flags.ac", ac_object + "numsurf 1\nSURF 0xZZ\n", "expected flags such as 0x10, found \"0xZZ\""},
      {"strip.ac", ac_object + "numsurf 1\nSURF 0x14\n", "surfaces of the kind \"0x14\" are not supported"},
      {"no_object.ac", "AC3Db\nloc 1 2 3\n", "line 2: expected OBJECT first"},
      {"more_vertices.ac", ac_object + "1 1 1\nkids 0\n", "a count before is too small"},
      {"overflow.ac",
       "AC3Db\nOBJECT a\nloc 1e308 0 0\nkids 1\nOBJECT b\nloc 1e308 0 0\nnumvert 1\n1e308 0 0\nkids 0\n",
       "leads to a number that is not finite"},
      {"kids_missing.ac", "AC3Db\nOBJECT a\nOBJECT b\n", "line 3: expected kids before the next OBJECT"},
  };
}

}  // namespace archetype::test
