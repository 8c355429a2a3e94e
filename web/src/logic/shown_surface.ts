// The boundary of a sub-domain as the server sends it (docs/api.md, "Surfaces"): a head of 48 bytes,
// vertices, triangles, and what each triangle is a piece of. What is malformed is refused as a whole.

export interface ShownSurface {
  vertices: Float32Array; // three for each, seen from the origin
  triangles: Uint32Array; // three for each
  pieces: Int32Array; // a patch by its number, or one of those below
  kinds: readonly number[]; // the pieces that there are, each once
  wholeTriangles: number; // before the server made them fewer
  origin: [number, number, number];
}

export const pieceOfCut = -1;
export const pieceOfLayers = -2;
export const pieceUnknown = -3;

const magic = 'TFSHOWN\n';
const headBytes = 48;
/** What the server gives at most. */
export const mostTriangles = 131_072;

function refuse(why: string): never {
  throw new Error(`the surface cannot be read: it ${why}`);
}

function hasOnlyKnownVertices(triangles: Uint32Array, vertices: number): boolean {
  for (let i = 0; i < triangles.length; ++i) if (triangles[i]! >= vertices) return false;
  return true;
}

/** @throws Error. */
export function parseShownSurface(bytes: ArrayBuffer): ShownSurface {
  if (bytes.byteLength < headBytes) refuse('is cut short');
  const head = new DataView(bytes);
  for (let i = 0; i < magic.length; ++i) {
    if (head.getUint8(i) !== magic.charCodeAt(i)) refuse('is something else');
  }
  if (head.getUint32(8, true) !== 1) refuse('is of another version');
  const vertexCount = head.getUint32(12, true);
  const triangleCount = head.getUint32(16, true);
  if (triangleCount > mostTriangles || vertexCount > 3 * triangleCount) refuse('has too much in it');
  if (bytes.byteLength !== headBytes + 12 * vertexCount + 16 * triangleCount) refuse('has another size');
  const origin: [number, number, number] = [24, 32, 40].map((at) => head.getFloat64(at, true)) as [number, number, number];
  const vertices = new Float32Array(bytes, headBytes, 3 * vertexCount);
  const triangles = new Uint32Array(bytes, headBytes + vertices.byteLength, 3 * triangleCount);
  const pieces = new Int32Array(bytes, headBytes + vertices.byteLength + triangles.byteLength, triangleCount);
  if (!origin.every(Number.isFinite) || !vertices.every(Number.isFinite)) refuse('has a place that is none');
  if (!hasOnlyKnownVertices(triangles, vertexCount)) refuse('has a corner that is none');
  return { vertices, triangles, pieces, kinds: [...new Set(pieces)], wholeTriangles: head.getUint32(20, true), origin };
}

export interface Box {
  low: [number, number, number];
  high: [number, number, number];
}

export const emptyBox = (): Box => ({ low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] });

export function addBox(box: Box, other: Box): void {
  for (let axis = 0; axis < 3; ++axis) {
    box.low[axis] = Math.min(box.low[axis]!, other.low[axis]!);
    box.high[axis] = Math.max(box.high[axis]!, other.high[axis]!);
  }
}

export function boxOf(surface: ShownSurface): Box {
  const box = emptyBox();
  for (let i = 0; i < surface.vertices.length; ++i) {
    const value = surface.origin[i % 3]! + surface.vertices[i]!;
    box.low[i % 3] = Math.min(box.low[i % 3]!, value);
    box.high[i % 3] = Math.max(box.high[i % 3]!, value);
  }
  return box;
}

export function centreOf(box: Box): [number, number, number] {
  return [0, 1, 2].map((axis) => (box.low[axis]! + box.high[axis]!) / 2) as [number, number, number];
}

export function diagonalOf(box: Box): number {
  const length = Math.hypot(...[0, 1, 2].map((axis) => box.high[axis]! - box.low[axis]!));
  return Number.isFinite(length) ? length : 0;
}

export function isInBox(box: Box, place: readonly number[], slack = 0): boolean {
  return [0, 1, 2].every((axis) => place[axis]! >= box.low[axis]! - slack && place[axis]! <= box.high[axis]! + slack);
}

/** How far a sub-domain is moved from where it is: away from the centre of all, `share` of its way
 * from there. */
export function explodedBy(
  centre: readonly number[],
  ofAll: readonly number[],
  share: number,
): [number, number, number] {
  return [0, 1, 2].map((axis) => share * (centre[axis]! - ofAll[axis]!)) as [number, number, number];
}

/** Triangles to ask for of each of so many sub-domains, so that a slow computer draws them all: a
 * power of two. */
export function trianglesForEach(count: number, budget = 300_000): number {
  const fair = Math.log2(budget / Math.max(1, count));
  return 2 ** Math.min(15, Math.max(8, Math.floor(fair)));
}
