// Seeded random streams. There is no global generator: each shape, part and purpose derives its own stream
// from the run's seed, so that neither order nor thread count can change a result.
#pragma once

#include <cstdint>
#include <vector>

namespace archetype {

// Mixes two numbers into a seed for an independent stream (SplitMix64's finaliser).
constexpr std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t key) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (key + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// SplitMix64 (Steele, Lea, Flood 2014): small, fast, the same on every platform, unlike the distributions of
// <random>, whose results differ between standard libraries.
class RandomStream {
  __extension__ using Wide = unsigned __int128;

 public:
  explicit constexpr RandomStream(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  // Uniform in [0, 1).
  constexpr double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // Uniform in [0, n); n > 0. The bias of the multiplication is below 2^-32 for every n in use.
  constexpr std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>((static_cast<Wide>(next()) * n) >> 64);
  }
  // Normal with mean 0 and standard deviation 1 (Box and Muller; one value of the pair is thrown away).
  double normal();

 private:
  std::uint64_t state_;
};

// `count` of the numbers below n, every set of them as likely, in increasing order; all if there are no more.
std::vector<std::size_t> random_subset(std::size_t n, std::size_t count, std::uint64_t seed);

}  // namespace archetype
