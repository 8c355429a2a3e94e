// The decomposition tree of a job: bars below one another, drawn on a canvas, into which one zooms.

import { useMemo, useState } from 'preact/hooks';
import type { ColumnTable } from '../api/columns';
import type { Job } from '../api/types';
import { bytes, dash, duration, percent, short, whole } from '../logic/format';
import { harmlessName } from '../logic/harmless';
import type { Tree } from '../logic/tree_layout';
import { ancestors, neighbour, nodeAt, rankedStates, treeOf } from '../logic/tree_layout';
import { lookOf } from '../logic/states';
import { isOfCycle, pathText, placeText } from '../logic/task_kinds';
import { Bar, Empty, Kind, Name, State, TaskLink } from '../ui/parts';
import { Surface } from '../ui/surface';
import { drawTree, rowHeightOf } from './tree_drawing';
import { TreeLegend } from './tree_legend';

/** Without what is of no sub-domain: cycles of a loop. */
function treeOfTasks(tasks: ColumnTable): Tree {
  const [kind, state] = [tasks.text('kind'), tasks.text('state')];
  const [task, path, share] = [tasks.number('task'), tasks.number('path'), tasks.number('share')];
  return treeOf(tasks.count, (i) =>
    path[i]! > 0 && !isOfCycle(kind[i]!)
      ? { task: task[i]!, path: path[i]!, state: state[i]!, share: share[i]! }
      : undefined,
  );
}

function tasksOfPath(tasks: ColumnTable, path: number): number[] {
  const [paths, kind] = [tasks.number('path'), tasks.text('kind')];
  const rows: number[] = [];
  for (let row = 0; row < tasks.count; ++row) {
    if (paths[row] === path && !isOfCycle(kind[row]!)) rows.push(row);
  }
  return rows;
}

const expectedAnd = (actual: number, expected: number, form: (value: number) => string) =>
  `${actual > 0 ? form(actual) : dash} / ${expected > 0 ? form(expected) : dash}`;

function Detail({ tree, tasks, node }: { tree: Tree; tasks: ColumnTable; node: number }) {
  const path = tree.path[node]!;
  const rows = useMemo(() => tasksOfPath(tasks, path), [tasks, path]);
  const n = (name: string, row: number) => tasks.number(name)[row] ?? 0;
  return (
    <section class="detail" aria-label="The sub-domain">
      <h2>
        <Name text={path === 1 ? 'The whole domain' : `Sub-domain ${pathText(path)}`} longest={80} />{' '}
        <small>level {tree.level[node]}, heap number {path}</small>
      </h2>
      {rows.length === 0 ? (
        <Empty>It has no task of its own (any more).</Empty>
      ) : (
        <div class="scroller" tabIndex={0} role="region" aria-label="Tasks of the sub-domain">
          <table class="small">
            <thead>
              <tr>
                <th scope="col">Task</th>
                <th scope="col">Kind</th>
                <th scope="col">State</th>
                <th scope="col" class="number">Time / expected</th>
                <th scope="col" class="number">Peak memory / expected</th>
                <th scope="col" class="number">Elements / expected</th>
              </tr>
            </thead>
            <tbody>
              {rows.map((row) => (
                <tr key={row}>
                  <td><TaskLink task={n('task', row)} /></td>
                  <td><Kind kind={tasks.text('kind')[row]!} /></td>
                  <td>
                    <State thing="task" state={tasks.text('state')[row]!} />{' '}
                    {tasks.text('state')[row] === 'leased' && (
                      <span class="faint">
                        {n('share', row) > 0 && `${percent(n('share', row))} `}
                        <Name text={tasks.text('doing')[row]} longest={60} />
                      </span>
                    )}
                  </td>
                  <td class="number">{expectedAnd(n('seconds', row), n('expected_seconds', row), duration)}</td>
                  <td class="number">{expectedAnd(n('peak_rss_bytes', row), n('expected_bytes', row), bytes)}</td>
                  <td class="number">{expectedAnd(n('elements', row), n('expected_elements', row), short)}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </section>
  );
}

function Crumbs({ path, onZoom }: { path: number; onZoom: (path: number) => void }) {
  const line = ancestors(path);
  return (
    <nav class="crumbs" aria-label="Zoomed into">
      {line.map((at) => {
        const words = at === 1 ? 'Whole domain' : at % 2 === 0 ? 'L' : 'R';
        const full = at === 1 ? 'the whole domain' : `sub-domain ${pathText(at)}`;
        return at === path ? (
          <span key={at} aria-current="true">{words}</span>
        ) : (
          <button key={at} type="button" class="crumb" aria-label={`Zoom out to ${full}`} onClick={() => onZoom(at)}>
            {words}
          </button>
        );
      })}
    </nav>
  );
}

function Running({ job }: { job: Job }) {
  const running = job.running ?? [];
  if (running.length === 0) return null;
  return (
    <section>
      <h2>Running the longest</h2>
      <div class="scroller" tabIndex={0} role="region" aria-label="Running the longest">
        <table class="small">
          <thead>
            <tr>
              <th scope="col">Task</th>
              <th scope="col">Kind</th>
              <th scope="col">Place</th>
              <th scope="col" class="number">For</th>
              <th scope="col">Progress</th>
              <th scope="col">Does</th>
            </tr>
          </thead>
          <tbody>
            {running.map((task) => (
              <tr key={task.task}>
                <td><TaskLink task={task.task} /></td>
                <td><Kind kind={task.kind} /></td>
                <td><Name text={placeText(task.kind, task.path)} longest={30} /></td>
                <td class="number">{duration(task.seconds)}</td>
                <td>
                  {task.share > 0 && (
                    <span class="progress">
                      <Bar share={task.share} label={`progress of task ${task.task}`} />
                      <span class="percent">{percent(task.share)}</span>
                    </span>
                  )}
                </td>
                <td class="wide"><Name text={task.doing} longest={100} /></td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}

/** What the pointer is over, in one line. */
function Tip({ tree, tasks, node }: { tree: Tree; tasks: ColumnTable; node: number }) {
  if (node < 0) return <p class="tip faint">Click a sub-domain to zoom into it. Keys: arrows choose, Enter zooms in, Escape out.</p>;
  const row = tree.shown[node]!;
  const state = rankedStates[tree.rank[node]!]!;
  const n = (name: string) => tasks.number(name)[row] ?? 0;
  const words = state === 'open' ? 'no task of its own' : lookOf('task', state).word;
  return (
    <p class="tip">
      <strong><Name text={pathText(tree.path[node]!)} longest={60} /></strong>
      {row >= 0 && ` · ${harmlessName(tasks.text('kind')[row], 40)} #${n('task')}`} · {words}
      {row >= 0 && state === 'leased' && n('share') > 0 && ` ${percent(n('share'))}`}
      {row >= 0 && ` · ${duration(n('seconds'))} of ${n('expected_seconds') > 0 ? duration(n('expected_seconds')) : dash}`}
      {row >= 0 && ` · ${n('peak_rss_bytes') > 0 ? bytes(n('peak_rss_bytes')) : dash}`}
      {row >= 0 && n('elements') > 0 && ` · ${short(n('elements'))} elements`}
    </p>
  );
}

export function TreeTab({ tasks, job }: { tasks: ColumnTable; job: Job }) {
  const tree = useMemo(() => treeOfTasks(tasks), [tasks]);
  const [width, setWidth] = useState(0);
  const [zoom, setZoom] = useState(1);
  const [chosen, choose] = useState(1);
  const [hover, setHover] = useState(-1);
  if (tree.count === 0) return <Empty>None of the job’s tasks belongs to a sub-domain yet.</Empty>;
  const zoomNode = tree.path2node.get(zoom) ?? 0;
  const chosenNode = tree.path2node.get(chosen) ?? 0;
  const view = { left: tree.left[zoomNode]!, right: tree.right[zoomNode]!, width };
  const rowHeight = rowHeightOf(tree.levels);
  const zoomTo = (path: number) => {
    setZoom(path);
    choose(path);
  };
  const at = (x: number, y: number) =>
    width > 0 ? nodeAt(tree, view.left + (x / width) * (view.right - view.left), Math.floor(y / rowHeight)) : -1;
  const onKey = (event: KeyboardEvent) => {
    if (event.key.startsWith('Arrow')) choose(tree.path[neighbour(tree, chosenNode, event.key)]!);
    else if (event.key === 'Enter') zoomTo(chosen);
    else if (event.key === 'Escape' || event.key === 'Backspace') zoomTo(Math.max(1, Math.floor(zoom / 2)));
    else if (event.key === 'Home') zoomTo(1);
    else return;
    event.preventDefault();
  };
  return (
    <>
      <div class="row between">
        <Crumbs path={zoom} onZoom={zoomTo} />
        <span class="faint">
          {whole(tree.count)} sub-domains, {whole(tree.leaves)} of them leaves, {tree.levels} levels
        </span>
      </div>
      <Surface
        label="Decomposition tree. Arrow keys choose a sub-domain, Enter zooms in, Escape out."
        height={tree.levels * rowHeight + 1}
        onSize={setWidth}
        draw={(drawing) => drawTree(drawing, { tree, tasks, view: { ...view, width: drawing.width }, chosenNode, hover })}
        onMove={(x, y) => setHover(at(x, y))}
        onLeave={() => setHover(-1)}
        onDown={(x, y) => {
          const node = at(x, y);
          if (node >= 0) zoomTo(tree.path[node]!);
        }}
        onKey={onKey}
        cursor={hover >= 0 ? 'zoom-in' : 'default'}
      />
      <Tip tree={tree} tasks={tasks} node={hover} />
      <TreeLegend tree={tree} />
      <Detail tree={tree} tasks={tasks} node={chosenNode} />
      <Running job={job} />
    </>
  );
}
