// What pages use of the server: live state, single answers that are asked for again, and tables of
// a job at a pace that the server can bear. Nothing is fetched while the page is out of sight.

import { useEffect, useRef, useState } from 'preact/hooks';
import { pauseAfter } from '../logic/pace';
import type { Columns, ColumnTable } from './columns';
import { fetchTable } from './columns';
import { ApiError, get, inAddress, isAbort } from './client';
import { Live } from './live';
import type { Api, Job } from './types';

export const live = new Live();

/** Redraws whenever the server told something. */
export function useLive(): Live {
  const [, again] = useState(0);
  useEffect(() => live.subscribe(() => again((n) => n + 1)), []);
  return live;
}

export interface Answer<T> {
  value: T | undefined;
  error: ApiError | undefined;
  ask: () => void;
}

function asApiError(error: unknown): ApiError {
  return error instanceof ApiError ? error : new ApiError(String(error), '', 0);
}

/** Runs `work` at once, again whenever `key` changes, and `pauseOf(its duration)` after it ended;
 * no pause: once. */
function useRepeated(
  work: (signal: AbortSignal) => Promise<void>,
  key: string,
  pauseOf: (fetchMs: number) => number | undefined,
): () => void {
  const latest = useRef({ work, pauseOf });
  latest.current = { work, pauseOf };
  const [asked, ask] = useState(0);
  useEffect(() => {
    const stop = new AbortController();
    let timer = 0;
    const run = async () => {
      if (document.hidden) return later(1000);
      const begin = performance.now();
      await latest.current.work(stop.signal);
      if (stop.signal.aborted) return;
      const pause = latest.current.pauseOf(performance.now() - begin);
      if (pause !== undefined) later(pause);
    };
    const later = (ms: number) => {
      timer = window.setTimeout(() => void run(), ms);
    };
    void run();
    return () => {
      stop.abort();
      window.clearTimeout(timer);
    };
  }, [key, asked]);
  return () => ask((n) => n + 1);
}

/** The answer to GET `path`; `everyMs` undefined: asked once. The last good answer stays while a
 * later one fails. */
export function useAnswer<T>(path: string | undefined, everyMs?: number): Answer<T> {
  const [state, set] = useState<{ path?: string; value?: T; error?: ApiError }>({});
  const ask = useRepeated(
    async (signal) => {
      if (path === undefined) return;
      try {
        const value = await get<T>(path, signal);
        set({ path, value });
      } catch (error) {
        if (isAbort(error)) return;
        set((before) => ({ ...(before.path === path ? before : {}), path, error: asApiError(error) }));
      }
    },
    `${path} ${everyMs === undefined}`,
    (fetchMs) => (everyMs === undefined ? undefined : pauseAfter(fetchMs, everyMs)),
  );
  const isOfPath = state.path === path;
  return {
    value: isOfPath ? state.value : undefined,
    error: isOfPath ? state.error : undefined,
    ask,
  };
}

/** All that is known of a few jobs: each is a question of its own. Those that fail are left out. */
export function useJobs(jobs: readonly string[], everyMs = 4000): readonly Job[] {
  const [told, set] = useState<readonly Job[]>([]);
  useRepeated(
    async (signal) => {
      const answers = await Promise.all(
        jobs.map((job) => get<Job>(`/jobs/${inAddress(job)}`, signal).catch(() => undefined)),
      );
      if (!signal.aborted) set(answers.filter((job): job is Job => job !== undefined));
    },
    jobs.join('\n'),
    (fetchMs) => (jobs.length ? pauseAfter(fetchMs, everyMs) : undefined),
  );
  return told;
}

export interface Loaded {
  table: ColumnTable | undefined;
  rows: number;
  error: ApiError | undefined;
}

/** A job's tasks or attempts: fetched whole, and again while the job is live, or when it changed
 * (`version`). */
export function useTable(
  job: string,
  what: 'tasks' | 'attempts',
  columns: Columns,
  isLive: boolean,
  version: string,
): Loaded {
  const [state, set] = useState<Loaded & { of?: string }>({
    table: undefined,
    rows: 0,
    error: undefined,
  });
  const of = `${job} ${what}`;
  useRepeated(
    async (signal) => {
      try {
        const table = await fetchTable(job, what, columns, signal, (rows) => {
          set((before) => (before.of === of && before.table ? before : { ...before, of, rows, error: undefined, table: undefined }));
        });
        set({ of, table, rows: table.count, error: undefined });
      } catch (error) {
        if (isAbort(error)) return;
        set((before) => ({
          table: before.of === of ? before.table : undefined,
          rows: 0,
          of,
          error: asApiError(error),
        }));
      }
    },
    `${of} ${version} ${isLive}`,
    (fetchMs) => (isLive ? pauseAfter(fetchMs) : undefined),
  );
  return state.of === of ? state : { table: undefined, rows: 0, error: undefined };
}

/** Whether acts are allowed, and the program's version. Asked again when the link comes back. */
export function useApi(): Api | undefined {
  const { link } = useLive();
  const answer = useAnswer<Api>('');
  useEffect(() => {
    if (link === 'open' && !answer.value) answer.ask();
  }, [link]);
  return answer.value;
}
