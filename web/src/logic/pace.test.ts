import { describe, expect, it } from 'vitest';
import { pauseAfter, pauseBeforeReconnect } from './pace';

describe('the pace', () => {
  it('is 3 s, and ten times what a slow fetch took', () => {
    expect(pauseAfter(20)).toBe(3000);
    expect(pauseAfter(2000)).toBe(20_000);
    expect(pauseAfter(NaN)).toBe(3000);
  });
  it('never ends', () => {
    expect(pauseAfter(1e9)).toBe(300_000);
  });
  it('of reconnecting doubles up to 30 s', () => {
    expect([0, 1, 2, 10, 1000].map(pauseBeforeReconnect)).toEqual([1000, 2000, 4000, 30_000, 30_000]);
  });
});
