// The one family of exceptions. What can be expected (cancelled, not converged, outlier) is a value instead.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace archetype {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A caller broke what a function asks for: a fault of the program, not of its input.
class PreconditionError : public Error {
 public:
  using Error::Error;
};

// A computation had no usable result (a singular system, no finite number).
class NumericError : public Error {
 public:
  using Error::Error;
};

// A file or a value from outside cannot be used. what() is one line for a person: the file, the place in it
// ("line 12", "byte 80"; may be empty), what is wrong and what was expected there or can be done.
class InputError : public Error {
 public:
  InputError(const std::filesystem::path& file, const std::string& place, const std::string& problem)
      : Error(file.string() + (place.empty() ? "" : ", " + place) + ": " + problem) {}
};

// Reading or writing through the operating system failed (no such file, permission, disk full).
class FileError : public Error {
 public:
  FileError(const std::filesystem::path& file, const std::string& problem)
      : Error(file.string() + ": " + problem) {}
};

}  // namespace archetype
