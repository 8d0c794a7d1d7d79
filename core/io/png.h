// Pictures as PNG.
#pragma once

#include <string>

#include "core/base/picture.h"

namespace archetype {

// The same picture gives the same bytes. Throws PreconditionError for one without pixels.
std::string encode_png(const Picture& picture);

}  // namespace archetype
