// The frame of all pages: the head with its navigation, banners, and the page of the address.

import { useEffect, useRef, useState } from 'preact/hooks';
import { useApi, useLive } from './api/hooks';
import { Banners } from './banners';
import { harmlessName } from './logic/harmless';
import type { Route } from './logic/router';
import { EventsPage } from './pages/events';
import { JobPage } from './pages/job';
import { JobsPage } from './pages/jobs';
import { TaskPage } from './pages/task';
import { WorkersPage } from './pages/workers';
import { ActLayer } from './ui/acts';
import { Link, useRoute } from './ui/navigation';
import { Empty } from './ui/parts';
import type { Choice } from './ui/theme';
import { chooseTheme, themeChoice } from './ui/theme';

function ThemeSwitch() {
  const [choice, set] = useState(themeChoice());
  return (
    <label class="theme">
      <span class="unseen">Colours</span>
      <select
        value={choice}
        onChange={(event) => {
          const next = event.currentTarget.value as Choice;
          chooseTheme(next);
          set(next);
        }}
      >
        <option value="auto">Auto</option>
        <option value="light">Light</option>
        <option value="dark">Dark</option>
      </select>
    </label>
  );
}

function LinkState() {
  const { link, farm } = useLive();
  const isWell = link === 'open' && farm?.connected === true;
  const words = isWell
    ? 'Live'
    : link === 'lost'
      ? 'Offline'
      : link === 'connecting' || !farm
        ? 'Connecting'
        : farm.at_rest
          ? 'At rest'
          : 'No answer';
  return (
    <span class={`link-state ${isWell ? 'good' : link === 'lost' || words === 'No answer' ? 'bad' : 'faint'}`}>
      <span aria-hidden="true">{isWell ? '●' : '○'}</span> {words}
    </span>
  );
}

function Header({ route }: { route: Route }) {
  const isOf = (...pages: Route['page'][]) => pages.includes(route.page);
  return (
    <header class="top">
      <Link to="/" class="brand">
        <svg viewBox="0 0 32 32" width="22" height="22" aria-hidden="true">
          <path d="M16 2 2 24l14 6z" fill="#2f6fb5" />
          <path d="M16 2l14 22-14 6z" fill="#5b9bd8" />
          <path d="M2 24l14-5 14 5-14 6z" fill="#17406e" opacity=".55" />
        </svg>
        Tetfarm
      </Link>
      <nav aria-label="Pages">
        <Link to="/" current={isOf('jobs', 'job', 'task')}>
          Jobs
        </Link>
        <Link to="/workers" current={isOf('workers')}>
          Workers
        </Link>
        <Link to="/events" current={isOf('events')}>
          Events
        </Link>
      </nav>
      <span class="spacer" />
      <LinkState />
      <ThemeSwitch />
    </header>
  );
}

function titleOf(route: Route): string {
  if (route.page === 'job') return `${harmlessName(route.job, 60)} · Tetfarm`;
  if (route.page === 'task') return `Task ${route.task} · Tetfarm`;
  const words = { jobs: 'Jobs', workers: 'Workers', events: 'Events', unknown: 'Not found' };
  return `${words[route.page]} · Tetfarm`;
}

function Page({ route, acts }: { route: Route; acts: boolean }) {
  switch (route.page) {
    case 'jobs':
      return <JobsPage />;
    case 'job':
      return <JobPage key={route.job} job={route.job} tab={route.tab} acts={acts} />;
    case 'task':
      return <TaskPage key={route.task} task={route.task} acts={acts} />;
    case 'workers':
      return <WorkersPage acts={acts} />;
    case 'events':
      return <EventsPage />;
    default:
      return (
        <>
          <h1>No such page</h1>
          <Empty>
            There is nothing at this address. <Link to="/">All jobs</Link>
          </Empty>
        </>
      );
  }
}

export function App() {
  const route = useRoute();
  const api = useApi();
  const main = useRef<HTMLElement>(null);
  const isFirst = useRef(true);
  const place = route.page === 'job' ? route.job : route.page === 'task' ? route.task : '';
  useEffect(() => {
    if (!isFirst.current) {
      window.scrollTo(0, 0);
      main.current?.focus({ preventScroll: true });
    }
    isFirst.current = false;
  }, [route.page, place]);
  useEffect(() => {
    document.title = titleOf(route);
  });
  return (
    <>
      <a class="skip" href="#main">
        Skip to the page
      </a>
      <Header route={route} />
      <Banners />
      <main id="main" ref={main} tabIndex={-1}>
        <Page route={route} acts={api?.acts === true} />
      </main>
      <ActLayer />
      <footer class="bottom">
        Tetfarm {api?.program_version ?? ''}
        {api && !api.acts && ' · this page only looks: `tetfarm dashboard --acts` lets it cancel, retry, drain and set priorities'}
      </footer>
    </>
  );
}
