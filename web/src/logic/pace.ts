// How often to ask again. A server that needs long for an answer is asked less often, so that this
// page takes at most about a tenth of its time.

export const leastPauseMs = 3000;
const mostPauseMs = 300_000;
const backoff = 10;

/** Milliseconds from the end of a fetch to the next one. */
export function pauseAfter(fetchMs: number, least = leastPauseMs): number {
  if (!(fetchMs >= 0)) return least;
  return Math.min(mostPauseMs, Math.max(least, backoff * fetchMs));
}

/** Milliseconds before the n-th attempt (from 0) to reconnect: 1, 2, 4 … 30 s. */
export function pauseBeforeReconnect(attempt: number): number {
  return Math.min(30_000, 1000 * 2 ** Math.max(0, Math.min(attempt, 10)));
}
