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
  path: string;
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

async function outcomeOf(props: ActProps): Promise<Outcome> {
  try {
    return { text: props.outcome(await act<Record<string, unknown>>(props.path)), isBad: false };
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

function ActDialog({ props, onClose }: { props: ActProps; onClose: () => void }) {
  const [isBusy, busy] = useState(false);
  const [came, set] = useState<Outcome>();
  const dialog = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => dialog.current?.showModal(), []);
  const go = async () => {
    busy(true);
    const outcome = await outcomeOf(props);
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
      <div class="row end">
        <button type="button" class="button" onClick={close}>
          {came ? 'Close' : 'Leave it'}
        </button>
        {!came && (
          <button
            type="button"
            class={props.isGrave ? 'button grave filled' : 'button filled'}
            disabled={isBusy}
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
