import { describe, expect, it } from 'vitest';
import { mergedEvents, mergedJobs } from './live';
import type { FarmEvent, JobLine } from './types';

const job = (id: string, created_ms: number, state = 'running') => ({ job: id, created_ms, state }) as JobLine;
const event = (id: number, message = '') => ({ event: id, message }) as FarmEvent;

describe('jobs that changed', () => {
  it('replace what was known of them and stay newest first', () => {
    const merged = mergedJobs([job('job-2', 5), job('job-1', 3)], [job('job-1', 3, 'done'), job('job-3', 9)]);
    expect(merged.map((line) => `${line.job} ${line.state}`)).toEqual(['job-3 running', 'job-2 running', 'job-1 done']);
  });
  it('of one moment are ordered by their number', () => {
    expect(mergedJobs([], [job('job-9', 1), job('job-10', 1)]).map((line) => line.job)).toEqual(['job-10', 'job-9']);
  });
});

describe('new events', () => {
  it('are there once, newest first, and bounded', () => {
    const merged = mergedEvents([event(3), event(1)], [event(2), event(3, 'again'), event(4)], 3);
    expect(merged.map((line) => line.event)).toEqual([4, 3, 2]);
    expect(merged[1]!.message).toBe('again');
  });
});
