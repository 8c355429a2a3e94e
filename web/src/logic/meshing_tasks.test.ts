import { describe, expect, it } from 'vitest';
import { attemptColumns, ColumnTable, taskColumns } from '../api/columns';
import { meshingOf } from './meshing_tasks';

function tableOf(columns: typeof taskColumns, keys: string[], rows: unknown[][]): ColumnTable {
  const table = new ColumnTable(columns.numbers, columns.texts);
  table.append({ columns: keys, rows, next: 0 });
  return table;
}

describe('meshingOf', () => {
  const tasks = tableOf(taskColumns, ['task', 'kind', 'path', 'state', 'attempt', 'seconds', 'worker', 'min_dihedral_deg'], [
    [1, 'decompose', 4, 'done', 10, 9, ''],
    [2, 'mesh', 4, 'replaced', 11, 9, ''],
    [3, 'mesh', 4, 'done', 12, 2.5, '', 17.5],
    [4, 'mesh', 5, 'leased', 13, 1.5, 'worker-9'],
    [5, 'mesh', 6, 'ready', 11, 0, ''],
  ]);
  const attempts = tableOf(attemptColumns, ['attempt', 'worker'], [[11, 'worker-1'], [12, 'worker-3']]);

  it('tells who meshed, how long that took, and who is at it', () => {
    const found = meshingOf(tasks, attempts);
    expect([...found]).toEqual([
      [4, { task: 3, worker: 'worker-3', seconds: 2.5, angle: 17.5, isRunning: false }],
      [5, { task: 4, worker: 'worker-9', seconds: 0, angle: 0, isRunning: true }],
      [6, { task: 5, worker: '', seconds: 0, angle: 0, isRunning: false }],
    ]);
  });

  it('knows nothing without tasks, and no workers without attempts', () => {
    expect(meshingOf(undefined, attempts).size).toBe(0);
    expect(meshingOf(tasks, undefined).get(4)!.worker).toBe('');
  });
});
