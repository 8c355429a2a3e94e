// What the server tells by itself (/api/v1/changes): the farm, jobs that changed, new events. One
// connection for all pages; when it is lost it is made again, and pages are told meanwhile.

import { pauseBeforeReconnect } from '../logic/pace';
import type { Farm, FarmEvent, JobLine } from './types';

export type Link = 'connecting' | 'open' | 'lost';

const mostEvents = 2000;
/** The farm is told every 10 s, or later where it is slow: a connection that is silent for so long
 * is not one. */
const silentForMs = 90_000;

export class Live {
  link: Link = 'connecting';
  farm: Farm | undefined;
  /** Newest first; undefined: not told yet. */
  jobs: JobLine[] | undefined;
  /** Newest first. */
  events: FarmEvent[] = [];
  heardMs = 0;

  private readonly listeners = new Set<() => void>();
  private source: EventSource | undefined;
  private attempts = 0;
  private timer = 0;
  private hasAllJobs = false;

  constructor(private readonly address = '/api/v1/changes') {}

  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  start(): void {
    this.connect();
    window.setInterval(() => {
      if (this.link === 'open' && Date.now() - this.heardMs > silentForMs) this.reconnect();
    }, 5000);
  }

  /** Of events that were fetched, for pages that show more than what came since. */
  addEvents(events: readonly FarmEvent[]): void {
    this.events = mergedEvents(this.events, events, mostEvents);
    this.tell();
  }

  private connect(): void {
    const source = new EventSource(this.address);
    this.source = source;
    this.hasAllJobs = false;
    source.onopen = () => {
      this.link = 'open';
      this.attempts = 0;
      this.heardMs = Date.now();
      this.tell();
    };
    source.onerror = () => {
      if (source === this.source) this.reconnect();
    };
    this.listen<Farm>(source, 'farm', (farm) => {
      this.farm = farm;
    });
    this.listen<{ jobs: JobLine[] }>(source, 'jobs', ({ jobs }) => {
      const before = this.hasAllJobs ? this.jobs ?? [] : [];
      this.hasAllJobs = true;
      this.jobs = mergedJobs(before, jobs);
    });
    this.listen<{ events: FarmEvent[] }>(source, 'events', ({ events }) => {
      this.events = mergedEvents(this.events, events, mostEvents);
    });
  }

  private listen<T>(source: EventSource, type: string, take: (value: T) => void): void {
    source.addEventListener(type, (message) => {
      if (source !== this.source) return;
      this.heardMs = Date.now();
      try {
        take(JSON.parse((message as MessageEvent<string>).data) as T);
      } catch {
        return;
      }
      this.tell();
    });
  }

  private reconnect(): void {
    this.source?.close();
    this.source = undefined;
    this.link = 'lost';
    this.tell();
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.connect(), pauseBeforeReconnect(this.attempts++));
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

function numberOf(job: string): number {
  return Number(/([0-9]+)$/.exec(job)?.[1] ?? 0);
}

/** Newest first; of a job that is in both, the later word counts. */
export function mergedJobs(before: readonly JobLine[], changed: readonly JobLine[]): JobLine[] {
  const id2job = new Map(before.map((job) => [job.job, job]));
  for (const job of changed) id2job.set(job.job, job);
  return [...id2job.values()].sort(
    (a, b) => (b.created_ms ?? 0) - (a.created_ms ?? 0) || numberOf(b.job) - numberOf(a.job),
  );
}

/** Newest first, each once, at most `most`. */
export function mergedEvents(
  before: readonly FarmEvent[],
  added: readonly FarmEvent[],
  most: number,
): FarmEvent[] {
  const id2event = new Map(before.map((event) => [event.event, event]));
  for (const event of added) id2event.set(event.event, event);
  return [...id2event.values()].sort((a, b) => b.event - a.event).slice(0, most);
}
