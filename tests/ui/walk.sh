#!/usr/bin/env bash
# A template made by a hand: the actions of a file are done with the mouse and the keys of a virtual display, and the
# template that they save is compared with the one beside it, numbers to two decimals.
#
# usage: walk.sh STUDIO BATCH ACTIONS EXPECTED [KEPT]   (KEPT: where the template is copied to)
#
# The actions begin with what they are done on, "collection FAMILY COUNT SEED SHAPE…", and with how many there may be,
# "most N". Then one a line: key CHORD | click X Y | ctrl-click X Y | type TEXT; and, no action of the hand,
# wait SECONDS: for a job to begin.
set -eu
studio=$1
batch=$2
actions=$3
expected=$4
kept=${5:-}
read -r _ family shape_count seed shapes < <(grep '^collection ' "$actions")
read -r _ most_actions < <(grep '^most ' "$actions")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data XDG_CACHE_HOME=$folder/cache HOME=$folder
"$batch" generate "$family" --count "$shape_count" --seed "$seed" --out "$folder/all" >/dev/null
mkdir "$folder/shapes"
for shape in $shapes; do mv "$folder/all/shapes/$shape".* "$folder/shapes"; done

count=$(grep -cEv '^(#|collection |most |wait )' "$actions")
echo "$count actions"
test "$count" -le $most_actions

# Runs inside the virtual display. The program rests when none of its threads has anything to do: then the window is
# drawn, and what was done to it has had its effect, however slow the machine is.
cat > "$folder/drive.sh" <<'DRIVE'
set -eu
"$1" "$2" &
program=$!
rest() {
  sleep 0.15
  for ((quiet = 0; quiet < 6; ++quiet)); do
    ! grep -qsE '^[0-9]+ \(.*\) [RD] ' "/proc/$program/task/"*/stat || quiet=-1
    sleep 0.05
  done
}
at() { xdotool mousemove "$1" "$2"; rest; }
window=$(timeout 60 xdotool search --sync --onlyvisible --name Archetype | head -1)
xdotool windowfocus "$window"
sleep 1
rest
while read -r action first more; do
  case $action in
    '#'* | collection | most) continue ;;
    wait) sleep "$first" ;;
    key) xdotool key "$first" ;;
    type) xdotool type --delay 40 "$first${more:+ $more}" ;;
    click) at "$first" "$more" && xdotool click 1 ;;
    ctrl-click) at "$first" "$more" && xdotool keydown ctrl sleep 0.2 click 1 && rest && xdotool keyup ctrl ;;
    *) echo "unknown action: $action" >&2; exit 1 ;;
  esac
  rest
done < "$3"
xdotool key ctrl+q
rest
xdotool key Return  # keep and close
wait "$program"
DRIVE
timeout 200 xvfb-run -a -s "-screen 0 1280x720x24 -noreset" \
  bash "$folder/drive.sh" "$studio" "$folder/shapes" "$actions"

made=$(ls "$folder"/*.json)  # the template is the only one there
test -z "$kept" || cp "$made" "$kept"
rounded() {
  awk '{ line = $0; sub(/[-0-9.e]+,?$/, "", line); text = substr($0, length(line) + 1); comma = sub(/,$/, "", text)
         if (text ~ /^-?[0-9]/) { text = sprintf("%.2f", text); if (text == "-0.00") text = "0.00" }
         print line text (comma ? "," : "") }' "$1"
}
rounded "$expected" > "$folder/expected.txt"
rounded "$made" > "$folder/made.txt"
diff "$folder/expected.txt" "$folder/made.txt"
