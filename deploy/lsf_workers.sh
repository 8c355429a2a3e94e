#!/bin/sh
# Workers under LSF: bsub < FILE
#BSUB -J "tetfarm-farm-4096M[1-20]"
#BSUB -n 1
#BSUB -R "span[hosts=1] rusage[mem=4096MB]"
#BSUB -M 4096MB
#BSUB -W 8:00
#BSUB -wt '1'
#BSUB -wa 'TERM'
#BSUB -rn
#BSUB -o "/SHARED/logs/tetfarm-farm-4096M-%J_%I.log"
# exec: signals have to reach the worker, not a shell that waits for it.
exec /SHARED/bin/tetfarm worker --connect tcp://HEAD:5555 --store /SHARED/farm --key /SHARED/keys/worker.key --memory 3584MB --pool-memory 14336MB --walltime 28800 --grace 60 --tag "farm/${LSB_JOBID}[${LSB_JOBINDEX}]"
