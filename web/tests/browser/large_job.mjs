// A job with 100,000 tasks: what is in the document and on the canvases is bounded by the screen.
// Times are printed; only counted work decides.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drawn, open, told, until } from './support.mjs';

function say(what, begin) {
  console.log(`  ${what}: ${Math.round(performance.now() - begin)} ms`);
}

/** Milliseconds of the longest time in which the page could not react, while `work` goes on. */
async function longestBlock(page, work) {
  await page.evaluate(() => {
    window.longest = 0;
    let last = performance.now();
    window.blockTimer = setInterval(() => {
      const now = performance.now();
      window.longest = Math.max(window.longest, now - last);
      last = now;
    }, 5);
  });
  await work();
  return Math.round(await page.evaluate(() => {
    clearInterval(window.blockTimer);
    return window.longest;
  }));
}

test('the tree of 100,000 tasks draws no more than the screen can show', async () => {
  const begin = performance.now();
  const { page, close } = await open('/jobs/job-1');
  await drawn(page);
  say('tree, first drawing with all tasks', begin);
  const width = (await page.locator('canvas.surface').boundingBox()).width;
  assert.equal(await told(page, 'nodes'), 39_999);
  const bars = await told(page, 'bars');
  assert.ok(bars < 39_999 / 2, `${bars} bars`);  // each level that has more than two a pixel is merged
  console.log(`  tree: ${bars} bars for 39,999 sub-domains, drawn in ${await told(page, 'draw-ms')} ms`);
  const zoomBegin = performance.now();
  const block = await longestBlock(page, async () => {
    await page.locator('canvas.surface').click({ position: { x: width * 0.3, y: 18 * 6 + 8 } });
    await until(async () => (await told(page, 'bars')) !== bars, 'the zoomed tree');
  });
  say('tree, zoom', zoomBegin);
  console.log(`  tree, zoom: longest block ${block} ms, ${await told(page, 'bars')} bars, drawn in ${await told(page, 'draw-ms')} ms`);
  assert.ok((await page.locator('*').count()) < 400);
  await close();
});

test('the timeline of 100,000 attempts draws no more than the screen can show', async () => {
  const begin = performance.now();
  const { page, close } = await open('/jobs/job-1/timeline');
  await drawn(page);
  say('timeline, first drawing with all attempts', begin);
  const width = (await page.locator('canvas.surface').boundingBox()).width;
  assert.ok((await told(page, 'attempts')) > 100_000);
  const bars = await told(page, 'bars');
  assert.ok(bars < 2 * width * 28, `${bars} bars`);
  console.log(`  timeline: ${bars} bars for ${await told(page, 'attempts')} attempts, drawn in ${await told(page, 'draw-ms')} ms`);
  const zoomBegin = performance.now();
  const before = await told(page, 'to') - await told(page, 'from');
  const box = await page.locator('canvas.surface').boundingBox();
  await page.mouse.move(box.x + 700, box.y + 100);
  const block = await longestBlock(page, async () => {
    for (let i = 0; i < 5; ++i) await page.mouse.wheel(0, -300);
    await until(async () => (await told(page, 'to')) - (await told(page, 'from')) < before / 50, 'the zoomed timeline');
  });
  say('timeline, five steps of zoom', zoomBegin);
  console.log(`  timeline, zoom: longest block ${block} ms, drawn in ${await told(page, 'draw-ms')} ms`);
  await close();
});

test('the table of 100,000 tasks has a few dozen rows in the document, wherever one scrolls', async () => {
  const begin = performance.now();
  const { page, close } = await open('/jobs/job-1/tasks');
  await page.locator('.count').getByText('100,001 of 100,001').waitFor();
  say('tasks, first rows', begin);
  const rows = page.locator('tr.opens');
  assert.ok((await rows.count()) < 60);
  assert.equal(await page.locator('table').getAttribute('aria-rowcount'), '100002');
  const scroller = page.locator('.scroller.tall');
  await scroller.evaluate((element) => element.scrollTo(0, element.scrollHeight));
  await page.getByRole('link', { name: '#100001' }).waitFor();
  assert.ok((await rows.count()) < 60);
  assert.equal(await rows.last().getAttribute('aria-rowindex'), '100002');
  const sortBegin = performance.now();
  await page.getByRole('button', { name: 'Time' }).click();
  await until(async () => (await page.locator('[aria-sort=descending]').count()) === 1, 'the sorted table');
  say('tasks, sort by time', sortBegin);
  const filterBegin = performance.now();
  await page.getByLabel('Task, place, host or message').fill('node03 cosmetic');
  await until(async () => !/100,001 of/.test(await page.locator('.count').innerText()), 'the filtered table');
  say('tasks, filter by text', filterBegin);
  assert.ok((await rows.count()) < 60);
  await close();
});

test('the tasks come by columns, 20,000 rows a page', async () => {
  const asked = [];
  const { page, close } = await open('/');
  page.on('request', (request) => {
    if (request.url().includes('/tasks?')) asked.push(new URL(request.url()).searchParams);
  });
  await page.getByRole('link', { name: 'd150_aircraft' }).click();
  await drawn(page);
  assert.equal(asked.length, 6);
  for (const query of asked) {
    assert.equal(query.get('limit'), '20000');
    assert.match(query.get('columns'), /^task,path,/);
  }
  assert.deepEqual(asked.map((query) => query.get('after')), ['0', '20000', '40000', '60000', '80000', '100000']);
  await close();
});
