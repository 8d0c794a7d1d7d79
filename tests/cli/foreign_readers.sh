#!/usr/bin/env bash
# What export writes, read by programs that are not ours: the point clouds by the Point Cloud Library, with the same
# points, parts and colours, and by CloudCompare where it is installed; the labels by awk, one for each face of the file;
# the plots by libxml2. Exit status 77 without pcl_ply2pcd (Debian's pcl-tools).
#
# usage: foreign_readers.sh BATCH TEMPLATE
set -eu
batch=$1
command -v pcl_ply2pcd >/dev/null || { echo "skipped: there is no pcl_ply2pcd (apt-get install pcl-tools)"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$batch" generate chairs --count 3 --out chairs >/dev/null
"$batch" import p.archetype chairs/shapes >/dev/null
"$batch" fit p.archetype --template "$2" >/dev/null
"$batch" export p.archetype --out result >/dev/null

shapes=0
for cloud in result/coaligned/*.ply; do
  name=$(basename "$cloud" .ply)
  header=$(grep -abo end_header "$cloud" | head -1 | cut -d: -f1)
  # The last 11 of a point's 59 bytes: part, face, red, green, blue.
  tail -c +$((header + 12)) "$cloud" | od -An -v -t u1 -w59 |
    awk '{ part = $49 == 255 ? -1 : $49; print part, $53 + 256 * ($54 + 256 * $55), $57, $58, $59 }' > ours.txt
  pcl_ply2pcd -format 0 "$cloud" cloud.pcd > log.txt
  awk 'data { rgb = $9; print $7, $8, int(rgb / 65536) % 256, int(rgb / 256) % 256, rgb % 256 } /^DATA ascii/ { data = 1 }' \
    cloud.pcd > theirs.txt
  diff ours.txt theirs.txt > difference.txt || { echo "$name: read otherwise"; head -5 difference.txt; exit 1; }
  test "$(wc -l < theirs.txt)" = "$(awk '/^POINTS/ { print $2 }' cloud.pcd)"
  test "$(wc -l < theirs.txt)" -ge 900

  if command -v CloudCompare >/dev/null; then
    HOME=$folder QT_QPA_PLATFORM=offscreen CloudCompare -SILENT -O "$cloud" -NO_TIMESTAMP -C_EXPORT_FMT ASC -PREC 9 \
      -SAVE_CLOUDS FILE compared.asc > log.txt 2>&1
    awk 'data { print $1, $2, $3 } /^DATA ascii/ { data = 1 }' cloud.pcd |
      paste -d ' ' - <(awk '{ print $3, $4, $5 }' ours.txt) compared.asc |
      awk 'NF != 12 { exit 1 }
           { for (k = 1; k <= 6; k++) { d = $k - $(k + 6); if (d > 1e-5 || d < -1e-5) exit 1 } }
           END { if (NR < 900) exit 1 }' || { echo "$name: read otherwise by CloudCompare"; exit 1; }
  fi

  # As many labels as the shape has faces, and those of the samples' parts nearly everywhere.
  test "$(wc -l < "result/labels/$name.seg")" = "$(awk 'NR == 2 { print $2 }' "chairs/shapes/$name.off")"
  awk -F, 'FILENAME == ARGV[1] { if (FNR > 1) label[$2] = $4; next }
       FILENAME == ARGV[2] { of_face[FNR - 1] = $1; next }
       { split($0, p, " "); if (p[1] >= 0) { all++; same += of_face[p[2]] == label[p[1]] } }
       END { if (all < 100 || same < 0.9 * all) { print same, "of", all, "samples have the label of their face"; exit 1 } }' \
    result/parts.csv "result/labels/$name.seg" theirs.txt
  shapes=$((shapes + 1))
done
test "$shapes" = 3

if command -v xmllint >/dev/null; then
  for plot in members energies energy-terms part-presence part-parameters; do
    "$batch" plot p.archetype --plot $plot --out $plot.svg >/dev/null
    xmllint --noout --nonet $plot.svg
  done
fi
echo "3 clouds, their labels and the plots are read alike by other programs"
