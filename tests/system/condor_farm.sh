#!/bin/bash
# A real HTCondor on one machine: Debian 12 has no package, so that of Debian 13 lies in a folder of
# its own (CONDOR_ROOT, 600 MB) and runs there, in mount, network and UTS namespaces with loopback
# only. Wants root. DIR is the same folder there.
#   condor_farm.sh install                 debootstrap and packages; a minute, once
#   condor_farm.sh installed               whether that was done
#   condor_farm.sh up DIR OWNER            ends by itself when the process OWNER has ended
#   condor_farm.sh exec DIR COMMAND...     in there, as the user tester, in DIR
#   condor_farm.sh kill DIR NAME           SIGKILL to its processes of that name
#   condor_farm.sh down DIR
set -u
root=${CONDOR_ROOT:-${HOME:-/root}/.cache/condor-root}
self=$(readlink -f "$0")
action=$1

enter() {  # FOLDER COMMAND...
  local pid
  pid=$(cat "$1/namespace.pid")
  shift
  nsenter -t "$pid" -m -n -u chroot "$root" "$@"
}

install() {
  [ "$(id -u)" = 0 ] || { echo "wants root" >&2; exit 1; }
  export DEBIAN_FRONTEND=noninteractive
  [ -x /usr/sbin/debootstrap ] ||
    apt-get -q -o DPkg::Lock::Timeout=600 install -y --no-install-recommends debootstrap || exit 1
  [ -d "$root/usr/bin" ] ||
    debootstrap --variant=minbase --include=ca-certificates,iproute2,procps trixie "$root" || exit 1
  printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d"
  chmod +x "$root/usr/sbin/policy-rc.d"
  cp /etc/resolv.conf "$root/etc/"
  chroot "$root" apt-get -q update &&
    chroot "$root" apt-get -q install -y --no-install-recommends minicondor condor
}

configuration() {
  cat <<'END'
CONDOR_HOST = 127.0.0.1
NETWORK_INTERFACE = 127.0.0.1
BIND_ALL_INTERFACES = False
NUM_CPUS = 4
MEMORY = 8000
NEGOTIATOR_INTERVAL = 2
NEGOTIATOR_CYCLE_DELAY = 1
NEGOTIATOR_MIN_INTERVAL = 1
SCHEDD_INTERVAL = 5
SCHEDD_MIN_INTERVAL = 1
UPDATE_INTERVAL = 5
SHADOW_QUEUE_UPDATE_INTERVAL = 5
MachineMaxVacateTime = 10
CGROUP_MEMORY_LIMIT_POLICY = none
BASE_CGROUP =
MOUNT_UNDER_SCRATCH =
END
}

# Runs in the new namespaces, outside of the other root. Its '/' has to be a mount point, or no job starts;
# what the daemons write lies in memory, so that each start is a fresh one.
prepare() {  # FOLDER
  local folder
  mount --make-rprivate /
  mount --bind "$root" "$root"
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount --bind /sys "$root/sys"
  for folder in run tmp var/log/condor var/lib/condor var/spool var/lock; do
    mkdir -p "$root/$folder"
    mount -t tmpfs tmpfs "$root/$folder"
  done
  mkdir -p "$root$1"
  mount --bind "$1" "$root$1"
  ip link set lo up
  chroot "$root" sh -c '
    echo "127.0.0.1 vm localhost" >/etc/hosts
    id tester >/dev/null 2>&1 || useradd -m tester
    mkdir -p /run/condor /run/lock/condor /var/spool/condor /var/lock/condor /var/lib/condor/execute /var/lib/condor/spool
    chown condor:condor /run/condor /run/lock/condor /var/lock/condor /var/log/condor /var/lib/condor/* /var/spool/condor
    chmod 755 /var/lib/condor/execute
    chmod 1777 /tmp
    condor_master'
  echo $$ >"$1/namespace.pid"
  exec sleep infinity
}

up() {  # FOLDER OWNER
  local i
  configuration >"$root/etc/condor/config.d/99-tetfarm"
  setsid unshare -m -n -u "$self" prepare "$1" >"$1/up.log" 2>&1 </dev/null &
  setsid "$self" watch "$1" "$2" >/dev/null 2>&1 </dev/null &
  for i in $(seq 60); do
    sleep 0.5
    [ -f "$1/namespace.pid" ] && enter "$1" condor_status -af Name 2>/dev/null | grep -q . && return 0
  done
  echo "HTCondor does not come up:" >&2
  tail -n 20 "$1/up.log" >&2
  exit 1
}

# The processes in the network namespace, of a name or all.
members() {  # FOLDER [NAME]
  local pid space process
  pid=$(cat "$1/namespace.pid" 2>/dev/null) || return 0
  space=$(readlink "/proc/$pid/ns/net") || return 0
  for process in /proc/[0-9]*; do
    [ "$(readlink "$process/ns/net" 2>/dev/null)" = "$space" ] || continue
    [ -z "${2:-}" ] || [ "$(cat "$process/comm" 2>/dev/null)" = "$2" ] || continue
    echo "${process#/proc/}"
  done
}

# The namespaces and what is mounted there end with the last of them.
down() {  # FOLDER
  local process
  for process in $(members "$1"); do kill -KILL "$process" 2>/dev/null; done
  rm -f "$1/namespace.pid"
}

case $action in
  install) install ;;
  installed) [ "$(id -u)" = 0 ] && [ -x "$root/usr/sbin/condor_master" ] ;;
  prepare) prepare "$2" ;;
  up) up "$(realpath "$2")" "$3" ;;
  exec) # each program becomes the next: a signal to this process reaches COMMAND
    folder=$(realpath "$2")
    shift 2
    exec nsenter -t "$(cat "$folder/namespace.pid")" -m -n -u chroot --userspec=tester:tester \
      "$root" env HOME=/home/tester sh -c 'cd "$0" && exec "$@"' "$folder" "$@"
    ;;
  kill) for process in $(members "$(realpath "$2")" "$3"); do kill -KILL "$process"; done ;;
  watch)
    while kill -0 "$3" 2>/dev/null && [ -d "$2" ]; do sleep 1; done
    down "$2"
    ;;
  down) down "$(realpath "$2")" ;;
  *) exit 2 ;;
esac
