// Attempts as bars, a row for each worker's process, and what of them is to be drawn: only what is
// visible, and bars narrower than a pixel merged, so that the number of rectangles is bounded by
// the picture and not by the job.

export interface TimelineAttempt {
  attempt: number;
  task: number;
  kind: string;
  state: string;
  host: string;
  process: number;
  startedMs: number;
  endedMs: number;
}

export interface TimelineRow {
  host: string;
  process: number;
  first: number;
  last: number;
}

export interface Timeline {
  count: number;
  rows: TimelineRow[];
  beginMs: number;
  /** Seconds since `beginMs`, sorted by row and start. */
  start: Float64Array;
  end: Float64Array;
  /** Largest end of the row's bars so far: what a search by time may skip. */
  latest: Float64Array;
  /** Index of the attempt in what was given. */
  source: Uint32Array;
  isBad: Uint8Array;
  kind: Uint8Array;
  kinds: string[];
  seconds: number;
}

const rowKey = (attempt: TimelineAttempt) => `${attempt.process} ${attempt.host}`;

export function timelineOf(
  count: number,
  attemptAt: (i: number) => TimelineAttempt,
  isBad: (state: string) => boolean,
  nowMs: number,
): Timeline {
  const attempts = Array.from({ length: count }, (_, i) => attemptAt(i)).map((a, i) => ({ a, i }));
  const usable = attempts.filter(({ a }) => a.startedMs > 0);
  const beginMs = usable.reduce((least, { a }) => Math.min(least, a.startedMs), Infinity);
  const keys = new Map<string, TimelineAttempt>();
  for (const { a } of usable) if (!keys.has(rowKey(a))) keys.set(rowKey(a), a);
  const heads = [...keys.entries()].sort(
    ([, a], [, b]) => (a.host < b.host ? -1 : a.host > b.host ? 1 : a.process - b.process),
  );
  const key2row = new Map(heads.map(([key], row) => [key, row]));
  const order = usable
    .map(({ a, i }) => ({ a, i, row: key2row.get(rowKey(a))! }))
    .sort((x, y) => x.row - y.row || x.a.startedMs - y.a.startedMs || x.i - y.i);
  const kinds = [...new Set(usable.map(({ a }) => a.kind))].slice(0, 255);
  const n = order.length;
  const made: Timeline = {
    count: n,
    rows: heads.map(([, a]) => ({ host: a.host, process: a.process, first: 0, last: 0 })),
    beginMs: n ? beginMs : 0,
    start: new Float64Array(n),
    end: new Float64Array(n),
    latest: new Float64Array(n),
    source: new Uint32Array(n),
    isBad: new Uint8Array(n),
    kind: new Uint8Array(n),
    kinds,
    seconds: 0,
  };
  order.forEach(({ a, i, row }, at) => {
    const line = made.rows[row]!;
    if (line.last === 0) line.first = at;
    line.last = at + 1;
    const endMs = a.endedMs > 0 ? a.endedMs : Math.max(nowMs, a.startedMs);
    made.start[at] = (a.startedMs - beginMs) / 1000;
    made.end[at] = Math.max(made.start[at]!, (endMs - beginMs) / 1000);
    made.latest[at] = at > line.first ? Math.max(made.latest[at - 1]!, made.end[at]!) : made.end[at]!;
    made.source[at] = i;
    made.isBad[at] = isBad(a.state) ? 1 : 0;
    made.kind[at] = Math.max(0, kinds.indexOf(a.kind));
    made.seconds = Math.max(made.seconds, made.end[at]!);
  });
  return made;
}

export interface TimeView {
  from: number;
  to: number;
  width: number;
}

export interface TimeBar {
  x: number;
  width: number;
  row: number;
  /** The first of the bars that it stands for. */
  bar: number;
  bars: number;
  kind: number;
  isBad: boolean;
}

function firstEndingAfter(timeline: Timeline, row: TimelineRow, time: number): number {
  let [low, high] = [row.first, row.last];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (timeline.latest[middle]! >= time) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** Bars of one row; those under a pixel that fall into one pixel are one bar, bad if one of them
 * is, in the colour of the longest. At most 2 for each pixel, unless attempts overlap. */
export function barsOfRow(timeline: Timeline, row: number, view: TimeView): TimeBar[] {
  const line = timeline.rows[row];
  if (!line) return [];
  const scale = view.width / (view.to - view.from);
  const bars: TimeBar[] = [];
  let merged: TimeBar | undefined;
  let longest = 0;
  for (let at = firstEndingAfter(timeline, line, view.from); at < line.last; ++at) {
    const start = timeline.start[at]!;
    const end = timeline.end[at]!;
    if (start > view.to) break;
    if (end < view.from) continue;
    const x = Math.max(0, (start - view.from) * scale);
    const width = Math.min(view.width, (end - view.from) * scale) - x;
    const isBad = timeline.isBad[at] === 1;
    const kind = timeline.kind[at]!;
    if (width >= 1) {
      merged = undefined;
      bars.push({ x, width, row, bar: at, bars: 1, kind, isBad });
    } else if (merged && x + width - merged.x <= 1) {
      merged.width = Math.max(merged.width, x + width - merged.x);
      merged.isBad ||= isBad;
      ++merged.bars;
      if (end - start > longest) merged.kind = kind;
      longest = Math.max(longest, end - start);
    } else {
      merged = { x, width, row, bar: at, bars: 1, kind, isBad };
      longest = end - start;
      bars.push(merged);
    }
  }
  return bars;
}

/** The bar at a time, or the one nearest to it within `slack` seconds; −1: none. */
export function barAt(timeline: Timeline, row: number, time: number, slack: number): number {
  const line = timeline.rows[row];
  if (!line) return -1;
  let best = -1;
  let distance = slack;
  for (let at = firstEndingAfter(timeline, line, time - slack); at < line.last; ++at) {
    if (timeline.start[at]! > time + slack) break;
    const away = Math.max(timeline.start[at]! - time, time - timeline.end[at]!, 0);
    if (away > distance) continue;
    best = at;
    distance = away;
  }
  return best;
}

export interface Span {
  from: number;
  to: number;
}

const shortestSpan = 0.01;

/** Kept within the whole, never shorter than a hundredth of a second. */
export function keptWithin(span: Span, seconds: number): Span {
  const whole = Math.max(seconds, shortestSpan);
  const size = Math.min(whole, Math.max(shortestSpan, span.to - span.from));
  const from = Math.min(Math.max(0, span.from), whole - size);
  return { from, to: from + size };
}

/** Zoomed by `factor` (below 1: closer) so that `at` stays where it is. */
export function zoomed(span: Span, factor: number, at: number, seconds: number): Span {
  const size = Math.max(shortestSpan, (span.to - span.from) * factor);
  const share = (at - span.from) / (span.to - span.from);
  return keptWithin({ from: at - share * size, to: at + (1 - share) * size }, seconds);
}

/** Round times for an axis, at most about `most` of them. */
export function ticks(span: Span, most: number): number[] {
  const steps = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120,
    300, 600, 900, 1800, 3600, 7200, 14400, 28800, 43200, 86400];
  const size = span.to - span.from;
  let step = steps.find((s) => size / s <= most);
  if (step === undefined) step = 86400 * Math.ceil(size / 86400 / most);
  const found: number[] = [];
  for (let i = Math.ceil(span.from / step); i * step <= span.to && found.length <= 2 * most; ++i) {
    found.push(i * step);
  }
  return found;
}

/** "1:02:03", "4:05", "12.50" by the size of what is shown. */
export function tickText(seconds: number, spanSeconds: number): string {
  const two = (n: number) => String(n).padStart(2, '0');
  if (spanSeconds < 5) return `${seconds.toFixed(spanSeconds < 0.5 ? 3 : 2)} s`;
  const s = Math.round(seconds);
  const minutes = `${Math.floor(s / 60) % 60}`;
  if (s < 3600) return `${minutes}:${two(s % 60)}`;
  return `${Math.floor(s / 3600)}:${two(Number(minutes))}:${two(s % 60)}`;
}
