// Acts: a button, and one dialog for all of them that says what will happen, does it when that is
// confirmed, and tells what came of it. The dialog stays although its button may go meanwhile.

import type { ComponentChildren } from 'preact';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { ApiError, act } from '../api/client';
import { harmlessName } from '../logic/harmless';
import { Said } from './parts';

export interface ActProps {
  label: string;
  title: string;
  children: ComponentChildren;
  confirm: string;
  /** With a number, what comes before it. */
  path: string;
  /** That is asked for in the dialog. */
  number?: { words: string; value: number; least: number; most: number };
  isGrave?: boolean;
  /** In words, what the server's answer means. */
  outcome: (answer: Record<string, unknown>) => string;
  onDone?: () => void;
}

type Outcome = { text: string; help?: string; isBad: boolean };

let show: ((props: ActProps) => void) | undefined;

export function Act(props: ActProps) {
  return (
    <button
      type="button"
      class={props.isGrave ? 'button grave' : 'button'}
      onClick={() => show?.({ ...props })}
    >
      {props.label}
    </button>
  );
}

async function outcomeOf(props: ActProps, number: number): Promise<Outcome> {
  const path = props.number ? `${props.path}${number}` : props.path;
  try {
    return { text: props.outcome(await act<Record<string, unknown>>(path)), isBad: false };
  } catch (error) {
    if (error instanceof ApiError) return { text: error.message, help: error.help, isBad: true };
    throw error;
  }
}

function OutcomeText({ came }: { came: Outcome }) {
  return (
    <div class={came.isBad ? 'callout bad' : 'callout good'} role="status">
      <Said text={came.text} />
      {came.help && (
        <div>
          <Said text={came.help} />
        </div>
      )}
    </div>
  );
}

interface NumberProps {
  asked: NonNullable<ActProps['number']>;
  value: number;
  onChange: (value: number) => void;
}

function NumberField({ asked, value, onChange }: NumberProps) {
  return (
    <label class="field">
      <span>{asked.words}</span>
      <input
        type="number"
        step={1}
        min={asked.least}
        max={asked.most}
        value={Number.isNaN(value) ? '' : value}
        onInput={(event) => onChange(event.currentTarget.valueAsNumber)}
      />
    </label>
  );
}

function isAllowed(asked: ActProps['number'], value: number): boolean {
  return !asked || (Number.isInteger(value) && value >= asked.least && value <= asked.most);
}

function ActDialog({ props, onClose }: { props: ActProps; onClose: () => void }) {
  const [isBusy, busy] = useState(false);
  const [came, set] = useState<Outcome>();
  const [number, take] = useState(props.number?.value ?? 0);
  const dialog = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => dialog.current?.showModal(), []);
  const go = async () => {
    busy(true);
    const outcome = await outcomeOf(props, number);
    busy(false);
    set(outcome);
    if (!outcome.isBad) props.onDone?.();
  };
  const close = () => {
    dialog.current?.close();
    onClose();
  };
  const title = harmlessName(props.title, 120);
  return (
    <dialog ref={dialog} aria-label={title} onClose={onClose}>
      <h2>{title}</h2>
      {came ? <OutcomeText came={came} /> : <div>{props.children}</div>}
      {!came && props.number && <NumberField asked={props.number} value={number} onChange={take} />}
      <div class="row end">
        <button type="button" class="button" onClick={close}>
          {came ? 'Close' : 'Leave it'}
        </button>
        {!came && (
          <button
            type="button"
            class={props.isGrave ? 'button grave filled' : 'button filled'}
            disabled={isBusy || !isAllowed(props.number, number)}
            onClick={() => void go()}
          >
            {props.confirm}
          </button>
        )}
      </div>
    </dialog>
  );
}

/** Once in the frame of the page. */
export function ActLayer() {
  const [props, set] = useState<ActProps>();
  useEffect(() => {
    show = set;
    return () => {
      show = undefined;
    };
  }, []);
  // Each opening is an object of its own, so that the late end of one does not end the next.
  const close = () => set((shown) => (shown === props ? undefined : shown));
  return props ? <ActDialog props={props} onClose={close} /> : null;
}

export function countOf(answer: Record<string, unknown>): number {
  return typeof answer.count === 'number' ? answer.count : 0;
}
