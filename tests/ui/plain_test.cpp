// The parts of the window that need no window: angles, latency, rows, folders.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/support/scratch_folder.h"
#include "ui/box_angles.h"
#include "ui/collection.h"
#include "ui/directory_reader.h"
#include "ui/latency.h"

using namespace archetype;
using archetype::test::ScratchFolder;

TEST_CASE("Angles give back the orientation that they were made of") {
  for (const Vec3& degrees : {Vec3(0, 0, 0), Vec3(30, 0, 0), Vec3(10, 20, 30), Vec3(-170, 80, 95),
                              Vec3(25, 90, 0), Vec3(40, -90, 0), Vec3(0, 45, -90)}) {
    const Eigen::Quaterniond orientation = orientation_of_degrees(degrees);
    const Vec3 back = degrees_of_orientation(orientation);
    CHECK(orientation_of_degrees(back).angularDistance(orientation) < 1e-6);
    CHECK((back - degrees).norm() < 1e-5);
  }
}

TEST_CASE("Latency counts every edit until a fit as new as it is on the screen") {
  LatencyMeter meter;
  const LatencyMeter::Clock::time_point start{};
  const auto at = [&](int milliseconds) { return start + std::chrono::milliseconds(milliseconds); };
  CHECK_FALSE(meter.percentile(0.5));
  meter.edited(1, at(0));
  meter.edited(2, at(10));
  meter.edited(3, at(20));
  meter.displayed(2, at(50));  // 1 was never computed: it is answered by 2
  CHECK(meter.milliseconds() == std::deque<double>{50, 40});
  meter.displayed(3, at(100));
  CHECK(meter.milliseconds() == std::deque<double>{50, 40, 80});
  CHECK(meter.percentile(0.5) == doctest::Approx(50));
  CHECK(meter.percentile(1) == doctest::Approx(80));
  CHECK(meter.percentile(0) == doctest::Approx(40));
  meter.edited(4, at(110));
  meter.forget_open();
  meter.displayed(5, at(500));
  CHECK(meter.milliseconds().size() == 3);
}

TEST_CASE("The untitled project of a folder is always the same file, another folder's is another") {
  const auto a = untitled_project_path("/data", "/shapes/chairs");
  CHECK(a == untitled_project_path("/data", "/shapes/chairs/"));
  CHECK(a == untitled_project_path("/data", "/shapes/planes/../chairs"));
  CHECK(a != untitled_project_path("/data", "/other/chairs"));
  CHECK(a.extension() == ".archetype");
}

TEST_CASE("Folders are listed folders first, without hidden ones; a missing one says why") {
  const ScratchFolder scratch;
  scratch.write("b.off", "x");
  scratch.write(".hidden", "x");
  scratch.write("folder/inside.off", "x");
  const auto listing = list_directory(scratch.path(), {});
  REQUIRE(listing);
  REQUIRE(listing->entries.size() == 2);
  CHECK(listing->entries[0].name == "folder");
  CHECK(listing->entries[0].folder);
  CHECK(listing->entries[1].name == "b.off");
  CHECK_FALSE(list_directory(scratch.path() / "none", {})->problem.empty());
}
