import { describe, expect, it } from 'vitest';
import type { TimelineAttempt } from './timeline_bars';
import { barAt, barsOfRow, keptWithin, ticks, tickText, timelineOf, zoomed } from './timeline_bars';

function attempt(process: number, from: number, to: number, change: Partial<TimelineAttempt> = {}): TimelineAttempt {
  const begin = 1_000_000;
  return { attempt: 1, task: 1, kind: 'mesh', state: 'done', host: 'a', process,
    startedMs: begin + 1000 * from, endedMs: to < 0 ? 0 : begin + 1000 * to, ...change };
}

const make = (attempts: TimelineAttempt[], nowMs = 0) =>
  timelineOf(attempts.length, (i) => attempts[i]!, (state) => state === 'lost', nowMs);

describe('the timeline', () => {
  it('has a row for each process, by host and number', () => {
    const made = make([attempt(2, 0, 1), attempt(1, 0, 1, { host: 'b' }), attempt(1, 1, 2), attempt(2, 2, 3)]);
    expect(made.rows.map((row) => `${row.host}${row.process}`)).toEqual(['a1', 'a2', 'b1']);
    expect(made.rows.map((row) => row.last - row.first)).toEqual([1, 2, 1]);
  });
  it('ends what runs now, and never before it began', () => {
    expect(make([attempt(1, 0, -1)], 1_005_000).end[0]).toBe(5);
    expect(make([attempt(1, 0, -1)], 0).end[0]).toBe(0);
  });
  it('leaves out what has no beginning', () => {
    expect(make([attempt(1, 0, 1, { startedMs: 0 })]).count).toBe(0);
  });
  it('keeps apart hosts whose names end in numbers', () => {
    expect(make([attempt(11, 0, 1, { host: 'a' }), attempt(1, 0, 1, { host: 'a1' })]).rows.length).toBe(2);
  });
});

describe('bars of a row', () => {
  const view = { from: 0, to: 100, width: 100 };
  it('lie where their time is, cut at the edges', () => {
    const made = make([attempt(1, 0, 10), attempt(1, 50, 200)]);
    expect(barsOfRow(made, 0, view).map(({ x, width }) => [x, width])).toEqual([[0, 10], [50, 50]]);
  });
  it('are bounded by pixels, and stand for every attempt', () => {
    const made = make(Array.from({ length: 100_000 }, (_, i) => attempt(1, i / 1000, (i + 0.9) / 1000)));
    const bars = barsOfRow(made, 0, view);
    expect(bars.length).toBeLessThanOrEqual(201);
    expect(bars.reduce((sum, bar) => sum + bar.bars, 0)).toBe(100_000);
  });
  it('show one that was lost among those of its pixel', () => {
    const made = make(Array.from({ length: 1000 }, (_, i) =>
      attempt(1, i / 100, (i + 0.9) / 100, { state: i === 500 ? 'lost' : 'done' })));
    expect(barsOfRow(made, 0, view).filter((bar) => bar.isBad).length).toBe(1);
  });
  it('that are merged have the colour of the longest', () => {
    const made = make([attempt(1, 0, 0.1, { kind: 'cut' }), attempt(1, 0.2, 0.8), attempt(1, 0.85, 0.9, { kind: 'cut' })]);
    const bars = barsOfRow(made, 0, view);
    expect(bars.length).toBe(1);
    expect(made.kinds[bars[0]!.kind]).toBe('mesh');
  });
  it('are found although a long one before them overlaps', () => {
    const made = make([attempt(1, 0, 90), attempt(1, 1, 2), attempt(1, 80, 85)]);
    expect(barsOfRow(made, 0, { from: 70, to: 79, width: 10 }).map((bar) => bar.bar)).toEqual([0]);
  });
  it('of a row that is not there are none', () => {
    expect(barsOfRow(make([attempt(1, 0, 1)]), 7, view)).toEqual([]);
  });
});

describe('what is under the pointer', () => {
  const made = make([attempt(1, 0, 10), attempt(1, 12, 20)]);
  it('is the bar there, or the nearest within reach', () => {
    expect(barAt(made, 0, 15, 0.5)).toBe(1);
    expect(barAt(made, 0, 10.4, 0.5)).toBe(0);
    expect(barAt(made, 0, 11, 0.5)).toBe(-1);
    expect(barAt(made, 3, 1, 1)).toBe(-1);
  });
});

describe('the span that is shown', () => {
  it('stays within the job', () => {
    expect(keptWithin({ from: -5, to: 5 }, 100)).toEqual({ from: 0, to: 10 });
    expect(keptWithin({ from: 95, to: 105 }, 100)).toEqual({ from: 90, to: 100 });
    expect(keptWithin({ from: 0, to: 1000 }, 100)).toEqual({ from: 0, to: 100 });
  });
  it('of a job without time is not empty', () => {
    const span = keptWithin({ from: 0, to: 0 }, 0);
    expect(span.to).toBeGreaterThan(span.from);
  });
  it('keeps the time under the pointer when it is zoomed', () => {
    const span = zoomed({ from: 0, to: 100 }, 0.5, 25, 100);
    expect(span).toEqual({ from: 12.5, to: 62.5 });
    expect((25 - span.from) / (span.to - span.from)).toBeCloseTo(0.25);
  });
  it('has few, round ticks at any zoom', () => {
    for (const size of [0.02, 3, 100, 5000, 1e6, 1e9]) {
      const found = ticks({ from: size / 3, to: size / 3 + size }, 8);
      expect(found.length).toBeGreaterThan(0);
      expect(found.length).toBeLessThan(17);
    }
    expect(tickText(3723, 4000)).toBe('1:02:03');
    expect(tickText(65, 100)).toBe('1:05');
    expect(tickText(1.25, 2)).toBe('1.25 s');
  });
});
