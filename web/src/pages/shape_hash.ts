// The settings of the page in space, kept in its address behind '#'.

import { useEffect, useState } from 'preact/hooks';
import type { ShapeSettings } from '../logic/shape_settings';
import { hashOf, settingsOf } from '../logic/shape_settings';

/** Browsers take a bounded number of changes: while a slider moves, the last one counts. */
const writeAfterMs = 300;

export function useShapeSettings(): [ShapeSettings, (change: Partial<ShapeSettings>) => void] {
  const [settings, set] = useState(() => settingsOf(window.location.hash));
  useEffect(() => {
    const read = () => {
      if (window.location.hash === '' || window.location.hash.includes('=')) set(settingsOf(window.location.hash));
    };
    window.addEventListener('hashchange', read);
    return () => window.removeEventListener('hashchange', read);
  }, []);
  useEffect(() => {
    const { pathname } = window.location;
    const timer = window.setTimeout(() => {
      const hash = hashOf(settings);
      if (window.location.pathname !== pathname || window.location.hash === hash) return;
      window.history.replaceState(window.history.state, '', pathname + hash);
    }, writeAfterMs);
    return () => window.clearTimeout(timer);
  }, [settings]);
  return [settings, (change) => set((before) => ({ ...before, ...change }))];
}
