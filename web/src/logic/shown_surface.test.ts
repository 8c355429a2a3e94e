import { describe, expect, it } from 'vitest';
import {
  addBox, boxOf, centreOf, diagonalOf, emptyBox, explodedBy, isInBox, parseShownSurface, trianglesForEach,
} from './shown_surface';

/** Two triangles, 1e9 away in x, as the server writes them. */
function bytesOfTwo(change: (bytes: DataView) => void = () => undefined, surplus = 0): ArrayBuffer {
  const bytes = new ArrayBuffer(48 + 4 * 12 + 2 * 16 + surplus);
  const view = new DataView(bytes);
  [...'TFSHOWN\n'].forEach((letter, i) => view.setUint8(i, letter.charCodeAt(0)));
  [1, 4, 2, 500].forEach((value, i) => view.setUint32(8 + 4 * i, value, true));
  [1e9, 2, 3].forEach((value, i) => view.setFloat64(24 + 8 * i, value, true));
  [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0].forEach((value, i) => view.setFloat32(48 + 4 * i, value, true));
  [0, 1, 2, 0, 2, 3].forEach((value, i) => view.setUint32(96 + 4 * i, value, true));
  [7, -1].forEach((value, i) => view.setInt32(120 + 4 * i, value, true));
  change(view);
  return bytes;
}

describe('parseShownSurface', () => {
  it('reads vertices, triangles and what they are pieces of', () => {
    const surface = parseShownSurface(bytesOfTwo());
    expect([...surface.triangles]).toEqual([0, 1, 2, 0, 2, 3]);
    expect([...surface.pieces]).toEqual([7, -1]);
    expect(surface.kinds).toEqual([7, -1]);
    expect(surface.vertices.length).toBe(12);
    expect(surface.wholeTriangles).toBe(500);
    expect(boxOf(surface)).toEqual({ low: [1e9 - 1, 1, 3], high: [1e9 + 1, 3, 3] });
  });

  it('refuses what is malformed', () => {
    const wrong: [string, ArrayBuffer][] = [
      ['nothing', new ArrayBuffer(0)],
      ['a head alone', bytesOfTwo().slice(0, 48)],
      ['cut short', bytesOfTwo().slice(0, 127)],
      ['longer', bytesOfTwo(undefined, 4)],
      ['another magic', bytesOfTwo((view) => view.setUint8(3, 0))],
      ['another version', bytesOfTwo((view) => view.setUint32(8, 2, true))],
      ['too many triangles', bytesOfTwo((view) => view.setUint32(16, 0xffffffff, true))],
      ['too many vertices', bytesOfTwo((view) => view.setUint32(12, 0xffffffff, true))],
      ['a corner that is none', bytesOfTwo((view) => view.setUint32(100, 4, true))],
      ['a place that is none', bytesOfTwo((view) => view.setFloat32(52, NaN, true))],
      ['an origin that is none', bytesOfTwo((view) => view.setFloat64(32, Infinity, true))],
    ];
    for (const [what, bytes] of wrong) expect(() => parseShownSurface(bytes), what).toThrow(/cannot be read/);
  });

  it('takes a surface without triangles', () => {
    const empty = bytesOfTwo((view) => [12, 16].forEach((at) => view.setUint32(at, 0, true))).slice(0, 48);
    expect(parseShownSurface(empty).pieces.length).toBe(0);
  });
});

describe('boxes', () => {
  it('grow by others, and have a centre and a diagonal', () => {
    const box = emptyBox();
    expect(diagonalOf(box)).toBe(0);
    addBox(box, { low: [0, 0, 0], high: [1, 1, 0] });
    addBox(box, { low: [2, 0, 0], high: [3, 4, 0] });
    expect(centreOf(box)).toEqual([1.5, 2, 0]);
    expect(diagonalOf(box)).toBe(5);
    expect(isInBox(box, [1, 4, 0])).toBe(true);
    expect(isInBox(box, [1, 4, 0.1])).toBe(false);
    expect(isInBox(box, [1, 4, 0.1], 0.2)).toBe(true);
  });
});

describe('explodedBy', () => {
  it('moves away from the centre of all, and not at all without a share', () => {
    expect(explodedBy([3, 2, 1], [1, 2, 3], 0.5)).toEqual([1, 0, -1]);
    expect(explodedBy([3, 2, 1], [1, 2, 3], 0).map(Math.abs)).toEqual([0, 0, 0]);
  });
});

describe('trianglesForEach', () => {
  it('is a power of two that the server takes, within the budget where it can be', () => {
    expect(trianglesForEach(0)).toBe(32_768);
    expect(trianglesForEach(1)).toBe(32_768);
    expect(trianglesForEach(100)).toBe(2048);
    expect(trianglesForEach(2000)).toBe(256);
    for (const count of [20, 77, 500, 1100]) expect(count * trianglesForEach(count)).toBeLessThanOrEqual(300_000);
  });
});
