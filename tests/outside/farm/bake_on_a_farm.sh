#!/usr/bin/env bash
# 80 probes baked by one process, by Slurm's array job of eight, by mpiexec, GNU parallel and make: the same bytes. Placing and
# a report by Slurm, too. And workers killed in the middle: what they left undone is made again.
#   tests/outside/farm/bake_on_a_farm.sh BOXPROBE GENERATE_SCENES FOLDER
# A Slurm of one machine is set up in FOLDER and ended with it; that needs root.
set -euo pipefail
boxprobe=$(realpath "$1") generate=$(realpath "$2")
folder=$(mkdir -p "$3" && realpath "$3")
left_out() { echo "left out: $*"; exit 77; }
for needed in munged:munge slurmctld:slurm-wlm parallel:parallel mpiexec:openmpi-bin make:make; do
  command -v "${needed%%:*}" >/dev/null || left_out "package ${needed#*:} is not installed"
done
((EUID == 0)) || left_out "Slurm's daemons need root"
rm -rf "${folder:?}"/*
cd "$folder"

"$generate" . --apartments 64 >/dev/null
sed -E 's/"faceSize": [0-9]+/"faceSize": 32/' apartments-64.boxprobe.json >scene.boxprobe.json
grep -q '"faceSize": 32' scene.boxprobe.json || sed -i 's/"name": "\(room\|corridor\) /"faceSize": 32, &/' scene.boxprobe.json
export GALLIVM_PERF=nopt OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
unset DISPLAY
bake=("$boxprobe" bake scene.boxprobe.json)

timed() { # NAME COMMAND...: wall and CPU seconds of it
  local name=$1 TIMEFORMAT="$1: %R s, CPU %U + %S s"
  shift
  time "$@"
}
same() {
  "${bake[@]}" -o "$1" --check --quiet
  diff -r whole "$1" || { echo "$1: other bytes than one process's"; exit 1; }
  echo "$1: $(find "$1" -name '*.exr' | wc -l) files, the same bytes"
}

timed "one process" "${bake[@]}" -o whole --quiet
"${bake[@]}" -o whole --list | tail -1
timed "mpiexec -n 3" mpiexec --oversubscribe -n 3 "${bake[@]}" -o mpi --quiet
same mpi
"${bake[@]}" -o parallel --emit parallel --shards 8 >parallel.sh
PARALLEL="-j 2 --will-cite" timed "GNU parallel" sh parallel.sh >/dev/null
same parallel
"${bake[@]}" -o make --emit make --shards 8 >bake.mk
timed make make -s -j 2 -f bake.mk >/dev/null
same make

# Rows of one reference picture.
trace=("$boxprobe" render scene.boxprobe.json --technique reference-scene --size 320x180 --rays 64 --quiet)
timed "a reference, one process" "${trace[@]}" -o alone.exr
timed "a reference, mpiexec -n 3" mpiexec --oversubscribe -n 3 "${trace[@]}" -o shared.exr
cmp alone.exr shared.exr

# A Slurm of this machine alone, its files in the folder.
mkdir -p slurm/state slurm/spool
dd if=/dev/urandom of=slurm/munge.key bs=64 count=1 status=none
chmod 600 slurm/munge.key
socket=$folder/slurm/munge.socket
munged --force --key-file="$folder/slurm/munge.key" --socket="$socket" --pid-file="$folder/slurm/munged.pid" \
  --log-file="$folder/slurm/munged.log" --seed-file="$folder/slurm/munge.seed" 2>/dev/null
host=$(hostname -s)
cat >slurm/slurm.conf <<CONF
ClusterName=farm
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$socket
CryptoType=crypto/munge
SlurmUser=root
StateSaveLocation=$folder/slurm/state
SlurmdSpoolDir=$folder/slurm/spool
SlurmctldPidFile=$folder/slurm/slurmctld.pid
SlurmdPidFile=$folder/slurm/slurmd.pid
SlurmctldLogFile=$folder/slurm/slurmctld.log
SlurmdLogFile=$folder/slurm/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmctldTimeout=30
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm/slurm.conf
end_slurm() {
  for daemon in slurmd slurmctld munged; do
    [ -f "$folder/slurm/$daemon.pid" ] && kill "$(cat "$folder/slurm/$daemon.pid")" 2>/dev/null || true
  done
}
trap end_slurm EXIT
slurmctld && slurmd
for _ in $(seq 60); do [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && break; sleep 1; done
[ "$(sinfo -h -o %T)" = idle ] || { echo "Slurm does not start:"; tail -5 slurm/*.log; exit 1; }
slurm() { # until the last job of the script, its check, has ended
  local last
  last=$(sh slurm.sh | tail -1)
  while squeue -h -j "$last" 2>/dev/null | grep -q .; do sleep 1; done
}
"${bake[@]}" -o slurm-bake --emit slurm --shards 8 >slurm.sh
timed "Slurm, array of 8" slurm
same slurm-bake

# Placing probes: fits by one array, pictures from the rooms by the next, a job that writes the scene. Fewer rooms, since one
# process compares pictures for many minutes where there are 64: with BOXPROBE_FARM_ROOMS=64 they are the same.
"$generate" . --apartments "${BOXPROBE_FARM_ROOMS:-2}" >/dev/null
rooms=apartments-${BOXPROBE_FARM_ROOMS:-2}.boxprobe.json
place=("$boxprobe" place "$rooms")
timed "placing, one process" "${place[@]}" -o placed.boxprobe.json --quiet
"${place[@]}" -o placed-slurm.boxprobe.json --emit slurm --shards 8 >slurm.sh
timed "placing, Slurm, arrays of 8" slurm
cmp placed.boxprobe.json placed-slurm.boxprobe.json
# A worker of the second step killed by Slurm's own means; the others and the last job make up for it.
"${place[@]}" -o placed-killed.boxprobe.json --emit slurm --shards 4 >slurm.sh
last=$(sh slurm.sh | tail -1)
until [ "$(find placed-killed.boxprobe.json.parts -name 'eye-*' 2>/dev/null | wc -l)" -ge 3 ]; do sleep 0.1; done
victim=$(squeue -h -t R -o %i -n boxprobe-place | head -1)
scancel --signal=KILL --full "$victim"
while squeue -h -j "$last" 2>/dev/null | grep -q .; do sleep 1; done
echo "placing, task $victim killed"
cmp placed.boxprobe.json placed-killed.boxprobe.json
[ ! -e placed-killed.boxprobe.json.parts ] || { echo "parts are left"; exit 1; }

# A report: bands of traced pictures and fits of boxes. One process that says nothing of its own seconds is --merge alone.
report=("$boxprobe" report "$folder/scene.boxprobe.json" --quick --size 160x90 -o "$folder/report.html")
timed "a report, one process" "${report[@]}" --merge --quiet
mv report.html report-alone.html
"${report[@]}" --emit slurm --shards 8 >slurm.sh
timed "a report, Slurm, array of 8" slurm
cmp report-alone.html report.html

# A worker killed in the middle of its share.
"${bake[@]}" -o killed --shard 1/2 --quiet &
worker=$!
while [ "$(find killed -name 'room*.exr' 2>/dev/null | wc -l)" -lt 5 ]; do sleep 0.1; done
kill -9 $worker
wait $worker 2>/dev/null || true
status=0
"${bake[@]}" -o killed --check || status=$?
[ $status = 3 ] || { echo "--check ended with $status"; exit 1; }
"${bake[@]}" -o killed --shard 1/2 --quiet
"${bake[@]}" -o killed --shard 2/2 --quiet
same killed
