#!/usr/bin/env bash
# A project on a disk that is full: a clear message, nothing lost that was saved, and what was edited meanwhile is saved
# once there is space. Needs to mount a small disk: exit status 77 where that is not allowed.
#
# usage: full_disk.sh STUDIO BATCH
set -eu
studio=$1
batch=$2
folder=$(mktemp -d)
mkdir "$folder/disk"
mount -t tmpfs -o size=1m archetype-test "$folder/disk" 2>/dev/null || { rm -rf "$folder"; echo "skipped: no disk can be mounted"; exit 77; }
trap 'umount "$folder/disk"; rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data XDG_CACHE_HOME=$folder/cache HOME=$folder
unset DISPLAY WAYLAND_DISPLAY
small="--set window_width=480 --set window_height=320"
"$batch" generate chairs --count 1 --out "$folder/chairs" >/dev/null
"$batch" import "$folder/disk/p.archetype" "$folder/chairs/shapes" >/dev/null

parts() {
  rm -f "$folder/kept.json"
  echo "save-template $folder/kept.json" > "$folder/keep.txt"
  timeout 60 "$studio" $small "$folder/disk/p.archetype" --script "$folder/keep.txt" --quit 2>/dev/null || true
  grep -c '"name": "part' "$folder/kept.json"
}

printf 'new-template\nadd-part\n' > "$folder/script.txt"
timeout 60 "$studio" $small "$folder/disk/p.archetype" --script "$folder/script.txt" --quit
test "$(parts)" = 1

fill() { cat /dev/zero > "$folder/disk/filler" 2>/dev/null || true; }

# Full from the start: the message says so, the status too, and what was saved is there.
fill
printf 'add-part\nadd-part\n' > "$folder/script.txt"
status=0
timeout 60 "$studio" $small "$folder/disk/p.archetype" --script "$folder/script.txt" --quit 2> "$folder/errors.txt" || status=$?
cat "$folder/errors.txt"
test "$status" = 1
grep -q 'the disk is full' "$folder/errors.txt"
test "$(parts)" = 1

# Full when it is edited, and free later: work goes on, and is saved by itself.
printf 'add-part\nadd-part\ndrag-part 0.3 0 0 100\n' > "$folder/script.txt"
status=0
timeout 100 "$studio" $small "$folder/disk/p.archetype" --script "$folder/script.txt" --quit 2> "$folder/errors.txt" &
program=$!
sleep 1
rm "$folder/disk/filler"
wait "$program" || status=$?
cat "$folder/errors.txt"
test "$(parts)" = 3
