import { describe, expect, it } from 'vitest';
import { busyShares, rankedCurves, scatterOf, spreadOf, thinned } from './balance';

describe('the spread', () => {
  it('counts only what is told', () => {
    expect(spreadOf([0, 2, 4, NaN, Infinity])).toEqual({ count: 2, max: 4, mean: 3, sum: 6 });
    expect(spreadOf([])).toEqual({ count: 0, max: 0, mean: 0, sum: 0 });
  });
});

describe('curves', () => {
  it('fall, with the expectation of the same task beside each', () => {
    const curves = rankedCurves([{ actual: 1, expected: 5 }, { actual: 3, expected: 0 }, { actual: 0, expected: 9 }]);
    expect(curves).toEqual([[1, 2], [3, 1], [null, 5]]);
  });
  it('keep their ranks and ends when they are thinned', () => {
    const [ranks, actual] = rankedCurves(Array.from({ length: 50_000 }, (_, i) => ({ actual: i + 1, expected: 1 })));
    expect(ranks.length).toBe(4000);
    expect([ranks[0], ranks[3999]]).toEqual([1, 50_000]);
    expect([actual[0], actual[3999]]).toEqual([50_000, 1]);
  });
  it('of expectation rise along it', () => {
    const [x, y, line] = scatterOf([{ actual: 2, expected: 9 }, { actual: 8, expected: 3 }, { actual: 1, expected: 0 }]);
    expect([x, y, line]).toEqual([[3, 9], [8, 2], [3, 9]]);
  });
  it('that are short are not thinned', () => {
    expect(thinned([1, 2, 3], 3)).toEqual([1, 2, 3]);
  });
});

describe('busy shares', () => {
  it('are of the time between the first and the last attempt', () => {
    const spans = [
      { worker: 'a', fromMs: 1000, toMs: 11_000 },
      { worker: 'b', fromMs: 6000, toMs: 8000 },
      { worker: 'b', fromMs: 8000, toMs: 11_000 },
      { worker: 'c', fromMs: 0, toMs: 5 },
    ];
    expect(busyShares(spans.length, (i) => spans[i]!)).toEqual([
      { name: 'a', seconds: 10, share: 1 },
      { name: 'b', seconds: 5, share: 0.5 },
    ]);
  });
  it('of nobody are none', () => {
    expect(busyShares(0, () => ({ worker: '', fromMs: 0, toMs: 0 }))).toEqual([]);
  });
});
