import { describe, expect, it } from 'vitest';
import { isJobLive, isLostAttempt, jobStates, lookOf, taskStates } from './states';

describe('states', () => {
  it('of tasks have different symbols, so that colour is not needed', () => {
    expect(new Set(taskStates.map((state) => lookOf('task', state).symbol)).size).toBe(taskStates.length);
  });
  it('of jobs have different symbols, and those that wait for others may still change', () => {
    expect(new Set(jobStates.map((state) => lookOf('job', state).symbol)).size).toBe(jobStates.length);
    expect(jobStates.filter(isJobLive)).toEqual(['waiting', 'running', 'stuck']);
  });
  it('that are not known are shown as they came', () => {
    expect(lookOf('job', 'constructor')).toEqual({ word: 'constructor', symbol: '?', tone: 'quiet' });
  });
  it('of attempts that came to nothing are all but done and running', () => {
    const all = ['running', 'done', 'failed', 'crashed', 'killed', 'lost', 'returned', 'revoked', 'starved'];
    expect(all.filter((state) => !isLostAttempt(state))).toEqual(['running', 'done']);
  });
});
