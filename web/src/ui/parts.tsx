// Small parts that all pages use: states, names, bars, figures, errors, empty places.

import type { ComponentChildren } from 'preact';
import type { ApiError } from '../api/client';
import { clampedShare, percent } from '../logic/format';
import { harmlessName, harmlessText } from '../logic/harmless';
import type { Thing } from '../logic/states';
import { lookOf } from '../logic/states';
import { taskAddress } from '../logic/router';
import { colourOf } from '../logic/task_kinds';
import { Link } from './navigation';

export function State({ thing, state }: { thing: Thing; state: string }) {
  const look = lookOf(thing, state);
  return (
    <span class={`state ${look.tone}`}>
      <span class="symbol" aria-hidden="true">
        {look.symbol}
      </span>
      {look.word}
    </span>
  );
}

/** A name from outside: its direction of writing stays its own. */
export function Name({ text, longest }: { text: unknown; longest?: number }) {
  return <bdi class="name">{harmlessName(text, longest)}</bdi>;
}

export function Said({ text }: { text: unknown }) {
  return <bdi class="said">{harmlessText(text)}</bdi>;
}

export function Kind({ kind }: { kind: string }) {
  return (
    <span class="kind">
      <span class="swatch" style={{ backgroundColor: colourOf(kind) }} aria-hidden="true" />
      {harmlessName(kind, 40)}
    </span>
  );
}

export function TaskLink({ task }: { task: number }) {
  return task > 0 ? <Link to={taskAddress(task)}>{`#${task}`}</Link> : <span class="faint">–</span>;
}

interface BarProps {
  share: number | undefined;
  label: string;
  tone?: string;
}

export function Bar({ share, label, tone = 'active' }: BarProps) {
  const part = clampedShare(share);
  return (
    <span
      class={`bar ${tone}`}
      role="progressbar"
      aria-label={label}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.floor(100 * part)}
      aria-valuetext={percent(share)}
    >
      <span class="filled" style={{ width: `${100 * part}%` }} />
    </span>
  );
}

export interface FigureProps {
  words: string;
  children: ComponentChildren;
  hint?: ComponentChildren;
}

export function Figure({ words, children, hint }: FigureProps) {
  return (
    <div class="figure">
      <dt>{words}</dt>
      <dd>
        {children}
        {hint !== undefined && <small>{hint}</small>}
      </dd>
    </div>
  );
}

export function Figures({ children }: { children: ComponentChildren }) {
  return <dl class="figures">{children}</dl>;
}

/** A line of a list of words and values (`dl.pairs`). */
export function Pair({ words, children }: Pick<FigureProps, 'words' | 'children'>) {
  return (
    <div>
      <dt>{words}</dt>
      <dd>{children}</dd>
    </div>
  );
}

interface TroubleProps {
  error: ApiError | undefined;
  /** Something is shown from before: that nobody answers now is said by the banner alone. */
  isKnown?: boolean;
}

export function Trouble({ error, isKnown = false }: TroubleProps) {
  if (!error || (isKnown && (error.status === 503 || error.status === 0))) return null;
  return (
    <div class="callout bad" role="alert">
      <strong>
        <Said text={error.message} />
      </strong>
      {error.help && (
        <div>
          <Said text={error.help} />
        </div>
      )}
    </div>
  );
}

export function Empty({ children }: { children: ComponentChildren }) {
  return <p class="empty">{children}</p>;
}

export function Waiting({ what }: { what: string }) {
  return (
    <p class="empty" role="status">
      {what}
    </p>
  );
}
