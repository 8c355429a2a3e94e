// Everything is reached without a pointer.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drawn, open, ownFarm, told, until } from './support.mjs';

const focused = (page) => page.evaluate(() => document.activeElement?.textContent?.trim() ?? '');

async function tabTo(page, text, most = 60) {
  for (let i = 0; i < most; ++i) {
    await page.keyboard.press('Tab');
    if ((await focused(page)).startsWith(text)) return;
  }
  assert.fail(`${text} is not reached by Tab`);
}

test('from the list of jobs to a sub-domain of one, by keys alone', async () => {
  const { page, close } = await open('/');
  await page.getByText('onera_m6_wing').waitFor();
  await page.keyboard.press('Tab');
  assert.equal(await focused(page), 'Skip to the page');
  await tabTo(page, 'onera_m6_wing');
  await page.keyboard.press('Enter');
  await page.waitForURL('**/jobs/job-10');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'main');
  await drawn(page);
  const all = await told(page, 'bars');
  await until(async () => {
    await page.keyboard.press('Tab');
    return page.evaluate(() => document.activeElement.tagName === 'CANVAS');
  }, 'the canvas in focus');
  for (const key of ['ArrowDown', 'ArrowRight', 'ArrowDown']) await page.keyboard.press(key);
  await page.getByRole('heading', { name: 'Sub-domain RL' }).waitFor();
  await page.keyboard.press('Enter');
  await until(async () => (await told(page, 'bars')) < all, 'the zoomed tree');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await until(async () => (await told(page, 'bars')) === all, 'the whole tree');
  await close();
});

test('the tabs, the timeline and a task', async () => {
  const { page, close } = await open('/jobs/job-10');
  await drawn(page);
  await tabTo(page, 'Timeline');
  await page.keyboard.press('Enter');
  await page.waitForURL('**/timeline');
  await drawn(page);
  await page.locator('canvas.surface').focus();
  const span = async () => (await told(page, 'to')) - (await told(page, 'from'));
  const all = await span();
  await page.keyboard.press('+');
  await page.keyboard.press('+');
  await until(async () => (await span()) < all / 2, 'a zoom by keys');
  const from = await told(page, 'from');
  await page.keyboard.press('ArrowRight');
  await until(async () => (await told(page, 'from')) > from, 'a move by keys');
  await page.keyboard.press('0');
  await until(async () => Math.abs((await span()) - all) < 0.01, 'the whole job');
  await page.locator('body').press('Tab');
  await page.goto(page.url().replace('timeline', 'tasks'));
  await page.locator('.count').waitFor();
  await tabTo(page, '#100430');
  await page.keyboard.press('Enter');
  await page.waitForURL('**/tasks/100430');
  await close();
});

test('an act: opened, left and confirmed by keys, with the focus kept in its dialog', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-10', { base: address });
  await page.getByRole('button', { name: 'Cancel' }).waitFor();
  await tabTo(page, 'Cancel');
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').waitFor();
  assert.equal(await focused(page), 'Leave it');
  await page.keyboard.press('Enter');
  await until(async () => (await page.getByRole('dialog').count()) === 0, 'the dialog to go');
  assert.equal(mock.requests.filter((line) => line.startsWith('POST')).length, 0);
  assert.equal(await focused(page), 'Cancel');
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').waitFor();
  await tabTo(page, 'Cancel the job', 3);
  await page.keyboard.press('Enter');
  await page.getByText('job-10 is cancelled.').waitFor();
  await close();
});
