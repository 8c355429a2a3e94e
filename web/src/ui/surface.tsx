// A canvas that is as wide as its place and sharp on every screen. It draws when asked, at most once
// a frame, and again when its size or the theme changes.

import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { onTheme } from './theme';

export interface Drawing {
  context: CanvasRenderingContext2D;
  width: number;
  height: number;
}

export interface SurfaceProps {
  label: string;
  height: number;
  draw: (drawing: Drawing) => void;
  onSize: (width: number) => void;
  onMove?: (x: number, y: number, event: PointerEvent) => void;
  onLeave?: () => void;
  onDown?: (x: number, y: number, event: PointerEvent) => void;
  onUp?: (x: number, y: number, event: PointerEvent) => void;
  onWheel?: (x: number, event: WheelEvent) => void;
  onKey?: (event: KeyboardEvent) => void;
  cursor?: string;
}

function drawOn(canvas: HTMLCanvasElement, height: number, draw: (drawing: Drawing) => void): void {
  const width = canvas.clientWidth;
  const ratio = window.devicePixelRatio || 1;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w) canvas.width = w;
  if (canvas.height !== h) canvas.height = h;
  const context = canvas.getContext('2d');
  if (!context || width === 0) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  const begin = performance.now();
  draw({ context, width, height });
  canvas.dataset.drawMs = (performance.now() - begin).toFixed(1);
}

export function Surface(props: SurfaceProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const frame = useRef(0);
  const latest = useRef(props);
  latest.current = props;
  const redraw = () => {
    if (frame.current) return;
    frame.current = requestAnimationFrame(() => {
      frame.current = 0;
      if (canvas.current) drawOn(canvas.current, latest.current.height, latest.current.draw);
    });
  };
  useLayoutEffect(redraw);
  useEffect(() => {
    const element = canvas.current!;
    const sizes = new ResizeObserver(() => {
      latest.current.onSize(element.clientWidth);
      redraw();
    });
    sizes.observe(element);
    const wheel = (event: WheelEvent) => {
      latest.current.onWheel?.(event.clientX - element.getBoundingClientRect().left, event);
    };
    element.addEventListener('wheel', wheel, { passive: false });
    const forget = onTheme(redraw);
    return () => {
      sizes.disconnect();
      element.removeEventListener('wheel', wheel);
      forget();
      cancelAnimationFrame(frame.current);
      frame.current = 0;
    };
  }, []);
  const at = (event: PointerEvent, then?: (x: number, y: number, event: PointerEvent) => void) => {
    const box = canvas.current!.getBoundingClientRect();
    then?.(event.clientX - box.left, event.clientY - box.top, event);
  };
  return (
    <canvas
      ref={canvas}
      class="surface"
      tabIndex={0}
      role="application"
      aria-label={props.label}
      style={{ height: `${props.height}px`, cursor: props.cursor ?? 'default' }}
      onPointerMove={(event) => at(event, props.onMove)}
      onPointerLeave={() => props.onLeave?.()}
      onPointerDown={(event) => at(event, props.onDown)}
      onPointerUp={(event) => at(event, props.onUp)}
      onKeyDown={(event) => props.onKey?.(event)}
    />
  );
}
