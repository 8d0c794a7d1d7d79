// The one place where Eigen's types (core) become GLM's (render, ui) and back.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <Eigen/Geometry>

namespace archetype {

inline glm::dvec3 to_glm(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
inline glm::dquat to_glm(const Eigen::Quaterniond& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}
inline Eigen::Vector3d to_eigen(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}
inline Eigen::Quaterniond to_eigen(const glm::dquat& q) {
  return {q.w, q.x, q.y, q.z};
}

}  // namespace archetype
