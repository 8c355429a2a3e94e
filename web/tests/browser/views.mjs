// What the pages show of a small farm, and that they find and open things.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drawn, open, ownFarm, sharedFarm, told, until } from './support.mjs';

/** What the farm knows of the job that runs. */
async function running() {
  const { job, tasks } = (await sharedFarm()).mock.jobOf('job-10');
  const count = (state, kind) => tasks.filter((task) => task.state === state && (!kind || task.kind === kind)).length;
  return { percent: `${Math.floor(100 * job.share)} %`, count };
}

/** A row of the timeline whose process is at work now. */
async function busyRow() {
  const { attempts } = (await sharedFarm()).mock.jobOf('job-10');
  const processes = [...new Set(attempts.map(({ host, process }) => `${host} ${process}`))].sort();
  const { host, process } = attempts.find(({ state }) => state === 'running');
  return processes.indexOf(`${host} ${process}`);
}

const rowsOf = (page) => page.locator('tbody tr');

test('jobs are filtered by state and by text, and lead to their page', async () => {
  const { page, close } = await open('/');
  await until(async () => (await rowsOf(page).count()) === 10, 'ten jobs');
  await page.getByLabel('State').selectOption('running');
  await until(async () => (await rowsOf(page).count()) === 1, 'the job that runs');
  const row = await rowsOf(page).first().innerText();
  for (const words of ['onera_m6_wing', 'running', 'mesh', (await running()).percent]) assert.ok(row.includes(words), words);
  await page.getByLabel('State').selectOption('');
  await page.getByLabel('Name or job').fill('PML');
  await until(async () => (await rowsOf(page).count()) === 1, 'the job of that name');
  await page.getByLabel('Name or job').fill('no such');
  await page.getByText('No job fits the filter.').waitFor();
  await page.getByLabel('Name or job').fill('job-8');
  await page.getByRole('link', { name: 'pml_sphere' }).click();
  await page.waitForURL('**/jobs/job-8');
  await until(async () => /pml_sphere/.test(await page.locator('h1').innerText()), 'the name of the job');
  await close();
});

test('a job says how far it is, what came of it and where its files are', async () => {
  const { page, close } = await open('/jobs/job-10');
  const head = page.locator('.job-head');
  await head.getByText('meshed in about').waitFor();
  const text = await head.innerText();
  assert.ok(text.includes((await running()).percent));
  for (const words of [/Sub-domains/, /Attempts lost/, /Crashes/, /Out of memory/, /Peak memory/]) assert.match(text, words);
  await close();
  const done = await open('/jobs/job-8');
  await done.page.getByText('smallest dihedral angle').waitFor();
  const result = await done.page.locator('.result').innerText();
  for (const words of [/11\.27°/, /0\.8612/, /passed/, /pml_sphere\.vtkhdf/, /forces a dihedral angle/]) assert.match(result, words);
  await done.close();
});

test('a failed job says why, and which tasks are in quarantine', async () => {
  const { page, close } = await open('/jobs/job-7');
  await page.getByText('2 tasks in quarantine').waitFor();
  assert.match(await page.locator('.job-head').innerText(), /signal 11/);
  await page.locator('.job-head').getByRole('link').first().click();
  await page.getByText('it is in quarantine: it crashed 3 times').waitFor();
  assert.equal(await page.locator('.reasons li').count(), 2);
  await page.getByText('What its process said').click();
  await page.getByText('read 3 files').waitFor();
  assert.match(await page.locator('pre.log').first().innerText(), /<script>window\.hacked=1<\/script>\\u001b\[31mred/);
  await close();
});

test('the tree zooms into what is clicked, and out by its crumbs', async () => {
  const { page, close } = await open('/jobs/job-10');
  await drawn(page);
  const canvas = page.locator('canvas.surface');
  const all = await told(page, 'bars');
  assert.equal(all, 319);
  const box = await canvas.boundingBox();
  await canvas.click({ position: { x: box.width * 0.9, y: 26 * 2 + 10 } });
  await page.getByRole('heading', { name: 'Sub-domain RR' }).waitFor();
  await until(async () => (await told(page, 'bars')) < all / 2, 'a part of the tree');
  assert.equal(await page.locator('.detail tbody tr').count(), 1);
  await canvas.hover({ position: { x: 40, y: 10 } });
  assert.match(await page.locator('.tip').innerText(), /root · decompose #\d+ · done/);
  await page.getByRole('button', { name: 'Zoom out to the whole domain' }).click();
  await until(async () => (await told(page, 'bars')) === all, 'the whole tree');
  await page.locator('.legend').getByText('running').waitFor();
  await close();
});

test('the timeline zooms by wheel, drag and buttons, and a click opens the task', async () => {
  const { page, close } = await open('/jobs/job-10/timeline');
  await drawn(page);
  const span = async () => (await told(page, 'to')) - (await told(page, 'from'));
  const all = await span();
  const canvas = page.locator('canvas.surface');
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + 60);
  await page.mouse.wheel(0, -400);
  await until(async () => (await span()) < all * 0.5, 'a zoom by the wheel');
  const from = await told(page, 'from');
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - 200, box.y + 60, { steps: 4 });
  await page.mouse.up();
  await until(async () => (await told(page, 'from')) > from, 'a move by dragging');
  assert.match(page.url(), /timeline$/);
  await page.getByRole('button', { name: 'Whole job' }).click();
  await until(async () => Math.abs((await span()) - all) < 0.01, 'the whole job');
  await page.keyboard.down('Shift');
  await page.mouse.move(box.x + 300, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + 500, box.y + 60, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.up('Shift');
  await until(async () => (await span()) < all * 0.3, 'the chosen time');
  await page.getByRole('button', { name: 'Whole job' }).click();
  await page.locator('.legend').getByText('decompose').waitFor();
  const y = 24 + 20 * (await busyRow()) + 8;
  await page.mouse.move(box.x + box.width - 3, box.y + y);
  await page.locator('.tip').getByText('running').waitFor();
  await canvas.click({ position: { x: box.width - 3, y } });
  await page.waitForURL('**/tasks/*');
  await close();
});

test('balance shows curves, scatter and busy shares, and says max and mean', async () => {
  const { page, close } = await open('/jobs/job-8/balance');
  await until(async () => (await page.locator('.uplot canvas').count()) === 7, 'seven charts');
  const text = await page.locator('main').innerText();
  assert.match(text, /max \/ mean 1\.\d\d over 24/);
  assert.match(text, /mean \d+ %, most \d+ %, least \d+ % \(worker-\d+\) over 18/);
  await page.getByLabel('Tasks of kind').selectOption('write');
  await page.getByText('Not told of tasks of this kind.').first().waitFor();
  await close();
});

test('quality shows the smallest angles as they come, and all angles of what is done', async () => {
  const done = await open('/jobs/job-8/quality');
  await until(async () => (await done.page.locator('.uplot canvas').count()) === 4, 'four charts');
  const text = await done.page.locator('main').innerText();
  for (const words of [/Near the cuts: 611,204 tetrahedra, angles from 11\.27° to 158\.3°, mean radius ratio 0\.8391/, /Away from the cuts: 2,700,000/, /Of 24 sub-domains so far/]) assert.match(text, words);
  await done.close();
  const { page, close } = await open('/jobs/job-10/quality');
  await page.getByText(`Of ${(await running()).count('done', 'mesh')} sub-domains so far`).waitFor();
  assert.doesNotMatch(await page.locator('main').innerText(), /Near the cuts:/);
  await close();
});

test('tasks are filtered by state, kind and text, sorted, and opened by a click', async () => {
  const { page, close } = await open('/jobs/job-10/tasks');
  const count = page.locator('.count');
  await count.getByText('801 of 801').waitFor();
  const known = await running();
  await page.getByLabel('State').selectOption('leased');
  await count.getByText(`${known.count('leased')} of 801`).waitFor();
  await page.getByLabel('State').selectOption('done');
  await page.getByLabel('Kind').selectOption('mesh');
  await count.getByText(`${known.count('done', 'mesh')} of 801`).waitFor();
  const elements = async () => (await page.locator('tr.opens td:nth-child(8)').allInnerTexts()).slice(0, 5);
  await page.getByRole('button', { name: 'Elements' }).click();
  const header = page.getByRole('columnheader', { name: 'Elements' });
  await until(async () => (await header.getAttribute('aria-sort')) === 'descending', 'the order');
  const most = (await elements()).map((text) => parseFloat(text));
  assert.deepEqual(most, [...most].sort((a, b) => b - a));
  await page.getByLabel('Task, place, host or message').fill('node02 L');
  await until(async () => (await page.locator('tr.opens').count()) > 0, 'rows');
  await page.locator('tr.opens').first().locator('td').nth(2).click();
  await page.waitForURL('**/tasks/*');
  await page.goBack();
  await page.waitForURL('**/jobs/job-10/tasks');
  await close();
});

test('workers are shown by host with what they do, what waits, and who was refused', async () => {
  const { page, close } = await open('/workers');
  await until(async () => (await page.locator('section.host').count()) === 3, 'three hosts');
  const text = await page.locator('main').innerText();
  for (const words of [/node01 6 workers/, /Tasks that wait for workers/, /41\s+1\.50 GiB/, /keys, encrypted/, /unknown_key 3/]) assert.match(text, words);
  await until(async () => /mesh\s+[LR]+\s+points: /.test(await page.locator('main').innerText()), 'what the workers do');
  await page.getByLabel('Worker, host or state').fill('node02');
  await until(async () => (await page.locator('section.host').count()) === 1, 'the one host');
  await close();
});

test('an unknown job, task and address say so', async () => {
  for (const path of ['/jobs/job-77', '/tasks/99999999']) {
    const { page, close } = await open(path, { mayFail: true });
    await page.getByRole('alert').getByText('there is no').waitFor();
    await close();
  }
  const { page, close } = await open('/no/such/page');
  await page.getByText('There is nothing at this address.').waitFor();
  await close();
});

test('a farm without jobs and workers says how to begin', async () => {
  const { mock, address } = await ownFarm();
  mock.farm.jobs = [];
  mock.farm.workers = [];
  mock.farm.events = [];
  const jobs = await open('/', { base: address });
  await jobs.page.getByText('No jobs yet').waitFor();
  await jobs.close();
  const workers = await open('/workers', { base: address });
  await workers.page.getByText('No workers').waitFor();
  await workers.close();
});

test('what runs is asked for at most every 3 s, what is done once', async () => {
  const { mock } = await sharedFarm();
  const count = (job) => mock.requests.filter((line) => line === `GET /api/v1/jobs/${job}/tasks`).length;
  const before = [count('job-10'), count('job-8')];
  const running = await open('/jobs/job-10');
  const done = await open('/jobs/job-8');
  await drawn(running.page);
  await drawn(done.page);
  await running.page.waitForTimeout(7000);
  const asked = count('job-10') - before[0];
  assert.ok(asked >= 2 && asked <= 3, `${asked} times in 7 s`);
  assert.equal(count('job-8') - before[1], 1);
  await running.close();
  await done.close();
});
