// Templates that are found in the shapes: suggested, learned, looked into.
#include <algorithm>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/learning_actions.h"
#include "ui/studio.h"

namespace archetype {
namespace {

std::string needs_suggestions(const Studio& studio) {
  return studio.ui.suggestions.empty() ? "let templates be suggested first" : "";
}

std::string needs_learning(const Studio& studio) {
  return studio.collection.content.learning ? "" : "learn from the shapes first";
}

std::string needs_look(const Studio& studio) {
  return studio.ui.look ? "" : "click a template in the learning panel first";
}

void suggest_command(Studio& studio, Arguments) {
  suggest_templates(studio);
}

void show_suggestions(Studio& studio, Arguments) {
  studio.ui.show_suggestions = true;
}

void take_suggestion_command(Studio& studio, Arguments arguments) {
  const double rank = number_argument(arguments, 0, "a rank from 1");
  if (rank < 1 || rank > static_cast<double>(studio.ui.suggestions.size()))
    throw Error("there are " + std::to_string(studio.ui.suggestions.size()) + " suggested templates");
  take_suggestion(studio, static_cast<std::size_t>(rank) - 1);
}

void learn_command(Studio& studio, Arguments) {
  learn(studio);
}

void learn_from_shapes_alone_command(Studio& studio, Arguments) {
  learn_from_shapes_alone(studio);
}

void show_learning_command(Studio& studio, Arguments) {
  show_learning(studio);
}

void look_command(Studio& studio, Arguments arguments) {
  const double round = number_argument(arguments, 0, "a round from 0 and the number of a template from 1");
  const double number = number_argument(arguments, 1, "a round from 0 and the number of a template from 1");
  const std::size_t rounds = studio.collection.content.learning->steps.size();
  if (round < 0 || round > static_cast<double>(rounds))
    throw Error("there are " + std::to_string(rounds) + " rounds");
  look_into_round(studio, static_cast<std::size_t>(round),
                  static_cast<std::size_t>(std::max(1.0, number)) - 1);
}

void stop_looking_command(Studio& studio, Arguments) {
  stop_looking(studio);
}

void take_look_command(Studio& studio, Arguments) {
  take_look(studio);
}

}  // namespace

void add_learning_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "suggest-templates",
                                       .title = "Suggest templates",
                                       .menu = "Template",
                                       .run = suggest_command,
                                       .why_not = needs_free_shapes,
                                       .separator = true},
                                      {.name = "show-suggestions",
                                       .title = "Show the suggested templates",
                                       .menu = "Template",
                                       .run = show_suggestions,
                                       .why_not = needs_suggestions},
                                      {.name = "take-suggestion",
                                       .title = "Take a suggested template",
                                       .arguments = "RANK",
                                       .run = take_suggestion_command,
                                       .why_not = needs_suggestions,
                                       .edits = true},
                                      {.name = "learn",
                                       .title = "Learn from all shapes",
                                       .menu = "Template",
                                       .key = "Ctrl+L",
                                       .run = learn_command,
                                       .why_not = needs_shapes_and_template},
                                      {.name = "learn-automatically",
                                       .title = "Learn from the shapes alone",
                                       .menu = "Template",
                                       .run = learn_from_shapes_alone_command,
                                       .why_not = needs_free_shapes},
                                      {.name = "show-learning",
                                       .title = "Show the learning panel",
                                       .menu = "Template",
                                       .key = "L",
                                       .run = show_learning_command},
                                      {.name = "look-at-learned",
                                       .title = "Look at a template of a round",
                                       .arguments = "ROUND NUMBER",
                                       .run = look_command,
                                       .why_not = needs_learning,
                                       .at_once = true},
                                      {.name = "take-look",
                                       .title = "Take the template that is looked at",
                                       .menu = "Template",
                                       .run = take_look_command,
                                       .why_not = needs_look,
                                       .edits = true},
                                      {.name = "stop-looking",
                                       .title = "Back to the template of the document",
                                       .menu = "Template",
                                       .run = stop_looking_command,
                                       .why_not = needs_look},
                                  });
}

}  // namespace archetype
