// How good the elements of a job are: while it runs, by the smallest angle of each sub-domain, and
// once it is done by all angles, near the cuts and away from them.

import type { ColumnTable } from '../api/columns';

export interface Bins {
  width: number; // degrees
  counts: number[];
}

/** Of a kind of task, the smallest angle of what each has made; those that do not tell are left out. */
export function smallestAngles(tasks: ColumnTable, kind: string): number[] {
  const [kinds, states, angles] = [tasks.text('kind'), tasks.text('state'), tasks.number('min_dihedral_deg')];
  const found: number[] = [];
  for (let row = 0; row < tasks.count; ++row) {
    const angle = angles[row]!;
    if (kinds[row] === kind && states[row] === 'done' && angle > 0 && angle <= 180) found.push(angle);
  }
  return found;
}

/** How many angles lie in each step, up to the last that has any. */
export function binned(angles: readonly number[], width: number): Bins {
  const counts: number[] = [];
  for (const angle of angles) {
    const bin = Math.floor(angle / width);
    while (counts.length <= bin) counts.push(0);
    ++counts[bin]!;
  }
  return { width, counts };
}

export interface Shapes {
  elements: number;
  minDegrees: number;
  maxDegrees: number;
  meanRadiusRatio: number;
  bins: Bins; // of all dihedral angles
}

const degreesOfBin = 10;

const numberOf = (value: unknown) => (typeof value === 'number' && Number.isFinite(value) ? value : 0);

/** What a result says of a part of the mesh (`near_cuts`, `away_from_cuts`); nothing where it does not. */
export function shapesOf(part: unknown): Shapes | undefined {
  if (typeof part !== 'object' || part === null) return undefined;
  const told = part as Record<string, unknown>;
  const counts = Array.isArray(told.dihedral_histogram) ? told.dihedral_histogram.slice(0, 18).map(numberOf) : [];
  if (!(numberOf(told.elements) > 0) || !counts.some((count) => count > 0)) return undefined;
  return {
    elements: numberOf(told.elements),
    minDegrees: numberOf(told.min_dihedral_deg),
    maxDegrees: numberOf(told.max_dihedral_deg),
    meanRadiusRatio: numberOf(told.mean_radius_ratio),
    bins: { width: degreesOfBin, counts },
  };
}

export interface WorstPlace {
  at: [number, number, number];
  degrees: number;
}

/** Where the smallest angle of the mesh is; nothing where the result does not tell. */
export function worstPlaceOf(result: unknown): WorstPlace | undefined {
  if (typeof result !== 'object' || result === null) return undefined;
  const { worst_at: at, min_dihedral_deg: degrees } = result as Record<string, unknown>;
  const isPlace = Array.isArray(at) && at.length === 3 && at.every((value) => typeof value === 'number' && Number.isFinite(value));
  if (!isPlace || !(numberOf(degrees) > 0)) return undefined;
  return { at: at as [number, number, number], degrees: numberOf(degrees) };
}

/** For a chart: the middles of the steps, and what lies in each. */
export function columnsOfBins({ width, counts }: Bins): [number[], number[]] {
  return [counts.map((_, bin) => (bin + 0.5) * width), counts.slice()];
}

/** As shares of all, in percent. */
export function inPercent({ width, counts }: Bins): Bins {
  const sum = counts.reduce((all, count) => all + count, 0);
  return { width, counts: counts.map((count) => (sum > 0 ? (100 * count) / sum : 0)) };
}
