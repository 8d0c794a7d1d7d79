// Hostile glTF and GLB files.
#include "tests/io/gltf_builder.h"
#include "tests/io/hostile_corpus.h"

namespace archetype::test {

namespace {

// A file with one triangle, from its parts; what is empty is left out.
struct Parts {
  std::string buffers = R"([{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
                        base64(std::string(36, '\0')) + "\"}]";
  std::string views = R"([{"buffer":0,"byteLength":36}])";
  std::string accessors = R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}])";
  std::string meshes = R"([{"primitives":[{"attributes":{"POSITION":0}}]}])";
  std::string nodes = R"([{"mesh":0}])";
  std::string more;

  std::string json() const {
    return R"({"asset":{"version":"2.0"},"buffers":)" + buffers + R"(,"bufferViews":)" + views +
           R"(,"accessors":)" + accessors + R"(,"meshes":)" + meshes + R"(,"nodes":)" + nodes + more + "}";
  }
};

std::string with(std::string Parts::*part, const std::string& value) {
  Parts parts;
  parts.*part = value;
  return parts.json();
}

std::string patched(std::string bytes, std::size_t at, std::uint32_t word) {
  std::string raw;
  append_word(raw, word);
  return bytes.replace(at, 4, raw);
}

std::string nested(int depth) {
  return R"({"asset":{"version":"2.0","extras":)" + std::string(static_cast<std::size_t>(depth), '[') +
         std::string(static_cast<std::size_t>(depth), ']') + "}}";
}

// Few bytes that stand for many vertices: one mesh in very many places.
std::string instance_bomb() {
  Parts parts;
  parts.accessors = R"([{"componentType":5126,"count":100000,"type":"VEC3"}])";
  std::string nodes("[{}");
  for (int i = 0; i < 20000; ++i) nodes += R"(,{"mesh":0})";
  parts.nodes = nodes + "]";
  return parts.json();
}

std::string many_entries() {
  std::string nodes("[{}");
  for (int i = 0; i < 100001; ++i) nodes += ",{}";
  return with(&Parts::nodes, nodes + "]");
}

}  // namespace

std::vector<HostileFile> hostile_gltf() {
  const std::string json = Parts{}.json();
  const std::string binary = glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4}]})", "abcd");
  std::string nan_buffer = R"([{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
                           base64(std::string(36, '\xFF')) + "\"}]";
  return {
      {"empty.gltf", "", "the file is empty"},
      {"prose.gltf", "once upon a time", "line 1, column 1: not valid JSON"},
      {"array.gltf", "[1, 2]", "expected a glTF document"},
      {"other.gltf", "{\"a\": 1}", "expected a glTF document"},
      {"cut.gltf", json.substr(0, json.size() / 2), "not valid JSON"},
      {"version_1.gltf", R"({"asset":{}})", "not valid glTF"},
      {"deep.gltf", nested(100000), "nested more than 64 levels deep"},
      {"quotes.gltf", "{\"asset\": \"" + std::string(1000, '\\'), "not valid JSON"},
      {"no_geometry.gltf", R"({"asset":{"version":"2.0"}})", "the file holds no vertices"},
      {"draco.gltf", R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"]})",
       "the geometry is compressed"},
      {"no_source.gltf", with(&Parts::buffers, R"([{"byteLength":36}])"),
       "buffers[0]: has neither a uri nor a binary chunk"},
      {"no_length.gltf", with(&Parts::buffers, R"([{"uri":"data:,"}])"),
       "buffers[0]: expected an object with a byteLength"},
      {"length_type.gltf", with(&Parts::buffers, R"([{"byteLength":-1}])"),
       "expected an object with a byteLength"},
      {"buffer_type.gltf", with(&Parts::buffers, "[7]"), "expected an object with a byteLength"},
      {"uri_type.gltf", with(&Parts::buffers, R"([{"byteLength":1,"uri":7}])"),
       "expected the uri to be a text"},
      {"bad_base64.gltf",
       with(&Parts::buffers, R"([{"byteLength":1,"uri":"data:application/octet-stream;base64,%%%"}])"),
       "cannot be decoded"},
      {"short_data.gltf",
       with(&Parts::buffers,
            R"([{"byteLength":4000000000,"uri":"data:application/octet-stream;base64,AAAA"}])"),
       "buffers[0]: promises 4000000000 bytes, but there are only 3"},
      {"escape.gltf", with(&Parts::buffers, R"([{"byteLength":1,"uri":"../../../../etc/passwd"}])"),
       "leaves the file's folder"},
      {"absolute.gltf", with(&Parts::buffers, R"([{"byteLength":1,"uri":"/etc/passwd"}])"),
       "is no relative path"},
      {"encoded.gltf", with(&Parts::buffers, R"([{"byteLength":1,"uri":"%2e%2e%2fsecret"}])"),
       "leaves the file's folder"},
      {"remote.gltf", with(&Parts::buffers, R"([{"byteLength":1,"uri":"http://localhost/x"}])"),
       "is no relative path"},
      {"missing.gltf", with(&Parts::buffers, R"([{"byteLength":1,"uri":"nowhere.bin"}])"), "cannot be found"},
      {"percent.gltf", with(&Parts::buffers, R"([{"byteLength":1,"uri":"a%4"}])"),
       "without two hexadecimal digits"},
      {"view_beyond.gltf", with(&Parts::views, R"([{"buffer":0,"byteLength":37}])"),
       "its buffer view goes beyond the 36 bytes"},
      {"view_overflow.gltf",
       with(&Parts::views, R"([{"buffer":0,"byteOffset":18446744073709551615,"byteLength":36}])"),
       "its buffer view goes beyond"},
      {"view_buffer.gltf", with(&Parts::views, R"([{"buffer":5,"byteLength":36}])"),
       "refers to buffers[5], which is not there"},
      {"view_negative.gltf", with(&Parts::views, R"([{"buffer":-1,"byteLength":36}])"),
       "refers to buffers[-1]"},
      {"stride.gltf", with(&Parts::views, R"([{"buffer":0,"byteLength":36,"byteStride":4}])"),
       "the stride is too small"},
      {"count.gltf",
       with(&Parts::accessors, R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}])"),
       "accessors[0]: promises 4 elements"},
      {"count_huge.gltf",
       with(&Parts::accessors,
            R"([{"bufferView":0,"componentType":5126,"count":18446744073709551615,"type":"VEC3"}])"),
       "promises more elements than the file has bytes"},
      {"count_of_nothing.gltf",
       with(&Parts::accessors, R"([{"componentType":5126,"count":4000000000,"type":"VEC3"}])"),
       "promises more elements"},
      {"offset.gltf",
       with(
           &Parts::accessors,
           R"([{"bufferView":0,"byteOffset":18446744073709551604,"componentType":5126,"count":1,"type":"VEC3"}])"),
       "promises 1 elements"},
      {"accessor_view.gltf",
       with(&Parts::accessors, R"([{"bufferView":9,"componentType":5126,"count":3,"type":"VEC3"}])"),
       "refers to bufferViews[9]"},
      {"accessor_type.gltf",
       with(&Parts::accessors, R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"}])"),
       "has the wrong type"},
      {"component_type.gltf",
       with(&Parts::accessors, R"([{"bufferView":0,"componentType":5127,"count":3,"type":"VEC3"}])"),
       "has an unknown component type"},
      {"sparse.gltf",
       with(&Parts::accessors,
            R"([{"bufferView":0,"componentType":5126,"count":2,"type":"VEC3","sparse":{"count":1,
          "indices":{"bufferView":0,"componentType":5126},"values":{"bufferView":0,"byteOffset":99}}}])"),
       "promises 1 elements"},
      {"sparse_negative.gltf",
       with(&Parts::accessors,
            R"([{"bufferView":0,"componentType":5126,"count":2,"type":"VEC3","sparse":{"count":-1,
          "indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}}])"),
       "negative number in its sparse part"},
      {"sparse_beyond.gltf",
       with(&Parts::accessors,
            R"([{"bufferView":0,"componentType":5126,"count":0,"type":"VEC3","sparse":{"count":1,
          "indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}}])"),
       "replaces an element that is not there"},
      {"nan.gltf", with(&Parts::buffers, nan_buffer), "accessors[0]: a coordinate is not a finite number"},
      {"no_accessor.gltf", with(&Parts::accessors, "[]"), "accessors[0]: is referred to, but is not there"},
      {"negative_accessor.gltf", with(&Parts::meshes, R"([{"primitives":[{"attributes":{"POSITION":-3}}]}])"),
       "is referred to, but is not there"},
      {"indices.gltf",
       with(&Parts::meshes, R"([{"primitives":[{"attributes":{"POSITION":0},"indices":7}]}])"),
       "not valid glTF"},
      {"no_mesh.gltf", with(&Parts::nodes, R"([{"mesh":3}])"), "meshes[3]: is referred to, but is not there"},
      {"no_node.gltf", with(&Parts::nodes, R"([{"children":[4]}])"),
       "nodes[4]: is referred to, but is not there"},
      {"negative_node.gltf", with(&Parts::nodes, R"([{"children":[-4]}])"), "nodes[-4]: is referred to"},
      {"no_scene.gltf", with(&Parts::more, R"(,"scene":3,"scenes":[{"nodes":[0]}])"),
       "refers to a scene that is not there"},
      {"matrix.gltf", with(&Parts::nodes, R"([{"mesh":0,"matrix":[1,2,3]}])"),
       "nodes[0].matrix: expected 16 numbers, found 3"},
      {"rotation.gltf", with(&Parts::nodes, R"([{"mesh":0,"rotation":[1,2,3]}])"),
       "nodes[0].rotation: expected 4 numbers"},
      {"overflow.gltf",
       with(&Parts::nodes,
            R"([{"translation":[1e308,0,0],"children":[1]},{"mesh":0,"translation":[1e308,0,0]}])"),
       "not finite"},
      {"instances.gltf", instance_bomb(), "has more vertices and corners than its size allows"},
      {"entries.gltf", many_entries(), "nodes: more than 100000 entries"},

      {"short.glb", "glTF", "the file is too short for binary glTF"},
      {"magic.glb", std::string(40, 'x'), "not valid JSON"},
      {"version.glb", patched(binary, 4, 1), "byte 4: expected version 2 of binary glTF, found 1"},
      {"length.glb", patched(binary, 8, 0xFFFFFFFF), "byte 8: the header promises 4294967295 bytes"},
      {"chunk.glb", patched(binary, 12, 0xFFFFFFF0), "byte 12: a chunk goes beyond the end of the file"},
      {"kind.glb", patched(binary, 16, 7), "byte 16: expected the first chunk to be JSON"},
      {"binary_chunk.glb", patched(binary, binary.size() - 12, 12),
       "a chunk goes beyond the end of the file"},
      {"buffer.glb", glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":9}]})", "abcd"),
       "promises 9 bytes, but there are only 4"},
      {"no_binary.glb", glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":9}]})", ""),
       "has neither a uri nor a binary chunk"},
  };
}

}  // namespace archetype::test
