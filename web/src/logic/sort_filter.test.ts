import { describe, expect, it } from 'vitest';
import { fittingRows, rowsInView, sortedRows, textFits } from './sort_filter';

const all = (n: number) => fittingRows(n, () => true);

describe('filters', () => {
  it('want every word, in any of the texts, capitals or not', () => {
    expect(textFits('WING node', ['wing-7', 'node01'])).toBe(true);
    expect(textFits('wing node02', ['wing-7', 'node01'])).toBe(false);
    expect(textFits('  ', [])).toBe(true);
  });
  it('take no pattern for more than its letters', () => {
    expect(textFits('.*', ['abc'])).toBe(false);
  });
  it('find nothing across two texts', () => {
    expect(textFits('ab', ['a', 'b'])).toBe(false);
  });
});

describe('sorting', () => {
  it('is stable both ways', () => {
    const keys = [2, 1, 2, 1];
    expect([...sortedRows(all(4), (row) => keys[row]!, false)]).toEqual([1, 3, 0, 2]);
    expect([...sortedRows(all(4), (row) => keys[row]!, true)]).toEqual([0, 2, 1, 3]);
  });
  it('puts what is no number last, both ways', () => {
    const keys = [NaN, 1, 2];
    expect([...sortedRows(all(3), (row) => keys[row]!, false)]).toEqual([1, 2, 0]);
    expect([...sortedRows(all(3), (row) => keys[row]!, true)]).toEqual([2, 1, 0]);
  });
  it('leaves the given rows as they are', () => {
    const rows = all(3);
    sortedRows(rows, (row) => -row, false);
    expect([...rows]).toEqual([0, 1, 2]);
  });
});

describe('rows in view', () => {
  it('are bounded by the view and not by the table', () => {
    const { first, last } = rowsInView(100_000, 32, 1_600_000, 640);
    expect(last - first).toBeLessThan(50);
    expect(first).toBeLessThanOrEqual(50_000);
    expect(last).toBeGreaterThanOrEqual(50_020);
  });
  it('fill the room of all rows together with what is before and after', () => {
    for (const top of [0, 31, 320, 99_999 * 32, 1e9]) {
      const { first, last, before, after } = rowsInView(100_000, 32, top, 640);
      expect(before + after + 32 * (last - first)).toBe(3_200_000);
      expect(last).toBeGreaterThan(first);
    }
  });
  it('are all of a short table', () => {
    expect(rowsInView(3, 32, 0, 640)).toEqual({ first: 0, last: 3, before: 0, after: 0 });
  });
});
