// Maps of a job: triangles with a number on each. Of defects it is which defect, of layers how many
// layers stand on the triangle. Their colours, and what a legend says of them.

import { counted } from './format';
import { harmlessName } from './harmless';
import type { ShownSurface } from './shown_surface';
import type { LegendLine, Rgb } from './surface_colours';
import { scaleColour, scaleSteps, unknownColour } from './surface_colours';

export interface MapColouring {
  /** Of a triangle of the map with that place among those that were coloured. */
  ofPiece: (map: number, piece: number) => Rgb;
  legend: LegendLine[];
}

const mostLines = 24;
/** None of those that sub-domains and patches have. */
const defectColours: readonly Rgb[] = [
  [200, 0, 60], [110, 40, 200], [255, 120, 120], [60, 60, 70], [150, 70, 20], [190, 160, 255],
];
export const noLayersColour: Rgb = [213, 94, 0];

function countPieces(surface: ShownSurface): Map<number, number> {
  const counts = new Map<number, number>();
  for (const piece of surface.pieces) counts.set(piece, (counts.get(piece) ?? 0) + 1);
  return counts;
}

const isWhole = (surfaces: readonly ShownSurface[]) =>
  surfaces.every(({ pieces, wholeTriangles }) => pieces.length === wholeTriangles);

/** The same defect has the same colour in all maps. `meanings`: of each map, what its numbers mean. */
export function colouringOfDefects(
  surfaces: readonly ShownSurface[],
  meanings: readonly (readonly string[])[],
): MapColouring {
  const wordsOf = (map: number, piece: number) => meanings[map]?.[piece] ?? 'defect';
  const words2count = new Map<string, number>();
  surfaces.forEach((surface, map) => {
    for (const [piece, count] of countPieces(surface)) {
      const words = wordsOf(map, piece);
      words2count.set(words, (words2count.get(words) ?? 0) + count);
    }
  });
  const all = [...words2count.keys()].sort();
  const words2colour = new Map(all.map((words, index) => [words, defectColours[index % defectColours.length]!]));
  const withCounts = isWhole(surfaces);
  return {
    ofPiece: (map, piece) => words2colour.get(wordsOf(map, piece)) ?? unknownColour,
    legend: all.slice(0, mostLines).map((words) => ({
      words: harmlessName(words, 60), colour: words2colour.get(words)!, ...(withCounts ? { count: words2count.get(words)! } : {}),
    })),
  };
}

/** Steps of whole numbers of layers; what has none stands out. */
export function colouringOfLayers(surfaces: readonly ShownSurface[]): MapColouring {
  const layers2count = new Map<number, number>();
  for (const surface of surfaces) {
    for (const [layers, count] of countPieces(surface)) layers2count.set(layers, (layers2count.get(layers) ?? 0) + count);
  }
  const most = [...layers2count.keys()].reduce((a, b) => Math.max(a, b), 0);
  const width = Math.max(1, Math.ceil(most / scaleSteps));
  const stepOf = (layers: number) => Math.floor((layers - 1) / width);
  const steps = most > 0 ? stepOf(most) + 1 : 0;
  const colourOf = (layers: number) => (layers > 0 ? scaleColour(stepOf(layers), steps) : noLayersColour);
  const withCounts = isWhole(surfaces);
  const lineOf = (from: number, to: number): LegendLine[] => {
    let count = 0;
    for (const [layers, there] of layers2count) if (layers >= from && layers <= to) count += there;
    const words = to === 0 ? 'no layers' : from === to ? counted(from, 'layer') : `${from} to ${to} layers`;
    return count === 0 ? [] : [{ words, colour: colourOf(to), ...(withCounts ? { count } : {}) }];
  };
  return {
    ofPiece: (_map, piece) => colourOf(piece),
    legend: [
      ...lineOf(0, 0),
      ...Array.from({ length: steps }, (_, step) => lineOf(step * width + 1, Math.min(most, (step + 1) * width))).flat(),
    ],
  };
}
