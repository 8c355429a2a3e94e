import { describe, expect, it } from 'vitest';
import type { TreeTask } from './tree_layout';
import { ancestors, barsOfTree, neighbour, nodeAt, rankOf, treeOf } from './tree_layout';

const make = (tasks: TreeTask[]) => treeOf(tasks.length, (i) => tasks[i]);
const task = (number: number, path: number, state = 'done'): TreeTask => ({ task: number, path, state, share: 0 });

/** All leaves `levels` below the root. */
function full(levels: number, state = 'done') {
  return make(Array.from({ length: 2 ** levels }, (_, i) => task(i + 1, 2 ** levels + i, state)));
}

describe('the tree', () => {
  it('has all sub-domains between its tasks and the root', () => {
    const tree = make([task(1, 13)]);
    expect([...tree.path]).toEqual([1, 3, 6, 13]);
    expect(tree.levels).toBe(4);
    expect(tree.leaves).toBe(1);
  });
  it('gives each leaf the same width, and each node that of its leaves', () => {
    const tree = make([task(1, 2), task(2, 6), task(3, 7)]);
    const width = (path: number) => {
      const node = tree.path2node.get(path)!;
      return tree.right[node]! - tree.left[node]!;
    };
    expect(width(2)).toBeCloseTo(1 / 3);
    expect(width(3)).toBeCloseTo(2 / 3);
    expect(width(6)).toBeCloseTo(1 / 3);
    expect(width(1)).toBe(1);
  });
  it('shows the newest task of a sub-domain', () => {
    const tree = make([task(5, 1, 'waiting'), task(9, 1, 'done'), task(7, 1, 'waiting')]);
    expect(tree.shown[0]).toBe(1);
  });
  it('shows what runs or failed before newer ones that wait', () => {
    expect(make([task(1, 1, 'leased'), task(2, 1, 'waiting')]).rank[0]).toBe(rankOf('leased'));
    expect(make([task(1, 1, 'failed'), task(2, 1, 'leased')]).rank[0]).toBe(rankOf('failed'));
  });
  it('leaves out paths that are none', () => {
    expect(make([task(1, 0), task(2, -4), task(3, 2.5), task(4, NaN), task(5, 2 ** 60)]).count).toBe(0);
  });
  it('of nothing is empty', () => {
    const tree = make([]);
    expect(tree.count).toBe(0);
    expect(barsOfTree(tree, { left: 0, right: 1, width: 100 })).toEqual([]);
  });
});

describe('bars of the tree', () => {
  it('cover each node once, in order, where there is room', () => {
    const bars = barsOfTree(full(3), { left: 0, right: 1, width: 800 });
    expect(bars.map((bar) => bar.level)).toEqual([0, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3]);
    expect(bars[14]).toMatchObject({ x: 700, width: 100, nodes: 1 });
  });
  it('are bounded by pixels and lose no node', () => {
    const tree = full(16);
    const bars = barsOfTree(tree, { left: 0, right: 1, width: 1000 });
    expect(bars.length).toBeLessThan(2 * 1000 * tree.levels);
    expect(bars.reduce((sum, bar) => sum + bar.nodes, 0)).toBe(tree.count);
    const ofLast = bars.filter((bar) => bar.level === 16);
    expect(ofLast.length).toBeLessThan(2001);
  });
  it('show one failed leaf among thousands that share its pixel', () => {
    const tasks = Array.from({ length: 2 ** 14 }, (_, i) => task(i + 1, 2 ** 14 + i, i === 5000 ? 'failed' : 'done'));
    const bars = barsOfTree(make(tasks), { left: 0, right: 1, width: 200 });
    expect(bars.filter((bar) => bar.rank === rankOf('failed')).length).toBe(1);
  });
  it('are only those in view', () => {
    const tree = full(4);
    const node = tree.path2node.get(5)!;
    const view = { left: tree.left[node]!, right: tree.right[node]!, width: 400 };
    const bars = barsOfTree(tree, view);
    expect(bars.map((bar) => tree.path[bar.node])).toEqual([1, 2, 5, 10, 11, 20, 21, 22, 23]);
    for (const bar of bars) expect(bar.x + bar.width).toBeLessThanOrEqual(400.001);
  });
});

describe('ways in the tree', () => {
  it('find the node under a place', () => {
    const tree = full(2);
    expect(tree.path[nodeAt(tree, 0.3, 2)]).toBe(5);
    expect(nodeAt(tree, 0.3, 3)).toBe(-1);
    const lopsided = make([task(1, 2), task(2, 12)]);
    expect(nodeAt(lopsided, 0.1, 2)).toBe(-1);
  });
  it('lead to parent, child and neighbours, and stay at the edge', () => {
    const tree = full(2);
    const at = (path: number) => tree.path2node.get(path)!;
    expect(neighbour(tree, at(5), 'ArrowUp')).toBe(at(2));
    expect(neighbour(tree, at(2), 'ArrowDown')).toBe(at(4));
    expect(neighbour(tree, at(5), 'ArrowRight')).toBe(at(6));
    expect(neighbour(tree, at(6), 'ArrowLeft')).toBe(at(5));
    expect(neighbour(tree, at(4), 'ArrowLeft')).toBe(at(4));
    expect(neighbour(tree, at(7), 'ArrowRight')).toBe(at(7));
    expect(neighbour(tree, at(1), 'ArrowUp')).toBe(at(1));
    expect(neighbour(tree, at(7), 'ArrowDown')).toBe(at(7));
  });
  it('name all ancestors from the root', () => {
    expect(ancestors(11)).toEqual([1, 2, 5, 11]);
  });
});
