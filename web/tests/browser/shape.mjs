// The sub-domains of a job in space, drawn by WebGL in software.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inflateSync } from 'node:zlib';
import { open, ownFarm, sharedFarm, until } from './support.mjs';

const canvasOf = (page) => page.locator('canvas.shape');
const number = async (page, name) => Number(await canvasOf(page).getAttribute(`data-${name}`));
const allDrawn = (page, count) => until(async () => (await number(page, 'parts')) === count, `${count} sub-domains`, 30_000);

/** The pixels of a picture that Chromium took: PNG of 8 bits, without interlacing. */
function pixelsOf(png) {
  const width = png.readUInt32BE(16);
  const height = png.readUInt32BE(20);
  const samples = png[25] === 6 ? 4 : 3;
  const data = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    if (png.toString('latin1', at + 4, at + 8) === 'IDAT') data.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  }
  const raw = inflateSync(Buffer.concat(data));
  const stride = width * samples;
  const rows = Buffer.alloc(height * stride);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const left = x >= samples ? rows[y * stride + x - samples] : 0;
      const above = y > 0 ? rows[(y - 1) * stride + x] : 0;
      const corner = x >= samples && y > 0 ? rows[(y - 1) * stride + x - samples] : 0;
      const [a, b, c] = [above - corner, left - corner, left + above - 2 * corner].map(Math.abs);
      const paeth = a <= b && a <= c ? left : b <= c ? above : corner;
      const guess = [0, left, above, (left + above) >> 1, paeth][filter];
      rows[y * stride + x] = raw[y * (stride + 1) + 1 + x] + guess;
    }
  }
  return { width, height, at: (x, y) => [...rows.subarray(y * stride + samples * x, y * stride + samples * x + 3)] };
}

/** How many colours are seen, and what part of the canvas is not as its corner. */
async function seen(page) {
  const picture = pixelsOf(await canvasOf(page).screenshot());
  const back = picture.at(6, 6).join();
  const colours = new Set();
  let drawn = 0;
  let all = 0;
  for (let y = 4; y < picture.height - 4; y += 2) {
    for (let x = 4; x < picture.width - 4; x += 2) {
      const colour = picture.at(x, y).join();
      ++all;
      if (colour === back) continue;
      ++drawn;
      colours.add(colour);
    }
  }
  return { share: drawn / all, colours: colours.size };
}

test('sub-domains are drawn in space, with colours, a legend and a summary', async () => {
  const { page, close } = await open('/jobs/job-8/shape');
  await allDrawn(page, 24);
  assert.equal(await number(page, 'triangles'), 24 * 12 + 2 * 8, 'those of boxes, and of the mark');
  const first = await seen(page);
  assert.ok(first.share > 0.05 && first.share < 0.9, `${first.share} of the canvas is drawn on`);
  assert.ok(first.colours >= 7, `${first.colours} colours`);
  assert.match(await page.locator('.shape-summary').innerText(), /24 of 24 sub-domains are here, 24 meshed\. Their boundaries have 96,000 triangles, of which 288/);
  const legend = page.locator('ul.legend li');
  assert.equal(await legend.count(), 24);
  await page.getByLabel('Colour by').selectOption('worker');
  await legend.first().getByText('worker-').waitFor();
  await page.getByLabel('Colour by').selectOption('seconds');
  await until(async () => (await legend.count()) === 6, 'six steps');
  await page.getByLabel('Colour by').selectOption('angle');
  await legend.getByText(/^\d+\.\d+° to/).first().waitFor();
  await page.getByLabel('Colour by').selectOption('state');
  await legend.getByText('meshed').waitFor();
  await page.getByLabel('Colour by').selectOption('patch');
  await legend.getByText('<script>window.hacked=1</script>').waitFor();
  await legend.getByText('cut between sub-domains').waitFor();
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  await close();
});

test('they are pulled apart, turned and zoomed, by pointer, keys and buttons', async () => {
  const { page, close } = await open('/jobs/job-8/shape');
  await allDrawn(page, 24);
  const picture = async () => {
    await page.waitForTimeout(200);
    return (await canvasOf(page).screenshot()).toString('base64');
  };
  let before = await picture();
  const changes = async (what, act) => {
    await act();
    const after = await picture();
    assert.notEqual(after, before, what);
    before = after;
  };
  await changes('pulled apart', () => page.getByLabel('Pulled apart').fill('120'));
  await canvasOf(page).focus();
  for (const key of ['ArrowLeft', 'ArrowUp', '+', 'Shift+ArrowRight', '0']) await changes(key, () => page.keyboard.press(key));
  assert.equal(await number(page, 'marks'), 1);
  await changes('no mark', () => page.getByLabel(/the smallest angle, 11\.27°, at 0\.3100, 0\.4200/).uncheck());
  assert.equal(await number(page, 'marks'), 0);
  for (const words of ['Zoom in', 'Turn right', 'Whole job']) await changes(words, () => page.getByRole('button', { name: words }).click());
  const box = await canvasOf(page).boundingBox();
  await changes('the wheel', async () => {
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.wheel(0, -300);
  });
  await changes('a drag', async () => {
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 30, { steps: 4 });
    await page.mouse.up();
  });
  await page.getByLabel('Pulled apart').fill('0');
  await page.getByRole('button', { name: 'Whole job' }).click();
  await page.waitForTimeout(200);
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.locator('.tip').getByText(/meshed, worker-\d+/).waitFor();
  await page.locator('.tip').getByRole('link').click();
  await page.waitForURL('**/tasks/*');
  await close();
});

test('sub-domains are added as they are made, and each is fetched once', async () => {
  const { mock, address } = await ownFarm();
  const { tasks } = mock.jobOf('job-10');
  const hidden = tasks.filter(({ kind }) => kind === 'mesh').slice(40);
  for (const task of hidden) task.kind = 'unborn';
  const { page, close } = await open('/jobs/job-10/shape', { base: address });
  await allDrawn(page, 40);
  for (const task of hidden) task.kind = 'mesh';
  mock.changeJob('job-10', { subdomains: 160 });
  await allDrawn(page, 160);
  const fetched = mock.requests.filter((line) => /surfaces\/\d+$/.test(line));
  assert.equal(fetched.length, 160);
  assert.equal(new Set(fetched).size, 160);
  await close();
});

test('a plane cuts what is drawn, by keys too, and the address remembers all that is set', async () => {
  const { address } = await ownFarm();
  const { page, close } = await open('/jobs/job-8/shape', { base: address });
  await allDrawn(page, 24);
  assert.equal(await number(page, 'lines'), 0);
  const whole = await seen(page);
  const axis = page.getByLabel('Cut across');
  await axis.focus();
  await page.keyboard.press('ArrowDown');
  await until(async () => (await number(page, 'lines')) > 0, 'lines where the plane goes through');
  const slider = page.getByRole('slider', { name: 'Cut at x = 0.5000' });
  await slider.focus();
  await page.keyboard.press('ArrowLeft');
  await page.getByRole('slider', { name: 'Cut at x = 0.4950' }).fill('20');
  await page.waitForTimeout(300);
  const part = await seen(page);
  assert.ok(part.share < 0.8 * whole.share, `${part.share} of ${whole.share} is left`);
  await page.getByLabel('Keep').selectOption('above');
  await page.getByLabel('Colour by').selectOption('patch');
  await page.getByLabel('Pulled apart').fill('30');
  await page.getByLabel(/the smallest angle/).uncheck();
  await page.waitForURL('**/jobs/job-8/shape#colour=patch&apart=30&marks=no&cut=x&at=20&keep=above');
  await page.reload();
  await allDrawn(page, 24);
  await page.getByRole('slider', { name: 'Cut at x = 0.2000' }).waitFor();
  assert.equal(await page.getByLabel('Keep').inputValue(), 'above');
  assert.equal(await page.getByLabel('Colour by').inputValue(), 'patch');
  assert.equal(await page.getByLabel('Pulled apart').inputValue(), '30');
  assert.equal(await page.getByLabel(/the smallest angle/).isChecked(), false);
  assert.ok((await number(page, 'lines')) > 0);
  await axis.selectOption('none');
  await until(async () => (await number(page, 'lines')) === 0, 'the whole');
  await close();
});

test('what the cut has taken away is not clicked at', async () => {
  const { address } = await ownFarm();
  const { page, close } = await open('/jobs/job-8/shape#cut=z&at=95&keep=above', { base: address });
  await allDrawn(page, 24);
  await canvasOf(page).click();
  await page.waitForTimeout(200);
  await page.locator('.tip').getByText('Drag or arrow keys').waitFor();
  await page.getByLabel('Keep').selectOption('below');
  await canvasOf(page).click();
  await page.locator('.tip').getByText(/meshed, worker-/).waitFor();
  await close();
});

test('defects are drawn where they are, in words too, over sub-domains and where there are none', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-7/shape', { base: address });
  await allDrawn(page, 8);
  await until(async () => (await number(page, 'overlays')) === 1, 'the defects');
  await page.getByText('2 triangles with defects').getByText('<b>self-intersection</b>').waitFor();
  await page.locator('ul.legend').getByText('open edge').waitFor();
  await page.getByLabel('defects', { exact: true }).uncheck();
  await until(async () => (await number(page, 'overlays')) === 0, 'no defects');
  await close();
  mock.jobOf('job-7').tasks.length = 1;
  const refused = await open('/jobs/job-7/shape', { base: address });
  await until(async () => (await number(refused.page, 'triangles')) === 2, 'two triangles', 30_000);
  assert.ok((await seen(refused.page)).colours >= 2);
  assert.equal(await refused.page.getByRole('table').count(), 0);
  await refused.close();
  mock.isMapGone = true;
  const gone = await open('/jobs/job-7/shape', { base: address });
  await gone.page.getByText('some.defects.vtp cannot be drawn').waitFor();
  await gone.close();
});

test('the wall is coloured by the layers that stand on it, where the job has a map of them', async () => {
  const { mock, address } = await ownFarm();
  const { page, close } = await open('/jobs/job-8/shape', { base: address });
  await allDrawn(page, 24);
  assert.ok(!mock.requests.some((line) => /maps\/\d/.test(line)), 'the map is not fetched before it is wanted');
  await page.getByLabel('Colour by').selectOption('layers');
  await until(async () => (await number(page, 'overlays')) === 1 && (await number(page, 'parts')) === 0, 'the wall alone');
  const legend = page.locator('ul.legend');
  await legend.getByText('no layers').waitFor();
  await legend.getByText('17 to 20 layers').waitFor();
  assert.ok((await seen(page)).colours >= 5);
  await close();
  const other = await open('/jobs/job-10/shape#colour=layers', { base: address });
  await allDrawn(other.page, 160);
  assert.equal(await other.page.getByLabel('Colour by').inputValue(), 'subdomain');
  await other.close();
});

test('what cannot be drawn is said: files that are gone, a store that is not seen, no WebGL', async () => {
  const { mock, address } = await ownFarm();
  mock.goneFiles = new Set(mock.jobOf('job-8').tasks.filter(({ kind }) => kind === 'mesh').slice(0, 3).map(({ path }) => path));
  const some = await open('/jobs/job-8/shape', { base: address });
  await some.page.getByText('3 sub-domains cannot be drawn').waitFor();
  await allDrawn(some.page, 21);
  await some.close();
  mock.seesFiles = false;
  const blind = await open('/jobs/job-8/shape', { base: address });
  await blind.page.getByText('does not see the files of the store').waitFor();
  assert.equal(await blind.page.getByRole('table').locator('tbody tr').count() > 0, true);
  await blind.close();
  mock.seesFiles = true;
  mock.goneFiles.clear();
  const { page, close } = await open('/', { base: address });
  await page.addInitScript(() => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind.startsWith('webgl') ? null : get.call(this, kind, ...rest);
    };
  });
  await page.goto(`${address}/jobs/job-8/shape`);
  await page.getByRole('alert').getByText('no WebGL').waitFor();
  await page.getByText('24 of 24 sub-domains are here').waitFor();
  await close();
});

test('three.js is loaded only by the page that draws in space', async () => {
  const { page, close } = await open('/jobs/job-8', { base: (await sharedFarm()).address });
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await page.getByRole('link', { name: 'Timeline' }).click();
  await page.waitForTimeout(500);
  assert.ok(!asked.includes('/shape_scene.js'));
  await page.getByRole('link', { name: 'In space' }).click();
  await allDrawn(page, 24);
  assert.ok(asked.includes('/shape_scene.js'));
  await close();
});
