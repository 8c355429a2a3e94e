import { describe, expect, it } from 'vitest';
import { hashOf, settingsOf, usual } from './shape_settings';

describe('settings of the page in space', () => {
  it('are the same when they come back from an address', () => {
    for (const settings of [
      usual,
      { ...usual, way: 'patch' as const, apart: 120 },
      { ...usual, marks: false, cut: 'y' as const, at: 12.5, keepsAbove: true },
      { ...usual, cut: 'z' as const, at: 0 },
    ]) {
      expect(settingsOf(hashOf(settings))).toEqual(settings);
    }
  });

  it('are left out of the address where they are as ever', () => {
    expect(hashOf(usual)).toBe('');
    expect(hashOf({ ...usual, cut: 'x' })).toBe('#cut=x&at=50');
  });

  it('are as ever where the address says what is none', () => {
    for (const hash of ['', '#', '#main', '#colour=constructor&apart=-1&at=x&cut=w', '#apart=1e9&at=101&at=5', '#%']) {
      expect(settingsOf(hash)).toEqual(usual);
    }
  });
});
