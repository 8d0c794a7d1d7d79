// Hostile PLY files.
#include "tests/io/hostile_corpus.h"

namespace archetype::test {

namespace {

const std::string ascii = "ply\nformat ascii 1.0\n";
const std::string little = "ply\nformat binary_little_endian 1.0\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string one_vertex = "element vertex 1\n" + xyz;
const std::string faces_of_ints = "property list uchar int vertex_indices\n";
const std::string end = "end_header\n";

}  // namespace

std::vector<HostileFile> hostile_ply() {
  const std::string zeros(12, '\0');
  std::string many = ascii + "element vertex 1\n";
  for (int i = 0; i < 1001; ++i) many += "property float x" + std::to_string(i) + "\n";
  std::string elements = ascii;
  for (int i = 0; i < 101; ++i) elements += "element e" + std::to_string(i) + " 0\n";
  return {
      {"empty.ply", "", "the file is empty"},
      {"magic.ply", "plyx\nformat ascii 1.0\n", "line 1: expected \"ply\" on the first line"},
      {"cut_header.ply", ascii + one_vertex, "the file ends where end_header was expected"},
      {"no_format.ply", "ply\n" + one_vertex + end + "0 0 0\n", "expected a line \"format ...\""},
      {"version.ply", "ply\nformat ascii 2.0\n", "line 2: expected version 1.0 of the format, found \"2.0\""},
      {"encoding.ply", "ply\nformat ebcdic 1.0\n",
       "expected ascii, binary_little_endian or binary_big_endian"},
      {"keyword.ply", ascii + "elephant vertex 1\n",
       "line 3: expected element, property, comment or end_header"},
      {"type.ply", ascii + "element vertex 1\nproperty quad x\n",
       "expected a type such as float or uchar, found \"quad\""},
      {"list_type.ply", ascii + "element face 1\nproperty list uchar\n",
       "expected a type such as float or uchar, found \"\""},
      {"no_name.ply", ascii + "element vertex 1\nproperty float\n", "the property has no name"},
      {"early_property.ply", ascii + xyz, "line 3: a property stands before the first element"},
      {"twice.ply", ascii + one_vertex + "property float x\n" + end,
       "the property \"x\" stands twice in the element"},
      {"two_vertex_elements.ply", ascii + one_vertex + one_vertex + end + "0 0 0\n0 0 0\n",
       "the element \"vertex\" stands there twice"},
      {"no_vertex.ply", ascii + "element face 0\n" + faces_of_ints + end, "expected \"element vertex\""},
      {"no_z.ply", ascii + "element vertex 1\nproperty float x\nproperty float y\n" + end + "0 0\n",
       "the vertices lack a property x, y or z"},
      {"no_vertices.ply", ascii + "element vertex 0\n" + xyz + end, "the file holds no vertices"},
      {"no_corners.ply", ascii + one_vertex + "element face 1\nproperty int a\n" + end + "0 0 0\n1\n",
       "the faces lack a list property vertex_indices"},
      {"negative_count.ply", ascii + "element vertex -1\n", "an element cannot have -1 records"},
      {"wide_count.ply", ascii + "element vertex 99999999999999999999\n", "expected a whole number"},
      {"promise.ply", little + "element vertex 4294967295\n" + xyz + end + zeros,
       "promises 4294967295 records of \"vertex\""},
      {"promise_ascii.ply", ascii + "element vertex 9223372036854775807\n" + xyz + end + "0 0 0\n",
       "promises 9223372036854775807"},
      {"promise_faces.ply", little + one_vertex + "element face 100\n" + faces_of_ints + end + zeros,
       "promises 100 records of \"face\""},
      {"promise_other.ply",
       little + one_vertex + "element junk 9000000000000000000\nproperty double a\nproperty double b\n" +
           end + zeros,
       "promises 9000000000000000000 records of \"junk\""},
      {"many_properties.ply", many, "more than 1000 properties"},
      {"many_elements.ply", elements, "more than 100 elements"},
      {"cut_list.ply",
       little + one_vertex + "element face 1\n" + faces_of_ints + end + zeros + "\xFF" + std::string(4, '\0'),
       "the file ends within a record; it is cut off"},
      {"huge_list.ply",
       little + one_vertex + "element face 1\nproperty list uint int vertex_indices\n" + end + zeros +
           "\xFF\xFF\xFF\xFF",
       "the file ends within a record; it is cut off"},
      {"negative_list.ply",
       little + one_vertex + "element face 1\nproperty list char int vertex_indices\n" + end + zeros + "\xFF",
       "a list cannot have -1 entries"},
      {"fraction_list.ply",
       little + one_vertex + "element face 1\nproperty list float int vertex_indices\n" + end + zeros +
           std::string("\0\0\x20\x40", 4),
       "a list cannot have 2.5 entries"},
      {"skipped_list.ply",
       little + one_vertex + "element junk 1\nproperty list uint double a\n" + end + zeros +
           "\xFF\xFF\xFF\x7F",
       "the file ends within a record"},
      {"beyond.ply",
       little + one_vertex + "element face 1\n" + faces_of_ints + end + zeros + std::string("\1\1\0\0\0", 5),
       "a face refers to vertex 1, but they count from 0 to 0"},
      {"negative_index.ply",
       little + one_vertex + "element face 1\n" + faces_of_ints + end + zeros + "\1\xFF\xFF\xFF\xFF",
       "a face refers to vertex -1"},
      {"nan_index.ply",
       little + one_vertex + "element face 1\nproperty list uchar float vertex_indices\n" + end + zeros +
           "\1\xFF\xFF\xFF\x7F",
       "a face refers to vertex nan"},
      {"nan.ply", little + one_vertex + end + std::string("\0\0\xc0\x7f", 4) + std::string(8, '\0'),
       "a coordinate is not a finite number"},
      {"inf_ascii.ply", ascii + one_vertex + end + "0 inf 0\n", "line 8: expected a finite number"},
      {"short_record.ply", ascii + one_vertex + end + "0 0\n0\n",
       "line 8: the line ends where a number was expected"},
      {"missing_record.ply", ascii + "element vertex 2\n" + xyz + end + "0.0000000 0 0\n",
       "the file ends where another record was expected"},
      {"fraction_index.ply", ascii + one_vertex + "element face 1\n" + faces_of_ints + end + "0 0 0\n1 0.5\n",
       "expected a whole number, found \"0.5\""},
      {"beyond_strip.ply",
       ascii + one_vertex + "element tristrips 1\n" + faces_of_ints + end + "0 0 0\n3 0 0 7\n",
       "a face refers to vertex 7"},
  };
}

}  // namespace archetype::test
