// What the looks of the tree's bars mean, and how many sub-domains have each.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { whole } from '../logic/format';
import { lookOf } from '../logic/states';
import type { Tree } from '../logic/tree_layout';
import { rankedStates } from '../logic/tree_layout';
import { onTheme } from '../ui/theme';
import { paintState } from './tree_drawing';

const [width, height] = [26, 16];

function Sample({ state }: { state: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [, again] = useState(0);
  useEffect(() => onTheme(() => again((n) => n + 1)), []);
  useEffect(() => {
    const context = canvas.current?.getContext('2d');
    if (!context) return;
    context.setTransform(2, 0, 0, 2, 0, 0);
    context.clearRect(0, 0, width, height);
    paintState(context, state, 0, 0, width, height);
  });
  return <canvas ref={canvas} class="sample" width={2 * width} height={2 * height} aria-hidden="true" />;
}

export function TreeLegend({ tree }: { tree: Tree }) {
  const counts = useMemo(() => {
    const found = rankedStates.map(() => 0);
    for (const rank of tree.rank) ++found[rank]!;
    return found;
  }, [tree]);
  return (
    <ul class="legend" aria-label="States of sub-domains">
      {rankedStates.map((state, rank) =>
        counts[rank] ? (
          <li key={state}>
            <Sample state={state} />
            {state === 'open' ? 'no task of its own' : `${lookOf('task', state).symbol} ${lookOf('task', state).word}`}{' '}
            <span class="faint">{whole(counts[rank])}</span>
          </li>
        ) : null,
      )}
    </ul>
  );
}
