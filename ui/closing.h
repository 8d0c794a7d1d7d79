// The end of the window: at once where everything is where its owner will look for it, else after a question.
#pragma once

namespace archetype {

struct Studio;

struct Closing {
  bool asked = false;      // the window was asked to close
  bool answered = false;   // the question was: it closes once all is saved
  bool saving_as = false;  // with "Save as": the file browser is open, or its job runs
};

enum class CloseQuestion {
  none,
  untitled,   // the project was edited, and has no file of its own yet: only this program finds it again
  homeless,   // templates that are in no project
  unsavable,  // the newest edits do not come to the file
};
CloseQuestion close_question(const Studio& studio);

// Ctrl+Q, or the cross of the window. Closes without a question where nobody is there to answer.
void request_close(Studio& studio);
// Once a frame, after autosave(): sets Studio::quit when all is done.
void follow_closing(Studio& studio);
// The question is on the screen and has the keyboard.
bool asks_to_close(const Studio& studio);
void draw_closing_window(Studio& studio);

}  // namespace archetype
