// One job: its head, and below it the views of its tasks.

import { useEffect, useRef } from 'preact/hooks';
import { inAddress } from '../api/client';
import { attemptColumns, taskColumns } from '../api/columns';
import type { Loaded } from '../api/hooks';
import { useAnswer, useLive, useTable } from '../api/hooks';
import type { Job } from '../api/types';
import { whole } from '../logic/format';
import type { JobTab } from '../logic/router';
import { jobAddress, jobTabs } from '../logic/router';
import { isJobLive } from '../logic/states';
import { Link } from '../ui/navigation';
import { Empty, Name, Trouble, Waiting } from '../ui/parts';
import { BalanceTab } from './balance_tab';
import { JobEvents } from './events';
import { JobHead } from './job_head';
import { QualityTab } from './quality_tab';
import { ShapeTab } from './shape_tab';
import { TasksTab } from './tasks_tab';
import { TimelineTab } from './timeline_tab';
import { TreeTab } from './tree_tab';

const tabWords: Record<JobTab, string> = {
  tree: 'Tree',
  shape: 'In space',
  timeline: 'Timeline',
  balance: 'Balance',
  quality: 'Quality',
  tasks: 'Tasks',
  events: 'Events',
};

function Tabs({ job, tab }: { job: string; tab: JobTab }) {
  return (
    <nav class="tabs" aria-label="Views of the job">
      {jobTabs.map((other) => (
        <Link key={other} to={jobAddress(job, other)} current={other === tab}>
          {tabWords[other]}
        </Link>
      ))}
    </nav>
  );
}

/** Says why there is no table yet, or nothing when there is one. */
export function LoadState({ loaded, what }: { loaded: Loaded; what: string }) {
  if (loaded.error) return <Trouble error={loaded.error} isKnown={loaded.table !== undefined} />;
  if (loaded.table?.count === 0) return <Empty>{`No ${what} yet.`}</Empty>;
  if (loaded.table) return null;
  return <Waiting what={loaded.rows ? `${whole(loaded.rows)} ${what} so far…` : `Asking for the ${what}…`} />;
}

interface ViewProps {
  job: Job;
  version: string;
}

function TasksView({ job, version, tab }: ViewProps & { tab: 'tree' | 'tasks' }) {
  const loaded = useTable(job.job, 'tasks', taskColumns, isJobLive(job.state), version);
  return (
    <>
      <LoadState loaded={loaded} what="tasks" />
      {loaded.table && loaded.table.count > 0 && (tab === 'tree' ? (
        <TreeTab tasks={loaded.table} job={job} />
      ) : (
        <TasksTab tasks={loaded.table} />
      ))}
    </>
  );
}

function AttemptsView({ job, version }: ViewProps) {
  const loaded = useTable(job.job, 'attempts', attemptColumns, isJobLive(job.state), version);
  return (
    <>
      <LoadState loaded={loaded} what="attempts" />
      {loaded.table && loaded.table.count > 0 && <TimelineTab attempts={loaded.table} />}
    </>
  );
}

function BothView({ job, version }: ViewProps) {
  const isLive = isJobLive(job.state);
  const tasks = useTable(job.job, 'tasks', taskColumns, isLive, version);
  const attempts = useTable(job.job, 'attempts', attemptColumns, isLive, version);
  return (
    <>
      <LoadState loaded={tasks} what="tasks" />
      {tasks.table && tasks.table.count > 0 && (
        <BalanceTab job={job} tasks={tasks.table} attempts={attempts.table} />
      )}
    </>
  );
}

function ShapeView({ job, version }: ViewProps) {
  const isLive = isJobLive(job.state);
  const tasks = useTable(job.job, 'tasks', taskColumns, isLive, version);
  const attempts = useTable(job.job, 'attempts', attemptColumns, isLive, version);
  return <ShapeTab job={job} tasks={tasks.table} attempts={attempts.table} />;
}

function QualityView({ job, version }: ViewProps) {
  const loaded = useTable(job.job, 'tasks', taskColumns, isJobLive(job.state), version);
  return (
    <>
      <LoadState loaded={loaded} what="tasks" />
      {loaded.table && loaded.table.count > 0 && <QualityTab job={job} tasks={loaded.table} />}
    </>
  );
}

function View({ tab, ...rest }: ViewProps & { tab: JobTab }) {
  if (tab === 'events') return <JobEvents job={rest.job.job} />;
  if (tab === 'timeline') return <AttemptsView {...rest} />;
  if (tab === 'shape') return <ShapeView {...rest} />;
  if (tab === 'quality') return <QualityView {...rest} />;
  if (tab === 'balance') return <BothView {...rest} />;
  return <TasksView {...rest} tab={tab} />;
}

interface PageProps {
  job: string;
  tab: JobTab;
  acts: boolean;
}

const everyMs = 2000;

/** What is known of the job, asked again while it may change, and when the farm tells of a change. */
function useJob(job: string) {
  const line = useLive().jobs?.find((other) => other.job === job);
  const mayChange = line === undefined || isJobLive(line.state);
  const asked = useAnswer<Job>(`/jobs/${inAddress(job)}`, mayChange ? everyMs : undefined);
  const told = useRef(line);
  useEffect(() => {
    if (told.current !== line && !mayChange) asked.ask();
    told.current = line;
  }, [line]);
  return asked;
}

export function JobPage({ job, tab, acts }: PageProps) {
  const asked = useJob(job);
  const known = asked.value;
  return (
    <>
      <p class="crumbs">
        <Link to="/">Jobs</Link>
      </p>
      {!known && <h1><Name text={job} longest={60} /></h1>}
      {!known && <Trouble error={asked.error} />}
      {!known && !asked.error && <Waiting what="Asking for the job…" />}
      {known && <JobHead job={known} acts={acts} onChange={asked.ask} />}
      {known && <Tabs job={job} tab={tab} />}
      {known && <View key={tab} tab={tab} job={known} version={known.state} />}
    </>
  );
}
