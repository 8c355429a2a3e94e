// Workers by host, with what they do; what waits for workers, and who was turned away.

import { useMemo, useState } from 'preact/hooks';
import { inAddress } from '../api/client';
import { useAnswer, useJobs, useLive } from '../api/hooks';
import type { Farm, RunningTask, Worker } from '../api/types';
import { bytes, counted, dash, duration, moment, percent, whole } from '../logic/format';
import { harmlessName } from '../logic/harmless';
import { textFits } from '../logic/sort_filter';
import { isJobLive } from '../logic/states';
import { placeText } from '../logic/task_kinds';
import { Act, countOf } from '../ui/acts';
import { Search } from '../ui/fields';
import { Bar, Empty, Figure, Figures, Kind, Name, State, TaskLink, Trouble, Waiting } from '../ui/parts';

const mostJobs = 5;

const securityWords: Record<string, string> = {
  keys: 'keys, encrypted',
  plain: 'plain, this host only',
  insecure: 'none: anybody may say anything',
};

function FarmState({ farm, workers }: { farm: Farm | undefined; workers: readonly Worker[] }) {
  const busy = workers.filter((worker) => worker.task > 0).length;
  const here = workers.filter((worker) => worker.state !== 'gone');
  const memory = here.reduce((most, worker) => Math.max(most, worker.memory_bytes || 0), 0);
  const refused = Object.entries(farm?.refused ?? {});
  const all = refused.reduce((sum, [, count]) => sum + count, 0);
  const security = farm?.security ?? '';
  return (
    <Figures>
      <Figure words="Workers" hint={`${whole(busy)} busy`}>
        {whole(here.length)}
      </Figure>
      <Figure words="Most memory" hint="of a worker">{memory > 0 ? bytes(memory) : dash}</Figure>
      <Figure words="Security">
        <span class="text-figure">
          {Object.hasOwn(securityWords, security) ? securityWords[security] : <Name text={security || dash} />}
        </span>
      </Figure>
      <Figure words="Authorized keys">{whole(farm?.authorized_keys)}</Figure>
      <Figure words="Connections">{whole(farm?.connections)}</Figure>
      <Figure
        words="Refused messages"
        hint={refused.filter(([, count]) => count > 0).map(([kind, count]) => `${harmlessName(kind, 40)} ${whole(count)}`).join(', ') || undefined}
      >
        {whole(all)}
      </Figure>
    </Figures>
  );
}

function Demands({ farm }: { farm: Farm | undefined }) {
  if (!farm?.demand) return null;
  return (
    <section>
      <h2>Tasks that wait for workers</h2>
      {farm.demand.length === 0 ? (
        <Empty>None: whatever can run has a worker.</Empty>
      ) : (
        <div class="scroller boxed">
        <table class="small">
          <thead>
            <tr>
              <th scope="col" class="number">Tasks</th>
              <th scope="col" class="number">Memory each</th>
              <th scope="col">For</th>
            </tr>
          </thead>
          <tbody>
            {farm.demand.map((demand, i) => (
              <tr key={i}>
                <td class="number">{whole(demand.tasks)}</td>
                <td class="number">{demand.memory_bytes > 0 ? bytes(demand.memory_bytes) : 'not known'}</td>
                <td>{demand.of_solvers ? 'workers that run solvers' : 'any worker'}</td>
              </tr>
            ))}
          </tbody>
        </table>
        </div>
      )}
    </section>
  );
}

function Doing({ worker, task }: { worker: Worker; task: RunningTask | undefined }) {
  if (!worker.task) return <span class="faint">{dash}</span>;
  return (
    <span class="doing">
      <TaskLink task={worker.task} />{' '}
      {task && (
        <>
          <Kind kind={task.kind} /> <Name text={placeText(task.kind, task.path)} longest={30} />{' '}
        </>
      )}
      <span class="faint">
        <Name text={worker.doing || task?.doing || ''} longest={60} />
      </span>
    </span>
  );
}

/** Of the time since it came. */
function busyShare(worker: Worker, nowMs: number): number {
  const seconds = (nowMs - worker.since_ms) / 1000;
  return seconds > 0 ? Math.min(1, worker.busy_seconds / seconds) : 0;
}

function DrainAct({ worker, onDone }: { worker: Worker; onDone: () => void }) {
  return (
    <Act
      label="Drain"
      title={`Drain ${harmlessName(worker.worker, 40)}?`}
      confirm="Drain it"
      path={`/workers/${inAddress(worker.worker)}/drain`}
      outcome={(answer) =>
        countOf(answer) > 0 ? `${worker.worker} finishes its task and leaves.` : 'That worker is not here any more.'
      }
      onDone={onDone}
    >
      The worker <Name text={worker.worker} /> on <Name text={worker.host} longest={60} /> finishes what it is
      doing, takes no further task, and leaves the farm.
    </Act>
  );
}

function RetryHost({ host, onDone }: { host: string; onDone: () => void }) {
  const name = harmlessName(host, 80);
  return (
    <Act
      label="Retry"
      title={`Retry ${name}?`}
      confirm="Retry it"
      path={`/hosts/${inAddress(host)}/retry`}
      outcome={(answer) => (countOf(answer) > 0 ? `${name} is out of quarantine; its workers get tasks again.` : 'It was not in quarantine.')}
      onDone={onDone}
    >
      Tasks kept crashing on <Name text={host} longest={80} />, and its workers get none. From now on they do again; see
      first that what was wrong with it is no longer so.
    </Act>
  );
}

interface HostProps {
  host: string;
  workers: readonly Worker[];
  running: Map<number, RunningTask>;
  nowMs: number;
  acts: boolean;
  onDone: () => void;
}

function WorkerRow({ worker, running, nowMs, acts, onDone }: Omit<HostProps, 'host' | 'workers'> & { worker: Worker }) {
  const busy = busyShare(worker, nowMs);
  const isHere = worker.state !== 'gone';
  return (
    <tr>
      <th scope="row">
        <Name text={worker.worker} longest={40} />
        <small title={`since ${moment(worker.since_ms)}`}>process {worker.process}</small>
      </th>
      <td>
        <State thing="worker" state={worker.state} />
      </td>
      <td class="wide">
        <Doing worker={worker} task={running.get(worker.task)} />
      </td>
      <td class="number extra">{bytes(worker.memory_bytes)}</td>
      <td class="number extra">{whole(worker.cores)}</td>
      <td class="number">
        {whole(worker.attempts_done)}
        <span class="faint"> / </span>
        <span class={worker.attempts_not_done > 0 ? 'warn' : 'faint'}>{whole(worker.attempts_not_done)}</span>
      </td>
      <td class="extra">
        <span class="progress" title={`busy for ${duration(worker.busy_seconds)}`}>
          <Bar share={busy} label={`busy share of ${harmlessName(worker.worker, 40)}`} />
          <span class="percent">{percent(busy)}</span>
        </span>
      </td>
      {acts && (
        <td class="number">
          {isHere && worker.state !== 'drains' && <DrainAct worker={worker} onDone={onDone} />}
        </td>
      )}
    </tr>
  );
}

function Host(props: HostProps) {
  const { host, workers, acts, onDone } = props;
  const isOut = workers.some((worker) => worker.host_in_quarantine);
  const name = harmlessName(host, 80);
  return (
    <section class="host">
      <div class="row between">
        <h2>
          <Name text={host} longest={80} /> <small>{counted(workers.length, 'worker')}</small>{' '}
          {isOut && (
            <span class="state bad">
              <span class="symbol" aria-hidden="true">
                ✕
              </span>
              in quarantine
            </span>
          )}
        </h2>
        {isOut && acts && <RetryHost host={host} onDone={onDone} />}
      </div>
      <div class="scroller" tabIndex={0} role="region" aria-label={`Workers of ${name}`}>
        <table class="workers">
          <thead>
            <tr>
              <th scope="col">Worker</th>
              <th scope="col">State</th>
              <th scope="col">Does</th>
              <th scope="col" class="number extra">Memory</th>
              <th scope="col" class="number extra">Cores</th>
              <th scope="col" class="number">Done / not done</th>
              <th scope="col" class="extra">Busy</th>
              {acts && <th scope="col" class="number">Act</th>}
            </tr>
          </thead>
          <tbody>
            {workers.map((worker) => (
              <WorkerRow key={worker.worker} {...props} worker={worker} />
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}

function hostsOf(workers: readonly Worker[]): [string, Worker[]][] {
  const host2workers = new Map<string, Worker[]>();
  for (const worker of workers) {
    const known = host2workers.get(worker.host);
    if (known) known.push(worker);
    else host2workers.set(worker.host, [worker]);
  }
  return [...host2workers].sort(([a], [b]) => (a < b ? -1 : 1));
}

export function WorkersPage({ acts }: { acts: boolean }) {
  const { farm, jobs } = useLive();
  const [query, setQuery] = useState('');
  const [withGone, setWithGone] = useState(false);
  const asked = useAnswer<{ workers: Worker[] }>(withGone ? '/workers?gone=1' : '/workers', 2000);
  const live = (jobs ?? []).filter((job) => isJobLive(job.state)).slice(0, mostJobs);
  const details = useJobs(live.map((job) => job.job));
  const running = useMemo(() => {
    const tasks = details.flatMap((job) => job.running ?? []);
    return new Map(tasks.map((task) => [task.task, task]));
  }, [details]);
  const workers = asked.value?.workers;
  const shown = (workers ?? []).filter((worker) => textFits(query, [worker.worker, worker.host, worker.state]));
  const nowMs = farm?.time_ms ?? Date.now();
  return (
    <>
      <h1>Workers</h1>
      {workers && <FarmState farm={farm} workers={workers} />}
      <Demands farm={farm} />
      <div class="row filters spaced">
        <Search label="Worker, host or state" value={query} onChange={setQuery} />
        <label class="check">
          <input
            type="checkbox"
            checked={withGone}
            onChange={(event) => setWithGone(event.currentTarget.checked)}
          />
          Those that have left, too
        </label>
      </div>
      <Trouble error={asked.error} isKnown={workers !== undefined} />
      {!workers && !asked.error && <Waiting what="Asking for the workers…" />}
      {workers && shown.length === 0 && (
        <Empty>{workers.length ? 'No worker fits the filter.' : 'No workers: `tetfarm worker` starts one.'}</Empty>
      )}
      {hostsOf(shown).map(([host, ofHost]) => (
        <Host
          key={host}
          host={host}
          workers={ofHost}
          running={running}
          nowMs={nowMs}
          acts={acts}
          onDone={asked.ask}
        />
      ))}
    </>
  );
}
