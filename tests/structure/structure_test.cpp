// How the code is laid out: layers, sizes, build lists.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/structure/source_rules.h"

using namespace archetype;
namespace fs = std::filesystem;

namespace {

const fs::path root = ARCHETYPE_SOURCE_DIR;

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE_MESSAGE(file, path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

// All C++ files of the repository, as paths from its root.
std::vector<fs::path> source_files() {
  std::vector<fs::path> files;
  for (const char* folder : {"core", "render", "ui", "app", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path ending = entry.path().extension();
      if (entry.is_regular_file() && (ending == ".cpp" || ending == ".h")) {
        files.push_back(fs::relative(entry.path(), root));
      }
    }
  }
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() > 50);
  return files;
}

bool lists(const fs::path& folder, const std::string& name) {
  const fs::path list = root / folder / "CMakeLists.txt";
  if (!fs::exists(list)) return false;
  const auto names = listed_names(content(list));
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

TEST_CASE("the rules find what breaks them") {
  CHECK(forbidden_includes("core/io/a.cpp", "#include \"render/camera.h\"\n").size() == 1);
  CHECK(forbidden_includes("core/io/a.cpp", "// text\n  # include <glm/vec3.hpp>\n") ==
        std::vector<std::string>{"core/io/a.cpp, line 2: core/ must not include glm/vec3.hpp"});
  CHECK(forbidden_includes("core/a.h", "#include <GLFW/glfw3.h>\n#include <epoxy/gl.h>\n#include <imgui.h>\n")
            .size() == 3);
  CHECK(forbidden_includes("render/a.h", "#include \"ui/ui_state.h\"\n#include <imgui.h>\n").size() == 2);
  CHECK(forbidden_includes("ui/a.cpp", "#include \"app/studio/main.h\"\n#include <epoxy/gl.h>\n").size() ==
        2);
  CHECK(forbidden_includes("app/batch/a.cpp", "#include \"render/camera.h\"\n").size() == 1);
  CHECK(forbidden_includes("ui/a.cpp", "#include \"render/camera.h\"\n#include \"core/base/error.h\"\n")
            .empty());
  CHECK(forbidden_includes("app/studio/a.cpp", "#include \"ui/ui_state.h\"\n#include <GLFW/glfw3.h>\n")
            .empty());
  CHECK(listed_names("add(x a.cpp # b.cpp\n  c.cpp)") ==
        std::vector<std::string>{"add", "x", "a.cpp", "c.cpp"});
  CHECK(line_count("one\ntwo\n") == 2);
}

TEST_CASE("includes follow the layers: core <- render <- ui <- app") {
  for (const fs::path& file : source_files()) {
    for (const std::string& found : forbidden_includes(file, content(root / file))) FAIL_CHECK(found);
  }
}

TEST_CASE("no file is longer than one can read") {
  for (const fs::path& file : source_files()) {
    const std::size_t lines = line_count(content(root / file));
    CHECK_MESSAGE(lines <= most_lines, file.string(), " has ", lines, " lines: does it still do one thing?");
  }
}

TEST_CASE("every source file is built: a CMakeLists.txt of its folder or above names it") {
  for (const fs::path& file : source_files()) {
    if (file.extension() != ".cpp") continue;
    bool listed = false;
    for (fs::path folder = file.parent_path(); !listed && !folder.empty(); folder = folder.parent_path()) {
      listed = lists(folder, file.lexically_relative(folder).generic_string());
    }
    CHECK_MESSAGE(listed, file.string(), " stands in no CMakeLists.txt");
  }
}

TEST_CASE("every header says what it is for and is included once") {
  for (const fs::path& file : source_files()) {
    if (file.extension() != ".h") continue;
    const std::string text = content(root / file);
    CHECK_MESSAGE(text.rfind("//", 0) == 0, file.string(), " does not open with a comment");
    CHECK_MESSAGE(text.find("\n#pragma once\n") != std::string::npos, file.string(), " has no #pragma once");
  }
}
