// Lines above every page while something is not as it should be: the server is away, the
// coordinator does not answer, the store is at rest, nothing is accepted.

import type { ComponentChildren } from 'preact';
import { useLive } from './api/hooks';
import { moment } from './logic/format';
import { Said } from './ui/parts';

function Banner({ tone, children }: { tone: string; children: ComponentChildren }) {
  return (
    <div class={`banner ${tone}`} role="status">
      {children}
    </div>
  );
}

export function Banners() {
  const { link, farm, heardMs } = useLive();
  if (link === 'lost') {
    return (
      <Banner tone="bad">
        <strong>The dashboard’s server cannot be reached.</strong> Trying again by itself.
        {heardMs > 0 && ` What is shown is of ${moment(heardMs)}.`}
      </Banner>
    );
  }
  if (!farm) return null;
  if (!farm.connected && !farm.at_rest) {
    return (
      <Banner tone="bad">
        <strong>The coordinator does not answer.</strong>{' '}
        {farm.trouble && <Said text={`${farm.trouble}. `} />}
        What is shown is the last that it said; it is asked again by itself.
      </Banner>
    );
  }
  return (
    <>
      {farm.at_rest && (
        <Banner tone="quiet">
          <strong>At rest.</strong> No coordinator runs: this is the store as it was left.
        </Banner>
      )}
      {farm.trouble && (
        <Banner tone="ready">
          <strong>Nothing is handed out.</strong> <Said text={farm.trouble} />
        </Banner>
      )}
    </>
  );
}
