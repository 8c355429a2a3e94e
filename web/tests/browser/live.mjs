// What changes while one looks: jobs, events, a coordinator that stops answering, a server that
// goes away, and both coming back.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open, ownFarm, until } from './support.mjs';

test('a job that changes changes on the page, a new one appears', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/', { base: address });
  const row = page.locator('tbody tr', { hasText: 'onera_m6_wing' });
  await row.getByText('running').waitFor();
  mock.changeJob('job-10', { share: 0.77, stage: 'cosmetic' });
  await row.getByText('77 %').waitFor();
  await row.getByText('cosmetic').waitFor();
  mock.changeJob('job-10', { state: 'done', share: 1 });
  await row.getByText('100 %').waitFor();
  assert.match(await row.innerText(), /done/);
  mock.farm.jobs.push({ ...mock.jobOf('job-8'), job: { ...mock.jobOf('job-8').job, job: 'job-11', created_ms: mock.farm.nowMs } });
  mock.changeJob('job-11', { name: 'just_submitted' });
  await page.getByText('just_submitted').waitFor();
  assert.match(await page.locator('tbody tr').first().innerText(), /just_submitted/);
  await close();
});

test('the page of a job that ends shows its end by itself', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-10', { base: address });
  await page.locator('h1').getByText('running').waitFor();
  mock.changeJob('job-10', { state: 'failed', message: 'no room on the disk' });
  await page.locator('h1').getByText('failed').waitFor();
  await page.getByText('no room on the disk').waitFor();
  await close();
});

test('events come by themselves, newest first, and are filtered', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/events', { base: address });
  await until(async () => (await page.locator('tbody tr').count()) > 50, 'the events so far');
  await until(async () => mock.watchers.size === 1, 'the page to listen');
  mock.addEvent({ what: 'quarantined', message: 'a very new event', job: 'job-9', task: 12 });
  await page.getByText('a very new event').waitFor();
  assert.match(await page.locator('tbody tr').first().innerText(), /a very new event/);
  await page.getByLabel('Filter').fill('quarantined very');
  await until(async () => (await page.locator('tbody tr').count()) === 1, 'the one event');
  await close();
  const ofJob = await open('/jobs/job-9/events', { base: address });
  await ofJob.page.getByText('a very new event').waitFor();
  await until(async () => mock.watchers.size === 1, 'the page to listen');
  mock.addEvent({ what: 'again', message: 'of another job', job: 'job-8' });
  mock.addEvent({ what: 'again', message: 'of this job', job: 'job-9' });
  await ofJob.page.getByText('of this job').waitFor();
  assert.equal(await ofJob.page.getByText('of another job').count(), 0);
  await ofJob.close();
});

test('a coordinator that does not answer is told, what is known stays, and it comes back', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-10', { base: address, mayFail: true });
  await page.locator('h1').getByText('running').waitFor();
  mock.setConnected(false);
  await page.getByText('The coordinator does not answer.').waitFor();
  await page.locator('.link-state').getByText('No answer').waitFor();
  await page.waitForTimeout(2500);
  assert.match(await page.locator('h1').innerText(), /onera_m6_wing/);
  assert.equal(await page.getByRole('alert').count(), 0);
  mock.setConnected(true);
  await until(async () => (await page.locator('.banner').count()) === 0, 'the banner to go');
  mock.changeJob('job-10', { state: 'done', share: 1 });
  await page.locator('h1').getByText('done').waitFor();
  await close();
});

test('a page that is opened while the coordinator is away fills itself when it is back', async () => {
  const { mock, address } = await ownFarm();
  mock.setConnected(false);
  const { page, close } = await open('/workers', { base: address, mayFail: true });
  await page.getByRole('alert').getByText('the coordinator does not answer').waitFor();
  mock.setConnected(true);
  await until(async () => (await page.locator('section.host').count()) === 3, 'the workers');
  await until(async () => (await page.getByRole('alert').count()) === 0, 'the error to go');
  await close();
});

test('a server that goes away is told, and the page goes on when it is back', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/', { base: address, mayFail: true });
  await page.getByText('onera_m6_wing').waitFor();
  await page.locator('.link-state').getByText('Live').waitFor();
  await mock.stop();
  await page.getByText('The dashboard’s server cannot be reached.').waitFor();
  await page.getByText('onera_m6_wing').waitFor();
  mock.jobOf('job-10').job.name = 'renamed_meanwhile';
  mock.farm.jobs = mock.farm.jobs.filter(({ job }) => job.job !== 'job-8');
  await mock.start(mock.port);
  await page.getByText('renamed_meanwhile').waitFor();
  assert.equal(await page.locator('.banner').count(), 0);
  assert.equal(await page.getByText('pml_sphere').count(), 0);
  await close();
});

test('a store at rest is said to be one, and trouble of the farm is told', async () => {
  const { mock, address } = await ownFarm();
  mock.setAtRest(true);
  const { page, close } = await open('/', { base: address });
  await page.getByText('No coordinator runs').waitFor();
  await page.getByText('onera_m6_wing').waitFor();
  mock.setAtRest(false);
  await until(async () => (await page.locator('.banner').count()) === 0, 'the banner to go');
  mock.setConnected(true, 'the database cannot be written to');
  await page.locator('.banner').getByText('the database cannot be written to').waitFor();
  await close();
});
