// Parsing the catalogues. extract_seats.cpp unpacks what they list.
#include "core/session/furniture_catalog.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

#include "core/base/error.h"

namespace archetype {
namespace {

void append_utf8(std::string& text, unsigned code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xc0 | (code >> 6));
    text += static_cast<char>(0x80 | (code & 0x3f));
  } else {
    text += static_cast<char>(0xe0 | (code >> 12));
    text += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
    text += static_cast<char>(0x80 | (code & 0x3f));
  }
}

// Latin-1 with \uXXXX to UTF-8.
std::string decode(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      append_utf8(decoded, static_cast<unsigned char>(text[i]));
      continue;
    }
    ++i;
    unsigned code = 0;
    if (text[i] == 'u' && i + 4 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 5, code, 16).ptr == text.data() + i + 5) {
      append_utf8(decoded, code);
      i += 4;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

std::array<double, 9> parse_rotation(std::string_view text, const std::string& id,
                                     const std::filesystem::path& name) {
  std::array<double, 9> rotation{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (double& value : rotation) {
    while (at != end && std::isspace(static_cast<unsigned char>(*at))) ++at;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value))
      throw InputError(name, id, "modelRotation has to be nine numbers");
    at = next;
  }
  return rotation;
}

bool holds(const std::string& text, std::string_view word) {
  return text.find(word) != std::string::npos;
}

}  // namespace

std::vector<FurniturePiece> parse_furniture_catalog(std::string_view text,
                                                    const std::filesystem::path& name) {
  std::map<std::string, std::string> catalogue;
  std::map<int, std::map<std::string, std::string>> pieces;
  while (!text.empty()) {
    const std::size_t line_end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, line_end));
    text.remove_prefix(std::min(line_end + 1, text.size()));
    const std::size_t equals = line.find('=');
    if (line.empty() || line[0] == '#' || equals == std::string_view::npos) continue;
    const std::string_view key = line.substr(0, equals);
    const std::string value = decode(trimmed(line.substr(equals + 1)));
    const std::size_t hash = key.find('#');
    int number = 0;
    if (hash == std::string_view::npos)
      catalogue[std::string(key)] = value;
    else if (std::from_chars(key.data() + hash + 1, key.data() + key.size(), number).ec == std::errc())
      pieces[number][std::string(key.substr(0, hash))] = value;
  }

  std::vector<FurniturePiece> listed;
  for (auto& [number, values] : pieces) {
    FurniturePiece piece;
    piece.id = values["id"];
    piece.title = values["name"];
    piece.tags = values["tags"];
    piece.creator = values["creator"];
    piece.licence = catalogue["license"];
    piece.source = catalogue["name"];
    piece.model = values["model"];
    if (!piece.model.empty() && piece.model[0] == '/') piece.model.erase(0, 1);
    if (piece.model.empty() || piece.title.empty()) continue;
    if (!values["modelRotation"].empty())
      piece.rotation = parse_rotation(values["modelRotation"], piece.id, name);
    listed.push_back(std::move(piece));
  }
  return listed;
}

// Two catalogues tag their seats, the others do not, so that the names have to help; three names mislead.
bool is_seat(const FurniturePiece& piece) {
  std::string title = piece.title;
  for (char& c : title) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* other : {"workbench", "abdominal bench", "seat leon"})
    if (holds(title, other)) return false;
  if (holds(piece.tags, "Seat")) return true;
  constexpr std::array words{"chair", "stool", "sofa", "bench", "seat", "couch"};
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return holds(title, word); });
}

}  // namespace archetype
