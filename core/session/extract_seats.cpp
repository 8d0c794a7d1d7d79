// Unpacks the seats of the furniture archives into a folder of OBJ files.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/io/file.h"
#include "core/io/json_input.h"
#include "core/session/furniture_catalog.h"
#include "core/session/zip_archive.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uint64_t max_catalogue_bytes = 4 << 20;
constexpr std::uint64_t max_total_bytes = std::uint64_t{1} << 30;  // of all models, unpacked
constexpr std::array<double, 9> upright{1, 0, 0, 0, 1, 0, 0, 0, 1};

// A file name from a title: letters, digits, blanks and a few signs; never a path.
std::string file_name(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) || byte >= 0x80 || c == ' ' || c == '-' || c == '(' || c == ')';
    name += plain ? c : '_';
  }
  return name.substr(0, 100);
}

// "chair3" of "scopia/chair3/chair3.obj".
std::string stem(const FurniturePiece& piece) {
  return fs::path(piece.model).stem().string();
}

// Titles that several pieces share get the name of the model added, so that each file has its own name
// whatever the order.
std::vector<std::string> unique_names(const std::vector<FurniturePiece>& pieces) {
  std::map<std::string, int> count;
  for (const FurniturePiece& piece : pieces) ++count[file_name(piece.title)];
  std::vector<std::string> names;
  for (const FurniturePiece& piece : pieces) {
    std::string name = file_name(piece.title);
    if (count[name] > 1) name += " (" + file_name(stem(piece)) + ")";
    const std::string base = name;
    for (int number = 2; std::find(names.begin(), names.end(), name) != names.end(); ++number)
      name = base + " " + std::to_string(number);
    names.push_back(std::move(name));
  }
  return names;
}

std::array<double, 3> parse_vertex(std::string_view numbers) {
  std::array<double, 3> vertex{};
  const char* at = numbers.data();
  const char* const end = at + numbers.size();
  for (double& value : vertex) {
    while (at != end && (*at == ' ' || *at == '\t')) ++at;
    at = std::from_chars(at, end, value).ptr;
  }
  return vertex;
}

// The same OBJ with its vertices turned. Normals are turned as well, being vectors.
std::string turned(std::string_view obj, const std::array<double, 9>& rotation) {
  std::string out;
  while (!obj.empty()) {
    const std::size_t end = std::min(obj.find('\n'), obj.size());
    const std::string_view line = obj.substr(0, end);
    obj.remove_prefix(std::min(end + 1, obj.size()));
    const bool normal = line.starts_with("vn ");
    if (normal || line.starts_with("v ") || line.starts_with("v\t")) {
      const std::array<double, 3> v = parse_vertex(line.substr(normal ? 2 : 1));
      out += normal ? "vn" : "v";
      for (int row = 0; row < 3; ++row) {
        out += ' ' + number_text(rotation[3 * row] * v[0] + rotation[3 * row + 1] * v[1] +
                                 rotation[3 * row + 2] * v[2]);
      }
      out += '\n';
    } else {
      out.append(line);
      out += '\n';
    }
  }
  return out;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

Json to_json(const Credit& credit) {
  return {{"shape", credit.shape},
          {"title", credit.title},
          {"creator", credit.creator},
          {"licence", credit.licence},
          {"source", credit.source}};
}

}  // namespace

bool extract_seats(const fs::path& furniture, const fs::path& target, const JobControl& control) {
  if (fs::exists(target / "credits.json")) return true;  // written last
  std::error_code missing;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(furniture, missing))
    if (entry.path().extension() == ".sh3f") paths.push_back(entry.path());
  if (missing || paths.empty())
    throw FileError(furniture, "no furniture here; install it with: apt install sweethome3d-furniture");
  std::sort(paths.begin(), paths.end());

  std::vector<ZipArchive> archives;
  std::vector<FurniturePiece> seats;
  std::vector<std::size_t> archive_of;
  for (const fs::path& path : paths) {
    archives.emplace_back(path);
    const std::string text = archives.back().read("PluginFurnitureCatalog.properties", max_catalogue_bytes);
    for (FurniturePiece& piece : parse_furniture_catalog(text, path)) {
      if (!is_seat(piece) || !archives.back().contains(piece.model)) continue;
      seats.push_back(std::move(piece));
      archive_of.push_back(archives.size() - 1);
    }
  }

  fs::create_directories(target);
  const std::vector<std::string> names = unique_names(seats);
  Json credits = Json::array();
  std::uint64_t bytes_left = max_total_bytes;
  for (std::size_t i = 0; i < seats.size(); ++i) {
    if (control.cancelled()) return false;
    control.progress(i, seats.size(), "unpacking seats");
    const FurniturePiece& piece = seats[i];
    const std::string obj = archives[archive_of[i]].read(piece.model, bytes_left);
    bytes_left -= obj.size();
    const std::string header = "# " + one_line(piece.title) + ", by " + one_line(piece.creator) + "\n# " +
                               one_line(piece.source) + ", " + one_line(piece.licence) + "\n";
    replace_file(target / (names[i] + ".obj"),
                 header + (piece.rotation == upright ? obj : turned(obj, piece.rotation)));
    credits.push_back(to_json({names[i], piece.title, piece.creator, piece.licence, piece.source}));
  }
  replace_file(target / "credits.json", credits.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  return true;
}

std::vector<Credit> read_credits(const fs::path& folder) {
  const fs::path path = folder / "credits.json";
  std::vector<Credit> credits;
  if (!fs::exists(path)) return credits;
  Json json;
  try {
    json = parse_json(read_file(path, max_catalogue_bytes), path);
  } catch (const Error&) {
    return credits;  // somebody else's file of that name
  }
  if (!json.is_array()) return credits;
  const auto text = [](const Json& entry, const char* key) {
    return entry.is_object() && entry.contains(key) && entry[key].is_string() ? entry[key].get<std::string>()
                                                                              : "";
  };
  for (const Json& entry : json)
    credits.push_back({text(entry, "shape"), text(entry, "title"), text(entry, "creator"),
                       text(entry, "licence"), text(entry, "source")});
  return credits;
}

}  // namespace archetype
