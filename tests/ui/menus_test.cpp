// The menus, opened by real clicks.
#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <array>

#include "tests/ui/test_window.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

// The windows of menus that are open.
std::vector<const ImGuiWindow*> open_menus() {
  std::vector<const ImGuiWindow*> menus;
  for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows)
    if (each->Active && !each->Hidden && (each->Flags & ImGuiWindowFlags_ChildMenu)) menus.push_back(each);
  return menus;
}

constexpr std::array menus{"File", "Edit", "Template", "Part", "Points", "Shape", "View", "Window", "Help"};

}  // namespace

TEST_CASE(
    "A menu stands below the bar and within the window, however long it is, and opening it does nothing") {
  struct Size {
    int width, height;
    float scale;
  };
  for (const Size& size : {Size{1280, 720, 1}, Size{1280, 720, 1.5F}, Size{800, 420, 1}}) {
    CAPTURE(size.height);
    CAPTURE(size.scale);
    TestWindow window(size.width, size.height, size.scale);
    window.open_chairs(1);
    window.make_template();
    for (const std::string name : menus) {
      CAPTURE(name);
      const Document before = window.studio().history.current();
      const ViewOptions view = window.studio().ui.view;
      window.click("menu:" + name);
      window.frames(2);
      const auto open = open_menus();
      REQUIRE(open.size() == 1);
      const ImRect place = open.front()->Rect();
      const float bar = ImGui::GetMainViewport()->WorkPos.y;
      CHECK(place.Min.y >= bar - 1);
      CHECK(place.Max.y <= static_cast<float>(size.height));
      CHECK(window.studio().history.current() == before);
      CHECK(window.studio().ui.view == view);
      ImGui::ClosePopupToLevel(0, false);
      ImGui::GetIO().MousePos = {-1, -1};
      window.frames(3);
      REQUIRE(open_menus().empty());
      CHECK(window.studio().ui.view == view);
    }
  }
}
