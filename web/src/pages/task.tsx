// One task: why it is as it is, its attempts, its inputs, and what its process said.

import { useState } from 'preact/hooks';
import { useAnswer } from '../api/hooks';
import type { Attempt, Explanation, TaskInput } from '../api/types';
import { bytes, dash, duration, moment, percent, short, whole } from '../logic/format';
import { jobAddress } from '../logic/router';
import { placeText } from '../logic/task_kinds';
import { Act, countOf } from '../ui/acts';
import { Link } from '../ui/navigation';
import { Bar, Empty, Figure, Figures, Kind, Name, Said, State, TaskLink, Trouble, Waiting } from '../ui/parts';

const everyMs = 3000;
const isSettled = (state: string) => state === 'done' || state === 'replaced';

function TaskFigures({ task }: { task: Explanation }) {
  const told = (value: number, form: (value: number) => string) => (value > 0 ? form(value) : dash);
  const of = (value: number, form: (value: number) => string) =>
    value > 0 ? `of ${form(value)} expected` : undefined;
  return (
    <Figures>
      <Figure words="Time" hint={of(task.expected_seconds, duration)}>{told(task.seconds, duration)}</Figure>
      <Figure words="CPU time">{told(task.cpu_seconds, duration)}</Figure>
      <Figure words="Peak memory" hint={of(task.expected_bytes, bytes)}>{told(task.peak_rss_bytes, bytes)}</Figure>
      <Figure words="Room in memory">{told(task.room_bytes, bytes)}</Figure>
      <Figure words="Elements" hint={of(task.expected_elements, short)}>{told(task.elements, short)}</Figure>
      <Figure words="Errors">{whole(task.errors)}</Figure>
      <Figure words="Losses">{whole(task.losses)}</Figure>
      <Figure words="Out of memory">{whole(task.out_of_memory)}</Figure>
      <Figure words="Time limit">{told(task.limit_seconds, duration)}</Figure>
    </Figures>
  );
}

function Reasons({ task }: { task: Explanation }) {
  const reasons = task.reasons ?? [];
  return (
    <section class="reasons">
      {reasons.length > 0 && (
        <ol aria-label="Why it is so">
          {reasons.map((reason, i) => (
            <li key={i}>
              <Said text={reason} />
            </li>
          ))}
        </ol>
      )}
      {task.state === 'leased' && (
        <p class="doing-now">
          {(task.share ?? 0) > 0 && (
            <span class="progress">
              <Bar share={task.share} label="progress of the task" />
              <span class="percent">{percent(task.share)}</span>
            </span>
          )}{' '}
          <Name text={task.doing ?? ''} longest={120} />
          <span class="faint">
            {' '}
            on <Name text={task.worker} longest={40} /> (<Name text={task.host} longest={60} />)
          </span>
        </p>
      )}
      {task.message && (
        <div class={`callout ${task.state === 'failed' ? 'bad' : 'quiet'}`}>
          <div><Said text={task.message} /></div>
        </div>
      )}
    </section>
  );
}

function Attempts({ attempts }: { attempts: readonly Attempt[] }) {
  if (attempts.length === 0) return <Empty>It has not been tried yet.</Empty>;
  return (
    <div class="scroller" tabIndex={0} role="region" aria-label="Attempts">
      <table class="small">
        <thead>
          <tr>
            <th scope="col" class="number">Attempt</th>
            <th scope="col">State</th>
            <th scope="col">Worker</th>
            <th scope="col">Began</th>
            <th scope="col" class="number">Time</th>
            <th scope="col" class="number">Peak memory / room</th>
            <th scope="col">Message</th>
          </tr>
        </thead>
        <tbody>
          {attempts.map((attempt) => (
            <tr key={attempt.attempt}>
              <td class="number">{attempt.attempt}</td>
              <td>
                <State thing="attempt" state={attempt.state} />
                {attempt.races && <small> races another</small>}
              </td>
              <td>
                <Name text={attempt.worker} longest={40} />
                <small><Name text={`${attempt.host}:${attempt.process}`} longest={60} /></small>
              </td>
              <td class="time">{moment(attempt.started_ms)}</td>
              <td class="number">{duration(attempt.seconds)}</td>
              <td class="number">
                {attempt.peak_rss_bytes > 0 ? bytes(attempt.peak_rss_bytes) : dash} /{' '}
                {attempt.memory_bytes > 0 ? bytes(attempt.memory_bytes) : dash}
              </td>
              <td class="wide"><Said text={attempt.message} /></td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Inputs({ inputs }: { inputs: readonly TaskInput[] }) {
  if (inputs.length === 0) return <Empty>It reads nothing.</Empty>;
  return (
    <div class="scroller" tabIndex={0} role="region" aria-label="Inputs">
      <table class="small">
        <thead>
          <tr>
            <th scope="col">Input</th>
            <th scope="col">Hash</th>
            <th scope="col" class="number">Size</th>
            <th scope="col">There</th>
            <th scope="col">Made by</th>
          </tr>
        </thead>
        <tbody>
          {inputs.map((input, i) => (
            <tr key={i}>
              <td><Name text={input.name} longest={60} /></td>
              <td><code><Name text={input.hash} longest={40} /></code></td>
              <td class="number">{bytes(input.size)}</td>
              <td>{input.is_there ? '✓ yes' : '✕ not yet'}</td>
              <td>{input.made_by_task > 0 ? <TaskLink task={input.made_by_task} /> : 'submitted'}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Logs({ task }: { task: number }) {
  const [isOpen, open] = useState(false);
  const asked = useAnswer<{ attempts: Attempt[] }>(isOpen ? `/tasks/${task}/logs` : undefined);
  const attempts = asked.value?.attempts ?? [];
  return (
    <details onToggle={(event) => open(event.currentTarget.open)}>
      <summary>What its process said</summary>
      <Trouble error={asked.error} />
      {isOpen && !asked.value && !asked.error && <Waiting what="Asking for the log…" />}
      {asked.value && attempts.length === 0 && <Empty>Nothing is kept.</Empty>}
      {attempts.map((attempt) => (
        <section key={attempt.attempt}>
          <h3>
            Attempt {attempt.attempt} <State thing="attempt" state={attempt.state} />
          </h3>
          <pre class="log" tabIndex={0} aria-label={`Log of attempt ${attempt.attempt}`}>
            {attempt.log ? <Said text={attempt.log} /> : '(nothing)'}
          </pre>
        </section>
      ))}
    </details>
  );
}

function TaskActs({ task, onDone }: { task: Explanation; onDone: () => void }) {
  if (task.state !== 'failed') return null;
  return (
    <Act
      label="Retry"
      title={`Retry task ${task.task}?`}
      confirm="Retry"
      path={`/tasks/${task.task}/retry`}
      outcome={(answer) =>
        countOf(answer) > 0 ? 'It is out of quarantine; a worker tries it again.' : 'It was not in quarantine.'
      }
      onDone={onDone}
    >
      Task {task.task} (<Kind kind={task.kind} />) leaves the quarantine and is tried again; its job goes on.
    </Act>
  );
}

export function TaskPage({ task: number, acts }: { task: number; acts: boolean }) {
  const [settled, settle] = useState(false);
  const asked = useAnswer<Explanation>(`/tasks/${number}`, settled ? undefined : everyMs);
  const task = asked.value;
  if (task && isSettled(task.state) !== settled) settle(isSettled(task.state));
  if (!task) {
    return (
      <>
        <h1>Task {number}</h1>
        {asked.error ? <Trouble error={asked.error} /> : <Waiting what="Asking for the task…" />}
      </>
    );
  }
  return (
    <>
      <p class="crumbs">
        <Link to="/">Jobs</Link> / <Link to={jobAddress(task.job)}><Name text={task.job} longest={60} /></Link> /{' '}
        <Link to={jobAddress(task.job, 'tasks')}>Tasks</Link>
      </p>
      <div class="row between top-line">
        <h1>
          Task {task.task} <small><Kind kind={task.kind} /> <Name text={placeText(task.kind, task.path)} longest={70} /></small>{' '}
          <State thing="task" state={task.state} />
        </h1>
        {acts && <TaskActs task={task} onDone={asked.ask} />}
      </div>
      <Reasons task={task} />
      <TaskFigures task={task} />
      <h2>Attempts</h2>
      <Attempts attempts={task.attempts ?? []} />
      <h2>Inputs</h2>
      <Inputs inputs={task.inputs ?? []} />
      <Logs task={number} />
    </>
  );
}
