// Drawing itself: the state of the pipeline and the draw calls.
#pragma once

#include <cstddef>
#include <glm/fwd.hpp>

#include "render/gl/vertices.h"

namespace archetype::gl {

enum class DepthTest { off, in_front, behind };  // in_front: at or before what is there; behind: hidden by it

struct DrawState {
  DepthTest depth_test = DepthTest::in_front;
  bool depth_write = true;
  bool blend = false;  // colours go over what is there by their alpha
};

void apply(const DrawState& state);

// Colour and depth of what is being drawn into; red, green, blue, alpha in [0, 1].
void clear(const glm::vec4& colour);

void draw_triangles(const VertexArray& vertices, std::size_t vertex_count);
void draw_points(const VertexArray& vertices, std::size_t first, std::size_t vertex_count);
// A triangle strip of four corners for each instance.
void draw_quads(const VertexArray& vertices, std::size_t instance_count);

// Whether the processor draws, for want of a graphics card: then less has to do while something moves.
bool in_software();

// Returns when all that was asked for has been drawn.
void finish();

// Throws Error if OpenGL has reported an error since the last call; `what` was being done then.
void check_errors(const char* what);

}  // namespace archetype::gl
