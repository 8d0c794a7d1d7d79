#include "ui/order_menu.h"

#include <imgui.h>

#include <array>

#include "ui/icons.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr std::array terms{ShapeQuantity::shape_to_template, ShapeQuantity::template_to_shape,
                           ShapeQuantity::features,          ShapeQuantity::deformation,
                           ShapeQuantity::smoothness,        ShapeQuantity::existence};
constexpr std::array of_parts{ShapeQuantity::part_x,      ShapeQuantity::part_y,
                              ShapeQuantity::part_z,      ShapeQuantity::part_half_x,
                              ShapeQuantity::part_half_y, ShapeQuantity::part_half_z,
                              ShapeQuantity::part_share};

class Items {
 public:
  Items(Studio& studio, const ShapeColumn* current) : studio_(studio), current_(current) {}

  void item(const ShapeColumn& column, const std::string& title) {
    if (ImGui::MenuItem(title.c_str(), nullptr, current_ && *current_ == column)) clicked = column;
    std::string name = "column:" + std::string(quantity_name(column.quantity));
    if (!column.part.empty()) name += ":" + column.part;
    mark_target(studio_, name);
  }
  void item(ShapeQuantity quantity) { item({.quantity = quantity}, quantity_title(quantity)); }
  void parts(const FitTable& table) {
    for (const std::string& part : part_names(table)) {
      const bool open = ImGui::BeginMenu(part.empty() ? "(no name)" : part.c_str());
      mark_target(studio_, "column-part:" + part);
      if (!open) continue;
      for (const ShapeQuantity quantity : of_parts)
        item({.quantity = quantity, .part = part}, quantity_title(quantity));
      ImGui::EndMenu();
    }
  }

  std::optional<ShapeColumn> clicked;

 private:
  Studio& studio_;
  const ShapeColumn* current_;
};

}  // namespace

std::optional<ShapeColumn> draw_column_items(Studio& studio, const ShapeColumn* current, bool with_name) {
  Items items(studio, current);
  if (with_name) items.item(ShapeQuantity::name);
  items.item(ShapeQuantity::elements);
  items.item(ShapeQuantity::energy);
  const bool open_terms = ImGui::BeginMenu("Terms of the energy");
  mark_target(studio, "column-terms");
  if (open_terms) {
    for (const ShapeQuantity quantity : terms) items.item(quantity);
    ImGui::EndMenu();
  }
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  const bool fitted = table && !table->rows.empty();
  const bool open_parts = ImGui::BeginMenu("Parts", fitted);
  mark_target(studio, "column-parts");
  if (!fitted) tooltip("Not now: fit the shapes or learn from them first");
  if (open_parts) {
    items.parts(*table);
    ImGui::EndMenu();
  }
  const std::optional<std::size_t> row =
      studio.ui.shape ? find_row(studio.collection, *studio.ui.shape) : std::nullopt;
  if (fitted && row && studio.collection.rows()[*row].fit)
    items.item({.quantity = ShapeQuantity::similarity, .shape = *studio.ui.shape},
               "Similarity to " + studio.collection.rows()[*row].name);
  return items.clicked;
}

void draw_order_button(Studio& studio, const char* target, float width) {
  ShapeOrder& order = studio.ui.shown.order;
  ImGui::PushID(target);
  const std::string title = column_title(order.column, studio.collection.rows());
  const float arrow = ImGui::CalcTextSize(icon::sort_down).x + ImGui::GetStyle().ItemInnerSpacing.x;
  const float room = width - 2 * ImGui::GetStyle().FramePadding.x - arrow;
  const std::string label =
      std::string(order.descending ? icon::sort_down : icon::sort_up) + " " + fitted(title, room);
  if (ImGui::Button((label + "###order").c_str(), {width, 0})) ImGui::OpenPopup("order");
  mark_target(studio, target);
  tooltip(("Sorted by " + title + (order.descending ? ", the largest first" : ", the least first")).c_str());
  if (ImGui::BeginPopup("order")) {
    if (const auto column = draw_column_items(studio, &order.column, true)) {
      const bool again = *column == order.column;
      order = {*column, again ? !order.descending : descending_at_first(*column)};
    }
    ImGui::Separator();
    if (ImGui::MenuItem("The least first", nullptr, !order.descending)) order.descending = false;
    mark_target(studio, "order:up");
    if (ImGui::MenuItem("The largest first", nullptr, order.descending)) order.descending = true;
    mark_target(studio, "order:down");
    ImGui::EndPopup();
  }
  ImGui::PopID();
}

bool descending_at_first(const ShapeColumn& column) {
  return column.quantity == ShapeQuantity::elements || is_of_part(column.quantity);
}

}  // namespace archetype
