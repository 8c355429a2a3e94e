// The kinds of tasks in the order in which a job comes to them, with the colours of the program's
// own charts (tasks/*_contract.cpp), and how a task's place in its job is called.

const kind2colour: Record<string, string> = {
  solve: '#1f78b4',
  adapt: '#33a02c',
  collect: '#e31a1c',
  remesh: '#7a9a3a',
  inspect: '#8c6bb1',
  decompose: '#d9822b',
  assimilate: '#a65628',
  mesh: '#3b7dbd',
  order: '#999999',
  extract: '#66c2a5',
  cosmetic: '#4daf4a',
  number: '#777777',
  write: '#e7a8c9',
  grow: '#b8860b',
  assemble: '#c0392b',
};

export const taskKinds = Object.keys(kind2colour);

export function colourOf(kind: string): string {
  return Object.hasOwn(kind2colour, kind) ? kind2colour[kind]! : '#8a8a8a';
}

/** Their path is the number of a cycle, not that of a sub-domain. */
export function isOfCycle(kind: string): boolean {
  return kind === 'solve' || kind === 'adapt';
}

/** The kinds there are in `kinds`, in the order of a job, unknown ones last. */
export function inOrder(kinds: Iterable<string>): string[] {
  const place = (kind: string) => {
    const at = taskKinds.indexOf(kind);
    return at < 0 ? taskKinds.length : at;
  };
  return [...new Set(kinds)].sort((a, b) => place(a) - place(b) || (a < b ? -1 : 1));
}

/** Of a heap number: "LR" is the right half of the left half, "root" the whole domain. */
export function pathText(path: number): string {
  if (!Number.isSafeInteger(path) || path < 1) return '';
  if (path === 1) return 'root';
  let text = '';
  for (let at = path; at > 1; at = Math.floor(at / 2)) text = (at % 2 === 0 ? 'L' : 'R') + text;
  return text;
}

/** "LR", "cycle 3", "" where the task is in no place. */
export function placeText(kind: string, path: number): string {
  if (!path) return '';
  return isOfCycle(kind) ? `cycle ${path}` : pathText(path);
}

/** Black or white, whichever is read more easily on "#rrggbb". */
export function inkOn(colour: string): string {
  const channel = (at: number) => {
    const c = parseInt(colour.slice(at, at + 2), 16) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  };
  const light = 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
  return light > 0.179 ? '#000000' : '#ffffff';
}
