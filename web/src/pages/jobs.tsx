// All jobs, newest first, with how far they are; above them the farm in a few figures.

import { useMemo, useState } from 'preact/hooks';
import { useAnswer, useJobs, useLive } from '../api/hooks';
import type { Farm, JobLine } from '../api/types';
import { ago, dash, duration, moment, percent, short, whole } from '../logic/format';
import { harmlessName } from '../logic/harmless';
import { jobAddress } from '../logic/router';
import { textFits } from '../logic/sort_filter';
import { isJobLive, jobStates, lookOf } from '../logic/states';
import { Choice, Search } from '../ui/fields';
import { Link, goTo } from '../ui/navigation';
import { Bar, Empty, Figure, Figures, Name, State, Trouble, Waiting } from '../ui/parts';

const mostEtas = 10;

function FarmFigures({ farm, jobs }: { farm: Farm | undefined; jobs: readonly JobLine[] }) {
  const running = jobs.filter((job) => isJobLive(job.state) && job.state !== 'waiting');
  const sum = (of: (job: JobLine) => number) => running.reduce((total, job) => total + of(job), 0);
  const inQuarantine = jobs.reduce((total, job) => total + (job.tasks_in_quarantine ?? 0), 0);
  return (
    <Figures>
      <Figure words="Jobs running" hint={`of ${whole(jobs.length)}`}>
        {whole(running.length)}
      </Figure>
      <Figure words="Workers">{whole(farm?.workers)}</Figure>
      <Figure words="Tasks running">{whole(sum((job) => job.tasks_running))}</Figure>
      <Figure words="Tasks waiting">{whole(sum((job) => job.tasks_ready))}</Figure>
      <Figure words="In quarantine">{whole(inQuarantine)}</Figure>
    </Figures>
  );
}

function rateOf(job: JobLine): string {
  return job.elements > 0 && job.seconds > 0 ? short(job.elements / job.seconds) : dash;
}

function Progress({ job }: { job: JobLine }) {
  const share = job.share ?? (job.state === 'done' ? 1 : undefined);
  return (
    <span class="progress">
      <Bar share={share} label={`progress of ${harmlessName(job.name, 60)}`} tone={lookOf('job', job.state).tone} />
      <span class="percent">{percent(share)}</span>
    </span>
  );
}

function Row({ job, eta, nowMs }: { job: JobLine; eta: number | undefined; nowMs: number }) {
  const isLive = isJobLive(job.state);
  const to = jobAddress(job.job);
  const open = (event: MouseEvent) => {
    if (!(event.target as Element).closest('a')) goTo(to);
  };
  return (
    <tr class="opens" onClick={open}>
      <th scope="row">
        <Link to={to} class="main-link">
          <Name text={job.name || job.job} longest={80} />
        </Link>
        <small>
          <Name text={job.job} longest={40} />
        </small>
      </th>
      <td>
        <State thing="job" state={job.state} />
        {(job.waits_for ?? []).length > 0 && (
          <small>
            for <Name text={job.waits_for!.join(', ')} longest={60} />
          </small>
        )}
      </td>
      <td class="extra">{isLive ? <Name text={job.stage} longest={30} /> : <span class="faint">{dash}</span>}</td>
      <td>
        <Progress job={job} />
      </td>
      <td class="number">{isLive ? duration(eta) : dash}</td>
      <td class="number extra">
        {short(job.elements)}
        <span class="faint"> / {job.estimated_elements > 0 ? short(job.estimated_elements) : dash}</span>
      </td>
      <td class="number extra">{rateOf(job)}</td>
      <td class="number extra">{isLive ? whole(job.tasks_running) : dash}</td>
      <td class="number extra" title={moment(job.created_ms)}>
        {ago(job.created_ms, nowMs)}
      </td>
    </tr>
  );
}

function JobsTable({ jobs, nowMs }: { jobs: readonly JobLine[]; nowMs: number }) {
  const asked = jobs.filter((job) => isJobLive(job.state)).slice(0, mostEtas);
  const details = useJobs(asked.map((job) => job.job));
  const etas = new Map(details.map((job) => [job.job, job.eta_seconds ?? undefined]));
  return (
    <div class="scroller" tabIndex={0} role="region" aria-label="Jobs">
      <table class="jobs">
        <thead>
          <tr>
            <th scope="col">Job</th>
            <th scope="col">State</th>
            <th scope="col" class="extra">Stage</th>
            <th scope="col">Progress</th>
            <th scope="col" class="number">Time left</th>
            <th scope="col" class="number extra">Elements / expected</th>
            <th scope="col" class="number extra">Elements/s</th>
            <th scope="col" class="number extra">Workers</th>
            <th scope="col" class="number extra">Started</th>
          </tr>
        </thead>
        <tbody>
          {jobs.map((job) => (
            <Row key={job.job} job={job} eta={job.eta_seconds ?? etas.get(job.job)} nowMs={nowMs} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

const stateOptions = [
  { value: '', words: 'All states' },
  ...jobStates.map((state) => ({ value: state, words: lookOf('job', state).word })),
];

export function JobsPage() {
  const { jobs: told, farm } = useLive();
  const asked = useAnswer<{ jobs: JobLine[] }>('/jobs');
  const jobs = told ?? asked.value?.jobs;
  const [state, setState] = useState('');
  const [query, setQuery] = useState('');
  const shown = useMemo(
    () =>
      (jobs ?? []).filter(
        (job) => (!state || job.state === state) && textFits(query, [job.name, job.job, job.stage]),
      ),
    [jobs, state, query],
  );
  return (
    <>
      <h1>Jobs</h1>
      {jobs && <FarmFigures farm={farm} jobs={jobs} />}
      <div class="row filters">
        <Choice label="State" value={state} options={stateOptions} onChange={setState} />
        <Search label="Name or job" value={query} onChange={setQuery} />
      </div>
      {!jobs && <Trouble error={asked.error} />}
      {!jobs && !asked.error && <Waiting what="Asking for the jobs…" />}
      {jobs && shown.length > 0 && <JobsTable jobs={shown} nowMs={farm?.time_ms ?? Date.now()} />}
      {jobs && shown.length === 0 && (
        <Empty>{jobs.length ? 'No job fits the filter.' : 'No jobs yet: `tetfarm submit wing.stl` begins one.'}</Empty>
      )}
    </>
  );
}
