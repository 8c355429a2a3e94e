// Which page an address means, and back. Addresses are ours, but anybody may type one.

export const jobTabs = ['tree', 'shape', 'timeline', 'balance', 'quality', 'tasks', 'events'] as const;
export type JobTab = (typeof jobTabs)[number];

export type Route =
  | { page: 'jobs' }
  | { page: 'job'; job: string; tab: JobTab }
  | { page: 'task'; task: number }
  | { page: 'workers' }
  | { page: 'events' }
  | { page: 'unknown' };

function decoded(part: string): string | undefined {
  try {
    return decodeURIComponent(part);
  } catch {
    return undefined;
  }
}

export function routeOf(pathname: string): Route {
  const parts = pathname.split('/').filter((part) => part !== '');
  const [first, second, third] = parts;
  if (parts.length === 0 || (first === 'jobs' && parts.length === 1)) return { page: 'jobs' };
  if (first === 'workers' && parts.length === 1) return { page: 'workers' };
  if (first === 'events' && parts.length === 1) return { page: 'events' };
  if (first === 'tasks' && parts.length === 2 && /^[1-9][0-9]{0,15}$/.test(second!)) {
    return { page: 'task', task: Number(second) };
  }
  if (first === 'jobs' && second !== undefined && parts.length <= 3) {
    const job = decoded(second);
    const tab = jobTabs.find((known) => known === (third ?? 'tree'));
    if (job && job.length <= 200 && tab) return { page: 'job', job, tab };
  }
  return { page: 'unknown' };
}

export function jobAddress(job: string, tab: JobTab = 'tree'): string {
  const base = `/jobs/${encodeURIComponent(job)}`;
  return tab === 'tree' ? base : `${base}/${tab}`;
}

export function taskAddress(task: number): string {
  return `/tasks/${task}`;
}
