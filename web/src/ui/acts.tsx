// Acts: a button that says in a dialog what will happen, does it when that is confirmed, and tells
// what came of it.

import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { ApiError, act } from '../api/client';
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

async function outcomeOf(props: ActProps): Promise<Outcome> {
  try {
    return { text: props.outcome(await act<Record<string, unknown>>(props.path)), isBad: false };
  } catch (error) {
    if (error instanceof ApiError) return { text: error.message, help: error.help, isBad: true };
    throw error;
  }
}

export function Act(props: ActProps) {
  const [isOpen, open] = useState(false);
  const [isBusy, busy] = useState(false);
  const [came, set] = useState<Outcome>();
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (isOpen) dialog.current?.showModal();
  }, [isOpen]);
  const close = () => {
    dialog.current?.close();
    open(false);
    set(undefined);
  };
  const go = async () => {
    busy(true);
    const outcome = await outcomeOf(props);
    busy(false);
    set(outcome);
    if (!outcome.isBad) props.onDone?.();
  };
  return (
    <>
      <button type="button" class={props.isGrave ? 'button grave' : 'button'} onClick={() => open(true)}>
        {props.label}
      </button>
      {isOpen && (
        <dialog ref={dialog} aria-label={props.title} onClose={close}>
          <h2>{props.title}</h2>
          {came ? (
            <div class={came.isBad ? 'callout bad' : 'callout good'} role="status">
              <Said text={came.text} />
              {came.help && (
                <div>
                  <Said text={came.help} />
                </div>
              )}
            </div>
          ) : (
            <div>{props.children}</div>
          )}
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
      )}
    </>
  );
}

export function countOf(answer: Record<string, unknown>): number {
  return typeof answer.count === 'number' ? answer.count : 0;
}
