#!/bin/sh
# Workers under Grid Engine: qsub FILE
#$ -N tetfarm-farm-4096M
#$ -t 1-20
#$ -S /bin/sh
#$ -cwd
#$ -l h_rt=08:00:00
#$ -l h_vmem=4096M
#$ -notify
#$ -r n
#$ -j y
#$ -o /SHARED/logs/$JOB_NAME-$JOB_ID.$TASK_ID.log
# exec: signals have to reach the worker, not a shell that waits for it.
exec /SHARED/bin/tetfarm worker --connect tcp://HEAD:5555 --store /SHARED/farm --key /SHARED/keys/worker.key --memory 3584MB --pool-memory 14336MB --walltime 28800 --grace 60 --tag "farm/${JOB_ID}.${SGE_TASK_ID}"
