import { afterEach, describe, expect, it, vi } from 'vitest';
import { ApiError, act, get } from './client';

afterEach(() => vi.unstubAllGlobals());

const answering = (body: string, status: number) =>
  vi.stubGlobal('fetch', vi.fn(async () => new Response(body, { status })));

async function failure(of: Promise<unknown>): Promise<ApiError> {
  return of.then(
    () => expect.unreachable(),
    (error: unknown) => error as ApiError,
  );
}

describe('requests', () => {
  it('say what the server says is wrong, and what to do', async () => {
    answering('{"error":"no such job","help":"list them"}', 404);
    const error = await failure(get('/jobs/x'));
    expect([error.message, error.help, error.status]).toEqual(['no such job', 'list them', 404]);
  });
  it('say so when the answer cannot be read', async () => {
    answering('<html>', 502);
    expect((await failure(get('/jobs'))).message).toContain('cannot be read (status 502)');
  });
  it('say so when there is no answer', async () => {
    vi.stubGlobal('fetch', async () => Promise.reject(new TypeError('failed')));
    expect((await failure(get('/jobs'))).status).toBe(0);
  });
  it('that act are POSTs with the header that the server wants', async () => {
    answering('{"count":1}', 200);
    await act('/jobs/j/retry');
    const [address, init] = vi.mocked(fetch).mock.calls[0]!;
    expect(address).toBe('/api/v1/jobs/j/retry');
    expect(init).toMatchObject({ method: 'POST', headers: { 'X-Tetfarm-Act': 'yes' } });
  });
});
