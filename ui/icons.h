// Font Awesome 4.7 as UTF-8. Where the font is not there they are drawn as nothing, so no icon stands without
// a word or a tooltip.
#pragma once

namespace archetype::icon {

inline constexpr const char* folder = "\xef\x81\xbb";       // f07b
inline constexpr const char* folder_open = "\xef\x81\xbc";  // f07c
inline constexpr const char* file = "\xef\x85\x9b";         // f15b
inline constexpr const char* cube = "\xef\x86\xb2";         // f1b2
inline constexpr const char* cubes = "\xef\x86\xb3";        // f1b3
inline constexpr const char* plus = "\xef\x81\xa7";         // f067
inline constexpr const char* copy = "\xef\x83\x85";         // f0c5
inline constexpr const char* trash = "\xef\x80\x94";        // f014
inline constexpr const char* mirror = "\xef\x81\xbe";       // f07e
inline constexpr const char* draw = "\xef\x81\x80";         // f040
inline constexpr const char* snap = "\xef\x81\xb6";         // f076
inline constexpr const char* split = "\xef\x83\x84";        // f0c4
inline constexpr const char* merge = "\xef\x81\xa6";        // f066
inline constexpr const char* undo = "\xef\x83\xa2";         // f0e2
inline constexpr const char* redo = "\xef\x80\x9e";         // f01e
inline constexpr const char* move = "\xef\x81\x87";         // f047
inline constexpr const char* scale = "\xef\x82\xb2";        // f0b2
inline constexpr const char* rotate = "\xef\x80\xa1";       // f021
inline constexpr const char* save = "\xef\x83\x87";         // f0c7
inline constexpr const char* search = "\xef\x80\x82";       // f002
inline constexpr const char* close = "\xef\x80\x8d";        // f00d
inline constexpr const char* check = "\xef\x80\x8c";        // f00c
inline constexpr const char* warning = "\xef\x81\xb1";      // f071
inline constexpr const char* error = "\xef\x81\x97";        // f057
inline constexpr const char* note = "\xef\x81\x9a";         // f05a
inline constexpr const char* play = "\xef\x81\x8b";         // f04b
inline constexpr const char* up = "\xef\x81\xa2";           // f062
inline constexpr const char* home = "\xef\x80\x95";         // f015
inline constexpr const char* frame = "\xef\x82\xb2";        // f0b2
inline constexpr const char* grid = "\xef\x80\x8a";         // f00a
inline constexpr const char* points = "\xef\x85\x82";       // f142
inline constexpr const char* more = "\xef\x85\x81";         // f141
inline constexpr const char* filter = "\xef\x82\xb0";       // f0b0
inline constexpr const char* sort_up = "\xef\x85\xa0";      // f160
inline constexpr const char* sort_down = "\xef\x85\xa1";    // f161
inline constexpr const char* tree = "\xef\x83\xa8";         // f0e8
inline constexpr const char* bars = "\xef\x82\x80";         // f080
inline constexpr const char* down = "\xef\x81\xb8";         // f078
inline constexpr const char* right = "\xef\x81\x94";        // f054
inline constexpr const char* clock = "\xef\x80\x97";        // f017

}  // namespace archetype::icon
