// How evenly work is spread: figures of sub-domains in falling order, expected beside actual, and
// the share of the time that each worker was busy.

export interface Spread {
  count: number;
  max: number;
  mean: number;
  sum: number;
}

/** Of those that are there: 0 means that it is not told. */
export function spreadOf(values: ArrayLike<number>): Spread {
  const spread = { count: 0, max: 0, mean: 0, sum: 0 };
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!;
    if (!(value > 0) || !Number.isFinite(value)) continue;
    ++spread.count;
    spread.sum += value;
    spread.max = Math.max(spread.max, value);
  }
  spread.mean = spread.count ? spread.sum / spread.count : 0;
  return spread;
}

export interface Pair {
  expected: number;
  actual: number;
}

const mostPoints = 4000;

/** At most `most` of them, evenly taken, the first and the last among them. */
export function thinned<T>(values: readonly T[], most = mostPoints): T[] {
  if (values.length <= most) return values.slice();
  const step = (values.length - 1) / (most - 1);
  return Array.from({ length: most }, (_, i) => values[Math.round(i * step)]!);
}

/** Curves over the rank: actual falling, with what was expected of the same sub-domain. */
export function rankedCurves(pairs: readonly Pair[]): [number[], number[], (number | null)[]] {
  const sorted = pairs.filter((p) => p.actual > 0).sort((a, b) => b.actual - a.actual);
  const ranked = sorted.map((pair, i) => ({ pair, rank: i + 1 }));
  const kept = thinned(ranked);
  return [
    kept.map(({ rank }) => rank),
    kept.map(({ pair }) => pair.actual),
    kept.map(({ pair }) => (pair.expected > 0 ? pair.expected : null)),
  ];
}

/** Points by rising expectation, and the line on which both are equal. */
export function scatterOf(pairs: readonly Pair[]): [number[], number[], number[]] {
  const known = pairs.filter((p) => p.actual > 0 && p.expected > 0);
  const kept = thinned(known.sort((a, b) => a.expected - b.expected));
  const expected = kept.map((p) => p.expected);
  return [expected, kept.map((p) => p.actual), expected];
}

export interface BusyWorker {
  name: string;
  seconds: number;
  share: number;
}

export interface WorkSpan {
  worker: string;
  fromMs: number;
  toMs: number;
}

/** Of the time from the job's first attempt to its last: how much each worker was at it. */
export function busyShares(count: number, spanAt: (i: number) => WorkSpan): BusyWorker[] {
  let begin = Infinity;
  let end = -Infinity;
  const name2seconds = new Map<string, number>();
  for (let i = 0; i < count; ++i) {
    const span = spanAt(i);
    if (!(span.fromMs > 0) || !(span.toMs >= span.fromMs)) continue;
    begin = Math.min(begin, span.fromMs);
    end = Math.max(end, span.toMs);
    const before = name2seconds.get(span.worker) ?? 0;
    name2seconds.set(span.worker, before + (span.toMs - span.fromMs) / 1000);
  }
  const whole = (end - begin) / 1000;
  return [...name2seconds]
    .map(([name, seconds]) => ({ name, seconds, share: whole > 0 ? Math.min(1, seconds / whole) : 0 }))
    .sort((a, b) => b.share - a.share || (a.name < b.name ? -1 : 1));
}
