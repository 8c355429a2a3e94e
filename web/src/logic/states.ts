// The states of tasks, attempts, jobs and workers: the word that people read, a symbol (so that
// nothing is told by colour alone), and the tone of its colour.

import { harmlessName } from './harmless';

export type Tone = 'good' | 'active' | 'ready' | 'quiet' | 'bad';

export interface Look {
  word: string;
  symbol: string;
  tone: Tone;
}

const look = (word: string, symbol: string, tone: Tone): Look => ({ word, symbol, tone });

const taskLooks: Record<string, Look> = {
  done: look('done', '✓', 'good'),
  leased: look('running', '▶', 'active'),
  ready: look('ready', '○', 'ready'),
  waiting: look('waiting', '·', 'quiet'),
  failed: look('failed', '✕', 'bad'),
  replaced: look('replaced', '⇄', 'quiet'),
};

const attemptLooks: Record<string, Look> = {
  running: look('running', '▶', 'active'),
  done: look('done', '✓', 'good'),
  failed: look('failed', '✕', 'bad'),
  crashed: look('crashed', '✕', 'bad'),
  killed: look('killed', '✕', 'bad'),
  lost: look('lost', '?', 'bad'),
  starved: look('starved', '✕', 'bad'),
  returned: look('returned', '↩', 'quiet'),
  revoked: look('revoked', '↩', 'quiet'),
};

const jobLooks: Record<string, Look> = {
  waiting: look('waiting', '·', 'quiet'),
  running: look('running', '▶', 'active'),
  done: look('done', '✓', 'good'),
  failed: look('failed', '✕', 'bad'),
  cancelled: look('cancelled', '■', 'quiet'),
  stuck: look('stuck', '!', 'ready'),
};

const workerLooks: Record<string, Look> = {
  busy: look('busy', '▶', 'active'),
  idle: look('idle', '○', 'quiet'),
  drains: look('drains', '↩', 'ready'),
  gone: look('gone', '×', 'quiet'),
};

const all = { task: taskLooks, attempt: attemptLooks, job: jobLooks, worker: workerLooks };
export type Thing = keyof typeof all;

/** A state that is not known is shown quietly as it came, harmless. */
export function lookOf(thing: Thing, state: string): Look {
  const looks = all[thing];
  return Object.hasOwn(looks, state) ? looks[state]! : look(harmlessName(state, 40), '?', 'quiet');
}

export const taskStates = Object.keys(taskLooks);
export const jobStates = Object.keys(jobLooks);

/** An attempt whose work came to nothing. */
export function isLostAttempt(state: string): boolean {
  return state !== 'done' && state !== 'running';
}

/** Whether a job may still change by itself. */
export function isJobLive(state: string): boolean {
  return state === 'running' || state === 'stuck' || state === 'waiting';
}
