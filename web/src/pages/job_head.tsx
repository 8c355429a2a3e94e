// The head of a job's page: how far it is, what it took so far, what came of it, and its acts.

import { inAddress } from '../api/client';
import type { Gate, Job, QuarantinedTask } from '../api/types';
import { bytes, counted, dash, duration, figure, moment, percent, short, whole } from '../logic/format';
import { harmlessName } from '../logic/harmless';
import { forecastFigures, qualityFigures } from '../logic/plain_words';
import { isJobLive, lookOf } from '../logic/states';
import { placeText } from '../logic/task_kinds';
import { Act, countOf } from '../ui/acts';
import { Bar, Figure, Figures, Kind, Name, Pair, Said, State, TaskLink } from '../ui/parts';

interface HeadProps {
  job: Job;
  acts: boolean;
  onChange: () => void;
}

function JobActs({ job, onChange }: Omit<HeadProps, 'acts'>) {
  const inQuarantine = job.quarantine?.length ?? 0;
  const name = harmlessName(job.name || job.job, 60);
  return (
    <span class="row">
      {(inQuarantine > 0 || job.state === 'failed') && (
        <Act
          label="Retry"
          title={`Retry ${job.job}?`}
          confirm="Retry"
          path={`/jobs/${inAddress(job.job)}/retry`}
          outcome={(answer) =>
            countOf(answer) > 0
              ? `${counted(countOf(answer), 'task')} taken out of quarantine; workers try again.`
              : 'There was no task in quarantine.'
          }
          onDone={onChange}
        >
          All tasks of <bdi>{name}</bdi> that are in quarantine ({inQuarantine}) are tried again, and the job goes on.
        </Act>
      )}
      {isJobLive(job.state) && (
        <Act
          label="Priority"
          title={`Priority of ${job.job}`}
          confirm="Set the priority"
          path={`/jobs/${inAddress(job.job)}/priority?priority=`}
          number={{ words: 'Priority, from −1000 to 1000', value: job.priority ?? 0, least: -1000, most: 1000 }}
          outcome={(answer) =>
            answer.set === true
              ? `${job.job} has priority ${String(answer.priority)}.`
              : `${job.job} is already ${String(answer.state)}: none of its tasks wait for workers.`
          }
          onDone={onChange}
        >
          Workers take tasks of the job with the highest priority first. What they have begun they end, and the mesh does
          not depend on it. <bdi>{name}</bdi> has {job.priority ?? 0}.
        </Act>
      )}
      {isJobLive(job.state) && (
        <Act
          label="Cancel"
          title={`Cancel ${job.job}?`}
          confirm="Cancel the job"
          isGrave
          path={`/jobs/${inAddress(job.job)}/cancel`}
          outcome={(answer) => (answer.found === true ? `${job.job} is cancelled.` : 'The coordinator does not know that job.')}
          onDone={onChange}
        >
          The job <bdi>{name}</bdi> ends without a mesh: its {whole(job.tasks_running)} running tasks are
          stopped, and those that wait are not begun. A cancelled job cannot go on.
        </Act>
      )}
    </span>
  );
}

function Progress({ job }: { job: Job }) {
  const isLive = isJobLive(job.state);
  const share = job.share ?? (job.state === 'done' ? 1 : undefined);
  return (
    <div class="job-progress">
      <Bar share={share} label="progress of the job" tone={lookOf('job', job.state).tone} />
      <span class="row between">
        <span>
          <strong>{percent(share)}</strong>
          {isLive && job.stage && (
            <>
              {' · '}
              <Name text={job.stage} longest={40} />
            </>
          )}
        </span>
        <span class="faint">
          {isLive
            ? typeof job.eta_seconds === 'number' && `meshed in about ${duration(job.eta_seconds)}`
            : job.finished_ms
              ? `ended ${moment(job.finished_ms)}`
              : ''}
        </span>
      </span>
    </div>
  );
}

function JobFigures({ job }: { job: Job }) {
  const expected = job.estimated_elements > 0 ? `of ${short(job.estimated_elements)}` : undefined;
  return (
    <Figures>
      <Figure words="Elements" hint={expected}>
        {short(job.elements)}
      </Figure>
      <Figure words="Sub-domains" hint={`meshed, of ${whole(job.subdomains)}`}>
        {whole(job.subdomains_meshed)}
      </Figure>
      <Figure words="Tasks done" hint={job.tasks ? `of ${whole(job.tasks.total)} so far` : undefined}>
        {whole(job.tasks_done)}
      </Figure>
      <Figure words="Running" hint={`${whole(job.tasks_ready)} waiting`}>
        {whole(job.tasks_running)}
      </Figure>
      {job.priority !== undefined && job.priority !== 0 && <Figure words="Priority">{String(job.priority)}</Figure>}
      <Figure words="Time">{duration(job.seconds)}</Figure>
      <Figure words="Peak memory" hint="of a worker">
        {job.peak_rss_bytes_worker > 0 ? bytes(job.peak_rss_bytes_worker) : dash}
      </Figure>
      <Figure words="Attempts lost">{whole(job.attempts_lost)}</Figure>
      <Figure words="Crashes">{whole(job.crashes)}</Figure>
      <Figure words="Out of memory">{whole(job.out_of_memory)}</Figure>
    </Figures>
  );
}

function Quarantine({ tasks }: { tasks: readonly QuarantinedTask[] }) {
  if (tasks.length === 0) return null;
  return (
    <section class="callout bad">
      <h2>{counted(tasks.length, 'task')} in quarantine</h2>
      <ul class="plain">
        {tasks.slice(0, 50).map((task) => (
          <li key={task.task}>
            <TaskLink task={task.task} /> <Kind kind={task.kind} />{' '}
            <Name text={placeText(task.kind, task.path)} longest={60} />
            <div><Said text={task.reason} /></div>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Gates({ gates }: { gates: readonly Gate[] }) {
  return (
    <>
      {gates
        .filter((gate) => gate.limit_deg > 0)
        .map((gate) => (
          <Pair key={gate.key} words={`gate ${harmlessName(gate.key, 40)}, ${figure(gate.limit_deg)}°`}>
            <span class={`state ${gate.passed ? 'good' : 'bad'}`}>
              <span class="symbol" aria-hidden="true">
                {gate.passed ? '✓' : '✕'}
              </span>
              {gate.passed ? 'passed' : 'not passed'}
            </span>
          </Pair>
        ))}
    </>
  );
}

function listOf<T>(value: unknown): T[] {
  return Array.isArray(value) ? (value as T[]) : [];
}

/** A file of a job is a name, or an object with one. */
function fileName(file: unknown): { name: string; size?: number } {
  if (typeof file === 'object' && file !== null) {
    const { name, size } = file as { name?: unknown; size?: unknown };
    return { name: String(name ?? ''), ...(typeof size === 'number' ? { size } : {}) };
  }
  return { name: String(file) };
}

function Result({ job }: { job: Job }) {
  const result = job.result ?? (job as unknown as Record<string, unknown>);
  const figures = job.state === 'done' ? qualityFigures(result) : [];
  const forecast = forecastFigures(job);
  const files = listOf<unknown>(job.files ?? result.files).map(fileName);
  const remarks = listOf<string>(result.remarks);
  const cuts = Object.entries(job.cut_further ?? {});
  if (figures.length + forecast.length + files.length + remarks.length + cuts.length === 0) return null;
  return (
    <details class="result" open={figures.length + files.length > 0}>
      <summary>{figures.length + files.length > 0 ? 'Result' : 'Forecast'}</summary>
      <dl class="pairs">
        {[...figures, ...forecast].map(({ key, words, text }) => (
          <Pair key={key} words={words}>
            {key === 'digest' ? <code><Name text={text} longest={64} /></code> : text}
          </Pair>
        ))}
        <Gates gates={listOf<Gate>(result.gates)} />
      </dl>
      {remarks.map((remark) => (
        <p key={remark}>
          <Said text={remark} />
        </p>
      ))}
      {cuts.map(([path, why]) => (
        <p key={path}>
          Cut further: <Name text={path} longest={60} /> – <Said text={why} />
        </p>
      ))}
      {files.length > 0 && (
        <ul class="files" aria-label="Files">
          {files.map((file) => (
            <li key={file.name}>
              <code>
                <Name text={file.name} />
              </code>{' '}
              {file.size !== undefined && <span class="faint">{bytes(file.size)}</span>}
            </li>
          ))}
        </ul>
      )}
    </details>
  );
}

export function JobHead({ job, acts, onChange }: HeadProps) {
  return (
    <section class="job-head" aria-label="The job">
      <div class="row between top-line">
        <h1>
          <Name text={job.name || job.job} longest={120} /> <small><Name text={job.job} longest={60} /></small>{' '}
          <State thing="job" state={job.state} />
        </h1>
        {acts && <JobActs job={job} onChange={onChange} />}
      </div>
      <Progress job={job} />
      {job.message && (
        <div class={`callout ${job.state === 'done' || job.state === 'waiting' ? 'quiet' : 'bad'}`}>
          <div><Said text={job.message} /></div>
        </div>
      )}
      <JobFigures job={job} />
      <Quarantine tasks={job.quarantine ?? []} />
      <Result job={job} />
    </section>
  );
}
