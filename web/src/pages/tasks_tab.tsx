// All tasks of a job as a table that filters and sorts.

import { useMemo, useState } from 'preact/hooks';
import type { ColumnTable } from '../api/columns';
import { bytes, dash, duration, short, whole } from '../logic/format';
import { taskAddress } from '../logic/router';
import type { Cell } from '../logic/sort_filter';
import { fittingRows, sortedRows, textFits } from '../logic/sort_filter';
import { lookOf, taskStates } from '../logic/states';
import { inOrder, placeText } from '../logic/task_kinds';
import { Choice, Search } from '../ui/fields';
import { goTo } from '../ui/navigation';
import { Empty, Kind, Name, State, TaskLink } from '../ui/parts';
import type { Column, Sorting } from '../ui/virtual_table';
import { VirtualTable } from '../ui/virtual_table';

const orDash = (value: number | undefined, form: (value: number) => string) =>
  value ? form(value) : <span class="faint">{dash}</span>;

function columnsOf(tasks: ColumnTable): Column[] {
  const n = (name: string) => tasks.number(name);
  const t = (name: string) => tasks.text(name);
  const place = (row: number) => placeText(t('kind')[row]!, n('path')[row]!);
  const unlucky = (row: number) =>
    n('errors')[row]! + n('losses')[row]! + n('out_of_memory')[row]!;
  return [
    { key: 'task', words: 'Task', isNumber: true, cell: (row) => <TaskLink task={n('task')[row]!} /> },
    { key: 'kind', words: 'Kind', cell: (row) => <Kind kind={t('kind')[row]!} /> },
    { key: 'place', words: 'Place', cell: (row) => <Name text={place(row)} longest={24} /> },
    { key: 'state', words: 'State', cell: (row) => <State thing="task" state={t('state')[row]!} /> },
    { key: 'seconds', words: 'Time', isNumber: true, cell: (row) => orDash(n('seconds')[row], duration) },
    { key: 'expected_seconds', words: 'Expected', isNumber: true, isExtra: true, cell: (row) => orDash(n('expected_seconds')[row], duration) },
    { key: 'peak_rss_bytes', words: 'Peak memory', isNumber: true, isExtra: true, cell: (row) => orDash(n('peak_rss_bytes')[row], bytes) },
    { key: 'elements', words: 'Elements', isNumber: true, isExtra: true, cell: (row) => orDash(n('elements')[row], short) },
    { key: 'unlucky', words: 'Not done', isNumber: true, isExtra: true, cell: (row) => orDash(unlucky(row), whole) },
    { key: 'host', words: 'Host', isExtra: true, cell: (row) => <Name text={t('host')[row]} longest={24} /> },
  ];
}

function sortKey(tasks: ColumnTable, key: string): (row: number) => Cell {
  if (key === 'place') {
    // In tree order: the path as a number would sort by level first.
    return (row) => placeText(tasks.text('kind')[row]!, tasks.number('path')[row]!);
  }
  if (key === 'unlucky') {
    const [a, b, c] = ['errors', 'losses', 'out_of_memory'].map((name) => tasks.number(name));
    return (row) => a![row]! + b![row]! + c![row]!;
  }
  const texts = tasks.text(key);
  if (texts.length) return (row) => texts[row]!;
  const numbers = tasks.number(key);
  return (row) => numbers[row] ?? 0;
}

interface Wanted {
  state: string;
  kind: string;
  query: string;
}

function rowsFor(tasks: ColumnTable, wanted: Wanted): Uint32Array {
  const [state, kind, host, worker, message] = ['state', 'kind', 'host', 'worker', 'message'].map(
    (name) => tasks.text(name),
  );
  const [task, path] = [tasks.number('task'), tasks.number('path')];
  return fittingRows(
    tasks.count,
    (row) =>
      (!wanted.state || state![row] === wanted.state) &&
      (!wanted.kind || kind![row] === wanted.kind) &&
      (!wanted.query ||
        textFits(wanted.query, [
          `#${task[row]}`,
          placeText(kind![row]!, path[row]!),
          kind![row]!,
          host![row]!,
          worker![row]!,
          message![row]!,
        ])),
  );
}

export function TasksTab({ tasks }: { tasks: ColumnTable }) {
  const [wanted, want] = useState<Wanted>({ state: '', kind: '', query: '' });
  const [sorting, sort] = useState<Sorting>({ key: 'task', descending: false });
  const kinds = useMemo(() => inOrder(tasks.text('kind')), [tasks]);
  const columns = useMemo(() => columnsOf(tasks), [tasks]);
  const rows = useMemo(() => rowsFor(tasks, wanted), [tasks, wanted]);
  const sorted = useMemo(
    () => sortedRows(rows, sortKey(tasks, sorting.key), sorting.descending),
    [tasks, rows, sorting],
  );
  return (
    <>
      <div class="row filters">
        <Choice
          label="State"
          value={wanted.state}
          options={[
            { value: '', words: 'All states' },
            ...taskStates.map((state) => ({ value: state, words: lookOf('task', state).word })),
          ]}
          onChange={(state) => want({ ...wanted, state })}
        />
        <Choice
          label="Kind"
          value={wanted.kind}
          options={[{ value: '', words: 'All kinds' }, ...kinds.map((kind) => ({ value: kind, words: kind }))]}
          onChange={(kind) => want({ ...wanted, kind })}
        />
        <Search
          label="Task, place, host or message"
          value={wanted.query}
          onChange={(query) => want({ ...wanted, query })}
        />
        <span class="faint count" role="status">
          {whole(rows.length)} of {whole(tasks.count)}
        </span>
      </div>
      {rows.length === 0 ? (
        <Empty>No task fits the filter.</Empty>
      ) : (
        <VirtualTable
          label="Tasks"
          columns={columns}
          rows={sorted}
          rowKey={(row) => tasks.number('task')[row]!}
          sorting={sorting}
          onSort={sort}
          onOpen={(row) => goTo(taskAddress(tasks.number('task')[row]!))}
        />
      )}
    </>
  );
}
