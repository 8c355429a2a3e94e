// Surfaces of sub-domains of the made-up farm: the unit cube, halved along x, y and z in turn as the
// tree says. The form is that of docs/api.md.

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
      triangles.push(at, at + u, at + u + v, at, at + u + v, at + v);
      const isOfCube = side ? high[axis] === 1 : low[axis] === 0;
      const piece = isOfCube ? axis : -1;
      pieces.push(piece, piece);
    }
  }
  const bytes = Buffer.alloc(48 + 4 * (vertices.length + triangles.length + pieces.length));
  bytes.write('TFSHOWN\n', 0, 'latin1');
  [1, 8, 12, 4000].forEach((value, i) => bytes.writeUInt32LE(value, 8 + 4 * i));
  origin.forEach((value, i) => bytes.writeDoubleLE(value, 24 + 8 * i));
  let at = 48;
  for (const value of vertices) at = bytes.writeFloatLE(value, at);
  for (const value of triangles) at = bytes.writeUInt32LE(value, at);
  for (const value of pieces) at = bytes.writeInt32LE(value, at);
  return bytes;
}

export const patches = ['wall', '<script>window.hacked=1</script>', 'far\u202Efield'];
