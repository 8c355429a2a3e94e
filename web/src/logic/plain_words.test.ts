import { describe, expect, it } from 'vitest';
import { balanceFigures, forecastFigures, qualityFigures } from './plain_words';

describe('figures in plain words', () => {
  it('are those that are told, in their form', () => {
    expect(qualityFigures({ min_dihedral_deg: 11.274, nodes: 12000, volume: 0, digest: '' })).toEqual([
      { key: 'nodes', words: 'nodes', text: '12,000' },
      { key: 'min_dihedral_deg', words: 'smallest dihedral angle', text: '11.27°' },
    ]);
    expect(forecastFigures({ expected_task_bytes: 1024 })[0]!.text).toBe('1.00 KiB');
    expect(balanceFigures({ elements: 1.25, unknown: 3 }).map(({ text }) => text)).toEqual(['1.250']);
  });
  it('of nothing are none', () => {
    for (const nothing of [undefined, null, 7, 'x', []]) expect(qualityFigures(nothing)).toEqual([]);
  });
});
