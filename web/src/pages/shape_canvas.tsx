// The canvas that sub-domains are drawn on, and how it is turned, moved and zoomed, by a pointer, by
// keys and by buttons.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { Cut } from '../logic/section';
import type { ShownSurface } from '../logic/shown_surface';
import { Waiting } from '../ui/parts';
import { colour, onTheme } from '../ui/theme';
import type { ColourOf, Overlay, ShapeScene } from './shape_scene';

interface CanvasProps {
  surfaces: ReadonlyMap<number, ShownSurface>;
  colourOf: ColourOf;
  exploded: number;
  mark: readonly number[] | undefined;
  cut: Cut | undefined;
  overlays: readonly Overlay[];
  label: string;
  onChoose: (path: number | undefined) => void;
}

const keySteps: Record<string, (scene: ShapeScene) => void> = {
  ArrowLeft: (scene) => scene.turn(-0.15, 0),
  ArrowRight: (scene) => scene.turn(0.15, 0),
  ArrowUp: (scene) => scene.turn(0, 0.15),
  ArrowDown: (scene) => scene.turn(0, -0.15),
  '+': (scene) => scene.zoom(1.25),
  '=': (scene) => scene.zoom(1.25),
  '-': (scene) => scene.zoom(0.8),
  '0': (scene) => scene.fit(),
};
const shiftedSteps: Record<string, (scene: ShapeScene) => void> = {
  ArrowLeft: (scene) => scene.move(-0.05, 0),
  ArrowRight: (scene) => scene.move(0.05, 0),
  ArrowUp: (scene) => scene.move(0, 0.05),
  ArrowDown: (scene) => scene.move(0, -0.05),
};

const buttons: [string, (scene: ShapeScene) => void][] = [
  ['Zoom in', keySteps['+']!],
  ['Zoom out', keySteps['-']!],
  ['Turn left', keySteps.ArrowLeft!],
  ['Turn right', keySteps.ArrowRight!],
  ['Whole job', keySteps['0']!],
];

type Stage = 'loading' | 'drawn' | 'without' | 'lost' | 'failed';

/** The scene of a canvas, as soon as three.js is there. */
function useScene(element: { current: HTMLCanvasElement | null }): [ShapeScene | undefined, Stage] {
  const [scene, set] = useState<ShapeScene>();
  const [stage, go] = useState<Stage>('loading');
  useEffect(() => {
    const canvas = element.current!;
    const context = canvas.getContext('webgl2', { antialias: true });
    if (!context) return go('without');
    let made: ShapeScene | undefined;
    let isOver = false;
    const sizes = new ResizeObserver(() => made?.size(canvas.clientWidth, canvas.clientHeight));
    const lost = () => go('lost');
    canvas.addEventListener('webglcontextlost', lost);
    const forget = onTheme(() => made?.background(colour('paper'), colour('ink')));
    import('./shape_scene').then(
      ({ ShapeScene: Made }) => {
        if (isOver) return;
        made = new Made(canvas, context);
        made.background(colour('paper'), colour('ink'));
        sizes.observe(canvas);
        set(made);
        go('drawn');
      },
      () => go('failed'),
    );
    return () => {
      isOver = true;
      canvas.removeEventListener('webglcontextlost', lost);
      sizes.disconnect();
      forget();
      made?.dispose();
    };
  }, []);
  return [scene, stage];
}

const stageWords: Record<Stage, string> = {
  loading: 'Loading what draws in space…',
  drawn: '',
  without: 'This browser has no WebGL 2, so nothing can be drawn here. The table below has the same sub-domains.',
  lost: 'The graphics of this computer gave up. Load the page again to draw anew.',
  failed: 'What draws in space could not be loaded. Load the page again.',
};

function usePointer(scene: ShapeScene | undefined, onChoose: CanvasProps['onChoose']) {
  const down = useRef<{ x: number; y: number; isMove: boolean; isStill: boolean }>();
  const placeOf = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top, box };
  };
  return {
    onPointerDown: (event: PointerEvent) => {
      const { x, y } = placeOf(event);
      down.current = { x, y, isMove: event.shiftKey || event.button === 2, isStill: true };
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
    },
    onPointerMove: (event: PointerEvent) => {
      const from = down.current;
      if (!from || !scene) return;
      const { x, y, box } = placeOf(event);
      const [right, downwards] = [x - from.x, y - from.y];
      if (from.isStill && Math.hypot(right, downwards) < 4) return;
      if (from.isMove) scene.move(right / box.height, -downwards / box.height);
      else scene.turn((3 * right) / box.height, (3 * downwards) / box.height);
      down.current = { ...from, x, y, isStill: false };
    },
    onPointerUp: (event: PointerEvent) => {
      const from = down.current;
      down.current = undefined;
      if (from?.isStill && scene) onChoose(scene.at(from.x, from.y));
      (event.currentTarget as Element).releasePointerCapture(event.pointerId);
    },
    onPointerCancel: () => (down.current = undefined),
  };
}

export function ShapeCanvas({ surfaces, colourOf, exploded, mark, cut, overlays, label, onChoose }: CanvasProps) {
  const element = useRef<HTMLCanvasElement>(null);
  const [scene, stage] = useScene(element);
  const pointer = usePointer(scene, onChoose);
  useEffect(() => {
    if (!scene) return;
    const canvas = element.current!;
    const wheel = (event: WheelEvent) => {
      event.preventDefault();
      scene.zoom(Math.exp(-event.deltaY / 500));
    };
    canvas.addEventListener('wheel', wheel, { passive: false });
    return () => canvas.removeEventListener('wheel', wheel);
  }, [scene]);
  useEffect(() => {
    scene?.show(surfaces);
    scene?.colour(colourOf);
  }, [scene, surfaces, colourOf]);
  useEffect(() => scene?.lay(overlays), [scene, overlays]);
  useEffect(() => scene?.cut(cut), [scene, cut]);
  useEffect(() => scene?.explode(exploded), [scene, exploded]);
  useEffect(() => scene?.markAt(mark), [scene, mark]);
  const key = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !scene) return;
    const step = (event.shiftKey && shiftedSteps[event.key]) || keySteps[event.key];
    if (!step) return;
    event.preventDefault();
    step(scene);
  };
  const isDrawn = stage === 'drawn';
  return (
    <>
      {!isDrawn && (stage === 'loading' ? <Waiting what={stageWords.loading} /> : (
        <div class="callout" role="alert">{stageWords[stage]}</div>
      ))}
      <canvas
        ref={element}
        class="shape"
        hidden={!isDrawn}
        tabIndex={0}
        role="application"
        aria-label={label}
        {...pointer}
        onContextMenu={(event) => event.preventDefault()}
        onKeyDown={key}
      />
      {isDrawn && (
        <div class="row">
          {buttons.map(([words, step]) => (
            <button key={words} type="button" class="button" onClick={() => scene && step(scene)}>
              {words}
            </button>
          ))}
        </div>
      )}
    </>
  );
}
