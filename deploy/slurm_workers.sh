#!/bin/bash
# Workers under Slurm: sbatch --array=1-20 slurm_workers.sh
#SBATCH --job-name=tetfarm-worker
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --mem=4G
#SBATCH --time=08:00:00
#SBATCH --requeue
#SBATCH --signal=TERM@60
#SBATCH --output=tetfarm-worker-%A_%a.log
export TETFARM_COORDINATOR=tcp://HEAD:5555
export TETFARM_STORE=/SHARED/farm
# exec: the signal has to reach the worker, not a shell that waits for it.
exec srun /SHARED/bin/tetfarm worker --memory-limit 3500MB --grace 45
