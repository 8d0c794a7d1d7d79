// Aligned text tables on standard output.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace archetype {

// The first column is aligned left, the others right. Every row has as many cells as the first. Control
// characters in cells are shown as "?".
void print_table(std::ostream& out, const std::vector<std::vector<std::string>>& rows);

std::string fixed(double value, int decimals);
std::string percent(double fraction);  // 0.9876 as "98.8"

}  // namespace archetype
