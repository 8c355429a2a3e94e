// Draws surfaces of sub-domains with WebGL (three.js), when something has changed and not otherwise.
// A chunk of its own, so that the other pages do without three.js.

import {
  AmbientLight, BackSide, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, FrontSide, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshBasicMaterial, MeshLambertMaterial, OctahedronGeometry, PerspectiveCamera, Plane, Raycaster, Scene, Spherical, Vector2, Vector3,
  WebGLRenderer, WireframeGeometry,
} from 'three';
import type { Cut } from '../logic/section';
import { axes, isKept, sectionOf } from '../logic/section';
import type { Box, ShownSurface } from '../logic/shown_surface';
import { addBox, boxOf, centreOf, diagonalOf, emptyBox, explodedBy, isInBox } from '../logic/shown_surface';
import type { Rgb } from '../logic/surface_colours';

export type ColourOf = (path: number, piece: number) => Rgb;

/** Triangles that are drawn beside the sub-domains. */
export interface Overlay {
  surface: ShownSurface;
  colourOf: (piece: number) => Rgb;
  isOnTop: boolean; // seen through whatever lies before it
}

interface Part {
  surface: ShownSurface;
  box: Box;
  centre: [number, number, number];
  mesh: Mesh<BufferGeometry, MeshLambertMaterial>;
  /** Its inner side where it is cut open: neighbours have the same triangles, and the one whose inside is seen is nearer. */
  inside: Mesh<BufferGeometry, MeshLambertMaterial>;
  /** Of triangles that may be too small or too flat to be seen. */
  outline: LineSegments<BufferGeometry, LineBasicMaterial> | undefined;
  section: LineSegments<BufferGeometry, LineBasicMaterial>;
  sectionBy: Cut | undefined; // the cut that the lines are of
  painted: string; // in which colours its pieces are
}

const fieldOfView = 40; // degrees
const quickest = 0.02;
const farthest = 20; // in diagonals

/** Three corners of its own for each triangle, so that each has its colour. */
function geometryOf(surface: ShownSurface): BufferGeometry {
  const { vertices, triangles } = surface;
  const places = new Float32Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; ++corner) {
    const vertex = 3 * triangles[corner]!;
    for (let axis = 0; axis < 3; ++axis) places[3 * corner + axis] = vertices[vertex + axis]!;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setAttribute('color', new BufferAttribute(new Uint8Array(places.length), 3, true));
  geometry.computeBoundingSphere();
  return geometry;
}

/** As three.js wants it: linear, in bytes. */
function linear([r, g, b]: Rgb): Rgb {
  const made = new Color().setRGB(r / 255, g / 255, b / 255, 'srgb');
  return [Math.round(255 * made.r), Math.round(255 * made.g), Math.round(255 * made.b)];
}

function paint(part: Part, colourOf: (piece: number) => Rgb): void {
  const { pieces, kinds } = part.surface;
  const kind2colour = new Map(kinds.map((kind) => [kind, linear(colourOf(kind))]));
  const painted = JSON.stringify([...kind2colour.values()]);
  if (painted === part.painted) return;
  part.painted = painted;
  const attribute = part.mesh.geometry.getAttribute('color') as BufferAttribute;
  const values = attribute.array as Uint8Array;
  for (let triangle = 0; triangle < pieces.length; ++triangle) {
    const colour = kind2colour.get(pieces[triangle]!)!;
    for (let corner = 0; corner < 3; ++corner) values.set(colour, 9 * triangle + 3 * corner);
  }
  attribute.needsUpdate = true;
}

/** After all that is not, and through whatever lies before it. */
const onTop = { depthTest: false, transparent: true, forceSinglePass: true };

/** Than the inside of a part, which is farther than the lines of its section. */
const farther = { polygonOffsetFactor: 2, polygonOffsetUnits: 8 };

function partOf(surface: ShownSurface, isOnTop = false): Part {
  const look = { vertexColors: true, flatShading: true };
  const mesh = new Mesh(geometryOf(surface), new MeshLambertMaterial({ ...look, ...farther, ...(isOnTop ? onTop : {}) }));
  const inside = new Mesh(
    mesh.geometry,
    new MeshLambertMaterial({ ...look, side: BackSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 4 }),
  );
  mesh.add(inside);
  const outline = isOnTop ? new LineSegments(new WireframeGeometry(mesh.geometry), new LineBasicMaterial(onTop)) : undefined;
  if (outline) mesh.add(outline);
  const section = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  section.visible = false;
  const box = boxOf(surface);
  return { surface, box, centre: centreOf(box), mesh, inside, outline, section, sectionBy: undefined, painted: '' };
}

function disposeOf(part: Part): void {
  for (const drawn of [part.mesh, part.inside, part.outline, part.section]) {
    drawn?.geometry.dispose();
    drawn?.material.dispose();
  }
}

/** What is cut open shows its inside. */
function setClipping({ mesh, inside, outline }: Part, plane: Plane | undefined): void {
  const planes = plane ? [plane] : null;
  const isOnTop = outline !== undefined;
  mesh.material.side = plane && !isOnTop ? FrontSide : DoubleSide;
  mesh.material.polygonOffset = mesh.material.side === FrontSide;
  inside.visible = plane !== undefined && !isOnTop;
  for (const drawn of [mesh, inside, outline]) if (drawn) drawn.material.clippingPlanes = planes;
}

/** Whether the plane goes through a box: elsewhere there are no lines. */
function isThrough({ axis, at }: Cut, box: Box): boolean {
  const i = axes.indexOf(axis);
  return box.low[i]! <= at && box.high[i]! >= at;
}

/** The lines where the plane goes through the part. */
function setSection(part: Part, cut: Cut | undefined): void {
  part.section.visible = cut !== undefined && isThrough(cut, part.box);
  if (!cut || !part.section.visible || part.sectionBy === cut) return;
  part.sectionBy = cut;
  part.section.geometry.dispose();
  part.section.geometry = new BufferGeometry();
  part.section.geometry.setAttribute('position', new BufferAttribute(sectionOf(part.surface, cut), 3));
}

/** Through whatever lies before it, black in white, so that it is seen on every colour. */
function markThatIsSeen(): Group {
  const group = new Group();
  [[1.5, 0xffffff], [1, 0x000000]].forEach(([size, colour], order) => {
    const material = new MeshBasicMaterial({ color: colour!, depthTest: false, transparent: true });
    const mesh = new Mesh(new OctahedronGeometry(size!), material);
    mesh.renderOrder = 1 + order;
    group.add(mesh);
  });
  group.visible = false;
  return group;
}

export class ShapeScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(fieldOfView, 1, 1, 10);
  private readonly lamp = new DirectionalLight(0xffffff, 2.2);
  private readonly parts = new Map<number, Part>();
  private overlays: { part: Part; overlay: Overlay }[] = [];
  private cutBy: Cut | undefined;
  private readonly ink = new Color(0x000000);
  private readonly place = new Spherical(1.7, 1.1, 0.7); // radius in diagonals
  private readonly aim = new Vector3(); // from the centre of all, in diagonals
  private readonly mark = markThatIsSeen();
  private marked: readonly number[] | undefined;
  private box = emptyBox();
  private share = 0;
  private frame = 0;
  private width = 1;
  private height = 1;

  /** @param context of a canvas that nothing was drawn on yet */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    context: WebGL2RenderingContext,
  ) {
    this.renderer = new WebGLRenderer({ canvas, context, antialias: true });
    this.renderer.localClippingEnabled = true;
    this.scene.add(new AmbientLight(0xffffff, 1.1), this.camera, this.mark);
    this.camera.add(this.lamp);
    this.lamp.position.set(0.4, 0.8, 1);
  }

  size(width: number, height: number): void {
    [this.width, this.height] = [Math.max(1, width), Math.max(1, height)];
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setSize(this.width, this.height, false);
    this.draw();
  }

  /** Exactly these from now on; what is here already stays. */
  show(surfaces: ReadonlyMap<number, ShownSurface>): void {
    for (const [path, part] of this.parts) if (surfaces.get(path) !== part.surface) this.remove(path, part);
    for (const [path, surface] of surfaces) if (!this.parts.has(path)) this.add(path, surface);
    this.measure();
  }

  /** Beside the sub-domains, exactly these from now on. */
  lay(overlays: readonly Overlay[]): void {
    for (const { part } of this.overlays) this.takeOut(part);
    this.overlays = overlays.map((overlay) => {
      const part = partOf(overlay.surface, overlay.isOnTop);
      paint(part, overlay.colourOf);
      this.scene.add(part.mesh, part.section);
      return { part, overlay };
    });
    this.measure();
  }

  colour(colourOf: ColourOf): void {
    for (const [path, part] of this.parts) paint(part, (piece) => colourOf(path, piece));
    this.draw();
  }

  /** Leaves out what lies on one side of a plane; where the plane goes through the boundaries, there are lines. */
  cut(by: Cut | undefined): void {
    this.cutBy = by;
    this.draw();
  }

  explode(share: number): void {
    this.share = share;
    this.draw();
  }

  /** Marks a place of the mesh; it moves with the sub-domain that it is in. */
  markAt(place: readonly number[] | undefined): void {
    this.marked = place;
    this.draw();
  }

  /** The background, and the lines of a section. */
  background(colour: string, ink: string): void {
    this.scene.background = new Color(colour);
    this.ink.set(ink);
    this.draw();
  }

  turn(right: number, up: number): void {
    this.place.theta -= right;
    this.place.phi = Math.min(Math.PI - 0.05, Math.max(0.05, this.place.phi - up));
    this.draw();
  }

  /** Moves what is seen, by parts of the canvas. */
  move(right: number, up: number): void {
    const step = 2 * this.place.radius * Math.tan((fieldOfView * Math.PI) / 360);
    const across = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const upwards = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    this.aim.addScaledVector(across, -right * step).addScaledVector(upwards, -up * step);
    this.draw();
  }

  zoom(factor: number): void {
    this.place.radius = Math.min(farthest, Math.max(quickest, this.place.radius / factor));
    this.draw();
  }

  fit(): void {
    this.place.set(1.7 * (1 + this.share), 1.1, 0.7);
    this.aim.set(0, 0, 0);
    this.draw();
  }

  /** The sub-domain at a point of the canvas. */
  at(x: number, y: number): number | undefined {
    const point = new Vector2((2 * x) / this.width - 1, 1 - (2 * y) / this.height);
    const ray = new Raycaster();
    this.arrange();
    this.scene.updateMatrixWorld();
    ray.setFromCamera(point, this.camera);
    const mesh2part = new Map([...this.parts].map(([path, part]) => [part.mesh as unknown, { path, part }]));
    for (const hit of ray.intersectObjects([...this.parts.values()].map(({ mesh }) => mesh), false)) {
      const { path, part } = mesh2part.get(hit.object)!;
      const place = part.mesh.worldToLocal(hit.point).toArray().map((value, axis) => value + part.surface.origin[axis]!);
      if (!this.cutBy || isKept(this.cutBy, place)) return path;
    }
    return undefined;
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    for (const [path, part] of this.parts) this.remove(path, part);
    for (const { part } of this.overlays) this.takeOut(part);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private add(path: number, surface: ShownSurface): void {
    const part = partOf(surface);
    this.parts.set(path, part);
    this.scene.add(part.mesh, part.section);
  }

  private remove(path: number, part: Part): void {
    this.takeOut(part);
    this.parts.delete(path);
  }

  private takeOut(part: Part): void {
    this.scene.remove(part.mesh, part.section);
    disposeOf(part);
  }

  private measure(): void {
    this.box = emptyBox();
    for (const part of this.parts.values()) addBox(this.box, part.box);
    for (const { part } of this.overlays) addBox(this.box, part.box);
    this.draw();
  }

  /** The sub-domain that a place is in, as far as boxes tell: the smallest of them. */
  private holderOf(place: readonly number[] | undefined, size: number): Part | undefined {
    if (!place) return undefined;
    const around = [...this.parts.values()].filter(({ box }) => isInBox(box, place, 0.01 * size));
    return around.sort((a, b) => diagonalOf(a.box) - diagonalOf(b.box))[0];
  }

  /** Everything in diagonals of what is drawn, about its centre: numbers of 32 bits suffice so. */
  private arrange(): void {
    const size = diagonalOf(this.box) || 1;
    const ofAll = this.parts.size + this.overlays.length > 0 ? centreOf(this.box) : [0, 0, 0];
    const placed = (place: readonly number[], centre: readonly number[]) => {
      const moved = explodedBy(centre, ofAll, this.share);
      const [x, y, z] = [0, 1, 2].map((axis) => (place[axis]! - ofAll[axis]! + moved[axis]!) / size);
      return new Vector3(x!, z!, -y!); // z of the mesh upwards
    };
    const arranged = (part: Part, centre: readonly number[]) => {
      setSection(part, this.cutBy);
      for (const drawn of [part.mesh, part.section]) {
        drawn.position.copy(placed(part.surface.origin, centre));
        drawn.rotation.x = -Math.PI / 2;
        drawn.scale.setScalar(1 / size);
      }
      for (const lines of [part.section, part.outline]) if (lines) lines.material.color = this.ink;
      setClipping(part, this.cutBy && this.planeOf(this.cutBy, placed, centre));
    };
    for (const part of this.parts.values()) arranged(part, part.centre);
    for (const { part } of this.overlays) arranged(part, this.holderOf(part.centre, size)?.centre ?? ofAll);
    const holder = this.holderOf(this.marked, size);
    this.mark.visible = holder !== undefined;
    if (holder) this.mark.position.copy(placed(this.marked!, holder.centre));
    this.mark.scale.setScalar(0.012 * this.place.radius);
    this.camera.aspect = this.width / this.height;
    this.camera.near = this.place.radius / 100;
    this.camera.far = this.place.radius + 4 + 4 * this.share;
    this.camera.position.setFromSpherical(this.place).add(this.aim);
    this.camera.lookAt(this.aim);
    this.camera.updateProjectionMatrix();
  }

  /** In the space that is drawn, moved as the part with that centre is. */
  private planeOf(cut: Cut, placed: (place: readonly number[], centre: readonly number[]) => Vector3, centre: readonly number[]): Plane {
    const i = axes.indexOf(cut.axis);
    const [x, y, z] = [0, 1, 2].map((axis) => (axis === i ? (cut.keepsAbove ? 1 : -1) : 0));
    const through = centre.map((value, axis) => (axis === i ? cut.at : value));
    return new Plane().setFromNormalAndCoplanarPoint(new Vector3(x!, z!, -y!), placed(through, centre));
  }

  private draw(): void {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      const begin = performance.now();
      this.arrange();
      this.renderer.render(this.scene, this.camera);
      const { triangles, lines } = this.renderer.info.render;
      this.canvas.dataset.lines = String(lines);
      this.canvas.dataset.marks = this.mark.visible ? '1' : '0';
      this.canvas.dataset.parts = String(this.parts.size);
      this.canvas.dataset.overlays = String(this.overlays.length);
      this.canvas.dataset.triangles = String(triangles);
      this.canvas.dataset.drawMs = (performance.now() - begin).toFixed(1);
    });
  }
}
