#!/bin/sh
# Workers under Slurm: sbatch FILE
#SBATCH --job-name=tetfarm-farm-4096M
#SBATCH --array=1-20
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --mem=4096M
#SBATCH --time=08:00:00
#SBATCH --signal=B:TERM@90
#SBATCH --no-requeue
#SBATCH --open-mode=append
#SBATCH --output=/SHARED/logs/tetfarm-farm-4096M-%A_%a.log
# exec: signals have to reach the worker, not a shell that waits for it.
exec /SHARED/bin/tetfarm worker --connect tcp://HEAD:5555 --store /SHARED/farm --key /SHARED/keys/worker.key --memory 3584MB --pool-memory 14336MB --walltime 28800 --grace 60 --tag "farm/${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}"
