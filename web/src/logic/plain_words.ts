// The keys of the figures of a job, in plain words (docs/glossary.md), with their form.

import { bytes, duration, figure, whole } from './format';

export interface Figure {
  key: string;
  words: string;
  text: string;
}

type Form = (value: unknown) => string;
const degrees: Form = (value) => `${figure(value)}°`;

const quality: [string, string, Form][] = [
  ['elements', 'elements', whole],
  ['nodes', 'nodes', whole],
  ['boundary_triangles', 'boundary triangles', whole],
  ['prisms', 'prisms', whole],
  ['pyramids', 'pyramids', whole],
  ['volume', 'volume', figure],
  ['min_dihedral_deg', 'smallest dihedral angle', degrees],
  ['max_dihedral_deg', 'largest dihedral angle', degrees],
  ['forced_dihedral_deg', 'smallest forced angle', degrees],
  ['mean_radius_ratio', 'mean radius ratio', figure],
  ['smallest_height', 'smallest height', figure],
  ['digest', 'digest', String],
];

const forecast: [string, string, Form][] = [
  ['expected_task_bytes', 'memory expected of the largest task', bytes],
  ['expected_disk_bytes', 'room expected on the disk', bytes],
  ['expected_cpu_seconds', 'CPU time expected', duration],
];

const balance: [string, string, Form][] = [
  ['estimated', 'estimated elements, max / mean', figure],
  ['elements', 'elements, max / mean', figure],
  ['faces', 'boundary faces of the groups, max / mean', figure],
  ['leaves', 'leaves before they were joined', whole],
  ['leaves_estimated', 'their estimated elements, max / mean', figure],
  ['leaves_faces', 'their boundary faces, max / mean', figure],
  ['communication_nodes_max', 'communication nodes, the most', whole],
  ['communication_nodes_sum', 'communication nodes, all', whole],
];

function figuresOf(from: unknown, table: [string, string, Form][]): Figure[] {
  if (typeof from !== 'object' || from === null) return [];
  const values = from as Record<string, unknown>;
  return table
    .filter(([key]) => Object.hasOwn(values, key) && !isUntold(values[key]))
    .map(([key, words, form]) => ({ key, words, text: form(values[key]) }));
}

function isUntold(value: unknown): boolean {
  return value === null || value === undefined || value === '' || value === 0;
}

export const qualityFigures = (job: unknown): Figure[] => figuresOf(job, quality);
export const forecastFigures = (job: unknown): Figure[] => figuresOf(job, forecast);
export const balanceFigures = (job: unknown): Figure[] => figuresOf(job, balance);

