// Numbers in files have a dot, whatever the user's language.
#include <doctest/doctest.h>

#include <clocale>
#include <locale>

#include "core/io/labels.h"
#include "core/io/read_shape.h"
#include "core/io/template_file.h"
#include "tests/io/sample_files.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

class CommaDecimals : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// A comma decimal for C++ streams, made by hand so that the test does not depend on installed languages, and
// the C library's where there is one.
class CommaLocale {
 public:
  CommaLocale() : before_(std::locale::global(std::locale(std::locale::classic(), new CommaDecimals))) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
      if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
    }
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  ~CommaLocale() {
    std::setlocale(LC_NUMERIC, "C");
    std::locale::global(before_);
  }

 private:
  std::locale before_;
};

}  // namespace

TEST_CASE("every reader and writer does the same under a locale with a decimal comma") {
  const ScratchFolder folder;
  std::vector<ShapeFile> shapes;
  std::vector<std::filesystem::path> paths;
  for (const SampleFile& sample : sample_shapes()) {
    paths.push_back(folder.write(sample.name, sample.bytes));
    shapes.push_back(read_shape(paths.back()));
  }
  for (const SampleFile& sample : sample_side_files()) folder.write(sample.name, sample.bytes);
  const PartTemplate part_template = read_template(folder.path() / "a.json");
  const std::string text = format_template(part_template);
  const auto landmarks = read_landmarks(folder.path() / "a.vts");
  const std::vector<int> labels(3, 1234567);

  const CommaLocale comma;
  REQUIRE((std::ostringstream() << 1234.5).str() == "1.234,5");  // the locale is in force
  for (std::size_t i = 0; i < paths.size(); ++i) {
    CAPTURE(paths[i].string());
    const ShapeFile again = read_shape(paths[i]);
    CHECK(again.mesh.vertices == shapes[i].mesh.vertices);
    CHECK(again.mesh.face_corners == shapes[i].mesh.face_corners);
    CHECK(again.mesh.face_begins == shapes[i].mesh.face_begins);
    CHECK(again.mesh.point_normals == shapes[i].mesh.point_normals);
    CHECK(again.warnings == shapes[i].warnings);
  }
  CHECK(read_template(folder.path() / "a.json") == part_template);
  CHECK(format_template(part_template) == text);
  CHECK(read_landmarks(folder.path() / "a.vts")[2].position == landmarks[2].position);
  write_labels(folder.path() / "b.seg", labels);
  CHECK(read_labels(folder.path() / "b.seg", 3) == labels);
}
