// A template as a fit of it sees it.
#pragma once

#include "core/model/part_template.h"

namespace archetype {

// With features for the parts that have none (with_expected_features()), and no spread smaller than a fit can
// make use of. The energy of a fit is that of this template.
PartTemplate expected_template(const PartTemplate& part_template);

}  // namespace archetype
