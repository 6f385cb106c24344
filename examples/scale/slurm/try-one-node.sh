#!/bin/bash
# Tries check-class.sbatch for real, on a Slurm that is made from Debian's packages for this alone: one machine that plays two
# nodes. One of them is broken while it works, and one task is killed. docs/scale.md shows what this prints.
#
#   apt-get install slurm-wlm munge    and then, as root:    examples/scale/slurm/try-one-node.sh
#
# All files lie in a folder of their own, the ports are unusual ones, and in the end everything is stopped and removed.
set -euo pipefail
source "$(dirname "$0")/../try.sh"
export SLURM_CONF=$work/slurm.conf

stop() {
  scancel --user=root 2>/dev/null || true
  sleep 1
  for daemon in slurmd-n1 slurmd-n2 slurmctld munged; do
    if [ -f "$work/$daemon.pid" ]; then kill "$(cat "$work/$daemon.pid")" 2>/dev/null || true; fi
  done
  sleep 1
  rm -rf "$work"
}
trap stop EXIT

start_slurm() {
  mkdir "$work/state" "$work/spool"
  local host
  host=$(hostname -s)
  cat >"$SLURM_CONF" <<END
ClusterName=try
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool/%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd-%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SlurmdTimeout=10
MpiDefault=none
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[16818-16819] CPUs=1 RealMemory=2000
PartitionName=all Nodes=ALL Default=YES State=UP
END
  head -c 1024 /dev/urandom >"$work/munge.key"
  chmod 400 "$work/munge.key"
  chmod 755 "$work"
  munged --force --key-file="$work/munge.key" --socket="$work/munge.socket" --pid-file="$work/munged.pid" \
    --log-file="$work/munged.log" --seed-file="$work/munge.seed"
  slurmctld
  slurmd -N n1
  slurmd -N n2
  until [ "$(sinfo --noheader --states=idle --format=%D)" = 2 ]; do sleep 1; done
}

until_done() { while [ -n "$(squeue --noheader --job="$1" 2>/dev/null)" ]; do sleep 1; done; }

kill_with_children() {
  local pid
  for pid in $(pgrep -P "$1"); do kill_with_children "$pid"; done
  kill -9 "$1"
}

# What happens when somebody pulls the plug: neither the node nor its task can say goodbye.
break_node() {
  local daemon
  daemon=$(cat "$work/slurmd-$1.pid")
  for step in $(pgrep --full "^slurmstepd: \[$2\."); do kill_with_children "$step"; done
  kill_with_children "$daemon"
}

make_class 210
start_slurm
show sinfo
cd "$work"
show sbatch --cpus-per-task=1 "$here/check-class.sbatch" closed-line "$work/class" "$work/results"
job=$(squeue --noheader --format=%A | sort -n | head -1)
until [ "$(kept)" -ge 10 ]; do sleep 0.2; done
show squeue

echo "# The plug of n2 is pulled:"
task=$(squeue --noheader --array --nodelist=n2 --format='%A %K' | head -1)
break_node n2 "${task% *}"
until [ -n "$(sinfo --noheader --states=down --format=%N)" ]; do sleep 1; done
show sinfo

until grep --quiet --no-messages '"name":"pupil-026"' "$work"/results/results/*; do sleep 0.2; done
echo "# Somebody cancels the fifth task in the middle of its work:"
show scancel "${job}_5"
until_done "$job"

echo "# Slurm itself has run task ${task#* } again, on the other node. Of the fifth there is a rest:"
show parcours check --merge "$work/results"
touch "$work/before"
show sbatch --cpus-per-task=1 --array=5 "$here/check-class.sbatch" closed-line "$work/class" "$work/results"
until_done "$(squeue --noheader --format=%A | tail -1)"
echo "# Written anew: $(find "$work/results/results" -newer "$work/before" -name '*.json' | wc -l) of $(kept) results."

compare_reports
