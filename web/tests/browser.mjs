// Tests of the built pages in a real Chromium. Against the made-up farm of mock_server.mjs, or, with
// TETFARM_DASHBOARD_URL, those that need no certain farm against that server.
//   TETFARM_CHROMIUM      the browser, /usr/bin/chromium
//   TETFARM_BROWSER_ONLY  only these files, such as "acts,live"
//   TETFARM_PICTURES      a folder that pictures are written to

import { after } from 'node:test';
import { closeAll, isReal } from './browser/support.mjs';

const needNoCertainFarm = ['every_page'];
const others = ['views', 'shape', 'large_job', 'live', 'acts', 'hostile', 'keyboard', 'pictures'];
const wanted = process.env.TETFARM_BROWSER_ONLY?.split(',');

for (const name of isReal ? needNoCertainFarm : [...needNoCertainFarm, ...others]) {
  if (!wanted || wanted.includes(name)) await import(`./browser/${name}.mjs`);
}

after(closeAll);
