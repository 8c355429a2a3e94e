// What the tasks and attempts of a job say of its sub-domains: who meshed each, how long
// it took, and how good its elements were then.

import type { ColumnTable } from '../api/columns';
import type { ShownSubdomain } from './shown_subdomains';

export type Meshing = Pick<ShownSubdomain, 'worker' | 'seconds' | 'angle' | 'task'> & { isRunning: boolean };

/** By path; of several tasks the last that is not replaced counts. */
export function meshingOf(tasks: ColumnTable | undefined, attempts: ColumnTable | undefined): Map<number, Meshing> {
  const meshing = new Map<number, Meshing>();
  if (!tasks) return meshing;
  const attempt2worker = new Map<number, string>();
  if (attempts) {
    const [attempt, worker] = [attempts.number('attempt'), attempts.text('worker')];
    for (let row = 0; row < attempts.count; ++row) attempt2worker.set(attempt[row]!, worker[row]!);
  }
  const [kind, state, worker] = [tasks.text('kind'), tasks.text('state'), tasks.text('worker')];
  const [task, path, attempt, seconds, angle] = ['task', 'path', 'attempt', 'seconds', 'min_dihedral_deg'].map((name) => tasks.number(name));
  for (let row = 0; row < tasks.count; ++row) {
    if (kind[row] !== 'mesh' || state[row] === 'replaced') continue;
    const isDone = state[row] === 'done';
    const isRunning = state[row] === 'leased';
    const known = worker[row] || attempt2worker.get(attempt![row]!) || '';
    meshing.set(path![row]!, {
      task: task![row]!,
      worker: isDone || isRunning ? known : '',
      seconds: isDone ? seconds![row]! : 0,
      angle: isDone ? angle![row]! : 0,
      isRunning,
    });
  }
  return meshing;
}
