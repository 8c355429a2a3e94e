// The tree's bars on a canvas: colour, pattern and symbol tell the state, a darker part the
// progress of what runs.

import type { ColumnTable } from '../api/columns';
import { harmlessName } from '../logic/harmless';
import { lookOf } from '../logic/states';
import type { Tree, TreeBar, TreeView } from '../logic/tree_layout';
import { barsOfTree, rankedStates } from '../logic/tree_layout';
import { patternOf } from '../ui/hatching';
import type { Drawing } from '../ui/surface';
import { colour, fontOf } from '../ui/theme';

export interface TreePicture {
  tree: Tree;
  tasks: ColumnTable;
  view: TreeView;
  chosenNode: number;
  hover: number;
}

export function rowHeightOf(levels: number): number {
  return levels <= 14 ? 26 : levels <= 24 ? 18 : 12;
}

const narrowest = 14;

/** The fill of a state, and the pattern that goes over it. */
export function paintState(context: CanvasRenderingContext2D, state: string, x: number, y: number, w: number, h: number): void {
  context.fillStyle = colour(`task-${state}`);
  context.fillRect(x, y, w, h);
  const pattern = state === 'failed' ? 'cross' : state === 'waiting' ? 'dots' : state === 'ready' ? 'stripes' : undefined;
  if (!pattern || w < 3) return;
  context.fillStyle = patternOf(context, pattern, colour(`mark-${state}`));
  context.fillRect(x, y, w, h);
}

function drawWords(drawing: Drawing, picture: TreePicture, bar: TreeBar, y: number, h: number): void {
  const { context } = drawing;
  const state = rankedStates[bar.rank]!;
  const row = picture.tree.shown[bar.node]!;
  const symbol = state === 'open' ? '' : lookOf('task', state).symbol;
  const kind = row >= 0 ? harmlessName(picture.tasks.text('kind')[row], 40) : '';
  const words = [`${symbol} ${kind}`.trim(), symbol].find(
    (text) => context.measureText(text).width <= bar.width - 6,
  );
  if (!words) return;
  const room = context.measureText(words).width;
  const x = bar.x + (bar.width - room) / 2;
  if (state === 'failed' || state === 'waiting' || state === 'ready') {
    context.fillStyle = colour(`task-${state}`);
    context.fillRect(x - 3, y + 2, room + 6, h - 4);
  }
  context.fillStyle = colour(`ink-${state}`);
  context.fillText(words, x, y + h / 2 + 0.5);
}

/** Leaves stand out from the sub-domains that they were cut from. */
function isCut(tree: Tree, node: number): boolean {
  const path = tree.path[node]!;
  return tree.path2node.has(2 * path) || tree.path2node.has(2 * path + 1);
}

function drawBar(drawing: Drawing, picture: TreePicture, bar: TreeBar, rowHeight: number): void {
  const { context } = drawing;
  const y = bar.level * rowHeight;
  const gap = bar.width > 4 ? 1 : 0;
  const [w, h] = [Math.max(1, bar.width - gap), rowHeight - 1];
  const state = rankedStates[bar.rank]!;
  paintState(context, state, bar.x, y, w, h);
  if (bar.node < 0) return;
  if (state === 'done' && isCut(picture.tree, bar.node)) {
    context.fillStyle = colour('task-cut');
    context.fillRect(bar.x, y, w, h);
  }
  const row = picture.tree.shown[bar.node]!;
  const share = row >= 0 ? picture.tasks.number('share')[row]! : 0;
  if (state === 'leased' && share > 0) {
    context.fillStyle = colour('task-progress');
    context.fillRect(bar.x, y, w * Math.min(1, share), h);
  }
  if (bar.width >= narrowest && rowHeight >= 16) drawWords(drawing, picture, bar, y, h);
}

function outline(drawing: Drawing, picture: TreePicture, node: number, ink: string, rowHeight: number): void {
  const { tree, view } = picture;
  if (node < 0) return;
  const scale = view.width / (view.right - view.left);
  const x = Math.max(0, (tree.left[node]! - view.left) * scale);
  const end = Math.min(view.width, (tree.right[node]! - view.left) * scale);
  if (end <= 0 || x >= view.width) return;
  drawing.context.strokeStyle = ink;
  drawing.context.lineWidth = 2;
  drawing.context.strokeRect(x + 1, tree.level[node]! * rowHeight + 1, Math.max(1, end - x - 2), rowHeight - 3);
}

export function drawTree(drawing: Drawing, picture: TreePicture): void {
  const { context } = drawing;
  const rowHeight = rowHeightOf(picture.tree.levels);
  context.font = fontOf(12);
  context.textBaseline = 'middle';
  const bars = barsOfTree(picture.tree, picture.view);
  for (const bar of bars) drawBar(drawing, picture, bar, rowHeight);
  outline(drawing, picture, picture.hover, colour('faint'), rowHeight);
  outline(drawing, picture, picture.chosenNode, colour('ink'), rowHeight);
  context.canvas.dataset.bars = String(bars.length);
  context.canvas.dataset.nodes = String(picture.tree.count);
}
