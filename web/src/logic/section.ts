// Where a plane cuts the boundary of a sub-domain: a line for each triangle that it goes through.

import type { Box, ShownSurface } from './shown_surface';

export const axes = ['x', 'y', 'z'] as const;
export type Axis = (typeof axes)[number];

/** What lies on one side of a plane across an axis is left out. */
export interface Cut {
  axis: Axis;
  at: number; // a coordinate of the mesh
  keepsAbove: boolean;
}

/** The plane at a share, 0 to 1, of the way through a box. */
export function placeOfCut(box: Box, axis: Axis, share: number): number {
  const i = axes.indexOf(axis);
  const [low, high] = [box.low[i]!, box.high[i]!];
  return Number.isFinite(high - low) ? low + share * (high - low) : 0;
}

export function isKept(cut: Cut, place: readonly number[]): boolean {
  const value = place[axes.indexOf(cut.axis)]!;
  return cut.keepsAbove ? value >= cut.at : value <= cut.at;
}

/** Six numbers for each line, seen from the surface's origin. */
export function sectionOf({ vertices, triangles, origin }: ShownSurface, { axis, at }: Cut): Float32Array {
  const i = axes.indexOf(axis);
  const level = at - origin[i]!;
  const lines: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    for (let side = 0; side < 3; ++side) {
      const a = 3 * triangles[t + side]!;
      const b = 3 * triangles[t + ((side + 1) % 3)]!;
      const [above, below] = [vertices[a + i]! - level, vertices[b + i]! - level];
      if (above >= 0 === below >= 0) continue;
      const share = above / (above - below);
      for (let k = 0; k < 3; ++k) lines.push(vertices[a + k]! + share * (vertices[b + k]! - vertices[a + k]!));
    }
  }
  return Float32Array.from(lines);
}
