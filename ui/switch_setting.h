// A command that switches a setting, and whether it is on: for Command::run and Command::checked.
#pragma once

#include "ui/command.h"
#include "ui/studio.h"

namespace archetype {

template <bool Settings::*Option>
void toggle_setting(Studio& studio, Arguments) {
  studio.settings.*Option = !(studio.settings.*Option);
}

template <bool Settings::*Option>
bool setting_is_on(const Studio& studio) {
  return studio.settings.*Option;
}

}  // namespace archetype
