// Brings the maps of a job that a page draws, one after the other, each once: their files never change.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { ShownSurface } from '../logic/shown_surface';
import { parseShownSurface } from '../logic/shown_surface';
import { getBytes, inAddress, isAbort } from './client';
import type { MapLine } from './types';

export interface LoadedMap {
  line: MapLine;
  surface: ShownSurface;
}

interface Brought {
  loaded: readonly LoadedMap[]; // of those that are wanted
  trouble: string; // of the last that did not come
}

const none: Brought = { loaded: [], trouble: '' };

/** Those that are wanted and have come. `triangles`: of each, at most. */
export function useMapSurfaces(job: string, wanted: readonly MapLine[], triangles: number): Brought {
  const brought = useRef(new Map<string, ShownSurface>());
  const [state, set] = useState<Brought>(none);
  const key = wanted.map(({ hash }) => hash).join();
  useEffect(() => {
    const stop = new AbortController();
    const loadedNow = () =>
      wanted.flatMap((line) => (brought.current.has(line.hash) ? [{ line, surface: brought.current.get(line.hash)! }] : []));
    const bring = async () => {
      let trouble = '';
      for (const { map, hash } of wanted) {
        if (brought.current.has(hash)) continue;
        try {
          const path = `/jobs/${inAddress(job)}/maps/${map}?triangles=${triangles}`;
          brought.current.set(hash, parseShownSurface(await getBytes(path, stop.signal)));
        } catch (error) {
          if (isAbort(error)) return;
          trouble = error instanceof Error ? error.message : String(error);
        }
      }
      if (!stop.signal.aborted) set({ loaded: loadedNow(), trouble });
    };
    void bring();
    return () => stop.abort();
  }, [job, key, triangles]);
  return key === '' ? none : state;
}
