// What is known of the sub-domains that are drawn, and which colours and legend that makes.

import { duration, figure } from './format';
import { harmlessName } from './harmless';
import { pieceOfCut, pieceOfLayers } from './shown_surface';
import type { LegendLine, Rgb, Way } from './surface_colours';
import {
  categoryColour, cutColour, differentColours, layersColour, stepsOf, unknownColour,
} from './surface_colours';

export interface ShownSubdomain {
  path: number;
  place: string;
  state: string; // 'whole', 'waits', 'runs' or 'done'
  worker: string; // '': nobody has meshed it yet
  seconds: number; // 0: as yet unknown
  angle: number; // the smallest dihedral one as it was meshed, degrees; 0: as yet unknown
  task: number; // of meshing, 0: there is none yet
}

export const stateWords: Record<string, string> = {
  whole: 'may be cut',
  waits: 'waits to be meshed',
  runs: 'is being meshed',
  done: 'meshed',
};
const stateNames = Object.keys(stateWords);
const mostLines = 24;

export interface Colouring {
  /** Of a whole sub-domain; nothing where its triangles differ. */
  ofSubdomain: (shown: ShownSubdomain) => Rgb | undefined;
  ofPiece: (piece: number) => Rgb;
  legend: LegendLine[];
  /** What the legend leaves out, and why colours come twice. */
  remark: string;
}

function counted(names: readonly string[]): Map<string, number> {
  const counts = new Map<string, number>();
  for (const name of names) counts.set(name, (counts.get(name) ?? 0) + 1);
  return counts;
}

function repeats(count: number, what: string): string {
  return count > differentColours ? `There are ${count} ${what}: after ${differentColours}, colours come again.` : '';
}

const oneColour = (of: (shown: ShownSubdomain) => Rgb, legend: LegendLine[], remark = ''): Colouring => ({
  ofSubdomain: of,
  ofPiece: () => unknownColour,
  legend,
  remark,
});

function bySubdomain(shown: readonly ShownSubdomain[]): Colouring {
  const path2index = new Map(shown.map(({ path }, index) => [path, index]));
  const legend = shown.slice(0, mostLines).map(({ place, path }) => ({
    words: harmlessName(place || String(path), 40),
    colour: categoryColour(path2index.get(path)!),
  }));
  const more = shown.length - legend.length;
  const left = more > 0 ? `${more} more are not listed here, but in the table below. ` : '';
  return oneColour(({ path }) => categoryColour(path2index.get(path) ?? 0), legend, left + repeats(shown.length, 'sub-domains'));
}

function byState(shown: readonly ShownSubdomain[]): Colouring {
  const counts = counted(shown.map(({ state }) => state));
  const colourOf = (state: string) => (stateNames.includes(state) ? categoryColour(stateNames.indexOf(state)) : unknownColour);
  const legend = stateNames
    .filter((state) => counts.has(state))
    .map((state) => ({ words: stateWords[state]!, colour: colourOf(state), count: counts.get(state)! }));
  return oneColour(({ state }) => colourOf(state), legend);
}

function byWorker(shown: readonly ShownSubdomain[]): Colouring {
  const counts = counted(shown.map(({ worker }) => worker).filter((worker) => worker !== ''));
  const workers = [...counts.keys()].sort((a, b) => a.localeCompare(b, 'en', { numeric: true }));
  const name2index = new Map(workers.map((worker, index) => [worker, index]));
  const colourOf = (worker: string) => (name2index.has(worker) ? categoryColour(name2index.get(worker)!) : unknownColour);
  const legend: LegendLine[] = workers.slice(0, mostLines).map((worker) => ({
    words: harmlessName(worker, 40), colour: colourOf(worker), count: counts.get(worker)!,
  }));
  const nobody = shown.filter(({ worker }) => worker === '').length;
  if (nobody > 0) legend.push({ words: 'nobody yet', colour: unknownColour, count: nobody });
  return oneColour(({ worker }) => colourOf(worker), legend, repeats(workers.length, 'workers'));
}

function byFigure(shown: readonly ShownSubdomain[], key: 'seconds' | 'angle', form: (value: number) => string): Colouring {
  const steps = stepsOf(shown.map((one) => one[key]));
  const legend: LegendLine[] = steps.legend.map(({ from, to, colour }) => ({
    words: from === to ? form(from) : `${form(from)} to ${form(to)}`, colour,
  }));
  const unknown = shown.filter((one) => !(one[key] > 0)).length;
  if (unknown > 0) legend.push({ words: 'not known yet', colour: unknownColour, count: unknown });
  return oneColour((one) => steps.colourOf(one[key]), legend);
}

function byPatch(patches: readonly string[], pieces: ReadonlySet<number>): Colouring {
  const ofPiece = (piece: number): Rgb =>
    piece >= 0 ? categoryColour(piece) : piece === pieceOfCut ? cutColour : piece === pieceOfLayers ? layersColour : unknownColour;
  const known = [...pieces].filter((piece) => piece >= 0).sort((a, b) => a - b);
  const legend: LegendLine[] = known.slice(0, mostLines).map((piece) => ({
    words: harmlessName(patches[piece] ?? (patches.length ? String(piece) : 'the input surface'), 40), colour: ofPiece(piece),
  }));
  if (pieces.has(pieceOfCut)) legend.push({ words: 'cut between sub-domains', colour: cutColour });
  if (pieces.has(pieceOfLayers)) legend.push({ words: 'top of the layers', colour: layersColour });
  if ([...pieces].some((piece) => piece < pieceOfLayers)) legend.push({ words: 'input surface, patch not known', colour: unknownColour });
  return { ofSubdomain: () => undefined, ofPiece, legend, remark: repeats(known.length, 'patches') };
}

export function colouringOf(
  way: Way,
  shown: readonly ShownSubdomain[],
  patches: readonly string[],
  pieces: ReadonlySet<number>,
): Colouring {
  switch (way) {
    case 'state':
      return byState(shown);
    case 'worker':
      return byWorker(shown);
    case 'seconds':
      return byFigure(shown, 'seconds', duration);
    case 'angle':
      return byFigure(shown, 'angle', (value) => `${figure(value)}°`);
    case 'patch':
      return byPatch(patches, pieces);
    default:
      return bySubdomain(shown);
  }
}
