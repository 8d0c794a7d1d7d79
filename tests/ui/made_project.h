// A project of shapes that are not there, with fits: for views of many shapes.
#pragma once

#include "tests/ui/test_window.h"

namespace archetype::test {

// Shapes "shape_00000" …, each with a fit by one of two templates with seat and back; in view as if opened.
void open_made(TestWindow& window, std::size_t count);

}  // namespace archetype::test
