// Pictures of the pages for the documentation, into the folder TETFARM_PICTURES.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { drawn, open, ownFarm, settled } from './support.mjs';

const folder = process.env.TETFARM_PICTURES;
const pictures = [
  ['jobs', '/'],
  ['tree', '/jobs/job-10'],
  ['shape', '/jobs/job-8/shape#apart=15&cut=z&at=60'],
  ['timeline', '/jobs/job-10/timeline'],
  ['workers', '/workers'],
];

test('pictures of the pages', { skip: folder ? false : 'TETFARM_PICTURES is not set' }, async () => {
  mkdirSync(folder, { recursive: true });
  const { mock, address } = await ownFarm();
  mock.farm.jobs = mock.farm.jobs.filter(({ job }) => !['job-2', 'job-3', 'job-4', 'job-5', 'job-6'].includes(job.job));
  for (const [name, path] of pictures) {
    const { page, close } = await open(path, { base: address, colorScheme: 'light' });
    await settled(page);
    if (path.includes('/shape')) {
      await page.locator('canvas.shape').scrollIntoViewIfNeeded();
    } else if (path.startsWith('/jobs')) {
      await drawn(page);
    }
    await page.waitForTimeout(800);
    await page.screenshot({ path: join(folder, `dashboard_${name}.png`) });
    await close();
  }
});
