// Draws surfaces of sub-domains with WebGL (three.js), when something has changed and not otherwise.
// A chunk of its own, so that the other pages do without three.js.

import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Group, Mesh,
  MeshBasicMaterial, MeshLambertMaterial, OctahedronGeometry, PerspectiveCamera, Raycaster, Scene, Spherical, Vector2, Vector3, WebGLRenderer,
} from 'three';
import type { Box, ShownSurface } from '../logic/shown_surface';
import { addBox, boxOf, centreOf, diagonalOf, emptyBox, explodedBy, isInBox } from '../logic/shown_surface';
import type { Rgb } from '../logic/surface_colours';

export type ColourOf = (path: number, piece: number) => Rgb;

interface Part {
  surface: ShownSurface;
  box: Box;
  centre: [number, number, number];
  mesh: Mesh<BufferGeometry, MeshLambertMaterial>;
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

function paint(part: Part, path: number, colourOf: ColourOf): void {
  const { pieces, kinds } = part.surface;
  const kind2colour = new Map(kinds.map((kind) => [kind, linear(colourOf(path, kind))]));
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
    this.box = emptyBox();
    for (const part of this.parts.values()) addBox(this.box, part.box);
    this.draw();
  }

  colour(colourOf: ColourOf): void {
    for (const [path, part] of this.parts) paint(part, path, colourOf);
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

  background(colour: string): void {
    this.scene.background = new Color(colour);
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
    const hit = ray.intersectObjects([...this.parts.values()].map(({ mesh }) => mesh), false)[0];
    if (!hit) return undefined;
    for (const [path, part] of this.parts) if (part.mesh === hit.object) return path;
    return undefined;
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    for (const [path, part] of this.parts) this.remove(path, part);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private add(path: number, surface: ShownSurface): void {
    const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, flatShading: true });
    const mesh = new Mesh(geometryOf(surface), material);
    const box = boxOf(surface);
    this.parts.set(path, { surface, box, centre: centreOf(box), mesh, painted: '' });
    this.scene.add(mesh);
  }

  private remove(path: number, part: Part): void {
    this.scene.remove(part.mesh);
    part.mesh.geometry.dispose();
    part.mesh.material.dispose();
    this.parts.delete(path);
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
    const ofAll = this.parts.size > 0 ? centreOf(this.box) : [0, 0, 0];
    const placed = (place: readonly number[], centre: readonly number[]) => {
      const moved = explodedBy(centre, ofAll, this.share);
      const [x, y, z] = [0, 1, 2].map((axis) => (place[axis]! - ofAll[axis]! + moved[axis]!) / size);
      return new Vector3(x!, z!, -y!); // z of the mesh upwards
    };
    for (const part of this.parts.values()) {
      part.mesh.position.copy(placed(part.surface.origin, part.centre));
      part.mesh.rotation.x = -Math.PI / 2;
      part.mesh.scale.setScalar(1 / size);
    }
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

  private draw(): void {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      const begin = performance.now();
      this.arrange();
      this.renderer.render(this.scene, this.camera);
      const { triangles } = this.renderer.info.render;
      this.canvas.dataset.marks = this.mark.visible ? '1' : '0';
      this.canvas.dataset.parts = String(this.parts.size);
      this.canvas.dataset.triangles = String(triangles);
      this.canvas.dataset.drawMs = (performance.now() - begin).toFixed(1);
    });
  }
}
