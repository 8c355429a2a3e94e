// Patterns of canvases, so that a state is told by more than its colour: stripes for what failed,
// dots for what waits.

const size = 6;
const known = new Map<string, CanvasPattern>();

export type Pattern = 'stripes' | 'cross' | 'dots';

function drawn(pattern: Pattern, ink: string): HTMLCanvasElement {
  const tile = document.createElement('canvas');
  tile.width = size;
  tile.height = size;
  const context = tile.getContext('2d')!;
  context.strokeStyle = ink;
  context.fillStyle = ink;
  context.lineWidth = 1.4;
  context.beginPath();
  if (pattern === 'dots') {
    context.arc(size / 2, size / 2, 0.9, 0, 2 * Math.PI);
    context.fill();
    return tile;
  }
  for (const shift of [-size, 0, size]) {
    context.moveTo(shift - 1, size + 1);
    context.lineTo(shift + size + 1, -1);
    if (pattern === 'stripes') continue;
    context.moveTo(shift - 1, -1);
    context.lineTo(shift + size + 1, size + 1);
  }
  context.stroke();
  return tile;
}

export function patternOf(
  context: CanvasRenderingContext2D,
  pattern: Pattern,
  ink: string,
): CanvasPattern | string {
  const key = `${pattern} ${ink}`;
  let made = known.get(key);
  if (!made) {
    const created = context.createPattern(drawn(pattern, ink), 'repeat');
    if (!created) return 'transparent';
    made = created;
    known.set(key, made);
  }
  return made;
}
