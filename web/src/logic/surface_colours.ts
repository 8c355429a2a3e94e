// Colours of sub-domains and patches that people with any kind of colour vision tell apart: the
// seven of Okabe and Ito, lighter and darker where there are more, and viridis for figures. A
// legend says what each means.

export type Rgb = readonly [number, number, number]; // 0 to 255

export interface LegendLine {
  words: string;
  colour: Rgb;
  count?: number;
}

export const ways = ['subdomain', 'state', 'worker', 'seconds', 'angle', 'patch', 'layers'] as const;
export type Way = (typeof ways)[number];

export const wayWords: Record<Way, string> = {
  subdomain: 'Sub-domain',
  state: 'State',
  worker: 'Worker',
  seconds: 'Seconds of meshing',
  angle: 'Smallest angle',
  patch: 'Patch',
  layers: 'Layers on the wall',
};

const hues: readonly Rgb[] = [
  [230, 159, 0], [86, 180, 233], [0, 158, 115], [240, 228, 66], [0, 114, 178], [213, 94, 0], [204, 121, 167],
];
const viridis: readonly Rgb[] = [
  [68, 1, 84], [65, 68, 135], [42, 120, 142], [34, 168, 132], [122, 209, 81], [253, 231, 37],
];
export const unknownColour: Rgb = [150, 156, 164];
export const cutColour: Rgb = [196, 201, 208];
export const layersColour: Rgb = [112, 128, 144];

/** The steps of the scale of figures. */
export const scaleSteps = viridis.length;

/** Of step `step` of so many, which are spread over the scale. */
export function scaleColour(step: number, steps: number): Rgb {
  const index = steps > 1 ? Math.round((step * (viridis.length - 1)) / (steps - 1)) : viridis.length - 2;
  return viridis[Math.min(viridis.length - 1, Math.max(0, index))]!;
}

export const differentColours = 3 * hues.length;

function mixed(colour: Rgb, other: number, share: number): Rgb {
  return colour.map((part) => Math.round(part + share * (other - part))) as unknown as Rgb;
}

/** The same after 21. */
export function categoryColour(index: number): Rgb {
  const hue = hues[index % hues.length]!;
  const round = Math.floor(index / hues.length) % 3;
  return round === 0 ? hue : round === 1 ? mixed(hue, 0, 0.4) : mixed(hue, 255, 0.5);
}

export function cssColour(colour: Rgb): string {
  return `rgb(${colour.join(', ')})`;
}

export interface Steps {
  colourOf: (value: number) => Rgb;
  legend: { from: number; to: number; colour: Rgb }[];
}

/** Equal steps between the least and the largest; values that are not above 0 are not known. */
export function stepsOf(values: readonly number[]): Steps {
  const known = values.filter((value) => value > 0 && Number.isFinite(value));
  const low = known.length ? Math.min(...known) : 0;
  const high = known.length ? Math.max(...known) : 0;
  const count = high > low ? viridis.length : known.length ? 1 : 0;
  const width = count > 0 ? (high - low) / count : 0;
  const stepOf = (value: number) => (width > 0 ? Math.min(count - 1, Math.max(0, Math.floor((value - low) / width))) : 0);
  return {
    colourOf: (value) => (count > 0 && value > 0 && Number.isFinite(value) ? viridis[stepOf(value)]! : unknownColour),
    legend: Array.from({ length: count }, (_, i) => ({ from: low + i * width, to: low + (i + 1) * width, colour: viridis[i]! })),
  };
}
