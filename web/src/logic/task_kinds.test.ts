import { describe, expect, it } from 'vitest';
import { colourOf, inOrder, inkOn, pathText, placeText, taskKinds } from './task_kinds';

describe('places', () => {
  it('are ways from the root', () => {
    expect(pathText(1)).toBe('root');
    expect(pathText(5)).toBe('LR');
    expect(pathText(2 ** 40)).toBe('L'.repeat(40));
  });
  it('that are none have no text', () => {
    for (const path of [0, -1, 1.5, NaN, 2 ** 60]) expect(pathText(path)).toBe('');
  });
  it('of a loop are cycles', () => {
    expect(placeText('solve', 3)).toBe('cycle 3');
    expect(placeText('mesh', 3)).toBe('R');
    expect(placeText('mesh', 0)).toBe('');
  });
});

describe('kinds', () => {
  it('come in the order of a job, unknown ones last, each once', () => {
    expect(inOrder(['write', 'zzz', 'mesh', 'inspect', 'mesh'])).toEqual(['inspect', 'mesh', 'write', 'zzz']);
  });
  it('have a colour even with a name that objects have', () => {
    expect(colourOf('constructor')).toBe('#8a8a8a');
  });
  it('can be read on their colours', () => {
    const light = (c: string) => {
      const channels = [1, 3, 5].map((at) => parseInt(c.slice(at, at + 2), 16) / 255);
      const [r, g, b] = channels.map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
    };
    for (const kind of taskKinds) {
      const [a, b] = [light(colourOf(kind)), light(inkOn(colourOf(kind)))];
      expect((Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05)).toBeGreaterThan(4.5);
    }
  });
});
