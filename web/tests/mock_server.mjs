// Stands in for `tetfarm dashboard` in tests: the built bundle with the real server's headers, and
// /api/v1 with generated data. Its farm can be told to stop answering, and it can itself go away.
// Run by itself it serves for trying things out: node tests/mock_server.mjs [PORT]

import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { makeFarm, pathText } from './mock_farm.mjs';
import { mapOf, meaningsOfDefects, patches, surfaceOf } from './mock_surfaces.mjs';

const headers = {
  'Content-Security-Policy':
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; " +
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
  'X-Content-Type-Options': 'nosniff',
  'Referrer-Policy': 'no-referrer',
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Resource-Policy': 'same-origin',
  'Cache-Control': 'no-store',
};
const types = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8', '.css': 'text/css; charset=utf-8', '.svg': 'image/svg+xml' };
const folder = process.env.TETFARM_WEB_OUT || fileURLToPath(new URL('../dist', import.meta.url));

const lineKeys = ['type', 'job', 'name', 'state', 'stage', 'priority', 'subdomains', 'subdomains_meshed', 'elements', 'estimated_elements', 'tasks_done',
  'tasks_ready', 'tasks_running', 'tasks_in_quarantine', 'created_ms', 'finished_ms', 'seconds', 'message', 'exit_code', 'share'];
const lineOf = (job) => Object.fromEntries(lineKeys.map((key) => [key, job[key]]));

class Fault extends Error {
  constructor(status, error, help) {
    super(error);
    this.status = status;
    this.help = help;
  }
}

export class MockServer {
  constructor({ acts = true, ...farm } = {}) {
    this.farm = makeFarm(farm);
    this.acts = acts;
    this.connected = true;
    this.atRest = false;
    this.trouble = '';
    this.seesFiles = true;
    this.goneFiles = new Set(); // paths of sub-domains whose files are not in the store
    this.watchers = new Set();
    this.requests = [];
  }

  async start(port = 0) {
    this.server = createServer((request, response) => this.answer(request, response));
    await new Promise((ready) => this.server.listen(port, '127.0.0.1', ready));
    this.port = this.server.address().port;
    this.timer = setInterval(() => {
      for (const watcher of this.watchers) watcher.write(': alive\n\n');
    }, 5000);
    return `http://127.0.0.1:${this.port}`;
  }

  async stop() {
    clearInterval(this.timer);
    const closed = new Promise((done) => this.server.close(done));
    this.server.closeAllConnections();
    this.watchers.clear();
    await closed;
  }

  farmLine() {
    return {
      connected: this.connected, trouble: this.trouble, at_rest: this.atRest, endpoint: 'tcp://127.0.0.1:7710', time_ms: this.farm.nowMs,
      type: 'farm', workers: this.farm.workers.length, jobs: this.farm.jobs.length, security: 'keys', connections: 21, authorized_keys: 4,
      refused: { unknown_key: 3, unreadable: 0, wrong_version: 1 },
      demand: [{ memory_bytes: 1.5 * 2 ** 30, tasks: 41, of_solvers: false }, { memory_bytes: 6 * 2 ** 30, tasks: 3, of_solvers: false }],
    };
  }

  say(event, data) {
    for (const watcher of this.watchers) watcher.write(`event: ${event}\ndata: ${JSON.stringify(data)}\n\n`);
  }

  setConnected(connected, trouble = connected ? '' : 'no answer for 5 s from tcp://127.0.0.1:7710') {
    this.connected = connected;
    this.trouble = trouble;
    this.say('farm', this.farmLine());
  }

  setAtRest(atRest) {
    this.atRest = atRest;
    this.connected = !atRest;
    this.say('farm', this.farmLine());
  }

  changeJob(id, change) {
    const job = this.jobOf(id).job;
    Object.assign(job, change);
    this.say('jobs', { jobs: [lineOf(job)] });
  }

  addEvent(event) {
    const line = { type: 'event', event: this.farm.events.length + 1, wall_ms: this.farm.nowMs, job: '', task: 0, attempt: 0, worker: '', what: '', message: '', ...event };
    this.farm.events.push(line);
    this.say('events', { events: [line] });
  }

  jobOf(id) {
    const found = this.farm.jobs.find(({ job }) => job.job === id);
    if (!found) throw new Fault(404, `there is no job ${id}`, '`tetfarm jobs` lists them');
    return found;
  }

  taskOf(number) {
    for (const made of this.farm.jobs) {
      const task = made.tasks[Number(number) - made.tasks[0].task];
      if (task) return { made, task };
    }
    throw new Fault(404, `there is no task ${number}`, '`tetfarm tasks JOB` lists them');
  }

  answer(request, response) {
    const url = new URL(request.url, 'http://127.0.0.1');
    this.requests.push(`${request.method} ${url.pathname}`);
    try {
      if (url.pathname === '/api/v1/changes') return this.watch(response);
      if (url.pathname.startsWith('/api/')) {
        const parts = url.pathname.slice('/api/v1'.length).split('/').filter(Boolean).map(decodeURIComponent);
        const body = request.method === 'POST' ? this.act(request, parts, url.searchParams) : this.look(parts, url.searchParams);
        return this.reply(response, 200, body);
      }
      return this.file(url.pathname, response);
    } catch (error) {
      if (!(error instanceof Fault)) throw error;
      return this.reply(response, error.status, { error: error.message, help: error.help });
    }
  }

  reply(response, status, body) {
    if (Buffer.isBuffer(body)) {
      response.writeHead(status, { ...headers, 'Content-Type': 'application/octet-stream' });
      return response.end(body);
    }
    response.writeHead(status, { ...headers, 'Content-Type': 'application/json; charset=utf-8' });
    response.end(JSON.stringify(body));
  }

  file(pathname, response) {
    let path = join(folder, pathname);
    if (!path.startsWith(folder) || !existsSync(path) || !statSync(path).isFile()) path = join(folder, 'index.html');
    response.writeHead(200, { ...headers, 'Content-Type': types[extname(path)] ?? 'application/octet-stream' });
    createReadStream(path).pipe(response);
  }

  watch(response) {
    response.writeHead(200, { ...headers, 'Content-Type': 'text/event-stream' });
    this.watchers.add(response);
    response.on('close', () => this.watchers.delete(response));
    const write = (event, data) => response.write(`event: ${event}\ndata: ${JSON.stringify(data)}\n\n`);
    write('farm', this.farmLine());
    write('jobs', { jobs: this.farm.jobs.map(({ job }) => lineOf(job)) });
  }

  needCoordinator() {
    if (!this.connected && !this.atRest) throw new Fault(503, 'the coordinator does not answer', 'see whether it runs; this page asks again by itself');
  }

  look(parts, query) {
    const [what, id, part, path] = parts;
    if (parts.length === 0) return { version: 1, program_version: '1.0.0-mock', acts: this.acts, paths: [] };
    if (what === 'farm') return this.farmLine();
    this.needCoordinator();
    const last = (events) => ({ events: events.slice(-Number(query.get('last') ?? 200)) });
    if (what === 'jobs' && !id) return { jobs: this.farm.jobs.map(({ job }) => lineOf(job)).reverse() };
    if (what === 'jobs' && !part) return this.jobOf(id).job;
    if (what === 'jobs' && part === 'events') return last(this.farm.events.filter(({ job }) => job === id));
    if (what === 'jobs' && (part === 'tasks' || part === 'attempts')) return this.page(this.jobOf(id)[part], part, query);
    if (what === 'jobs' && part === 'surfaces') return path ? this.surface(id, Number(path)) : this.surfaces(id);
    if (what === 'jobs' && part === 'maps') return path ? this.map(id, Number(path)) : this.maps(id);
    if (what === 'tasks' && part === 'logs') return { attempts: this.attemptsOf(id).map((attempt) => ({ ...attempt, log: `read 3 files\nmeshed ${attempt.path}\n<script>window.hacked=1</script>\u001b[31mred\n` })) };
    if (what === 'tasks' && id) return this.explain(id);
    if (what === 'workers') return { workers: this.farm.workers.filter(({ state }) => state !== 'gone' || query.get('gone') === '1') };
    if (what === 'events') return last(this.farm.events);
    throw new Fault(404, 'there is nothing at this address', '/api/v1 lists the addresses');
  }

  page(rows, part, query) {
    const key = part === 'tasks' ? 'task' : 'attempt';
    const columns = query.get('columns')?.split(',') ?? Object.keys(rows[0] ?? {});
    const after = Number(query.get('after') ?? 0);
    const limit = Number(query.get('limit') ?? 1000);
    const begin = after === 0 ? 0 : rows.findIndex((row) => row[key] > after);
    const found = begin < 0 ? [] : rows.slice(begin, begin + limit);
    const isLast = begin < 0 || begin + limit >= rows.length;
    return { columns, rows: found.map((row) => columns.map((column) => row[column])), next: isLast ? 0 : found[found.length - 1][key] };
  }

  surfaces(id) {
    const leaves = this.jobOf(id).tasks.filter(({ kind }) => kind === 'mesh');
    const surfaces = leaves.slice(0, 2000).map(({ path, state }) => ({
      path, place: pathText(path), state: 'leaf', meshed: state === 'done', hash: String(path).padStart(32, '0'), bytes: 250_000,
      is_there: this.seesFiles && !this.goneFiles.has(path),
    }));
    return { sees_files: this.seesFiles, patches, left_out: leaves.length - surfaces.length, surfaces };
  }

  surface(id, path) {
    const line = this.surfaces(id).surfaces.find((other) => other.path === path);
    if (!line?.is_there) throw new Fault(404, `the file of sub-domain ${pathText(path)} is no longer in the store`, 'look at another');
    return surfaceOf(path);
  }

  /** Of the job that failed and of the one that is done. */
  maps(id) {
    const of = { 'job-7': 'defects', 'job-8': 'layers' }[this.jobOf(id).job.job];
    const meanings = of === 'defects' ? meaningsOfDefects : [];
    const line = { map: 1, file: `some.${of}.vtp`, of, meanings, hash: `map of ${of}`, bytes: 4000, is_there: this.seesFiles && !this.isMapGone };
    return { sees_files: this.seesFiles, maps: of ? [line] : [] };
  }

  map(id, number) {
    const line = this.maps(id).maps[number - 1];
    if (!line?.is_there) throw new Fault(404, 'the map is no longer in the store', 'look at another');
    return mapOf[line.of]();
  }

  attemptsOf(number) {
    return this.taskOf(number).made.attempts.filter(({ task }) => task === Number(number));
  }

  explain(number) {
    const { task } = this.taskOf(number);
    const reasons = { ready: ['it waits for a worker with 1.5 GiB', 'the 18 workers are busy'], waiting: [`it needs what task ${task.task - 1} makes`], failed: ['it is in quarantine: it crashed 3 times', '`tetfarm retry` takes it out'] };
    return {
      ...task, type: 'explanation', subdomain: task.path ? 'leaf' : '', reasons: reasons[task.state] ?? [], limit_seconds: 3600, room_bytes: 2 ** 31,
      attempts: this.attemptsOf(number), inputs: [{ name: `surface:${task.path}`, hash: '9f4c1a20b7d3e6550c81f2a94d7e3b16', size: 48_211, is_there: true, made_by_task: task.task > 1 ? task.task - 1 : 0 }],
    };
  }

  act(request, [what, id, deed], query) {
    if (request.headers['x-tetfarm-act'] !== 'yes') throw new Fault(403, 'the header X-Tetfarm-Act is missing', 'send it');
    if (!this.acts) throw new Fault(403, 'this dashboard only looks', 'start it with --acts');
    this.needCoordinator();
    if (what === 'jobs' && deed === 'cancel') {
      this.changeJob(id, { state: 'cancelled', finished_ms: this.farm.nowMs });
      return { found: true };
    }
    if (what === 'jobs' && deed === 'retry') {
      const { job, tasks } = this.jobOf(id);
      for (const { task } of job.quarantine) tasks.find((other) => other.task === task).state = 'ready';
      const count = job.quarantine.length;
      this.changeJob(id, { state: 'running', message: '', quarantine: [], tasks_in_quarantine: 0 });
      return { count };
    }
    if (what === 'jobs' && deed === 'priority') {
      const priority = Number(query.get('priority'));
      this.changeJob(id, { priority });
      return { set: true, priority, state: this.jobOf(id).job.state };
    }
    if (what === 'tasks' && deed === 'retry') {
      const { task } = this.taskOf(id);
      const count = task.state === 'failed' ? 1 : 0;
      if (count) task.state = 'ready';
      return { count };
    }
    if (what === 'hosts' && deed === 'retry') {
      const out = this.farm.workers.filter(({ host, host_in_quarantine: isOut }) => host === id && isOut);
      for (const worker of out) worker.host_in_quarantine = false;
      return { count: out.length > 0 ? 1 : 0 };
    }
    if (what === 'workers' && deed === 'drain') {
      const worker = this.farm.workers.find((other) => other.worker === id);
      if (worker) worker.state = 'drains';
      return { count: worker ? 1 : 0 };
    }
    throw new Fault(404, 'there is no such act', '/api/v1 lists the addresses');
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const address = await new MockServer().start(Number(process.argv[2] ?? 8710));
  console.log(`a made-up farm at ${address}`);
}
