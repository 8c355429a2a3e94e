// Who worked at what when: a row for each worker's process, a bar for each attempt. Zoomed by wheel,
// drag and keys; a click opens the task.

import { useMemo, useRef, useState } from 'preact/hooks';
import type { ColumnTable } from '../api/columns';
import { live } from '../api/hooks';
import { duration, whole } from '../logic/format';
import { harmlessName } from '../logic/harmless';
import { taskAddress } from '../logic/router';
import { isLostAttempt, lookOf } from '../logic/states';
import { inOrder, placeText } from '../logic/task_kinds';
import type { Span, Timeline } from '../logic/timeline_bars';
import { barAt, keptWithin, timelineOf, zoomed } from '../logic/timeline_bars';
import { goTo } from '../ui/navigation';
import { Empty, Kind } from '../ui/parts';
import { Surface } from '../ui/surface';
import type { TimelinePicture } from './timeline_drawing';
import { axisHeight, drawTimeline, labelWidth, rowHeight } from './timeline_drawing';

const mostHeight = 560;

function timelineOfAttempts(attempts: ColumnTable, nowMs: number): Timeline {
  const n = (name: string) => attempts.number(name);
  const t = (name: string) => attempts.text(name);
  const [attempt, task, process, started, ended] =
    [n('attempt'), n('task'), n('process'), n('started_ms'), n('ended_ms')];
  const [kind, state, host] = [t('kind'), t('state'), t('host')];
  return timelineOf(
    attempts.count,
    (i) => ({
      attempt: attempt[i]!,
      task: task[i]!,
      kind: kind[i]!,
      state: state[i]!,
      host: host[i]!,
      process: process[i]!,
      startedMs: started[i]!,
      endedMs: ended[i]!,
    }),
    isLostAttempt,
    nowMs,
  );
}

function tipOf(timeline: Timeline, attempts: ColumnTable, bar: number): string {
  const row = timeline.source[bar]!;
  const kind = attempts.text('kind')[row]!;
  const place = placeText(kind, attempts.number('path')[row]!);
  const seconds = timeline.end[bar]! - timeline.start[bar]!;
  const host = harmlessName(attempts.text('host')[row], 40);
  return (
    `${harmlessName(kind, 40)} ${place.slice(0, 40)} · task #${attempts.number('task')[row]} · ` +
    `${lookOf('attempt', attempts.text('state')[row]!).word} · ${duration(seconds)} · ` +
    `${host}:${attempts.number('process')[row]}`
  );
}

function Legend({ timeline }: { timeline: Timeline }) {
  return (
    <ul class="legend" aria-label="Kinds of tasks">
      {inOrder(timeline.kinds).map((kind) => (
        <li key={kind}>
          <Kind kind={kind} />
        </li>
      ))}
      <li>
        <span class="sample hatched" aria-hidden="true" /> came to nothing
      </li>
    </ul>
  );
}

interface Drag {
  x: number;
  y: number;
  span: Span;
  top: number;
  hasMoved: boolean;
  selects: boolean;
}

interface Controls {
  span: Span;
  setSpan: (span: Span) => void;
  seconds: number;
  scrollBy: (rows: number) => void;
}

function keyDone(event: KeyboardEvent, { span, setSpan, seconds, scrollBy }: Controls): boolean {
  const size = span.to - span.from;
  const middle = (span.from + span.to) / 2;
  const move = (part: number) =>
    setSpan(keptWithin({ from: span.from + part * size, to: span.to + part * size }, seconds));
  const keys: Record<string, () => void> = {
    '+': () => setSpan(zoomed(span, 0.6, middle, seconds)),
    '=': () => setSpan(zoomed(span, 0.6, middle, seconds)),
    '-': () => setSpan(zoomed(span, 1 / 0.6, middle, seconds)),
    '0': () => setSpan(keptWithin({ from: 0, to: seconds }, seconds)),
    Home: () => setSpan(keptWithin({ from: 0, to: size }, seconds)),
    End: () => setSpan(keptWithin({ from: seconds - size, to: seconds }, seconds)),
    ArrowLeft: () => move(-0.2),
    ArrowRight: () => move(0.2),
    ArrowUp: () => scrollBy(-1),
    ArrowDown: () => scrollBy(1),
    PageUp: () => scrollBy(-10),
    PageDown: () => scrollBy(10),
  };
  const found = Object.hasOwn(keys, event.key) ? keys[event.key] : undefined;
  found?.();
  return found !== undefined;
}

export function TimelineTab({ attempts }: { attempts: ColumnTable }) {
  const timeline = useMemo(
    () => timelineOfAttempts(attempts, live.farm?.time_ms ?? Date.now()),
    [attempts],
  );
  const [width, setWidth] = useState(0);
  const [chosenSpan, setSpan] = useState<Span>();
  const [top, setTop] = useState(0);
  const [hover, setHover] = useState(-1);
  const [chosen, choose] = useState<Span>();
  const drag = useRef<Drag>();
  if (timeline.count === 0) return <Empty>No attempt has begun yet.</Empty>;
  const all = keptWithin({ from: 0, to: timeline.seconds }, timeline.seconds);
  const span = chosenSpan ? keptWithin(chosenSpan, timeline.seconds) : all;
  const height = Math.min(mostHeight, axisHeight + timeline.rows.length * rowHeight + 4);
  const lowest = Math.max(0, timeline.rows.length * rowHeight - (height - axisHeight - 4));
  const scroll = (to: number) => setTop(Math.min(lowest, Math.max(0, to)));
  const room = Math.max(1, width - labelWidth);
  const timeAt = (x: number) => span.from + ((x - labelWidth) / room) * (span.to - span.from);
  const find = (x: number, y: number) => {
    if (x < labelWidth || y < axisHeight) return -1;
    const slack = (2 / room) * (span.to - span.from);
    return barAt(timeline, Math.floor((y - axisHeight + top) / rowHeight), timeAt(x), slack);
  };
  const controls = {
    span,
    setSpan,
    seconds: timeline.seconds,
    scrollBy: (rows: number) => scroll(top + rows * rowHeight),
  };
  const onMove = (x: number, y: number) => {
    const from = drag.current;
    if (!from) return setHover(find(x, y));
    from.hasMoved ||= Math.abs(x - from.x) + Math.abs(y - from.y) > 4;
    if (!from.hasMoved) return;
    if (from.selects) return choose({ from: Math.min(timeAt(x), timeAt(from.x)), to: Math.max(timeAt(x), timeAt(from.x)) });
    const shift = ((from.x - x) / room) * (from.span.to - from.span.from);
    setSpan(keptWithin({ from: from.span.from + shift, to: from.span.to + shift }, timeline.seconds));
    scroll(from.top + from.y - y);
  };
  const onUp = (x: number, y: number) => {
    const from = drag.current;
    drag.current = undefined;
    if (from?.selects && chosen) {
      setSpan(keptWithin(chosen, timeline.seconds));
      choose(undefined);
    } else if (from && !from.hasMoved) {
      const bar = find(x, y);
      const row = bar >= 0 ? timeline.source[bar]! : -1;
      if (row >= 0) goTo(taskAddress(attempts.number('task')[row]!));
    }
  };
  const picture: Omit<TimelinePicture, 'width'> = { timeline, span, top, hover, ...(chosen ? { chosen } : {}) };
  const zoomBy = (factor: number) => setSpan(zoomed(span, factor, (span.from + span.to) / 2, timeline.seconds));
  return (
    <>
      <div class="row between">
        <span class="row">
          <button type="button" class="button" onClick={() => zoomBy(0.5)}>Zoom in</button>
          <button type="button" class="button" onClick={() => zoomBy(2)}>Zoom out</button>
          <button type="button" class="button" onClick={() => setSpan(undefined)}>Whole job</button>
        </span>
        <span class="faint">
          {whole(timeline.count)} attempts by {whole(timeline.rows.length)} processes
        </span>
      </div>
      <Surface
        label="Timeline of attempts. Plus and minus zoom, arrow keys move, 0 shows the whole job. The tab Tasks lists the same tasks."
        height={height}
        onSize={setWidth}
        draw={(drawing) => drawTimeline(drawing, picture)}
        onMove={onMove}
        onLeave={() => setHover(-1)}
        onDown={(x, y, event) => {
          (event.target as Element).setPointerCapture(event.pointerId);
          drag.current = { x, y, span, top, hasMoved: false, selects: event.shiftKey };
        }}
        onUp={onUp}
        onWheel={(x, event) => {
          event.preventDefault();
          setSpan(zoomed(span, Math.exp(Math.max(-1, Math.min(1, event.deltaY / 300))), timeAt(x), timeline.seconds));
        }}
        onKey={(event) => {
          if (keyDone(event, controls)) event.preventDefault();
        }}
        cursor={hover >= 0 ? 'pointer' : 'grab'}
      />
      <p class="tip" role="status">
        {hover >= 0 && hover < timeline.count ? (
          tipOf(timeline, attempts, hover)
        ) : (
          <span class="faint">
            Wheel zooms, dragging moves, dragging with Shift shows that time. Keys: + − arrows 0. A click opens the task.
          </span>
        )}
      </p>
      <Legend timeline={timeline} />
    </>
  );
}
