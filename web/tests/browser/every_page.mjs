// What holds for every page: it draws without an error, fits a narrow screen, and axe finds nothing
// serious in it, dark and light. Needs no certain farm.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { address, isReal, open, settled, until } from './support.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

async function answerOf(path) {
  return (await (await fetch((await address()) + path)).json());
}

/** All pages, of a job and a task that there are. */
async function allPages() {
  const { jobs } = await answerOf('/api/v1/jobs');
  const ids = isReal ? jobs.slice(0, 1).map(({ job }) => job) : ['job-10', 'job-7', 'job-8'];
  const pages = ['/', '/workers', '/events', '/nothing/here', `/jobs/${isReal ? jobs[0].job : 'job-8'}/shape#colour=layers&cut=z&at=40`];
  for (const id of ids) {
    for (const tab of ['', '/shape', '/timeline', '/balance', '/quality', '/tasks', '/events']) pages.push(`/jobs/${id}${tab}`);
    const { rows } = await answerOf(`/api/v1/jobs/${id}/tasks?columns=task&limit=1`);
    if (rows.length) pages.push(`/tasks/${rows[0][0]}`);
  }
  return pages;
}

test('every page draws without errors, console messages and policy violations', async () => {
  for (const path of await allPages()) {
    const { page, close } = await open(path);
    await settled(page);
    assert.equal(await page.locator('main h1').count(), 1, path);
    await close();
  }
});

test('the server sends what the contract says', async () => {
  const response = await fetch(`${await address()}/`);
  assert.match(response.headers.get('content-security-policy'), /default-src 'none'; script-src 'self'; style-src 'self'/);
  assert.equal(response.headers.get('x-content-type-options'), 'nosniff');
  const html = await response.text();
  assert.doesNotMatch(html, /<style|style=|<script>|https?:/);
});

test('no page scrolls sideways at 400 pixels', async () => {
  for (const path of await allPages()) {
    const { page, close } = await open(path, { viewport: { width: 400, height: 800 } });
    await settled(page);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 400, `${path} is ${width} pixels wide`);
    await close();
  }
});

for (const colorScheme of ['light', 'dark']) {
  test(`axe finds nothing serious or critical, ${colorScheme}`, async () => {
    for (const path of await allPages()) {
      const { page, close } = await open(path, { colorScheme, bypassCSP: true });
      await settled(page);
      await page.addScriptTag({ content: axe });
      const { violations } = await page.evaluate(() => window.axe.run());
      const grave = violations
        .filter(({ impact }) => impact === 'serious' || impact === 'critical')
        .map(({ id, nodes }) => `${path}: ${id} ${nodes[0].html.slice(0, 160)} ${nodes[0].failureSummary}`);
      assert.deepEqual(grave, []);
      await close();
    }
  });
}

test('the colours follow the system, and the switch is remembered', async () => {
  const { page, close } = await open('/', { colorScheme: 'dark' });
  const become = (theme) =>
    until(async () => (await page.locator('html').getAttribute('data-theme')) === theme, `the ${theme} theme`);
  const back = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  await become('dark');
  const dark = await back();
  await page.emulateMedia({ colorScheme: 'light' });
  await become('light');
  assert.notEqual(await back(), dark);
  await page.getByLabel('Colours').selectOption('dark');
  await become('dark');
  await page.reload();
  await become('dark');
  assert.equal(await back(), dark);
  await page.getByLabel('Colours').selectOption('auto');
  await become('light');
  await close();
});
