#!/bin/bash
# Checks a class on several computers by GNU parallel, each with a part of the hand-ins at a time.
#
#   check-class.sh closed-line ~/class ~/results                          on this computer
#   check-class.sh closed-line ~/class ~/results --sshlogin :,ada,grace   on this one and two more
#
# The computers share a folder with hand-ins and results, and one with Parcours (PARCOURS), under the same paths, given from
# the root. The same command once more goes on with what was interrupted, and runs what pupils have handed in anew.
PARCOURS=${PARCOURS:-$HOME/parcours}
PARTS=${PARTS:-7}

task=$1 hand_ins=$2 results=$3
shift 3
mkdir -p "$results"
# One part at a time uses all threads of a computer; one that breaks is tried three times.
# 3: some have not passed. That is a result, and no failure.
parallel --quote --jobs 1 --joblog "$results/parts.log" --retries 3 "$@" \
  bash -c 'node "$1" check "$2" "$3" --resume "$4" --shard "$5" --quiet || [ $? -eq 3 ]' \
  check-class "$PARCOURS/bin/parcours.mjs" "$task" "$hand_ins" "$results" "{}/$PARTS" ::: $(seq "$PARTS")
