// Generated data for tests of the pages: jobs whose tasks are scheduled on workers as a farm would,
// so that trees, timelines and figures fit together. The same every time.

const hosts = ['node01', 'node02', 'node03'];

export const hostileNames = [
  '<script>window.hacked=1</script>',
  '"><img src=x onerror=window.hacked=1>',
  'gnp.\u202Eexe.wing\u200F\u2067',
  `${'long'.repeat(50)}`,
  'bell\u0007 escape\u001b[31m nul\u0000 line\nend',
];

/** A small generator of numbers from 0 to 1 (mulberry32). */
function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const perLeaf = ['mesh', 'extract', 'cosmetic', 'write'];

/** Cuts the largest leaf again and again, by uneven halves: inner nodes in the order of cutting. */
function cutTree(leaves, random) {
  const open = [{ path: 1, size: 1 }];
  const inner = [];
  let at = 0;
  while (open.length - at < leaves) {
    const node = open[at++];
    const share = 0.42 + 0.16 * random();
    inner.push(node);
    open.push({ path: 2 * node.path, size: node.size * share });
    open.push({ path: 2 * node.path + 1, size: node.size * (1 - share) });
  }
  return { inner, leaves: open.slice(at) };
}

function plannedTasks(options, random) {
  const { leaves, firstTask, elements, secondsPerElement } = options;
  const tree = cutTree(leaves, random);
  const tasks = [];
  const path2cut = new Map();
  const add = (kind, path, size, seconds, after) => {
    const task = { task: firstTask + tasks.length, kind, path, size, seconds, after };
    tasks.push(task);
    return task;
  };
  const whole = elements * secondsPerElement;
  const inspect = add('inspect', 0, 0, whole * 0.004 + 0.5, []);
  for (const { path, size } of tree.inner) {
    const parent = path2cut.get(Math.floor(path / 2)) ?? inspect;
    path2cut.set(path, add('decompose', path, 0, whole * 0.004 * size + 0.08, [parent]));
  }
  const ends = [];
  const meshed = tree.leaves.map(({ path, size }, place) => {
    const parent = path2cut.get(Math.floor(path / 2)) ?? inspect;
    const seconds = whole * size * (0.75 + 0.5 * random()) + 0.05;
    return { path, size, place, mesh: add('mesh', path, size, seconds, [parent]) };
  });
  for (const kind of perLeaf.slice(1)) {
    const part = { extract: 0.06, cosmetic: 0.3, write: 0.08 }[kind];
    for (const leaf of meshed) {
      leaf[kind] = add(kind, leaf.path, leaf.size, leaf.mesh.seconds * part + 0.02, [leaf.last ?? leaf.mesh]);
      leaf.last = leaf[kind];
      if (kind === 'write') ends.push(leaf.last);
    }
  }
  add('assemble', 0, 0, whole * 0.01 + 0.3, ends.slice(-50));
  // Leaf after leaf, each step a while after the one before.
  for (const leaf of meshed) {
    perLeaf.forEach((kind, step) => (leaf[kind].turn = leaf.place + step * (4 + leaves / 12)));
  }
  tasks[tasks.length - 1].turn = Infinity;
  return tasks;
}

/** Gives each task a worker and a time; every now and then an attempt is lost before. */
function schedule(tasks, workers, random, lossShare) {
  const freeAt = new Float64Array(workers.length);
  const id2end = new Map();
  const attempts = [];
  const inTurn = tasks.slice().sort((a, b) => (a.turn ?? -1) - (b.turn ?? -1) || a.task - b.task);
  for (const task of inTurn) {
    let end = task.after.reduce((latest, other) => Math.max(latest, id2end.get(other.task)), 0);
    for (let tries = 0; tries < 3; ++tries) {
      let best = 0;
      for (let w = 1; w < workers.length; ++w) if (freeAt[w] < freeAt[best]) best = w;
      const start = Math.max(end, freeAt[best]) + 0.01;
      const isLost = tries < 2 && random() < lossShare;
      end = start + task.seconds * (isLost ? 0.3 + 0.6 * random() : 1);
      freeAt[best] = end;
      attempts.push({ task, worker: workers[best], start, end, isLost, cause: random() });
      if (!isLost) break;
    }
    id2end.set(task.task, end);
    task.end = end;
  }
  return { attempts, seconds: tasks.reduce((latest, task) => Math.max(latest, task.end), 0) };
}

function attemptState(attempt, now) {
  if (attempt.end > now) return 'running';
  if (!attempt.isLost) return 'done';
  return attempt.cause < 0.4 ? 'lost' : attempt.cause < 0.7 ? 'crashed' : 'starved';
}

function attemptRow(options, attempt, number, now, beginMs) {
  const { task, worker, start, end } = attempt;
  const state = attemptState(attempt, now);
  const ends = state === 'running' ? now : end;
  const peak = Math.round(60e6 + options.elements * task.size * 420);
  return {
    type: 'attempt', attempt: number, job: options.job, task: task.task, kind: task.kind, path: task.path,
    worker: worker.worker, host: worker.host, process: worker.process, state, races: false,
    started_ms: Math.round(beginMs + 1000 * start), ended_ms: state === 'running' ? 0 : Math.round(beginMs + 1000 * end),
    seconds: ends - start, memory_bytes: worker.memory_bytes, peak_rss_bytes: state === 'running' ? 0 : peak,
    message: { lost: 'its worker fell silent', crashed: 'signal 11 (segmentation fault)', starved: 'std::bad_alloc' }[state] ?? '',
  };
}

export function pathText(path) {
  let text = '';
  for (let at = path; at > 1; at = Math.floor(at / 2)) text = (at % 2 ? 'R' : 'L') + text;
  return path === 0 ? '' : text || 'root';
}

function taskRow(options, task, tries, now, random) {
  const last = tries[tries.length - 1];
  const isReady = task.after.every((other) => other.end <= now);
  const state = !last ? (isReady ? 'ready' : 'waiting') : last.state === 'running' ? 'leased' : last.state === 'done' ? 'done' : 'ready';
  const isDone = state === 'done';
  const isMesh = task.kind === 'mesh' || task.kind === 'cosmetic';
  const expected = Math.round(options.elements * task.size * (isMesh ? 1 : 0));
  const share = state === 'leased' ? Math.min(0.95, last.seconds / task.seconds) : 0;
  const count = (name) => tries.filter((attempt) => attempt.state === name).length;
  return {
    type: 'task', task: task.task, job: options.job, kind: task.kind, path: task.path, place: pathText(task.path),
    state, attempt: last?.attempt ?? 0, worker: last?.worker ?? '', host: last?.host ?? '',
    errors: count('crashed'), losses: count('lost'), out_of_memory: count('starved'),
    seconds: last ? last.seconds : 0, peak_rss_bytes: isDone ? last.peak_rss_bytes : 0, memory_bytes: 0,
    expected_seconds: task.seconds * (0.8 + 0.4 * random()), cpu_seconds: isDone ? last.seconds * 0.97 : 0,
    expected_bytes: Math.round(70e6 + options.elements * task.size * 400 * (0.9 + 0.2 * random())),
    min_dihedral_deg: isDone && isMesh ? 9 + ((task.task * 7919) % 160) / 10 : 0,
    expected_elements: expected, elements: isDone && isMesh ? Math.round(expected * (0.85 + 0.3 * random())) : 0,
    exit_code: 0, message: '',
    doing: state === 'leased' ? `${task.kind === 'mesh' ? 'points' : 'cosmetics'}: ${Math.round(share * 5000).toLocaleString('en-GB')} of 5,000` : '',
    doing_stage: state === 'leased' ? 'points' : '', doing_pass: 0, doing_done: Math.round(share * 5000), doing_total: 5000, share,
  };
}

export function workersFor(perHost, first = 1) {
  return hosts.flatMap((host, h) =>
    Array.from({ length: perHost }, (_, i) => ({
      worker: `worker-${first + h * perHost + i}`, host, process: 4100 + 37 * (h * perHost + i), memory_bytes: 8 * 2 ** 30,
    })),
  );
}

function jobRow(options, tasks, attempts, state, seconds) {
  const of = (kind, wanted) => tasks.filter((task) => task.kind === kind && (!wanted || task.state === wanted));
  const leaves = of('mesh');
  const meshed = of('mesh', 'done');
  const count = (wanted) => tasks.filter((task) => task.state === wanted).length;
  const elements = meshed.reduce((sum, task) => sum + task.elements, 0);
  const share = state === 'done' ? 1 : Math.min(0.99, count('done') / tasks.length);
  const running = tasks.filter((task) => task.state === 'leased');
  const lost = (wanted) => attempts.filter((attempt) => attempt.state === wanted).length;
  return {
    type: 'job', job: options.job, name: options.name, state, stage: state === 'done' ? '' : options.stage ?? 'mesh',
    subdomains: leaves.length, subdomains_meshed: meshed.length, subdomains_mended: 0, elements,
    estimated_elements: options.elements, expected_task_bytes: 1.4e9, expected_disk_bytes: 5.1e9, expected_cpu_seconds: 900,
    tasks_done: count('done'), tasks_ready: count('ready') + count('waiting'), tasks_running: running.length,
    attempts_lost: lost('lost'), crashes: lost('crashed'), out_of_memory: lost('starved'), quarantine: [],
    running: running.slice(0, 20).map(({ task, kind, path, attempt, seconds: s, doing, share: part }) => ({ task, kind, path, attempt, seconds: s, doing, share: part })),
    elements_under_way: 0, peak_rss_bytes_worker: Math.max(0, ...attempts.slice(0, 5000).map((a) => a.peak_rss_bytes)),
    seconds, balance: { elements: 1.31, estimated: 1.18 }, cut_further: {}, message: '', exit_code: 0,
    share, tasks: { done: count('done'), total: tasks.length, running: running.length, waiting: count('ready') + count('waiting'), failed: 0 },
    tasks_in_quarantine: 0, workers: options.workers.length,
    eta_seconds: state === 'running' ? Math.round((seconds * (1 - share)) / Math.max(share, 0.01)) : null,
    created_ms: options.beginMs, finished_ms: state === 'running' ? 0 : Math.round(options.beginMs + 1000 * seconds),
  };
}

/** A job with its tasks and attempts. `fraction`: how much of its time has passed. */
export function makeJob(options) {
  const random = randomFrom(options.seed ?? 1);
  const planned = plannedTasks(options, random);
  const { attempts: planned_attempts, seconds } = schedule(planned, options.workers, random, options.lossShare ?? 0.01);
  const now = seconds * options.fraction + (options.fraction >= 1 ? 1 : 0);
  if (options.nowMs) options.beginMs = Math.round(options.nowMs - 1000 * now);
  const attempts = [];
  const task2attempts = new Map();
  for (const attempt of planned_attempts.filter(({ start }) => start <= now)) {
    const row = attemptRow(options, attempt, options.firstTask + attempts.length, now, options.beginMs);
    attempts.push(row);
    if (!task2attempts.has(row.task)) task2attempts.set(row.task, []);
    task2attempts.get(row.task).push(row);
  }
  const tasks = planned.map((task) => taskRow(options, task, task2attempts.get(task.task) ?? [], now, random));
  const state = options.state ?? (options.fraction >= 1 ? 'done' : 'running');
  return { job: jobRow(options, tasks, attempts, state, Math.min(now, seconds)), tasks, attempts };
}

const result = {
  elements: 3311204, nodes: 588120, boundary_triangles: 81244, volume: 12.8134, min_dihedral_deg: 11.274,
  max_dihedral_deg: 158.31, mean_radius_ratio: 0.8612, smallest_height: 0.00213, forced_dihedral_deg: 14.1,
  worst_at: [0.31, 0.42, 0.93],
  near_cuts: { elements: 611204, min_dihedral_deg: 11.274, max_dihedral_deg: 158.31, mean_radius_ratio: 0.8391, smallest_height: 0.00213,
    dihedral_histogram: [0, 900, 9000, 61000, 171000, 310000, 420000, 390000, 290000, 190000, 120000, 70000, 34000, 14000, 4000, 900, 0, 0] },
  away_from_cuts: { elements: 2700000, min_dihedral_deg: 14.02, max_dihedral_deg: 151.9, mean_radius_ratio: 0.8722, smallest_height: 0.0031,
    dihedral_histogram: [0, 300, 12000, 190000, 800000, 1700000, 2400000, 2100000, 1500000, 800000, 500000, 200000, 90000, 20000, 3000, 90, 0, 0] },
  digest: '9f4c1a20b7d3e6550c81f2a94d7e3b16',
  gates: [{ key: 'min_dihedral', limit_deg: 8, smallest_deg: 11.274, at: [0, 0, 0], passed: true }],
  remarks: ['the edge between two triangles forces a dihedral angle of 14.1 deg or less near (0.81, 0.02, 1.1)'],
};

function failJob(made) {
  const failed = made.tasks.filter((task) => task.kind === 'mesh').slice(0, 2);
  for (const task of failed) {
    task.state = 'failed';
    task.message = 'crashed 3 times: signal 11 (segmentation fault); <b>last words</b>';
    task.exit_code = 70;
    task.errors = 3;
    for (const attempt of made.attempts.filter((other) => other.task === task.task)) {
      attempt.state = 'crashed';
      attempt.message = 'signal 11 (segmentation fault)';
    }
  }
  const { job } = made;
  job.state = 'failed';
  job.stage = 'mesh';
  job.message = 'two tasks are in quarantine: mesh of sub-domain LL, mesh of sub-domain LR';
  job.tasks_in_quarantine = 2;
  job.exit_code = 70;
  job.quarantine = failed.map(({ task, kind, path }) => ({ task, kind, path, reason: 'quarantined: crashed 3 times; last failure: signal 11\ninputs: 9f4c…, a01b…', exit_code: 70 }));
  return made;
}

/** All of a farm: jobs by their id, workers, events. */
export function makeFarm({ largeLeaves = 20_000, nowMs = Date.UTC(2026, 10, 30, 4, 0, 0) } = {}) {
  const workers = workersFor(6);
  const jobs = [];
  const add = (options) => {
    const made = makeJob({ workers, seed: jobs.length + 7, ...options });
    jobs.push(made);
    return made;
  };
  const at = (minutesAgo) => nowMs - 60_000 * minutesAgo;
  const large = add({ job: 'job-1', name: 'd150_aircraft', leaves: largeLeaves, firstTask: 1, elements: 310e6, secondsPerElement: 2.2e-5, fraction: 1, beginMs: at(300), workers: workersFor(21) });
  large.job.result = result;
  const next = () => 1 + jobs.reduce((most, { tasks }) => Math.max(most, tasks[tasks.length - 1].task), 0);
  hostileNames.forEach((name, i) => {
    const made = add({ job: `job-${i + 2}`, name, leaves: 4, firstTask: next(), elements: 4e5, secondsPerElement: 3e-5, fraction: 1, beginMs: at(120 - 5 * i), state: i === 4 ? 'cancelled' : 'done' });
    made.job.message = name;
  });
  failJob(add({ job: 'job-7', name: 'landing_gear', leaves: 8, firstTask: next(), elements: 2e6, secondsPerElement: 4e-5, fraction: 0.5, beginMs: at(80), lossShare: 0.1 }));
  const done = add({ job: 'job-8', name: 'pml_sphere', leaves: 24, firstTask: next(), elements: 3.3e6, secondsPerElement: 6e-5, fraction: 1, beginMs: at(50) });
  done.job.result = result;
  done.job.files = ['/srv/tetfarm/out/pml_sphere.vtkhdf'];
  const stuck = add({ job: 'job-9', name: 'turbine_blade', leaves: 32, firstTask: next(), elements: 9e6, secondsPerElement: 5e-5, fraction: 0.2, nowMs: at(12), state: 'stuck' });
  stuck.job.message = 'the disk of the store has no room: 1.2 GiB are free, 3.4 GiB are needed';
  add({ job: 'job-10', name: 'onera_m6_wing', leaves: 160, firstTask: next(), elements: 42e6, secondsPerElement: 3e-4, fraction: 0.55, nowMs, lossShare: 0.03 });
  return { jobs, workers: workerRows(workers, jobs, nowMs), events: eventsOf(jobs), nowMs };
}

function workerRows(workers, jobs, nowMs) {
  const running = jobs[jobs.length - 1].tasks.filter((task) => task.state === 'leased');
  const random = randomFrom(3);
  return workers.map((worker) => {
    const task = running.find((other) => other.worker === worker.worker);
    return {
      type: 'worker', ...worker, state: task ? 'busy' : 'idle', task: task?.task ?? 0, cores: 1, version: '1.0.0',
      since_ms: nowMs - 6 * 3600_000, attempts_done: 900 + Math.round(400 * random()), attempts_not_done: Math.round(4 * random()),
      busy_seconds: 6 * 3600 * (0.7 + 0.28 * random()), host_in_quarantine: false,
    };
  });
}

function eventsOf(jobs) {
  const events = [];
  for (const { attempts } of jobs) {
    for (const attempt of attempts.filter(({ state }) => state !== 'done').slice(0, 60)) {
      events.push({
        type: 'event', event: 0, wall_ms: attempt.started_ms, job: attempt.job, task: attempt.task, attempt: attempt.attempt,
        worker: attempt.worker, what: attempt.state === 'running' ? 'ready' : 'again', message: attempt.message || 'handed out',
      });
    }
  }
  events.sort((a, b) => a.wall_ms - b.wall_ms);
  events.forEach((event, i) => (event.event = i + 1));
  if (events.length) events[events.length - 1].message = hostileNames.join(' ');
  return events;
}
