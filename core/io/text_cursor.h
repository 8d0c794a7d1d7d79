// Walks over the words and numbers of a text file, line by line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace archetype {

// What differs between the text formats.
struct TextSyntax {
  bool comments = true;       // from '#' to the end of the line
  bool continuation = false;  // a '\' at the end of a line joins the next one to it
};

// One pass over the bytes, no allocation. Lines end in LF, CR LF or CR; blanks are spaces and tabs; numbers
// have a dot whatever the locale. A byte order mark is skipped.
class TextCursor {
 public:
  // `text` and `file` are referred to, not copied. `first_line` is the number of text's first line.
  TextCursor(std::string_view text, const std::filesystem::path& file, TextSyntax syntax = {},
             std::size_t first_line = 1);

  // Goes to the next line that has a word; false at the end of the file. The first call goes to the first
  // line.
  bool next_line();
  // The same, but refuses the file when it ends. `expected`: what should have come, for the message.
  void require_line(const char* expected);

  // The next word of this line, empty at its end.
  std::string_view word();
  // The next word of this or a later line, empty at the end of the file.
  std::string_view word_in_file();
  bool at_line_end();
  // What is left of this line, without the blanks around it; comments are not recognised.
  std::string_view rest_of_line();

  // The next word of this line as a finite number or an integer; refuses the file if there is none.
  double number();
  std::int64_t integer();

  // Skips the end of this line and then exactly `count` bytes (or what there is).
  void skip_bytes_after_line(std::size_t count);

  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  // Throws InputError for the current line.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  bool continues_here() const;  // needs a byte to be left
  void skip_blanks();
  void skip_newline();
  void skip_line();

  const char* at_;
  const char* end_;
  std::size_t line_;
  TextSyntax syntax_;
  bool started_ = false;
  const std::filesystem::path* file_;
};

// A number or integer that is all of `word`, with an optional sign; false if it is none or not finite.
// Numbers too small for a double are zero.
bool parse_number(std::string_view word, double& value);
bool parse_integer(std::string_view word, std::int64_t& value);

// A word of a file for an error message: quoted, shortened, nothing unprintable in it.
std::string quote(std::string_view word);

// Without regard to the case of ASCII letters; `lower` is in lower case.
bool equals_ignoring_case(std::string_view word, std::string_view lower);

}  // namespace archetype
