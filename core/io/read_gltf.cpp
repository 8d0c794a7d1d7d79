// glTF 2.0 and GLB: the triangles of every mesh where a node of the scene places it, in the order of nodes
// and primitives. The format repeats a vertex for each normal and texture coordinate; those at exactly the
// same place become one within a mesh, so that faces have neighbours. Without triangles, the POINTS
// primitives are a point set. Skins, morph targets and animations are not applied.
#include <Eigen/Geometry>
#include <map>

#include "core/base/error.h"
#include "core/io/gltf_arrays.h"
#include "core/io/vertex_welder.h"

namespace archetype {
namespace {

Eigen::Affine3d local_transform(const tinygltf::Node& node, int index, const GltfFile& gltf) {
  const auto check = [&](const std::vector<double>& numbers, std::size_t size, const char* key) {
    if (numbers.empty() || numbers.size() == size) return !numbers.empty();
    throw InputError(
        gltf.path, "nodes[" + std::to_string(index) + "]." + key,
        "expected " + std::to_string(size) + " numbers, found " + std::to_string(numbers.size()));
  };
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (check(node.matrix, 16, "matrix")) {
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    transform.makeAffine();
    return transform;
  }
  if (check(node.translation, 3, "translation"))
    transform.translate(Eigen::Map<const Vec3>(node.translation.data()));
  if (check(node.rotation, 4, "rotation")) {
    const Eigen::Map<const Eigen::Quaterniond> rotation(node.rotation.data());  // x y z w, as Eigen has it
    transform.rotate(rotation.normalized());
  }
  if (check(node.scale, 3, "scale")) transform.scale(Vec3(Eigen::Map<const Vec3>(node.scale.data())));
  return transform;
}

class GltfReader {
 public:
  GltfReader(const GltfFile& gltf, ShapeFile& shape) : gltf_(gltf), arrays_(gltf), shape_(shape) {}

  void read() {
    if (gltf_.model.nodes.empty()) {
      for (std::size_t i = 0; i < gltf_.model.meshes.size(); ++i) {
        add_mesh(static_cast<int>(i), Eigen::Affine3d::Identity());
      }
    } else {
      walk_nodes();
    }
    if (shape_.mesh.face_count() == 0) {
      shape_.mesh.vertices = std::move(points_);
    } else if (!points_.empty()) {
      shape_.warnings.push_back(std::to_string(points_.size()) + " points beside the triangles are not read");
    }
    if (lines_) shape_.warnings.emplace_back("lines are not read");
    if (partial_) shape_.warnings.emplace_back("corners beyond the last whole triangle are not read");
  }

 private:
  struct Visit {
    int node;
    Eigen::Affine3d parent;
  };

  // The nodes that no other one contains, or those that the scene shown first names.
  std::vector<int> root_nodes() const {
    const tinygltf::Model& model = gltf_.model;
    if (!model.scenes.empty()) {
      const std::size_t scene = model.defaultScene < 0 ? 0 : static_cast<std::size_t>(model.defaultScene);
      if (scene >= model.scenes.size())
        throw InputError(gltf_.path, "scene", "refers to a scene that is not there");
      return model.scenes[scene].nodes;
    }
    std::vector<bool> contained(model.nodes.size());
    for (const tinygltf::Node& node : model.nodes) {
      for (const int child : node.children) {
        if (child >= 0 && static_cast<std::size_t>(child) < contained.size()) {
          contained[static_cast<std::size_t>(child)] = true;
        }
      }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < contained.size(); ++i) {
      if (!contained[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
  }

  // Depth first, children in order. The format wants a tree: a node that is met twice would be a cycle, or
  // grow the scene beyond all bounds.
  void walk_nodes() {
    std::vector<bool> visited(gltf_.model.nodes.size());
    std::vector<Visit> open;
    const auto push = [&](const std::vector<int>& nodes, const Eigen::Affine3d& parent) {
      for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) open.push_back({*node, parent});
    };
    push(root_nodes(), Eigen::Affine3d::Identity());
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      const std::string place = "nodes[" + std::to_string(visit.node) + "]";
      if (visit.node < 0 || static_cast<std::size_t>(visit.node) >= visited.size()) {
        throw InputError(gltf_.path, place, "is referred to, but is not there");
      }
      const auto index = static_cast<std::size_t>(visit.node);
      if (visited[index]) throw InputError(gltf_.path, place, "is contained twice, or contains itself");
      visited[index] = true;
      const tinygltf::Node& node = gltf_.model.nodes[index];
      const Eigen::Affine3d transform = visit.parent * local_transform(node, visit.node, gltf_);
      if (node.mesh >= 0) add_mesh(node.mesh, transform);
      push(node.children, transform);
    }
  }

  std::vector<Vec3> transformed_positions(int accessor, const Eigen::Affine3d& transform) {
    std::vector<Vec3> positions = arrays_.positions(accessor);
    for (Vec3& position : positions) {
      position = transform * position;
      if (!position.allFinite()) {
        throw InputError(gltf_.path, "nodes", "a node's transform leads to a number that is not finite");
      }
    }
    return positions;
  }

  void add_mesh(int index, const Eigen::Affine3d& transform) {
    if (static_cast<std::size_t>(index) >= gltf_.model.meshes.size()) {
      throw InputError(gltf_.path, "meshes[" + std::to_string(index) + "]",
                       "is referred to, but is not there");
    }
    VertexWelder welder(shape_.mesh.vertices, 0);
    std::map<int, std::vector<std::uint32_t>> welded;  // of each accessor: primitives often share one
    for (const tinygltf::Primitive& primitive :
         gltf_.model.meshes[static_cast<std::size_t>(index)].primitives) {
      arrays_.spend(1);  // also for one without vertices, of which there may be many in many places
      const auto attribute = primitive.attributes.find("POSITION");
      if (attribute == primitive.attributes.end()) continue;  // allowed; there is nothing to see
      if (primitive.mode == TINYGLTF_MODE_POINTS) {
        const std::vector<Vec3> positions = transformed_positions(attribute->second, transform);
        points_.insert(points_.end(), positions.begin(), positions.end());
      } else if (primitive.mode == TINYGLTF_MODE_TRIANGLES ||
                 primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                 primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
        const auto [entry, is_new] = welded.try_emplace(attribute->second);
        if (is_new) {
          for (const Vec3& position : transformed_positions(attribute->second, transform)) {
            entry->second.push_back(welder.add(position));
          }
        }
        add_triangles(primitive, corners_of(primitive, entry->second, index));
      } else {
        lines_ = true;
      }
    }
  }

  // The vertices of a primitive in the order in which triangles are made of them.
  std::vector<std::uint32_t> corners_of(const tinygltf::Primitive& primitive,
                                        const std::vector<std::uint32_t>& vertices, int mesh) {
    if (primitive.indices < 0) {
      arrays_.spend(vertices.size());
      return vertices;
    }
    std::vector<std::uint32_t> corners = arrays_.indices(primitive.indices);
    for (std::uint32_t& corner : corners) {
      if (corner >= vertices.size()) {
        throw InputError(gltf_.path, "meshes[" + std::to_string(mesh) + "]",
                         "a triangle refers to vertex " + std::to_string(corner) + ", but there are only " +
                             std::to_string(vertices.size()));
      }
      corner = vertices[corner];
    }
    return corners;
  }

  void add_triangles(const tinygltf::Primitive& primitive, const std::vector<std::uint32_t>& corners) {
    PolygonMesh& mesh = shape_.mesh;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      mesh.add_face(std::array{corners[a], corners[b], corners[c]});
    };
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
      for (std::size_t i = 0; i + 2 < corners.size(); i += 3) add(i, i + 1, i + 2);
      partial_ |= corners.size() % 3 != 0;
      return;
    }
    const bool strip = primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP;
    arrays_.spend(2 * corners.size());  // up to three corners come of each
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
      if (strip) {
        add(i, i + 1 + i % 2, i + 2 - i % 2);
      } else {
        add(i + 1, i + 2, 0);
      }
    }
    partial_ |= corners.size() < 3;
  }

  const GltfFile& gltf_;
  GltfArrays arrays_;
  ShapeFile& shape_;
  std::vector<Vec3> points_;
  bool lines_ = false;
  bool partial_ = false;
};

}  // namespace

void read_gltf(const ShapeBytes& file, ShapeFile& shape) {
  const GltfFile gltf = open_gltf(file);
  GltfReader(gltf, shape).read();
  if (!gltf.external) return;
  std::vector<std::uint64_t> hashes(shape.hash.words.begin(), shape.hash.words.end());
  for (const std::string& buffer : gltf.owned) {
    const ContentHash hash = hash_content(std::as_bytes(std::span(buffer)));
    hashes.insert(hashes.end(), hash.words.begin(), hash.words.end());
  }
  shape.hash = hash_content(std::as_bytes(std::span(hashes)));
}

}  // namespace archetype
