#include "tests/io/sample_files.h"

#include "tests/io/gltf_builder.h"
#include "tests/io/ply_encoder.h"

namespace archetype::test {

namespace {

std::string sample_ply(PlyFlavour flavour) {
  PlyEncoder ply(flavour);
  ply.header(
      "comment x\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\nproperty uchar "
      "red\n"
      "element face 2\nproperty list uchar int vertex_indices\nproperty list uint short other\n"
      "element tristrips 1\nproperty list int int vertex_indices\n");
  for (int i = 0; i < 4; ++i) {
    ply.value<float>(0.5F * static_cast<float>(i)).value<double>(i * i * 0.25).value<float>(-1.5F);
    ply.value<std::uint8_t>(200).end_record();
  }
  for (const std::int32_t last : {2, 3}) {
    ply.value<std::uint8_t>(3).value<std::int32_t>(0).value<std::int32_t>(1).value<std::int32_t>(last);
    ply.value<std::uint32_t>(2).value<std::int16_t>(5).value<std::int16_t>(-5).end_record();
  }
  ply.value<std::int32_t>(5);
  for (const std::int32_t corner : {0, 1, -1, 2, 3}) ply.value<std::int32_t>(corner);
  ply.end_record();
  return ply.bytes();
}

std::string sample_stl() {
  std::string bytes(80, ' ');
  append_word(bytes, 2);
  for (int i = 0; i < 2; ++i) {
    for (const float x : {0.F, 0.F, 1.F, 0.F, 0.5F, 0.F, 1.F, 0.25F, 0.F, 0.F, 1.F, 0.125F}) {
      append_word(bytes, std::bit_cast<std::uint32_t>(x));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

GltfBuilder sample_gltf() {
  GltfBuilder builder;
  builder.positions({0, 0, 0.5, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  builder.indices({0, 1, 2, 0, 2, 3});
  const int places = builder.view<std::uint8_t>({1, 2});
  const int values = builder.view<float>({5, 5, 5, 6, 6, 6});
  builder.accessor(0, 5126, "VEC3", 4,
                   R"("sparse":{"count":2,"indices":{"bufferView":)" + std::to_string(places) +
                       R"(,"componentType":5121},"values":{"bufferView":)" + std::to_string(values) + "}}");
  return builder;
}

const std::string sample_scene = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1},
    {"attributes":{"POSITION":2},"mode":5},{"attributes":{"POSITION":0},"mode":6}]}],
    "nodes":[{"children":[1,2]},{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0.5,0,0,1]},
    {"mesh":0,"rotation":[0,0,0.6,0.8],"scale":[1,2,3],"translation":[0,0.25,0]}],"scenes":[{"nodes":[0]}],"scene":0)";

std::string sample_binvox() {
  std::string bytes = "#binvox 1\ndim 6 6 6\ntranslate 0.5 -1.25 0\nscale 2.5\ndata\n";
  for (int i = 0; i < 27; ++i) bytes += std::string{static_cast<char>(i % 2), '\10'};
  return bytes;
}

}  // namespace

std::vector<SampleFile> sample_shapes() {
  const GltfBuilder gltf = sample_gltf();
  return {
      {"a.obj",
       "# c\nmtllib x\nv 0 0 0.5\nv 1.25 0 0\nv 1 1e-1 0\nv -0.5 +1 \\\n0\nvt 0 0\nf 1/1 2/1 3/1\nf -1 -2 "
       "\\\n-3 1\nl 1 2\n"},
      {"a.off", "OFF # c\n4 3 0\n0 0 0.5\n1.25 0 0\n1 1e-1 0\n-0.5 1 0\n3 0 1 2\n4 0 1 2 3 255 0 0\n0\n"},
      {"b.off",
       "CN4OFF4 1 0\n0 0 0.5 1 0 0 1\n1.25 0 0 2 0 0 1\n1 1e-1 0 1 0 0 1\n-0.5 1 0 1 0 0 1\n3 0 1 2\n"},
      {"a.ply", sample_ply(PlyFlavour::ascii)},
      {"b.ply", sample_ply(PlyFlavour::little)},
      {"c.ply", sample_ply(PlyFlavour::big)},
      {"a.stl",
       "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0.5\nvertex 1.25 0 0\nvertex 1 1e-1 "
       "0\nendloop\nendfacet\n"
       "facet normal 0 0 1\nouter loop\nvertex 0 0 0.5\nvertex 1 1e-1 0\nvertex 0 1 "
       "0\nendloop\nendfacet\nendsolid x\n"},
      {"b.stl", sample_stl()},
      {"a.gltf", gltf.embedded(sample_scene)},
      {"a.glb", gltf.binary(sample_scene)},
      {"a.xyz", "0 0 0.5 0 0 1\n1.25 0 0 0 0.6 0.8\n"},
      {"a.pts", "2\n0 0 0.5 -7 255 0 0\n1.25 0 0 8 0 0 0\n"},
      {"a.binvox", sample_binvox()},
      {"a.ac",
       "AC3Db\nMATERIAL \"m\" rgb 1 1 1\nOBJECT world\nkids 1\nOBJECT poly\nname \"x\"\ndata 4\nabcd\nloc "
       "0.5 0 0.25\n"
       "rot 0.8 0.6 0 -0.6 0.8 0 0 0 1\nnumvert 3\n0 0 0.5\n1.25 0 0\n1 1e-1 0\nnumsurf 2\nSURF 0x30\nmat "
       "0\nrefs 3\n"
       "0 0 0\n1 0.5 0\n2 0 0\nSURF 0x2\nmat 0\nrefs 2\n0 0 0\n1 0 0\nkids 0\n"},
  };
}

std::vector<SampleFile> sample_side_files() {
  return {
      {"a.json", R"({"format":"archetype-template","version":1,"name":"chair","up":"y","parts":[
          {"name":"seat","label":0,"must_exist":true,"orientation":[1,0,0,0],
           "position":{"mean":[0,0.1,0],"stddev":[0.2,0.2,0.25]},"scale":{"mean":[0.6,0.08,0.6],"stddev":[0.2,0.1,0.2]},
           "features":{"mean":[0,0,0,0,0,0.5],"stddev":[1,1,1,1,1,1]},"existence":1.0,"note":[1,{"x":null}]}],"more":"ü"})"},
      {"a.seg", "0\n1\n-1\n"},
      {"a_labels.txt", "leg\n1 2\nseat rest\n3\n"},
      {"a.vts", "0.5 1 2\n-1\n1e-3 0 0\n"},
  };
}

}  // namespace archetype::test
