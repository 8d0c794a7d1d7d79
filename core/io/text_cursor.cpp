// The scanner under every text format. It is one pass over the bytes because import is bound by it.
#include "core/io/text_cursor.h"

#include <charconv>
#include <cmath>

#include "core/base/error.h"

namespace archetype {
namespace {

bool is_newline(char c) {
  return c == '\n' || c == '\r';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

}  // namespace

TextCursor::TextCursor(std::string_view text, const std::filesystem::path& file, TextSyntax syntax,
                       std::size_t first_line)
    : at_(text.data()), end_(text.data() + text.size()), line_(first_line), syntax_(syntax), file_(&file) {
  if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
}

void TextCursor::skip_newline() {
  if (at_ == end_) return;
  if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
  ++at_;
  ++line_;
}

bool TextCursor::continues_here() const {
  return syntax_.continuation && *at_ == '\\' && at_ + 1 != end_ && is_newline(at_[1]);
}

void TextCursor::skip_blanks() {
  while (at_ != end_) {
    if (is_blank(*at_)) {
      ++at_;
    } else if (continues_here()) {
      ++at_;
      skip_newline();
    } else {
      return;
    }
  }
}

void TextCursor::skip_line() {
  // A comment never continues: many end in a Windows path with a backslash.
  bool comment = false;
  while (at_ != end_ && !is_newline(*at_)) {
    comment |= syntax_.comments && *at_ == '#';
    if (!comment && continues_here()) {
      ++at_;
      skip_newline();
    } else {
      ++at_;
    }
  }
  skip_newline();
}

bool TextCursor::next_line() {
  if (started_) skip_line();
  started_ = true;
  while (at_line_end()) {
    if (at_ == end_) return false;
    skip_line();
  }
  return true;
}

void TextCursor::require_line(const char* expected) {
  if (!next_line()) fail(std::string("the file ends where ") + expected + " was expected; it is cut off");
}

bool TextCursor::at_line_end() {
  skip_blanks();
  return at_ == end_ || is_newline(*at_) || (syntax_.comments && *at_ == '#');
}

std::string_view TextCursor::word() {
  if (at_line_end()) return {};
  const char* begin = at_;
  while (at_ != end_ && !is_blank(*at_) && !is_newline(*at_) && !continues_here()) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextCursor::word_in_file() {
  started_ = true;
  if (at_line_end() && !next_line()) return {};
  return word();
}

std::string_view TextCursor::rest_of_line() {
  skip_blanks();
  const char* begin = at_;
  while (at_ != end_ && !is_newline(*at_)) ++at_;
  const char* last = at_;
  while (last != begin && is_blank(last[-1])) --last;
  return {begin, static_cast<std::size_t>(last - begin)};
}

double TextCursor::number() {
  const std::string_view text = word();
  double value = 0;
  if (!parse_number(text, value)) {
    fail(text.empty() ? "the line ends where a number was expected"
                      : "expected a finite number, found " + quote(text));
  }
  return value;
}

std::int64_t TextCursor::integer() {
  const std::string_view text = word();
  std::int64_t value = 0;
  if (!parse_integer(text, value)) {
    fail(text.empty() ? "the line ends where a whole number was expected"
                      : "expected a whole number, found " + quote(text));
  }
  return value;
}

void TextCursor::skip_bytes_after_line(std::size_t count) {
  skip_line();
  for (; count > 0 && at_ != end_; --count) {
    if (is_newline(*at_)) ++line_;
    ++at_;
  }
  // What follows on the line that was stopped in is read as a line of its own.
  started_ = false;
}

void TextCursor::fail(const std::string& problem) const {
  throw InputError(*file_, "line " + std::to_string(line_), problem);
}

bool parse_number(std::string_view word, double& value) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) {
    if (word.find("e-") == word.npos && word.find("E-") == word.npos) return false;
    value = 0;
    return true;
  }
  return error == std::errc() && stop == end && std::isfinite(value);
}

bool parse_integer(std::string_view word, std::int64_t& value) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end;
}

std::string quote(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text = "\"";
  for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > longest ? "...\"" : "\"");
}

bool equals_ignoring_case(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = word[i] >= 'A' && word[i] <= 'Z' ? static_cast<char>(word[i] - 'A' + 'a') : word[i];
    if (c != lower[i]) return false;
  }
  return true;
}

}  // namespace archetype
