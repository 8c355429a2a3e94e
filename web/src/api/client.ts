// Requests to /api/v1. What goes wrong is an ApiError that says what is wrong and what to do.

export class ApiError extends Error {
  readonly help: string;
  readonly status: number;

  constructor(message: string, help: string, status: number) {
    super(message);
    this.help = help;
    this.status = status;
  }
}

const base = '/api/v1';

/** A part of an address, of a name that anybody may have given. */
export const inAddress = encodeURIComponent;

async function answerOf(response: Response): Promise<unknown> {
  let body: unknown;
  try {
    body = await response.json();
  } catch {
    throw new ApiError(
      `the server's answer cannot be read (status ${response.status})`,
      'see whether this address is that of `tetfarm dashboard`',
      response.status,
    );
  }
  if (response.ok) return body;
  const said = (typeof body === 'object' && body !== null ? body : {}) as Record<string, unknown>;
  throw new ApiError(
    typeof said.error === 'string' ? said.error : `the server answered ${response.status}`,
    typeof said.help === 'string' ? said.help : '',
    response.status,
  );
}

async function responseTo(path: string, init: RequestInit): Promise<Response> {
  try {
    return await fetch(base + path, { credentials: 'same-origin', cache: 'no-store', ...init });
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') throw error;
    throw new ApiError(
      'the dashboard’s server cannot be reached',
      'see whether `tetfarm dashboard` still runs',
      0,
    );
  }
}

async function request(path: string, init: RequestInit): Promise<unknown> {
  return answerOf(await responseTo(path, init));
}

export async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await request(path, signal ? { signal } : {})) as T;
}

/** An answer that is not JSON. */
export async function getBytes(path: string, signal?: AbortSignal): Promise<ArrayBuffer> {
  const response = await responseTo(path, signal ? { signal } : {});
  if (!response.ok) await answerOf(response);
  return response.arrayBuffer();
}

/** An act: the server takes it only with this header, which no form of another site can send. */
export async function act<T>(path: string): Promise<T> {
  return (await request(path, { method: 'POST', headers: { 'X-Tetfarm-Act': 'yes' } })) as T;
}

export function isAbort(error: unknown): boolean {
  return error instanceof DOMException && error.name === 'AbortError';
}
