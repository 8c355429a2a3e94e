// Surfaces of sub-domains of the made-up farm, and its maps: the unit cube, halved along x, y and z in turn as the
// tree says. The form is that of docs/api.md.

function bytesOf({ origin, vertices, triangles, pieces, whole = pieces.length }) {
  const bytes = Buffer.alloc(48 + 4 * (vertices.length + triangles.length + pieces.length));
  bytes.write('TFSHOWN\n', 0, 'latin1');
  [1, vertices.length / 3, pieces.length, whole].forEach((value, i) => bytes.writeUInt32LE(value, 8 + 4 * i));
  origin.forEach((value, i) => bytes.writeDoubleLE(value, 24 + 8 * i));
  let at = 48;
  for (const value of vertices) at = bytes.writeFloatLE(value, at);
  for (const value of triangles) at = bytes.writeUInt32LE(value, at);
  for (const value of pieces) at = bytes.writeInt32LE(value, at);
  return bytes;
}

/** The part of the cube that a sub-domain is. */
function boxOf(path) {
  const box = { low: [0, 0, 0], high: [1, 1, 1] };
  const ways = path.toString(2).slice(1);
  [...ways].forEach((way, level) => {
    const axis = level % 3;
    const middle = (box.low[axis] + box.high[axis]) / 2;
    if (way === '0') box.high[axis] = middle;
    else box.low[axis] = middle;
  });
  return box;
}

/** Two triangles for each face; a face of the cube is a patch, the others are cuts. */
export function surfaceOf(path) {
  const { low, high } = boxOf(path);
  const origin = low.map((value, axis) => (value + high[axis]) / 2);
  const vertices = [];
  for (let i = 0; i < 8; ++i) {
    for (let axis = 0; axis < 3; ++axis) vertices.push(((i >> axis) & 1 ? high[axis] : low[axis]) - origin[axis]);
  }
  const triangles = [];
  const pieces = [];
  for (let axis = 0; axis < 3; ++axis) {
    const [u, v] = [1 << (axis + 1) % 3, 1 << (axis + 2) % 3];
    for (const side of [0, 1]) {
      const at = side << axis;
      const corners = [at, at + u, at + u + v, at + v];
      if (side === 0) corners.reverse(); // seen from outside they go anticlockwise
      const [a, b, c, d] = corners;
      triangles.push(a, b, c, a, c, d);
      const isOfCube = side ? high[axis] === 1 : low[axis] === 0;
      const piece = isOfCube ? axis : -1;
      pieces.push(piece, piece);
    }
  }
  return bytesOf({ origin, vertices, triangles, pieces, whole: 4000 });
}

export const patches = ['wall', '<script>window.hacked=1</script>', 'far\u202Efield'];

export const meaningsOfDefects = ['open edge', '<b>self-intersection</b>'];

/** Two triangles with defects, each in a corner of the cube's top. */
function defects() {
  const vertices = [];
  for (const [x, y] of [[0.1, 0.1], [0.6, 0.6]]) vertices.push(x, y, 1, x + 0.3, y, 1, x, y + 0.3, 1);
  return bytesOf({ origin: [0, 0, 0], vertices, triangles: [0, 1, 2, 3, 4, 5], pieces: [0, 1] });
}

/** The floor of the cube in strips, on which 0, 1, 2, … layers stand. */
function layers(most = 20) {
  const vertices = [];
  const triangles = [];
  const pieces = [];
  for (let i = 0; i <= most + 1; ++i) vertices.push(i / (most + 1), 0, 0, i / (most + 1), 1, 0);
  for (let i = 0; i <= most; ++i) {
    triangles.push(2 * i, 2 * i + 2, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 1);
    pieces.push(i, i);
  }
  return bytesOf({ origin: [0, 0, 0], vertices, triangles, pieces });
}

export const mapOf = { defects, layers };
