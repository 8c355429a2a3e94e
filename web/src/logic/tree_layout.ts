// The decomposition tree as bars: one level below the other, each sub-domain as wide as its share
// of the leaves. It comes from the heap numbers of the tasks; sub-domains between that have no task
// (any more) are there as well. Layout is O(n log n), what is drawn is bounded by pixels.

export interface TreeTask {
  task: number;
  path: number;
  state: string;
  share: number;
}

export interface Tree {
  count: number;
  levels: number;
  leaves: number;
  path: Float64Array;
  level: Uint8Array;
  /** From 0 to 1, as shares of the leaves. */
  left: Float64Array;
  right: Float64Array;
  /** Index of the task (of what was given) that tells the node's state; −1: it has none. */
  shown: Int32Array;
  /** Rank of its state, see `rankOf`. */
  rank: Uint8Array;
  path2node: Map<number, number>;
  /** Nodes of each level, from left to right. */
  ofLevel: Uint32Array[];
}

const deepest = 52;

/** What is looked for first has the highest rank: of a node's tasks it decides, and of nodes that
 * are merged in one pixel as well. */
const state2rank: Record<string, number> = {
  open: 0,
  replaced: 1,
  done: 2,
  waiting: 3,
  ready: 4,
  leased: 5,
  failed: 6,
};
export const rankedStates = Object.keys(state2rank);

export function rankOf(state: string): number {
  return Object.hasOwn(state2rank, state) ? state2rank[state]! : 0;
}

/** A node has the state of its newest task, unless an older one runs, is ready or has failed: while
 * a leaf is meshed, the tasks that come after wait. */
function decides(next: TreeTask, than: TreeTask): boolean {
  const urgent = (task: TreeTask) => {
    const rank = rankOf(task.state);
    return rank >= state2rank.ready! ? rank : 0;
  };
  const difference = urgent(next) - urgent(than);
  return difference !== 0 ? difference > 0 : next.task > than.task;
}

function levelOf(path: number): number {
  let level = 0;
  for (let at = path; at > 1; at = Math.floor(at / 2)) ++level;
  return level;
}

/** `taskAt(i)` gives the i-th of `count` tasks, or nothing where it is in no sub-domain. */
export function treeOf(count: number, taskAt: (i: number) => TreeTask | undefined): Tree {
  const shownOf = new Map<number, number>();
  const decided = new Map<number, TreeTask>();
  for (let i = 0; i < count; ++i) {
    const task = taskAt(i);
    if (!task || !Number.isSafeInteger(task.path) || task.path < 1) continue;
    const before = decided.get(task.path);
    if (before && !decides(task, before)) continue;
    decided.set(task.path, task);
    shownOf.set(task.path, i);
  }
  const paths = new Set<number>();
  for (const path of decided.keys()) {
    if (levelOf(path) > deepest) continue;
    for (let at = path; at >= 1 && !paths.has(at); at = Math.floor(at / 2)) paths.add(at);
  }
  return laidOut(paths, shownOf, decided);
}

function laidOut(
  paths: Set<number>,
  shownOf: Map<number, number>,
  decided: Map<number, TreeTask>,
): Tree {
  const sorted = Float64Array.from(paths).sort();
  const n = sorted.length;
  const path2node = new Map<number, number>();
  sorted.forEach((path, node) => path2node.set(path, node));
  const child = (path: number, half: number) => path2node.get(2 * path + half) ?? -1;
  const leavesBelow = new Float64Array(n);
  for (let node = n - 1; node >= 0; --node) {
    const [left, right] = [child(sorted[node]!, 0), child(sorted[node]!, 1)];
    const sum = (left < 0 ? 0 : leavesBelow[left]!) + (right < 0 ? 0 : leavesBelow[right]!);
    leavesBelow[node] = sum || 1;
  }
  const tree: Tree = {
    count: n,
    levels: 0,
    leaves: n ? leavesBelow[0]! : 0,
    path: sorted,
    level: new Uint8Array(n),
    left: new Float64Array(n),
    right: new Float64Array(n),
    shown: new Int32Array(n).fill(-1),
    rank: new Uint8Array(n),
    path2node,
    ofLevel: [],
  };
  const ofLevel: number[][] = [];
  for (let node = 0; node < n; ++node) {
    const path = sorted[node]!;
    if (node === 0) tree.right[0] = 1;
    const level = tree.level[node]!;
    (ofLevel[level] ??= []).push(node);
    tree.shown[node] = shownOf.get(path) ?? -1;
    tree.rank[node] = rankOf(decided.get(path)?.state ?? 'open');
    let at = tree.left[node]!;
    for (const half of [0, 1]) {
      const below = child(path, half);
      if (below < 0) continue;
      tree.level[below] = level + 1;
      tree.left[below] = at;
      at += leavesBelow[below]! / tree.leaves;
      tree.right[below] = at;
    }
  }
  tree.levels = ofLevel.length;
  tree.ofLevel = ofLevel.map((nodes) => Uint32Array.from(nodes));
  return tree;
}

export interface TreeBar {
  x: number;
  width: number;
  level: number;
  /** −1 where several nodes share the bar. */
  node: number;
  rank: number;
  nodes: number;
}

export interface TreeView {
  left: number;
  right: number;
  width: number;
}

/** The first node of a level whose right end is beyond `x`. */
function firstBeyond(tree: Tree, nodes: Uint32Array, x: number): number {
  let [low, high] = [0, nodes.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (tree.right[nodes[middle]!]! > x) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** What is to be drawn of the part from `left` to `right` on `width` pixels. Neighbours that are
 * narrower than a pixel become one bar with the state of the highest rank: at most 2 bars a pixel
 * and level. */
export function barsOfTree(tree: Tree, view: TreeView): TreeBar[] {
  const scale = view.width / (view.right - view.left);
  const bars: TreeBar[] = [];
  tree.ofLevel.forEach((nodes, level) => {
    let merged: TreeBar | undefined;
    for (let i = firstBeyond(tree, nodes, view.left); i < nodes.length; ++i) {
      const node = nodes[i]!;
      if (tree.left[node]! >= view.right) break;
      const x = Math.max(0, (tree.left[node]! - view.left) * scale);
      const end = Math.min(view.width, (tree.right[node]! - view.left) * scale);
      const rank = tree.rank[node]!;
      if (end - x >= 1) {
        merged = undefined;
        bars.push({ x, width: end - x, level, node, rank, nodes: 1 });
      } else if (merged && end - merged.x <= 1) {
        merged.width = Math.max(merged.width, end - merged.x);
        merged.rank = Math.max(merged.rank, rank);
        merged.node = -1;
        ++merged.nodes;
      } else {
        merged = { x, width: end - x, level, node, rank, nodes: 1 };
        bars.push(merged);
      }
    }
  });
  return bars;
}

/** The node at a place of the picture; −1: none. `x` is a share of the leaves. */
export function nodeAt(tree: Tree, x: number, level: number): number {
  const nodes = tree.ofLevel[level];
  if (!nodes) return -1;
  const node = nodes[firstBeyond(tree, nodes, x)];
  return node !== undefined && tree.left[node]! <= x ? node : -1;
}

/** Where the arrow keys lead from a node; the node itself where there is nothing. */
export function neighbour(tree: Tree, node: number, key: string): number {
  const path = tree.path[node]!;
  const to = (target: number | undefined) => target ?? node;
  if (key === 'ArrowUp') return to(tree.path2node.get(Math.floor(path / 2)));
  if (key === 'ArrowDown') {
    return to(tree.path2node.get(2 * path) ?? tree.path2node.get(2 * path + 1));
  }
  const level = tree.ofLevel[tree.level[node]!]!;
  const at = firstBeyond(tree, level, tree.left[node]!);
  if (key === 'ArrowLeft') return to(level[at - 1]);
  if (key === 'ArrowRight') return to(level[at + 1]);
  return node;
}

/** From the root down to the node itself, as heap numbers. */
export function ancestors(path: number): number[] {
  const line: number[] = [];
  for (let at = path; at >= 1; at = Math.floor(at / 2)) line.unshift(at);
  return line;
}
