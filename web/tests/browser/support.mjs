// What the tests share: one browser, one made-up farm, and pages that note everything that went
// wrong in them (errors, console errors, violations of the Content-Security-Policy).

import assert from 'node:assert/strict';
import { chromium } from 'playwright-core';
import { MockServer } from '../mock_server.mjs';

export const realAddress = process.env.TETFARM_DASHBOARD_URL?.replace(/\/$/, '');
export const isReal = Boolean(realAddress);

const flags = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

let browser;
let shared;
const servers = [];

async function theBrowser() {
  browser ??= await chromium.launch({
    executablePath: process.env.TETFARM_CHROMIUM || '/usr/bin/chromium',
    headless: true,
    args: flags,
  });
  return browser;
}

/** A farm of the test's own, small unless it says otherwise. */
export async function ownFarm(options = {}) {
  const mock = new MockServer({ largeLeaves: 40, ...options });
  const address = await mock.start();
  servers.push(mock);
  return { mock, address };
}

/** The farm with the large job, which no test changes. */
export async function sharedFarm() {
  shared ??= await ownFarm({ largeLeaves: 20_000 });
  return shared;
}

export async function address() {
  return realAddress ?? (await sharedFarm()).address;
}

/** A page at `path`; `mayFail`: requests may be refused or answered with errors. */
export async function open(path, { base, mayFail = false, ...options } = {}) {
  const context = await (await theBrowser()).newContext({
    viewport: { width: 1280, height: 800 },
    timezoneId: 'UTC',
    ...options,
  });
  const page = await context.newPage();
  const problems = [];
  page.on('pageerror', (error) => problems.push(`error: ${error.message}`));
  page.on('console', (message) => {
    const text = message.text();
    if (!['error', 'warning'].includes(message.type())) return;
    // The browser says this of its own pictures, where WebGL is software.
    if (/GPU stall due to ReadPixels/.test(text)) return;
    if (mayFail && /Failed to load resource|net::ERR/.test(text)) return;
    problems.push(`${message.type()}: ${text}`);
  });
  await page.addInitScript(() => {
    window.violations = [];
    document.addEventListener('securitypolicyviolation', (event) => {
      window.violations.push(`${event.violatedDirective} ${event.blockedURI}`);
    });
  });
  page.setDefaultTimeout(15_000);
  await page.goto((base ?? (await address())) + path);
  return {
    page,
    /** To be called at the end of each test. */
    async close() {
      const violations = await page.evaluate(() => window.violations);
      await context.close();
      assert.deepEqual([...problems, ...violations], []);
    },
  };
}

/** Waits until `question` holds; tells `what` it waited for when it does not. */
export async function until(question, what, ms = 10_000) {
  const end = Date.now() + ms;
  while (Date.now() < end) {
    if (await question()) return;
    await new Promise((go) => setTimeout(go, 50));
  }
  assert.fail(`waited in vain for ${what}`);
}

/** A number that a canvas says of its last drawing. */
export async function told(page, name) {
  return Number(await page.locator('canvas.surface').getAttribute(`data-${name}`));
}

export async function drawn(page) {
  await until(async () => (await told(page, 'bars')) > 0, 'the first drawing', 20_000);
}

/** The heading is there, and nothing waits any more. */
export async function settled(page) {
  await page.locator('h1').first().waitFor();
  await until(async () => (await page.getByText(/^Asking for/).count()) === 0, 'the answers');
  await page.waitForTimeout(150);
}

export async function closeAll() {
  await browser?.close();
  for (const mock of servers) await mock.stop().catch(() => undefined);
}
