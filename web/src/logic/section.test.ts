import { describe, expect, it } from 'vitest';
import type { ShownSurface } from './shown_surface';
import type { Cut } from './section';
import { isKept, placeOfCut, sectionOf } from './section';

const tetrahedron: ShownSurface = {
  vertices: new Float32Array([0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2]),
  triangles: new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]),
  pieces: new Int32Array(4),
  kinds: [0],
  wholeTriangles: 4,
  origin: [10, 0, 0],
};
const cut = (at: number, axis: Cut['axis'] = 'x'): Cut => ({ axis, at, keepsAbove: false });

describe('a section', () => {
  it('has a line for each triangle that the plane goes through, and all of it lies in the plane', () => {
    const lines = sectionOf(tetrahedron, cut(11));
    expect(lines.length).toBe(3 * 6);
    for (let i = 0; i < lines.length; i += 3) expect(lines[i]).toBeCloseTo(1);
    expect(Math.max(...lines)).toBeCloseTo(1);
  });

  it('is closed: each of its ends is that of two lines', () => {
    const lines = sectionOf(tetrahedron, cut(0.5, 'z'));
    const ends = new Map<string, number>();
    for (let i = 0; i < lines.length; i += 3) {
      const end = [...lines.slice(i, i + 3)].map((value) => value.toFixed(4)).join();
      ends.set(end, (ends.get(end) ?? 0) + 1);
    }
    expect([...ends.values()]).toEqual([2, 2, 2]);
  });

  it('of a plane beside the surface is empty, and of one through a corner has no lengths', () => {
    expect(sectionOf(tetrahedron, cut(9)).length).toBe(0);
    expect(sectionOf(tetrahedron, cut(12.5)).length).toBe(0);
    const corner = sectionOf(tetrahedron, cut(12));
    for (let i = 0; i < corner.length; i += 6) expect([...corner.slice(i, i + 3)]).toEqual([...corner.slice(i + 3, i + 6)]);
  });
});

describe('a cut', () => {
  it('lies at its share of a box', () => {
    expect(placeOfCut({ low: [0, -2, 0], high: [1, 6, 1] }, 'y', 0.25)).toBe(0);
    expect(placeOfCut({ low: [Infinity, 0, 0], high: [-Infinity, 0, 0] }, 'x', 0.5)).toBe(0);
  });

  it('keeps the side that it says', () => {
    expect(isKept(cut(1), [0.5, 9, 9])).toBe(true);
    expect(isKept(cut(1), [1.5, 0, 0])).toBe(false);
    expect(isKept({ ...cut(1, 'y'), keepsAbove: true }, [0, 1.5, 0])).toBe(true);
  });
});
