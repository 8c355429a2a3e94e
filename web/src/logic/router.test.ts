import { describe, expect, it } from 'vitest';
import { jobAddress, routeOf, taskAddress } from './router';

describe('addresses', () => {
  it('lead to their pages', () => {
    expect(routeOf('/')).toEqual({ page: 'jobs' });
    expect(routeOf('/jobs/')).toEqual({ page: 'jobs' });
    expect(routeOf('/jobs/job-7')).toEqual({ page: 'job', job: 'job-7', tab: 'tree' });
    expect(routeOf('/jobs/job-7/timeline')).toEqual({ page: 'job', job: 'job-7', tab: 'timeline' });
    expect(routeOf('/tasks/12')).toEqual({ page: 'task', task: 12 });
    expect(routeOf('/workers')).toEqual({ page: 'workers' });
    expect(routeOf('/events')).toEqual({ page: 'events' });
  });
  it('that nobody made lead nowhere', () => {
    for (const path of ['/tasks/0', '/tasks/x', '/tasks/1/2', '/jobs/a/b', '/jobs/a/tree/c', '/nothing',
      '/jobs/%E0%A4%A', `/jobs/${'a'.repeat(201)}`, '/tasks/99999999999999999']) {
      expect(routeOf(path)).toEqual({ page: 'unknown' });
    }
  });
  it('of jobs and tasks lead back to them, whatever their name', () => {
    const job = 'a/b?c#d <>';
    expect(routeOf(jobAddress(job, 'events'))).toEqual({ page: 'job', job, tab: 'events' });
    expect(routeOf(jobAddress(job))).toEqual({ page: 'job', job, tab: 'tree' });
    expect(routeOf(taskAddress(5))).toEqual({ page: 'task', task: 5 });
  });
});
