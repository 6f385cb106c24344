#!/bin/bash
# Tries check-class.sh for real on two computers: this one, and this one once more by SSH. docs/scale.md shows what it prints.
#
#   apt-get install parallel openssh-server    and then, as root:    examples/scale/gnu-parallel/try-two-hosts.sh
#
# The SSH server is for this alone: it hears only this computer, has keys of its own, and is stopped in the end.
set -euo pipefail
source "$(dirname "$0")/../try.sh"

stop() {
  if [ -f "$work/sshd.pid" ]; then kill "$(cat "$work/sshd.pid")"; fi
  rm -rf "$work"
}
trap stop EXIT

make_class 105

for key in host user; do ssh-keygen -q -t ed25519 -N '' -f "$work/$key"; done
cp "$work/user.pub" "$work/authorized"
mkdir -p /run/sshd
"$(command -v sshd)" -p 16820 -h "$work/host" -f /dev/null -o ListenAddress=127.0.0.1 -o PidFile="$work/sshd.pid" \
  -o AuthorizedKeysFile="$work/authorized" -o StrictModes=no -o PermitRootLogin=prohibit-password
cat >"$work/ssh-config" <<END
Host grace
  HostName 127.0.0.1
  Port 16820
  IdentityFile $work/user
  UserKnownHostsFile $work/known
  StrictHostKeyChecking accept-new
  LogLevel ERROR
END
hosts=(--ssh "ssh -F $work/ssh-config" --sshlogin :,grace)
cd "$work"
"$here/check-class.sh" closed-line "$work/class" "$work/results" "${hosts[@]}" &
parallel=$!
until [ "$(kept)" -ge 20 ]; do sleep 0.2; done
echo "# A part is killed:"
broken=$(pgrep --full "^node .*--resume $work/results" | tail -1)
tr '\0' ' ' <"/proc/$broken/cmdline" | sed "s|$PARCOURS/||; s|$work/||g"
echo
kill -9 "$broken"
wait "$parallel"
show cut -f 1,2,7 "$work/results/parts.log"
compare_reports
