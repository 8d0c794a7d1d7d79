#include "ui/flow_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/model/part_colours.h"
#include "ui/studio.h"
#include "ui/template_picture.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

// Paul Tol's "bright" scheme for colour-blind readers, https://personal.sron.nl/~pault/.
constexpr std::array<Rgb, 6> line_hues{
    {{68, 119, 170}, {238, 102, 119}, {34, 136, 51}, {204, 187, 68}, {102, 204, 238}, {170, 51, 119}}};

// Where a node lies in its column.
struct Span {
  float top = 0;
  float bottom = 0;
};

// Where the columns stand and what is in them.
struct Chart {
  ImVec2 low;            // of the area below the heads of the columns
  float height = 0;      // of that area
  float pitch = 0;       // from column to column
  float node_width = 0;  // bar and picture
  float bar = 0;
  std::vector<std::vector<Span>> spans;  // by column and node

  float left(std::size_t column) const { return low.x + pitch * static_cast<float>(column); }
};

// As high as it has members, but never too low to be seen and clicked: what that takes comes from the others.
std::vector<Span> spans_of(const FlowColumn& column, float top, float height, float gap, float least) {
  const auto count = static_cast<float>(column.nodes.size());
  gap = std::min(gap, height * 0.3f / count);
  const float space = height - gap * (count - 1);
  least = std::min(least, space / count);
  std::vector<float> highs(column.nodes.size(), 0);
  for (bool changed = true; changed;) {  // a node at a time becomes one of the lowest
    changed = false;
    float members = 0;
    float left = space;
    for (std::size_t n = 0; n < highs.size(); ++n) {
      if (highs[n] > 0)
        left -= least;
      else
        members += static_cast<float>(column.nodes[n].members.size());
    }
    const auto wanted = [&](std::size_t n) {
      return members > 0 ? left * static_cast<float>(column.nodes[n].members.size()) / members : 0;
    };
    for (std::size_t n = 0; n < highs.size() && !changed; ++n) {
      changed = highs[n] == 0 && wanted(n) < least;
      if (changed) highs[n] = least;
    }
    if (changed) continue;
    for (std::size_t n = 0; n < highs.size(); ++n)
      if (highs[n] == 0) highs[n] = wanted(n);
  }
  std::vector<Span> spans;
  for (const float high : highs) {
    spans.push_back({top, top + high});
    top += high + gap;
  }
  return spans;
}

// The ends of the bands at the nodes, in the order of the other ends, so that they do not cross needlessly.
struct BandEnds {
  Span from;
  Span to;
};
std::vector<BandEnds> ends_of_bands(const FlowColumn& before, const FlowColumn& column,
                                    const std::vector<Span>& from, const std::vector<Span>& to) {
  std::vector<float> left(from.size());
  std::vector<float> right(to.size());
  const auto part = [](const Span& span, float& used, std::size_t count, std::size_t all) {
    const float high = (span.bottom - span.top) * static_cast<float>(count) / static_cast<float>(all);
    const Span result{span.top + used, span.top + used + high};
    used += high;
    return result;
  };
  std::vector<BandEnds> ends;
  for (const FlowBand& band : column.bands) {
    const std::size_t count = band.shapes.size();
    ends.push_back({part(from[band.from], left[band.from], count, before.nodes[band.from].members.size()),
                    part(to[band.to], right[band.to], count, column.nodes[band.to].members.size())});
  }
  return ends;
}

float eased(float a, float b, float t) {
  return a + (b - a) * t * t * (3 - 2 * t);
}

void draw_band(ImDrawList& draw, const BandEnds& ends, float x0, float x1, ImU32 colour) {
  constexpr int steps = 20;
  // The rims of antialiased quads would be seen where they meet.
  const ImDrawListFlags flags = draw.Flags;
  draw.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (int i = 0; i < steps; ++i) {
    const float t0 = static_cast<float>(i) / steps;
    const float t1 = static_cast<float>(i + 1) / steps;
    const float a = x0 + (x1 - x0) * t0;
    const float b = x0 + (x1 - x0) * t1;
    draw.AddQuadFilled({a, eased(ends.from.top, ends.to.top, t0)}, {b, eased(ends.from.top, ends.to.top, t1)},
                       {b, eased(ends.from.bottom, ends.to.bottom, t1)},
                       {a, eased(ends.from.bottom, ends.to.bottom, t0)}, colour);
  }
  draw.Flags = flags;
}

bool is_on_band(const BandEnds& ends, float x0, float x1, ImVec2 at) {
  if (at.x < x0 || at.x > x1) return false;
  const float t = (at.x - x0) / (x1 - x0);
  return at.y >= eased(ends.from.top, ends.to.top, t) && at.y < eased(ends.from.bottom, ends.to.bottom, t);
}

void draw_bands(const Chart& chart, const std::vector<FlowColumn>& columns, std::size_t c) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto ends = ends_of_bands(columns[c - 1], columns[c], chart.spans[c - 1], chart.spans[c]);
  const float x0 = chart.left(c - 1) + chart.node_width;
  const float x1 = chart.left(c);
  const bool hovers = ImGui::IsWindowHovered();
  for (const bool moved : {false, true}) {  // those that move lie above those that stay
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const FlowBand& band = columns[c].bands[i];
      if (band.moved != moved) continue;
      const FlowNode& from = columns[c - 1].nodes[band.from];
      const FlowNode& to = columns[c].nodes[band.to];
      const bool hovered = hovers && is_on_band(ends[i], x0, x1, ImGui::GetIO().MousePos);
      const float opacity = hovered ? 0.9f : moved ? 0.65f : 0.22f;
      draw_band(draw, ends[i], x0, x1, line_colour(moved ? to.line : from.line, opacity));
      if (!hovered) continue;
      const std::string count = plural(band.shapes.size(), "shape");
      ImGui::SetTooltip("%s %s %s %s%s", count.c_str(), moved ? "moved from" : "stayed with",
                        from.part_template->name.c_str(), moved ? "to " : "",
                        moved ? to.part_template->name.c_str() : "");
    }
  }
}

std::string facts_of(const FlowNode& node, const FlowColumn& column, const LearningRecord& record,
                     const std::vector<FlowColumn>& columns) {
  std::string text = node.part_template->name + "\n" + plural(node.members.size(), "judging shape") + ", " +
                     plural(node.part_template->parts.size(), "part");
  if (column.round == 0) return text + "\nlearning began with it";
  const FlowColumn& before = columns[static_cast<std::size_t>(column.round) - 1];
  for (const FlowEnd& end : column.ended)
    if (end.into && &column.nodes[*end.into] == &node)
      text.append("\n").append(end_text(before, column, end));
  if (!node.spawned)
    return text + (node.changed ? "\nre-estimated in this round" : "\nas in the round before");
  const std::size_t parent = *record.lines[node.line].parent;
  for (const FlowNode& from : before.nodes)
    if (from.line == parent) text += "\nspawned by " + from.part_template->name + " in this round";
  return text;
}

void draw_node_tooltip(const Studio& studio, const FlowNode& node, const std::string& facts) {
  ImGui::BeginTooltip();
  const float side = 150 * studio.fonts.scale;
  draw_template_picture(*ImGui::GetWindowDrawList(), *node.part_template, ImGui::GetCursorScreenPos(), side);
  ImGui::Dummy({side, side});
  ImGui::TextUnformatted(facts.c_str());
  ImGui::EndTooltip();
}

// True when it was clicked.
bool draw_node(Studio& studio, const Chart& chart, const std::vector<FlowColumn>& columns,
               const LearningRecord& record, std::size_t c, std::size_t n, bool chosen) {
  const FlowNode& node = columns[c].nodes[n];
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const Span& span = chart.spans[c][n];
  const ImVec2 low(chart.left(c), span.top);
  const ImVec2 high(low.x + chart.node_width, span.bottom);
  ImGui::SetCursorScreenPos(low);
  ImGui::PushID(static_cast<int>(n));
  const bool clicked = ImGui::InvisibleButton("node", {high.x - low.x, high.y - low.y});
  ImGui::PopID();
  mark_target(studio, "learned:" + std::to_string(c) + ":" + std::to_string(n + 1));
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(low, high, ImGui::GetColorU32(hovered || chosen ? p.hovered : p.raised), 3 * scale);
  draw.AddRectFilled(low, {low.x + chart.bar, high.y}, line_colour(node.line), 3 * scale);
  const float line = ImGui::GetTextLineHeight();
  const float room = high.x - low.x - chart.bar - 4 * scale;
  const std::string count = std::to_string(node.members.size());
  const float tall = span.bottom - span.top;
  const ImU32 text = ImGui::GetColorU32(p.text);
  const ImVec2 text_size = ImGui::CalcTextSize(count.c_str());
  // The number below the picture or beside it, where it leaves more room for it.
  const float above = std::min(room, tall - line - 4 * scale);
  const float beside = std::min(room - text_size.x - 6 * scale, tall - 2 * scale);
  const float left = low.x + chart.bar + 2 * scale;
  if (above > beside) {
    const float top = low.y + (tall - above - line) / 2;
    draw_template_picture(draw, *node.part_template, {left + (room - above) / 2, top}, above);
    draw.AddText({left + (room - text_size.x) / 2, top + above}, text, count.c_str());
  } else {
    if (beside > 9 * scale)
      draw_template_picture(draw, *node.part_template, {left, low.y + (tall - beside) / 2}, beside);
    draw.AddText({high.x - text_size.x - 4 * scale, low.y + (tall - line) / 2}, text, count.c_str());
  }
  if (node.spawned || node.changed) {
    // A new one has a full dot in its corner, a re-estimated one a ring.
    const ImVec2 at(high.x - 7 * scale, low.y + 7 * scale);
    if (tall > 20 * scale) {
      if (node.spawned)
        draw.AddCircleFilled(at, 3.5f * scale, line_colour(node.line));
      else
        draw.AddCircle(at, 3.2f * scale, line_colour(node.line), 0, 1.5f * scale);
    }
  }
  if (chosen) draw.AddRect(low, high, ImGui::GetColorU32(p.accent), 3 * scale, 0, 2 * scale);
  if (hovered) draw_node_tooltip(studio, node, facts_of(node, columns[c], record, columns));
  return clicked;
}

// True when it was clicked.
bool draw_head(Studio& studio, const Chart& chart, const FlowColumn& column, std::size_t c, float top,
               bool chosen) {
  const float line = ImGui::GetTextLineHeight();
  ImGui::SetCursorScreenPos({chart.left(c), top});
  const bool clicked = ImGui::InvisibleButton("head", {chart.node_width, 2 * line});
  mark_target(studio, "round:" + std::to_string(c));
  const Palette& p = colours(studio);
  const bool lit = chosen || ImGui::IsItemHovered();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::string title = c == 0 ? "start" : "round " + std::to_string(column.round);
  const std::string moved = c == 0 ? "" : std::to_string(column.moved) + " moved";
  const auto put = [&](const std::string& text, float y, ImVec4 colour) {
    const std::string shown = fitted(text, chart.pitch - 4 * studio.fonts.scale);
    draw.AddText({chart.left(c), y}, ImGui::GetColorU32(colour), shown.c_str());
  };
  put(title, top, lit ? p.text : p.muted);
  put(moved, top + line, column.moved > 0 ? p.text : p.muted);
  return clicked;
}

void draw_coming(Studio& studio, const Chart& chart, std::size_t c, float top) {
  const Palette& p = colours(studio);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::string title = "round " + std::to_string(c) + "…";
  draw.AddText({chart.left(c), top}, ImGui::GetColorU32(p.accent), title.c_str());
  draw.AddRect({chart.left(c), chart.low.y}, {chart.left(c) + chart.node_width, chart.low.y + chart.height},
               ImGui::GetColorU32({p.accent.x, p.accent.y, p.accent.z, 0.5f}), 3 * studio.fonts.scale);
}

}  // namespace

ImU32 line_colour(std::size_t line, float opacity) {
  const Rgb& hue = line_hues[line % line_hues.size()];
  // From the seventh on paler ones, so that they are not quite the same.
  const double pale = line / line_hues.size() % 2 == 1 ? 0.5 : 0;
  const auto mixed = [&](std::uint8_t value) { return static_cast<int>(value + (255 - value) * pale); };
  return IM_COL32(mixed(hue[0]), mixed(hue[1]), mixed(hue[2]), static_cast<int>(255 * opacity));
}

std::optional<LearningChoice> draw_flow_chart(Studio& studio, const std::vector<FlowColumn>& columns,
                                              const LearningRecord& record, const LearningChoice& chosen,
                                              bool coming, ImVec2 size) {
  const float scale = studio.fonts.scale;
  std::optional<LearningChoice> clicked;
  ImGui::BeginChild("##flow", size, false, ImGuiWindowFlags_HorizontalScrollbar);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  const std::size_t count = columns.size() + (coming ? 1 : 0);
  Chart chart;
  const float least_pitch = 84 * scale;
  const float wanted = (size.x - 4 * scale) / static_cast<float>(std::max<std::size_t>(count, 3));
  chart.pitch = std::clamp(wanted, least_pitch, 190 * scale);
  chart.node_width = std::min(chart.pitch * 0.6f, 96 * scale);
  chart.bar = 6 * scale;
  const float whole = chart.pitch * static_cast<float>(count);
  const float bar_below = whole > size.x ? ImGui::GetStyle().ScrollbarSize : 0;
  chart.low = {at.x, at.y + 2 * line + 4 * scale};
  chart.height = std::max(40 * scale, size.y - 2 * line - 8 * scale - bar_below);
  for (const FlowColumn& column : columns)
    chart.spans.push_back(spans_of(column, chart.low.y, chart.height, 6 * scale, 18 * scale));
  for (std::size_t c = 1; c < columns.size(); ++c) draw_bands(chart, columns, c);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    ImGui::PushID(static_cast<int>(c));
    if (draw_head(studio, chart, columns[c], c, at.y, chosen.round == c)) clicked = {c, std::nullopt};
    for (std::size_t n = 0; n < columns[c].nodes.size(); ++n) {
      const bool is_chosen = chosen.round == c && chosen.part_template == n;
      if (draw_node(studio, chart, columns, record, c, n, is_chosen)) clicked = {c, n};
    }
    ImGui::PopID();
  }
  if (coming) draw_coming(studio, chart, columns.size(), at.y);
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({whole, chart.low.y + chart.height - at.y});
  // Begins at the newest round and follows it unless somebody has scrolled back or chosen another one.
  if (chosen.round && chosen.bring_into_sight) {
    const float left = chart.pitch * static_cast<float>(*chosen.round);
    const float right = left + chart.node_width + 4 * scale;
    if (left < ImGui::GetScrollX()) ImGui::SetScrollX(left);
    if (right > ImGui::GetScrollX() + size.x) ImGui::SetScrollX(right - size.x);
  } else if (ImGui::IsWindowAppearing() && !chosen.round)
    ImGui::SetScrollX(whole);
  else if (!chosen.round && ImGui::GetScrollX() >= ImGui::GetScrollMaxX() - chart.pitch * 1.1f)
    ImGui::SetScrollX(ImGui::GetScrollMaxX());
  ImGui::EndChild();
  return clicked;
}

}  // namespace archetype
