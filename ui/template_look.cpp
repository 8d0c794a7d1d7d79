#include "ui/template_look.h"

#include "core/base/error.h"
#include "core/session/actions.h"
#include "ui/icons.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

std::shared_ptr<const PartTemplate> shown_template(const Studio& studio) {
  if (studio.ui.look) return studio.ui.look->part_template;
  const Document& document = studio.history.current();
  return document.active_template() ? document.templates[document.active] : nullptr;
}

void look_at(Studio& studio, const PartTemplate& part_template, std::string origin) {
  select_only(studio.ui, std::nullopt);  // what is selected is of the document
  studio.ui.look = {std::make_shared<const PartTemplate>(part_template), std::move(origin)};
}

void stop_looking(Studio& studio) {
  studio.ui.look.reset();
}

void take_look(Studio& studio) {
  if (!studio.ui.look) throw PreconditionError("no template is looked at");
  const TemplateLook look = *std::exchange(studio.ui.look, std::nullopt);
  add_template(studio.history, *look.part_template,
               "Take " + look.part_template->name + " of " + look.origin);
  select_only(studio.ui, std::nullopt);
}

void draw_look_strip(Studio& studio) {
  if (!studio.ui.look) return;
  const float scale = studio.fonts.scale;
  const Palette& p = colours(studio);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetFrameHeight() + 8 * scale;
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height},
                                            ImGui::GetColorU32({p.accent.x, p.accent.y, p.accent.z, 0.22f}));
  const float take = 140 * scale;
  const float back = 120 * scale;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorScreenPos({low.x + 10 * scale, low.y + 4 * scale});
  ImGui::AlignTextToFramePadding();
  const float room = width - take - back - 2 * gap - 20 * scale;
  std::string text = "Looking at " + studio.ui.look->part_template->name + " of " + studio.ui.look->origin;
  const std::string more = text + ". The document is as it was.";
  if (ImGui::CalcTextSize(more.c_str()).x < room) text = more;
  ImGui::TextUnformatted(fitted(text, room).c_str());
  ImGui::SetCursorScreenPos({low.x + width - take - back - gap - 8 * scale, low.y + 4 * scale});
  command_button(studio, "take-look", std::string(icon::check) + "  Take template", {take, 0});
  ImGui::SameLine();
  command_button(studio, "stop-looking", std::string(icon::undo) + "  Back (Esc)", {back, 0});
  ImGui::SetCursorScreenPos({low.x, low.y + height});
}

}  // namespace archetype
