# What the scripts that try a recipe have in common. They are started by hand, because they need root and Debian's packages.
# shellcheck shell=bash disable=SC2034
here=$(cd "$(dirname "$0")" && pwd)
PARCOURS=$(cd "$here/../../.." && pwd)
work=$(mktemp -d /tmp/parcours-try.XXXXXX)
export PARCOURS

parcours() { node "$PARCOURS/bin/parcours.mjs" "$@"; }

# Shows a command before it is carried out, with short paths as one would type them.
show() {
  echo "\$ $*" | sed "s|$here/||g; s|$work/||g"
  "$@" 2>&1 | sed "s|$work/||g" || true
}

# A class of this many: most follow the line, every tenth never gets anywhere.
make_class() {
  mkdir "$work/class"
  for pupil in $(seq -w 1 "$1"); do
    if [ $((10#$pupil % 10)) -eq 0 ]; then
      echo 'while True: pass'
    else
      echo "# pupil $pupil"
      cat "$PARCOURS/courses/closed-line/main.py"
    fi >"$work/class/pupil-$pupil.py"
  done
}

# How many results there are.
kept() { find "$work/results/results" -name '*.json' 2>/dev/null | wc -l; }

# Ends with an error unless the reports of the joined parts are those of one machine.
compare_reports() {
  local kinds=(html csv xml json) kind
  parcours check --merge "$work/results" --json --report "$work/together.html" --csv "$work/together.csv" \
    --junit "$work/together.xml" >"$work/together.json" || [ $? -eq 3 ]
  parcours check closed-line "$work/class" --json --report "$work/alone.html" --csv "$work/alone.csv" \
    --junit "$work/alone.xml" >"$work/alone.json" || [ $? -eq 3 ]
  for kind in "${kinds[@]}"; do
    show cmp "$work/together.$kind" "$work/alone.$kind"
    cmp --silent "$work/together.$kind" "$work/alone.$kind"
  done
  echo "The joined reports and those of one machine are the same, byte for byte."
}
