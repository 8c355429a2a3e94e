#!/bin/bash
# A real Slurm on one machine, for any user, without systemd: munge, a controller, and nodes n1, n2 …
# that all are this host, on loopback ports. Packages: slurmctld slurmd slurm-client
# slurm-wlm-basic-plugins munge.
#   slurm_farm.sh up DIR NODES PORT OWNER   ends by itself when the process OWNER has ended
#   slurm_farm.sh down DIR
#   slurm_farm.sh kill-node DIR nX | start-node DIR nX      with all that runs there
#   slurm_farm.sh kill-controller DIR | start-controller DIR
# Use it with SLURM_CONF=DIR/slurm.conf.
set -u
action=$1
folder=$(realpath -m "$2")
export SLURM_CONF=$folder/slurm.conf
self=$(readlink -f "$0")

in_background() {  # LOG COMMAND...
  local log=$1
  shift
  setsid "$@" >>"$log" 2>&1 </dev/null &
}

start_node() { in_background "$folder/log/$1.out" slurmd -D -N "$1" -f "$SLURM_CONF"; }
start_controller() { in_background "$folder/log/slurmctld.out" slurmctld -D -f "$SLURM_CONF"; }

# The process and all below it, lowest first.
kill_tree() {  # SIGNAL PROCESS
  local child
  for child in $(ps -o pid= --ppid "$2"); do kill_tree "$1" "$child"; done
  kill "-$1" "$2" 2>/dev/null
}

write_configuration() {  # NODES PORT
  local host i nodes
  host=$(hostname -s)
  nodes=$(seq -s, -f n%g "$1")
  cat <<END
ClusterName=tetfarm
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmctldPort=$2
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.%n.pid
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool/%n
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.%n.log
MailProg=/bin/true
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerType=sched/backfill
SchedulerParameters=bf_interval=2,sched_interval=2
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=10
SlurmctldTimeout=10
KillWait=5
MinJobAge=10
JobRequeue=1
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
END
  for i in $(seq "$1"); do
    echo "NodeName=n$i NodeHostname=$host NodeAddr=127.0.0.1 Port=$(($2 + i)) CPUs=2 RealMemory=4000 State=UNKNOWN"
  done
  echo "PartitionName=mesh Nodes=$nodes Default=YES MaxTime=INFINITE State=UP PriorityTier=1 PreemptMode=REQUEUE GraceTime=5"
  echo "PartitionName=urgent Nodes=$nodes MaxTime=INFINITE State=UP PriorityTier=100 PreemptMode=OFF"
}

up() {  # NODES PORT OWNER
  local i
  mkdir -p "$folder"/{munge,state,log}
  chmod 0711 "$folder/munge"
  for i in $(seq "$1"); do mkdir -p "$folder/spool/n$i"; done
  (umask 077 && head -c 1024 /dev/urandom >"$folder/munge/key")
  munged --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
    --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" \
    --seed-file="$folder/munge/seed" || exit 1
  write_configuration "$1" "$2" >"$SLURM_CONF"
  start_controller
  for i in $(seq "$1"); do start_node "n$i"; done
  in_background "$folder/log/watch" "$self" watch "$folder" "$3"
  for i in $(seq 60); do
    sleep 0.5
    [ "$(sinfo -h -N -p mesh -o %T 2>/dev/null | grep -c idle)" = "$1" ] && return 0
  done
  echo "Slurm does not come up:" >&2
  tail -n 5 "$folder"/log/* >&2
  exit 1
}

down() {
  local file
  for file in "$folder"/slurmd.*.pid; do [ -f "$file" ] && kill_tree KILL "$(cat "$file")"; done
  for file in "$folder/slurmctld.pid" "$folder/munge/pid"; do
    [ -f "$file" ] && kill -TERM "$(cat "$file")" 2>/dev/null
  done
  for file in $(steps ''); do kill_tree KILL "$file"; done
  return 0
}

# The step processes of a job, or of all: they are not below their node's daemon, but know its
# configuration, which tells them from those of another Slurm.
steps() {  # JOB
  local process
  for process in $(pgrep -x slurmstepd); do
    tr '\0' '\n' 2>/dev/null <"/proc/$process/environ" | grep -qx "SLURM_CONF=$SLURM_CONF" || continue
    [ -z "$1" ] || tr '\0' ' ' <"/proc/$process/cmdline" | grep -qF "[$1." || continue
    echo "$process"
  done
}

kill_node() {
  local job step
  kill -KILL "$(cat "$folder/slurmd.$1.pid")"
  for job in $(squeue -h -w "$1" -o %A); do
    for step in $(steps "$job"); do kill_tree KILL "$step"; done
  done
}

case $action in
  up) up "$3" "$4" "$5" ;;
  down) down ;;
  watch)
    while kill -0 "$3" 2>/dev/null && [ -d "$folder" ]; do sleep 1; done
    down
    ;;
  kill-node) kill_node "$3" ;;
  start-node) start_node "$3" ;;
  kill-controller) kill -KILL "$(cat "$folder/slurmctld.pid")" ;;
  start-controller) start_controller ;;
  *) exit 2 ;;
esac
