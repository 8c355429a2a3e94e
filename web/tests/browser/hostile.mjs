// Names, messages and logs that are made to do harm are shown as text, and do nothing.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hostileNames } from '../mock_farm.mjs';
import { open, ownFarm, settled } from './support.mjs';

async function assertInert(page, path) {
  assert.equal(await page.evaluate(() => window.hacked), undefined, path);
  assert.equal(await page.locator('main img, main script, main iframe').count(), 0, path);
  const text = await page.evaluate(() => document.body.innerText);
  assert.doesNotMatch(text, /[\u202a-\u202e\u2066-\u2069\u200e\u200f\u0007\u001b\u0000]/, path);
}

test('hostile names of jobs, events, messages and logs are inert', async () => {
  const { mock, address } = await ownFarm();
  const task = mock.jobOf('job-2').tasks[3].task;
  const paths = ['/', '/events', ...hostileNames.map((_, i) => `/jobs/job-${i + 2}`), `/tasks/${task}`];
  for (const path of paths) {
    const { page, close } = await open(path, { base: address });
    await settled(page);
    if (path.startsWith('/tasks')) {
      await page.getByText('What its process said').click();
      await page.locator('pre.log').first().waitFor();
    }
    await assertInert(page, path);
    await close();
  }
});

test('hostile names of workers, hosts, kinds, states and troubles are inert', async () => {
  const { mock, address } = await ownFarm();
  const [script, image, direction] = hostileNames;
  Object.assign(mock.farm.workers[0], { worker: script, host: image, state: direction, version: script });
  Object.assign(mock.jobOf('job-10').job, { stage: image, message: script });
  mock.jobOf('job-10').tasks.forEach((task) => Object.assign(task, { kind: script, host: direction, message: image, doing: image }));
  mock.jobOf('job-10').attempts.forEach((attempt) => Object.assign(attempt, { kind: image, host: script, state: direction }));
  mock.trouble = script;
  for (const path of ['/', '/workers', '/jobs/job-10', '/jobs/job-10/timeline', '/jobs/job-10/balance', '/jobs/job-10/tasks']) {
    const { page, close } = await open(path, { base: address });
    await settled(page);
    await page.locator('canvas.surface').hover({ timeout: 500 }).catch(() => undefined);
    await assertInert(page, path);
    await close();
  }
});

test('names keep their text', async () => {
  const { address } = await ownFarm();
  const { page, close } = await open('/', { base: address });
  await page.getByRole('link', { name: '<script>window.hacked=1</script>' }).waitFor();
  await page.getByRole('link', { name: 'gnp.\\u202eexe.wing\\u200f\\u2067' }).waitFor();
  await close();
});
