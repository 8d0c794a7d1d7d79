#!/usr/bin/env bash
# A template made by a hand: the actions of a file are done with the mouse and the keys of a virtual display, and the
# template that they save is compared with the one beside it, numbers to two decimals.
#
# usage: walk.sh STUDIO BATCH ACTIONS EXPECTED [KEPT]   (KEPT: where the template is copied to)
#
# actions, one a line: key CHORD | click X Y | ctrl-click X Y | type TEXT
set -eu
studio=$1
batch=$2
actions=$3
expected=$4
kept=${5:-}
most_actions=60
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data XDG_CACHE_HOME=$folder/cache HOME=$folder
"$batch" generate chairs --count 2 --seed 7 --out "$folder/all" >/dev/null
mkdir "$folder/shapes"
mv "$folder"/all/shapes/chair_00001.* "$folder/shapes"  # a chair with arms

count=$(grep -cv '^#' "$actions")
echo "$count actions"
test "$count" -le $most_actions

# Runs inside the virtual display. Nothing tells from outside when the window is ready: the pauses are long enough with
# the machine to itself (RUN_SERIAL in CMakeLists.txt).
cat > "$folder/drive.sh" <<'DRIVE'
set -eu
"$1" "$2" &
program=$!
window=$(timeout 60 xdotool search --sync --onlyvisible --name Archetype | head -1)
xdotool windowfocus "$window"
sleep 3
while read -r action first rest; do
  case $action in
    '#'*) continue ;;
    key) xdotool key "$first" ;;
    type) xdotool type --delay 40 "$first${rest:+ $rest}" ;;
    click) xdotool mousemove "$first" "$rest" sleep 0.3 click 1 ;;
    ctrl-click) xdotool mousemove "$first" "$rest" sleep 0.3 keydown ctrl sleep 0.2 click 1 sleep 0.2 keyup ctrl ;;
    *) echo "unknown action: $action" >&2; exit 1 ;;
  esac
  sleep 1
done < "$3"
sleep 1
xdotool key ctrl+q
wait "$program"
DRIVE
timeout 200 xvfb-run -a -s "-screen 0 1280x720x24 -noreset" \
  bash "$folder/drive.sh" "$studio" "$folder/shapes" "$actions"

test -z "$kept" || cp "$folder/chair.json" "$kept"
rounded() {
  awk '{ line = $0; sub(/[-0-9.e]+,?$/, "", line); text = substr($0, length(line) + 1); comma = sub(/,$/, "", text)
         if (text ~ /^-?[0-9]/) { text = sprintf("%.2f", text); if (text == "-0.00") text = "0.00" }
         print line text (comma ? "," : "") }' "$1"
}
rounded "$expected" > "$folder/expected.txt"
rounded "$folder/chair.json" > "$folder/made.txt"
diff "$folder/expected.txt" "$folder/made.txt"
