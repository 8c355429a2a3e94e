// The timeline on a canvas: labels of the processes, the axis of time, bars of attempts.

import { harmlessName } from '../logic/harmless';
import { colourOf, inkOn } from '../logic/task_kinds';
import type { Span, TimeBar, Timeline } from '../logic/timeline_bars';
import { barsOfRow, tickText, ticks } from '../logic/timeline_bars';
import { patternOf } from '../ui/hatching';
import type { Drawing } from '../ui/surface';
import { colour, fontOf } from '../ui/theme';

export const axisHeight = 24;
export const rowHeight = 20;
export const labelWidth = 120;

export interface TimelinePicture {
  timeline: Timeline;
  span: Span;
  top: number;
  hover: number;
  chosen?: Span;
}

function drawAxis({ context, width, height }: Drawing, span: Span): void {
  const room = width - labelWidth;
  const size = span.to - span.from;
  context.textAlign = 'center';
  for (const time of ticks(span, Math.max(2, Math.floor(room / 90)))) {
    const x = labelWidth + ((time - span.from) / size) * room;
    context.fillStyle = colour('line');
    context.fillRect(Math.round(x), axisHeight - 4, 1, height);
    context.fillStyle = colour('faint');
    const half = context.measureText(tickText(time, size)).width / 2;
    context.fillText(tickText(time, size), Math.min(Math.max(x, labelWidth + half), width - half), axisHeight / 2 - 1);
  }
}

function drawBar(drawing: Drawing, { timeline, hover }: TimelinePicture, bar: TimeBar, y: number): void {
  const { context } = drawing;
  const kind = timeline.kinds[bar.kind] ?? '';
  const x = labelWidth + bar.x;
  const gap = bar.width > 3 ? 0.75 : 0;
  const [w, h] = [Math.max(1, bar.width - gap), rowHeight - 5];
  context.fillStyle = colourOf(kind);
  context.fillRect(x, y, w, h);
  if (bar.isBad) {
    context.fillStyle = colour('bad');
    context.fillRect(x, y, w, h);
    context.fillStyle = patternOf(context, 'stripes', colour('paper'));
    context.fillRect(x, y, w, h);
  } else if (bar.width > 44 && bar.bars === 1) {
    context.fillStyle = inkOn(colourOf(kind));
    const words = harmlessName(kind, 20);
    if (context.measureText(words).width < bar.width - 8) context.fillText(words, x + 4, y + h / 2 + 0.5);
  }
  if (hover >= bar.bar && hover < bar.bar + bar.bars) {
    context.strokeStyle = colour('ink');
    context.lineWidth = 2;
    context.strokeRect(x + 1, y + 1, Math.max(1, w - 2), h - 2);
  }
}

function drawLabel({ context }: Drawing, picture: TimelinePicture, row: number, y: number): void {
  const { host, process } = picture.timeline.rows[row]!;
  context.fillStyle = colour('faint');
  context.fillText(`${harmlessName(host, 14)}:${process}`, 0, y + (rowHeight - 5) / 2 + 0.5, labelWidth - 10);
}

export function drawTimeline(drawing: Drawing, picture: TimelinePicture): void {
  const { context, width, height } = drawing;
  const { timeline, span, top } = picture;
  context.font = fontOf(11);
  context.textBaseline = 'middle';
  drawAxis(drawing, span);
  context.textAlign = 'left';
  context.save();
  context.beginPath();
  context.rect(0, axisHeight, width, height - axisHeight);
  context.clip();
  const first = Math.floor(top / rowHeight);
  const last = Math.min(timeline.rows.length, Math.ceil((top + height - axisHeight) / rowHeight));
  let drawn = 0;
  for (let row = first; row < last; ++row) {
    const y = axisHeight + row * rowHeight - top + 3;
    drawLabel(drawing, picture, row, y);
    const bars = barsOfRow(timeline, row, { ...span, width: width - labelWidth });
    for (const bar of bars) drawBar(drawing, picture, bar, y);
    drawn += bars.length;
  }
  context.restore();
  if (picture.chosen) {
    const at = (time: number) => labelWidth + ((time - span.from) / (span.to - span.from)) * (width - labelWidth);
    context.fillStyle = colour('selection');
    context.fillRect(at(picture.chosen.from), axisHeight, at(picture.chosen.to) - at(picture.chosen.from), height);
  }
  context.canvas.dataset.bars = String(drawn);
  context.canvas.dataset.attempts = String(timeline.count);
  context.canvas.dataset.from = span.from.toFixed(3);
  context.canvas.dataset.to = span.to.toFixed(3);
}
