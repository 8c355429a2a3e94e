import { describe, expect, it } from 'vitest';
import type { ShownSubdomain } from './shown_subdomains';
import { colouringOf } from './shown_subdomains';
import { cutColour, unknownColour } from './surface_colours';

const one = (path: number, more: Partial<ShownSubdomain> = {}): ShownSubdomain => ({
  path, place: `P${path}`, state: 'done', worker: 'worker-2', seconds: 3, angle: 20, task: path, ...more,
});

describe('colouringOf', () => {
  it('gives each sub-domain its colour and names it', () => {
    const made = colouringOf('subdomain', [one(4), one(5)], [], new Set());
    expect(made.legend.map(({ words }) => words)).toEqual(['P4', 'P5']);
    expect(made.ofSubdomain(one(5))).toEqual(made.legend[1]!.colour);
    expect(made.ofSubdomain(one(4))).not.toEqual(made.ofSubdomain(one(5)));
    expect(made.remark).toBe('');
  });

  it('says what the legend leaves out and that colours come again', () => {
    const made = colouringOf('subdomain', Array.from({ length: 60 }, (_, i) => one(i + 1)), [], new Set());
    expect(made.legend).toHaveLength(24);
    expect(made.remark).toMatch(/36 more .* colours come again/);
  });

  it('counts workers, and who nobody has meshed', () => {
    const made = colouringOf('worker', [one(4, { worker: 'worker-10' }), one(5), one(6), one(7, { worker: '' })], [], new Set());
    expect(made.legend.map(({ words, count }) => [words, count])).toEqual([['worker-2', 2], ['worker-10', 1], ['nobody yet', 1]]);
    expect(made.ofSubdomain(one(7, { worker: '' }))).toEqual(unknownColour);
  });

  it('tells states that are there, in their order', () => {
    const made = colouringOf('state', [one(4), one(5, { state: 'runs' }), one(6, { state: 'odd' })], [], new Set());
    expect(made.legend.map(({ words }) => words)).toEqual(['is being meshed', 'meshed']);
    expect(made.ofSubdomain(one(6, { state: 'odd' }))).toEqual(unknownColour);
  });

  it('has steps of seconds', () => {
    const made = colouringOf('seconds', [one(4, { seconds: 1 }), one(5, { seconds: 61 }), one(6, { seconds: 0 })], [], new Set());
    expect(made.legend).toHaveLength(7);
    expect(made.ofSubdomain(one(6, { seconds: 0 }))).toEqual(unknownColour);
  });

  it('has steps of angles', () => {
    const made = colouringOf('angle', [one(4, { angle: 10 }), one(5, { angle: 40 })], [], new Set());
    expect(made.legend).toHaveLength(6);
    expect(made.legend[0]!.words).toBe('10° to 15°');
    expect(made.ofSubdomain(one(5, { angle: 40 }))).toEqual(made.legend[5]!.colour);
  });

  it('colours triangles by patch, names those that are seen, and makes names harmless', () => {
    const made = colouringOf('patch', [one(4)], ['wall', 'far\u202Efield', 'inlet'], new Set([1, 0, -1, -3]));
    expect(made.ofSubdomain(one(4))).toBeUndefined();
    expect(made.ofPiece(-1)).toEqual(cutColour);
    expect(made.legend.map(({ words }) => words)).toEqual(
      ['wall', expect.not.stringContaining('\u202E'), 'cut between sub-domains', 'input surface, patch not known']);
  });

  it('calls a surface without patches what it is', () => {
    expect(colouringOf('patch', [], [], new Set([0])).legend[0]!.words).toBe('the input surface');
  });
});
