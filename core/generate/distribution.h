// The distributions that parameters of generated shapes are drawn from. They are data, so that what the
// ground truth states is what was drawn from.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "core/base/random.h"

namespace archetype {

struct Distribution {
  enum class Kind {
    uniform,  // a: lowest, b: highest
    normal,   // a: mean, b: standard deviation; drawn again beyond 2.5 of them
    chance,   // 1 with probability a, else 0
    whole     // whole numbers from a to b, each as likely
  };
  Kind kind = Kind::uniform;
  double a = 0;
  double b = 0;

  double draw(RandomStream& random) const;
  double mean() const;
  double stddev() const;  // of what draw() gives: the cut of the normal distribution is counted in
};

constexpr Distribution uniform(double low, double high) {
  return {Distribution::Kind::uniform, low, high};
}
constexpr Distribution normal(double mean, double stddev) {
  return {Distribution::Kind::normal, mean, stddev};
}
constexpr Distribution chance(double probability) {
  return {Distribution::Kind::chance, probability, 0};
}
constexpr Distribution whole(int low, int high) {
  return {Distribution::Kind::whole, static_cast<double>(low), static_cast<double>(high)};
}

struct Parameter {
  std::string_view name;
  Distribution distribution;
  std::string_view meaning;  // with the unit
};

// The drawn parameters of one shape, in the order of its style's list.
struct ParameterValues {
  std::vector<std::pair<std::string_view, double>> values;

  const double* find(std::string_view name) const;  // nullptr where the style has no such parameter
  double operator[](std::string_view name) const;   // throws PreconditionError there
  bool is(std::string_view name) const { return find(name) != nullptr && *find(name) != 0; }
};

// Each parameter has its own stream, derived from its name: a new parameter changes no other.
ParameterValues draw_parameters(const std::vector<Parameter>& parameters, std::uint64_t seed);

}  // namespace archetype
