import { describe, expect, it } from 'vitest';
import { SurfaceLoader } from './surface_loader';
import type { SurfaceLine } from './types';

const line = (path: number, hash = `h${path}`, isThere = true): SurfaceLine => ({
  path, place: '', state: 'leaf', meshed: false, hash, bytes: 1, is_there: isThere,
});

function emptySurface(): ArrayBuffer {
  const bytes = new ArrayBuffer(48);
  [...'TFSHOWN\n\u0001'].forEach((letter, i) => new DataView(bytes).setUint8(i, letter.charCodeAt(0)));
  return bytes;
}

/** A server whose answers come when they are told to. */
function slowServer() {
  const asked: { path: string; answer: (bytes: ArrayBuffer) => void; fail: (error: Error) => void }[] = [];
  const fetching = (path: string) =>
    new Promise<ArrayBuffer>((answer, fail) => asked.push({ path, answer, fail }));
  return { asked, fetching };
}

const settle = () => new Promise((go) => setTimeout(go, 0));
const pathsOf = (loader: SurfaceLoader) => loader.loaded().map((one) => one.line.path);

describe('SurfaceLoader', () => {
  it('asks for three at once, for each once, and not for what is not there', async () => {
    const { asked, fetching } = slowServer();
    const loader = new SurfaceLoader('job-1', () => undefined, fetching);
    const lines = [line(2), line(3), line(4), line(5), line(6, 'h6', false)];
    loader.update(lines, 512);
    loader.update(lines, 512);
    expect(asked.map(({ path }) => path)).toEqual([2, 3, 4].map((n) => `/jobs/job-1/surfaces/${n}?triangles=512`));
    expect(loader.toCome()).toBe(4);
    asked[0]!.answer(emptySurface());
    await settle();
    expect(asked).toHaveLength(4);
    for (const one of asked.slice(1)) one.answer(emptySurface());
    await settle();
    expect(pathsOf(loader)).toEqual([2, 3, 4, 5]);
    expect(loader.toCome()).toBe(0);
    loader.update(lines, 512);
    expect(asked).toHaveLength(4);
  });

  it('drops what is no longer listed, and fetches a file that is another', async () => {
    const { asked, fetching } = slowServer();
    const loader = new SurfaceLoader('job-1', () => undefined, fetching);
    loader.update([line(1)], 512);
    asked[0]!.answer(emptySurface());
    await settle();
    loader.update([line(2), line(3)], 512);
    expect(pathsOf(loader)).toEqual([]);
    for (const one of asked.slice(1)) one.answer(emptySurface());
    await settle();
    loader.update([line(2), line(3, 'another')], 512);
    expect(pathsOf(loader)).toEqual([2]);
    expect(asked).toHaveLength(4);
  });

  it('says what failed, and goes on with the others', async () => {
    const { asked, fetching } = slowServer();
    let changes = 0;
    const loader = new SurfaceLoader('job-1', () => ++changes, fetching);
    loader.update([line(2), line(3), line(4), line(5)], 512);
    asked[0]!.fail(new Error('it is gone'));
    asked[1]!.answer(new ArrayBuffer(3));
    await settle();
    for (const one of asked.slice(2)) one.answer(emptySurface());
    await settle();
    expect(loader.failed()).toEqual({ count: 2, trouble: 'it is gone' });
    expect(pathsOf(loader)).toEqual([4, 5]);
    expect(changes).toBeGreaterThan(3);
  });

  it('is silent once it is stopped', async () => {
    const { asked, fetching } = slowServer();
    let changes = 0;
    const loader = new SurfaceLoader('job-1', () => ++changes, fetching);
    loader.update([line(2), line(3), line(4), line(5)], 512);
    changes = 0;
    loader.stop();
    asked[0]!.answer(emptySurface());
    await settle();
    expect(changes).toBe(0);
    expect(asked).toHaveLength(3);
  });
});
