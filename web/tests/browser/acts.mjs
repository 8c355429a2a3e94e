// Acts: each asks first and says what will happen, does it only then, and tells what came of it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open, ownFarm, until } from './support.mjs';

const posts = (mock) => mock.requests.filter((line) => line.startsWith('POST'));

test('a job is cancelled after a confirmation, and not without', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-10', { base: address });
  const dialog = page.getByRole('dialog');
  await page.getByRole('button', { name: 'Cancel' }).click();
  await dialog.getByText('ends without a mesh').waitFor();
  assert.match(await dialog.innerText(), /onera_m6_wing/);
  await dialog.getByRole('button', { name: 'Leave it' }).click();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await dialog.waitFor();
  await page.keyboard.press('Escape');
  await until(async () => (await dialog.count()) === 0, 'the dialog to go');
  assert.deepEqual(posts(mock), []);
  await page.getByRole('button', { name: 'Cancel' }).click();
  await dialog.getByRole('button', { name: 'Cancel the job' }).click();
  await dialog.getByText('job-10 is cancelled.').waitFor();
  assert.deepEqual(posts(mock), ['POST /api/v1/jobs/job-10/cancel']);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await page.locator('h1').getByText('cancelled').waitFor();
  assert.equal(await page.getByRole('button', { name: 'Cancel' }).count(), 0);
  await close();
});

test('a job gets another priority, a whole one within its bounds', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-10', { base: address });
  const dialog = page.getByRole('dialog');
  await page.getByRole('button', { name: 'Priority' }).click();
  await dialog.getByText('the highest priority first').waitFor();
  const confirm = dialog.getByRole('button', { name: 'Set the priority' });
  const field = dialog.getByLabel('Priority, from −1000 to 1000');
  for (const wrong of ['', '1.5', '1001', '-1001']) {
    await field.fill(wrong);
    assert.ok(await confirm.isDisabled(), `${wrong} is refused`);
  }
  await field.fill('-20');
  await confirm.click();
  await dialog.getByText('job-10 has priority -20.').waitFor();
  assert.deepEqual(posts(mock), ['POST /api/v1/jobs/job-10/priority']);
  assert.equal(mock.jobOf('job-10').job.priority, -20);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await page.locator('.figures').getByText('Priority').waitFor();
  await close();
});

test('a failed job is tried again', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-7', { base: address });
  const dialog = page.getByRole('dialog');
  await page.getByRole('button', { name: 'Retry' }).click();
  await dialog.getByText('in quarantine (2)').waitFor();
  await dialog.getByRole('button', { name: 'Retry' }).click();
  await dialog.getByText('2 tasks taken out of quarantine').waitFor();
  assert.deepEqual(posts(mock), ['POST /api/v1/jobs/job-7/retry']);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await page.locator('h1').getByText('running').waitFor();
  await close();
});

test('a task in quarantine is tried again', async () => {
  const { mock, address } = await ownFarm();
  const { task } = mock.jobOf('job-7').job.quarantine[0];
  const { page, close } = await open(`/tasks/${task}`, { base: address });
  const dialog = page.getByRole('dialog');
  await page.getByRole('button', { name: 'Retry' }).click();
  await dialog.getByText('leaves the quarantine').waitFor();
  await dialog.getByRole('button', { name: 'Retry' }).click();
  await dialog.getByText('It is out of quarantine').waitFor();
  assert.deepEqual(posts(mock), [`POST /api/v1/tasks/${task}/retry`]);
  await close();
});

test('a worker is drained', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/workers', { base: address });
  const row = page.locator('tr', { hasText: 'worker-7' }).first();
  const dialog = page.getByRole('dialog');
  await row.getByRole('button', { name: 'Drain' }).click();
  await dialog.getByText('finishes what it is doing').waitFor();
  await dialog.getByRole('button', { name: 'Drain it' }).click();
  await dialog.getByText('worker-7 finishes its task and leaves.').waitFor();
  assert.deepEqual(posts(mock), ['POST /api/v1/workers/worker-7/drain']);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await row.getByText('drains').waitFor();
  assert.equal(await row.getByRole('button', { name: 'Drain' }).count(), 0);
  await close();
});

test('a host is taken out of quarantine, whatever its name is', async () => {
  const { mock, address } = await ownFarm();
  const host = 'node/1 <b>';
  for (const worker of mock.farm.workers.slice(0, 2)) Object.assign(worker, { host, host_in_quarantine: true });
  const { page, close } = await open('/workers', { base: address });
  const section = page.locator('section.host', { hasText: host });
  await section.getByText('in quarantine').waitFor();
  await section.getByRole('button', { name: 'Retry' }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByText('Tasks kept crashing on').waitFor();
  await dialog.getByRole('button', { name: 'Retry it' }).click();
  await dialog.getByText('is out of quarantine').waitFor();
  assert.deepEqual(posts(mock), ['POST /api/v1/hosts/node%2F1%20%3Cb%3E/retry']);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await until(async () => (await section.getByText('in quarantine').count()) === 0, 'the host to be in');
  await close();
});

test('an act that fails says why and what to do', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-10', { base: address, mayFail: true });
  await page.getByRole('button', { name: 'Cancel' }).click();
  mock.setConnected(false);
  const dialog = page.getByRole('dialog');
  await dialog.getByRole('button', { name: 'Cancel the job' }).click();
  await dialog.getByText('the coordinator does not answer').waitFor();
  await dialog.getByText('see whether it runs').waitFor();
  await close();
});

test('a page that may only look offers no acts', async () => {
  const { address, mock } = await ownFarm({ acts: false });
  const task = mock.jobOf('job-7').job.quarantine[0].task;
  for (const path of ['/jobs/job-10', '/jobs/job-7', '/workers', `/tasks/${task}`]) {
    const { page, close } = await open(path, { base: address });
    await page.getByText('this page only looks').waitFor();
    await until(async () => (await page.locator('h1 .state, section.host').count()) > 0, 'the page');
    for (const name of ['Cancel', 'Retry', 'Drain', 'Priority']) assert.equal(await page.getByRole('button', { name }).count(), 0);
    await close();
  }
});
