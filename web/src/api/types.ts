// The objects of /api/v1. They have the keys of the command line's --json (json/*.cpp); each key
// may be missing in what an older or newer program sends, so pages show a dash for it.

export interface Api {
  version: number;
  program_version: string;
  acts: boolean;
}

export interface Demand {
  memory_bytes: number;
  tasks: number;
  of_solvers?: boolean;
}

export interface Farm {
  connected: boolean;
  trouble?: string;
  at_rest?: boolean;
  endpoint?: string;
  time_ms?: number;
  workers?: number;
  jobs?: number;
  security?: string;
  connections?: number;
  authorized_keys?: number;
  refused?: Record<string, number>;
  program_version?: string;
  demand?: Demand[];
}

export interface JobLine {
  job: string;
  name: string;
  state: string;
  stage: string;
  priority?: number;
  after?: string[];
  waits_for?: string[];
  share?: number;
  subdomains: number;
  subdomains_meshed: number;
  elements: number;
  estimated_elements: number;
  tasks_done: number;
  tasks_ready: number;
  tasks_running: number;
  tasks_in_quarantine?: number;
  created_ms?: number;
  finished_ms?: number;
  seconds: number;
  message: string;
  exit_code: number;
  eta_seconds?: number | null;
}

export interface RunningTask {
  task: number;
  kind: string;
  path: number;
  attempt: number;
  seconds: number;
  doing: string;
  share: number;
}

export interface QuarantinedTask {
  task: number;
  kind: string;
  path: number;
  reason: string;
  exit_code: number;
}

export interface Gate {
  key: string;
  limit_deg: number;
  smallest_deg: number;
  passed: boolean;
}

export interface Job extends JobLine {
  tasks?: { done: number; total: number; running: number; waiting: number; failed: number };
  workers?: number;
  attempts_lost: number;
  crashes: number;
  out_of_memory: number;
  peak_rss_bytes_worker: number;
  quarantine?: QuarantinedTask[];
  running?: RunningTask[];
  balance?: Record<string, number>;
  cut_further?: Record<string, string>;
  result?: Record<string, unknown>;
  files?: unknown[];
}

export interface Doing {
  doing?: string;
  doing_stage?: string;
  share?: number;
}

export interface Attempt {
  attempt: number;
  job: string;
  task: number;
  kind: string;
  path: number;
  worker: string;
  host: string;
  process: number;
  state: string;
  races: boolean;
  started_ms: number;
  ended_ms: number;
  seconds: number;
  memory_bytes: number;
  peak_rss_bytes: number;
  message: string;
  log?: string;
}

export interface TaskInput {
  name: string;
  hash: string;
  size: number;
  is_there: boolean;
  made_by_task: number;
}

export interface Explanation extends Doing {
  task: number;
  job: string;
  kind: string;
  path: number;
  state: string;
  attempt: number;
  worker: string;
  host: string;
  errors: number;
  losses: number;
  out_of_memory: number;
  seconds: number;
  peak_rss_bytes: number;
  memory_bytes: number;
  expected_seconds: number;
  cpu_seconds: number;
  expected_bytes: number;
  expected_elements: number;
  elements: number;
  exit_code: number;
  message: string;
  subdomain: string;
  reasons: string[];
  limit_seconds: number;
  room_bytes: number;
  attempts: Attempt[];
  inputs: TaskInput[];
}

export interface Worker {
  worker: string;
  host: string;
  process: number;
  state: string;
  task: number;
  cores: number;
  memory_bytes: number;
  version: string;
  since_ms: number;
  attempts_done: number;
  attempts_not_done: number;
  busy_seconds: number;
  host_in_quarantine: boolean;
  doing?: string;
}

export interface FarmEvent {
  event: number;
  wall_ms: number;
  job: string;
  task: number;
  attempt: number;
  worker: string;
  what: string;
  message: string;
}

/** A file of a job that marks triangles. */
export interface MapLine {
  map: number;
  file: string;
  of: string; // 'defects' or 'layers'
  meanings: string[]; // of the numbers of defects
  hash: string;
  bytes: number;
  is_there: boolean;
}

export interface MapList {
  sees_files: boolean;
  maps: MapLine[];
}

export interface SurfaceLine {
  path: number;
  place: string;
  state: string;
  meshed: boolean;
  hash: string;
  bytes: number;
  is_there: boolean;
}

/** The sub-domains that can be drawn. */
export interface SurfaceList {
  sees_files: boolean;
  patches: string[];
  left_out: number;
  surfaces: SurfaceLine[];
}
