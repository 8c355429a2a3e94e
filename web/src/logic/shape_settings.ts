// How the page in space is set, as the part of its address behind '#': who opens the address again, or
// is sent it, sees the same. What is as ever is left out.

import type { Axis } from './section';
import { axes } from './section';
import type { Way } from './surface_colours';
import { ways } from './surface_colours';

export interface ShapeSettings {
  way: Way;
  apart: number; // percent, 0 to mostApart
  marks: boolean;
  cut: Axis | undefined;
  at: number; // of the cut, percent of the way through
  keepsAbove: boolean;
}

export const mostApart = 200;
export const usual: ShapeSettings = { way: 'subdomain', apart: 0, marks: true, cut: undefined, at: 50, keepsAbove: false };

export function hashOf(settings: ShapeSettings): string {
  const { way, apart, marks, cut, at, keepsAbove } = settings;
  const said = new URLSearchParams();
  if (way !== usual.way) said.set('colour', way);
  if (apart !== usual.apart) said.set('apart', String(apart));
  if (!marks) said.set('marks', 'no');
  if (cut) {
    said.set('cut', cut);
    said.set('at', String(at));
    if (keepsAbove) said.set('keep', 'above');
  }
  const text = said.toString();
  return text && `#${text}`;
}

function numberIn(text: string | null, most: number, otherwise: number): number {
  const value = text === null || text === '' ? NaN : Number(text);
  return value >= 0 && value <= most ? value : otherwise;
}

/** Anybody may type one: what is none is as ever. */
export function settingsOf(hash: string): ShapeSettings {
  const said = new URLSearchParams(hash.replace(/^#/, ''));
  return {
    way: ways.find((way) => way === said.get('colour')) ?? usual.way,
    apart: numberIn(said.get('apart'), mostApart, usual.apart),
    marks: said.get('marks') !== 'no',
    cut: axes.find((axis) => axis === said.get('cut')),
    at: numberIn(said.get('at'), 100, usual.at),
    keepsAbove: said.get('keep') === 'above',
  };
}
