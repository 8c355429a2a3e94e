// Brings the surfaces of sub-domains that a page draws, a few at once, each once. Those that are no
// longer listed go. One that fails is tried again only when its file is another.

import type { ShownSurface } from '../logic/shown_surface';
import { parseShownSurface } from '../logic/shown_surface';
import { getBytes, inAddress, isAbort } from './client';
import type { SurfaceLine } from './types';

export interface LoadedSurface {
  line: SurfaceLine;
  surface: ShownSurface;
}

interface Entry {
  line: SurfaceLine;
  surface?: ShownSurface;
  trouble?: string;
}

type Fetching = (path: string, signal: AbortSignal) => Promise<ArrayBuffer>;

const atOnce = 3;

export class SurfaceLoader {
  private readonly entries = new Map<number, Entry>();
  private readonly waiting: SurfaceLine[] = [];
  private readonly stopped = new AbortController();
  private busy = 0;
  private triangles = 1024;

  constructor(
    private readonly job: string,
    private readonly changed: () => void,
    private readonly fetching: Fetching = getBytes,
  ) {}

  /** What there is now, and how many triangles to ask for of each. */
  update(lines: readonly SurfaceLine[], triangles: number): void {
    this.triangles = triangles;
    const path2line = new Map(lines.filter((line) => line.is_there).map((line) => [line.path, line]));
    for (const [path, entry] of this.entries) {
      if (path2line.get(path)?.hash !== entry.line.hash) this.entries.delete(path);
    }
    this.waiting.length = 0;
    for (const line of path2line.values()) {
      const entry = this.entries.get(line.path);
      if (entry) entry.line = line;
      else this.waiting.push(line);
    }
    this.changed();
    this.goOn();
  }

  loaded(): LoadedSurface[] {
    return [...this.entries.values()].filter((entry): entry is LoadedSurface => entry.surface !== undefined);
  }

  /** How many did not come, and what was wrong with one of them. */
  failed(): { count: number; trouble: string } {
    const wrong = [...this.entries.values()].filter(({ trouble }) => trouble !== undefined);
    return { count: wrong.length, trouble: wrong[0]?.trouble ?? '' };
  }

  /** How many are still to come. */
  toCome(): number {
    return this.waiting.length + this.busy;
  }

  stop(): void {
    this.waiting.length = 0;
    this.stopped.abort();
  }

  private goOn(): void {
    while (this.busy < atOnce && this.waiting.length > 0) {
      const line = this.waiting.shift()!;
      if (!this.entries.has(line.path)) void this.bring(line);
    }
  }

  private async bring(line: SurfaceLine): Promise<void> {
    const entry: Entry = { line };
    this.entries.set(line.path, entry);
    ++this.busy;
    try {
      const path = `/jobs/${inAddress(this.job)}/surfaces/${line.path}?triangles=${this.triangles}`;
      entry.surface = parseShownSurface(await this.fetching(path, this.stopped.signal));
    } catch (error) {
      if (!isAbort(error)) entry.trouble = error instanceof Error ? error.message : String(error);
    }
    --this.busy;
    if (this.stopped.signal.aborted) return;
    this.changed();
    this.goOn();
  }
}
