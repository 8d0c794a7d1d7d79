// Drawing the parameters of generated shapes.
#include "core/generate/distribution.h"

#include <cmath>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/base/hash.h"

namespace archetype {

namespace {

constexpr double normal_cut = 2.5;  // standard deviations
// Standard deviation of a standard normal variable that is cut there: sqrt(1 - 2 c phi(c) / (2 Phi(c) - 1)).
constexpr double cut_normal_stddev = 0.95460;

}  // namespace

double Distribution::draw(RandomStream& random) const {
  switch (kind) {
    case Kind::uniform:
      return random.uniform(a, b);
    case Kind::normal: {
      double z = random.normal();
      while (std::abs(z) > normal_cut) z = random.normal();
      return a + b * z;
    }
    case Kind::chance:
      return random.uniform() < a ? 1 : 0;
    case Kind::whole:
      return a + static_cast<double>(random.below(static_cast<std::uint64_t>(b - a) + 1));
  }
  throw PreconditionError("a distribution of an unknown kind was drawn from");
}

double Distribution::mean() const {
  return kind == Kind::uniform || kind == Kind::whole ? 0.5 * (a + b) : a;
}

double Distribution::stddev() const {
  switch (kind) {
    case Kind::uniform:
      return (b - a) / std::sqrt(12.0);
    case Kind::normal:
      return b * cut_normal_stddev;
    case Kind::chance:
      return std::sqrt(a * (1 - a));
    case Kind::whole:
      return std::sqrt(((b - a + 1) * (b - a + 1) - 1) / 12.0);
  }
  return 0;
}

const double* ParameterValues::find(std::string_view name) const {
  for (const auto& entry : values) {
    if (entry.first == name) return &entry.second;
  }
  return nullptr;
}

double ParameterValues::operator[](std::string_view name) const {
  const double* value = find(name);
  if (value == nullptr) throw PreconditionError("this style has no parameter " + std::string(name));
  return *value;
}

ParameterValues draw_parameters(const std::vector<Parameter>& parameters, std::uint64_t seed) {
  ParameterValues drawn;
  drawn.values.reserve(parameters.size());
  for (const Parameter& parameter : parameters) {
    const ContentHash key = hash_content(std::as_bytes(std::span(parameter.name)));
    RandomStream random(derive_seed(seed, key.words[0]));
    drawn.values.emplace_back(parameter.name, parameter.distribution.draw(random));
  }
  return drawn;
}

}  // namespace archetype
