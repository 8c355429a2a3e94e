import { describe, expect, it } from 'vitest';
import { ColumnTable, taskColumns } from '../api/columns';
import { binned, columnsOfBins, inPercent, shapesOf, smallestAngles, worstPlaceOf } from './quality';

describe('smallestAngles', () => {
  it('are those that tasks of the kind have told', () => {
    const tasks = new ColumnTable(taskColumns.numbers, taskColumns.texts);
    tasks.append({
      columns: ['task', 'kind', 'state', 'min_dihedral_deg'],
      rows: [[1, 'mesh', 'done', 12], [2, 'mesh', 'leased', 13], [3, 'cosmetic', 'done', 14], [4, 'mesh', 'done', 0],
        [5, 'mesh', 'done', 999], [6, 'mesh', 'done', 21]],
      next: 0,
    });
    expect(smallestAngles(tasks, 'mesh')).toEqual([12, 21]);
    expect(smallestAngles(tasks, 'cosmetic')).toEqual([14]);
  });
});

describe('binned', () => {
  it('counts by steps up to the last that has any', () => {
    expect(binned([0.5, 4.9, 5, 19], 5)).toEqual({ width: 5, counts: [2, 1, 0, 1] });
    expect(binned([], 5).counts).toEqual([]);
  });

  it('makes columns in the middle of the steps, and shares', () => {
    expect(columnsOfBins({ width: 10, counts: [3, 1] })).toEqual([[5, 15], [3, 1]]);
    expect(inPercent({ width: 10, counts: [3, 1] }).counts).toEqual([75, 25]);
    expect(inPercent({ width: 10, counts: [0] }).counts).toEqual([0]);
  });
});

describe('shapesOf', () => {
  it('reads what the result tells', () => {
    const told = { elements: 10, min_dihedral_deg: 8, max_dihedral_deg: 160, mean_radius_ratio: 0.9, dihedral_histogram: [1, 2, 57] };
    expect(shapesOf(told)).toEqual({
      elements: 10, minDegrees: 8, maxDegrees: 160, meanRadiusRatio: 0.9, bins: { width: 10, counts: [1, 2, 57] },
    });
  });

  it('takes nothing from what tells nothing', () => {
    for (const nothing of [null, undefined, 3, {}, { elements: 0 }, { elements: 4 }, { elements: 4, dihedral_histogram: 'x' },
      { elements: 4, dihedral_histogram: [null, NaN, 'x'] }]) {
      expect(shapesOf(nothing)).toBeUndefined();
    }
  });
});

describe('worstPlaceOf', () => {
  it('is where the result says, and nowhere where it does not', () => {
    expect(worstPlaceOf({ worst_at: [1, 2, 3], min_dihedral_deg: 9 })).toEqual({ at: [1, 2, 3], degrees: 9 });
    for (const nothing of [null, 3, {}, { worst_at: [1, 2, 3] }, { worst_at: [1, 2], min_dihedral_deg: 9 },
      { worst_at: [1, 2, '3'], min_dihedral_deg: 9 }, { worst_at: 'x', min_dihedral_deg: 9 }]) {
      expect(worstPlaceOf(nothing)).toBeUndefined();
    }
  });
});
