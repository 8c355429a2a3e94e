#!/bin/bash
# Workers under LSF: bsub < lsf_workers.sh
#BSUB -J tetfarm-worker[1-20]
#BSUB -n 1
#BSUB -M 4GB
#BSUB -W 8:00
#BSUB -wt 1
#BSUB -wa TERM
#BSUB -r
#BSUB -o tetfarm-worker-%J_%I.log
export TETFARM_COORDINATOR=tcp://HEAD:5555
export TETFARM_STORE=/SHARED/farm
exec /SHARED/bin/tetfarm worker --memory-limit 3500MB --grace 45
