#!/usr/bin/env bash
# The program is killed again and again while it saves, and while a box is dragged: what it said was done is in the
# project each time, and the project goes on from there.
#
# usage: killed.sh STUDIO BATCH
set -eu
studio=$1
batch=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data XDG_CACHE_HOME=$folder/cache HOME=$folder
unset DISPLAY WAYLAND_DISPLAY
small="--set window_width=480 --set window_height=320"
"$batch" generate chairs --count 1 --out "$folder/chairs" >/dev/null
"$batch" import "$folder/p.archetype" "$folder/chairs/shapes" >/dev/null

# Parts of the template in the project.
parts() {
  rm -f "$folder/kept.json"
  echo "save-template $folder/kept.json" > "$folder/keep.txt"
  timeout 60 "$studio" $small "$folder/p.archetype" --script "$folder/keep.txt" --quit
  grep -c '"name": "part' "$folder/kept.json"
}

# Kills the program once its output has the given number of lines, a moment later.
kill_after() {
  lines=$1
  moment=$2
  : > "$folder/said.txt"
  "$studio" $small "$folder/p.archetype" --script "$folder/script.txt" --quit > "$folder/said.txt" 2>/dev/null &
  program=$!
  for ((i = 0; i < 3000; ++i)); do
    test "$(wc -l < "$folder/said.txt")" -lt "$lines" || break
    sleep 0.01
  done
  sleep "$moment"
  kill -KILL "$program" 2>/dev/null || true
  wait "$program" 2>/dev/null || true
}

printf 'new-template\nadd-part\n' > "$folder/script.txt"
timeout 60 "$studio" $small "$folder/p.archetype" --script "$folder/script.txt" --quit
before=$(parts)
test "$before" = 1

# A script's command is run when the one before is saved: of the parts whose report was printed none may be missing.
for ((i = 0; i < 40; ++i)); do echo add-part; echo report-fit; done > "$folder/script.txt"
for moment in 0 0.013 0.029; do
  kill_after 2 "$moment"
  said=$(grep -c '^fit ' "$folder/said.txt" || true)
  after=$(parts)
  echo "killed $moment s later: $before parts before, $said said to be made, $after there"
  test "$after" -ge $((before + said))
  test "$after" -le $((before + 40))
  before=$after
done

# Killed in the middle of a drag: all that came before it is there, and nothing of the drag.
printf 'add-part\nreport-fit\ndrag-part 0.3 0 0 100000\nreport-fit\n' > "$folder/script.txt"
kill_after 1 0.5
test "$(grep -c '^fit ' "$folder/said.txt")" = 1
after=$(parts)
echo "killed while a box is dragged: $after parts there"
test "$after" = $((before + 1))
