#!/usr/bin/env bash
# The real window on a real (virtual) display, driven from outside: keys make a template, it is saved by itself, and a
# second start without a display finds it again.
#
# usage: end_to_end.sh STUDIO BATCH
set -eu
studio=$1
batch=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data XDG_CACHE_HOME=$folder/cache HOME=$folder
"$batch" generate chairs --count 2 --out "$folder/chairs" >/dev/null

# Runs inside the virtual display: types, quits, and gives the status of the program.
cat > "$folder/drive.sh" <<'DRIVE'
set -eu
"$1" --set theme=light "$2" &
program=$!
window=$(timeout 60 xdotool search --sync --onlyvisible --name Archetype | head -1)
xdotool windowfocus "$window"
for keys in ctrl+n shift+a shift+a ctrl+z; do
  sleep 0.3
  xdotool key "$keys"
done
sleep 0.3  # what was edited a moment ago is saved all the same
# The settings are written while the program runs: what was opened is in the list of recent projects.
grep -q chairs/shapes "$XDG_CONFIG_HOME/archetype/settings.json"
xdotool key ctrl+q
# An untitled project with edits: keep and close, as soon as the question is on the screen.
for second in $(seq 60); do
  sleep 1
  kill -0 "$program" 2>/dev/null || break
  xdotool key Return 2>/dev/null || break
done
wait "$program"
DRIVE
timeout 120 xvfb-run -a -s "-screen 0 1280x720x24 -noreset" bash "$folder/drive.sh" "$studio" "$folder/chairs/shapes"

echo "save-template $folder/kept.json" > "$folder/script.txt"
env -u DISPLAY -u WAYLAND_DISPLAY timeout 120 "$studio" "$folder/chairs/shapes" --script "$folder/script.txt" \
  --screenshot "$folder/window.png" --quit
test "$(grep -c '"name": "part' "$folder/kept.json")" = 1
test "$(head -c 8 "$folder/window.png" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a
