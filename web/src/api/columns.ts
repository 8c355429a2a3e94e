// Tables that come by columns, page by page: kept as one array for each column, with texts that
// repeat (kinds, states, hosts) held once. What is not of the expected form becomes 0 or "".

import { get, inAddress } from './client';

export interface Page {
  columns: string[];
  rows: unknown[][];
  next: number;
}

export const rowsOfPage = 20_000;
/** More than any job has; a server that never ends is not believed. */
export const mostRows = 2_000_000;

export class ColumnTable {
  count = 0;
  private readonly numbers = new Map<string, number[]>();
  private readonly texts = new Map<string, string[]>();
  private readonly known = new Map<string, string>();

  constructor(numberColumns: readonly string[], textColumns: readonly string[]) {
    for (const name of numberColumns) this.numbers.set(name, []);
    for (const name of textColumns) this.texts.set(name, []);
  }

  get columns(): string[] {
    return [...this.numbers.keys(), ...this.texts.keys()];
  }

  append(page: Page): void {
    const rows = Array.isArray(page.rows) ? page.rows : [];
    const place = (name: string) => (Array.isArray(page.columns) ? page.columns.indexOf(name) : -1);
    for (const [name, values] of this.numbers) {
      const at = place(name);
      for (const row of rows) values.push(Number(row[at] ?? 0) || 0);
    }
    for (const [name, values] of this.texts) {
      const at = place(name);
      for (const row of rows) values.push(this.once(row[at]));
    }
    this.count += rows.length;
  }

  number(name: string): readonly number[] {
    return this.numbers.get(name) ?? [];
  }

  text(name: string): readonly string[] {
    return this.texts.get(name) ?? [];
  }

  private once(value: unknown): string {
    const text = typeof value === 'string' ? value : '';
    const known = this.known.get(text);
    if (known !== undefined) return known;
    this.known.set(text, text);
    return text;
  }
}

export interface Columns {
  numbers: readonly string[];
  texts: readonly string[];
}

export const taskColumns: Columns = {
  numbers: ['task', 'path', 'attempt', 'errors', 'losses', 'out_of_memory', 'seconds',
    'peak_rss_bytes', 'expected_seconds', 'cpu_seconds', 'expected_bytes', 'expected_elements',
    'elements', 'min_dihedral_deg', 'share'],
  texts: ['kind', 'state', 'worker', 'host', 'message', 'doing'],
};

export const attemptColumns: Columns = {
  numbers: ['attempt', 'task', 'path', 'process', 'started_ms', 'ended_ms', 'peak_rss_bytes'],
  texts: ['kind', 'state', 'worker', 'host'],
};

/** All pages of a job's `what`; `seen` is told how many rows have come so far. */
export async function fetchTable(
  job: string,
  what: 'tasks' | 'attempts',
  columns: Columns,
  signal: AbortSignal,
  seen: (rows: number) => void,
): Promise<ColumnTable> {
  const table = new ColumnTable(columns.numbers, columns.texts);
  let after = 0;
  do {
    const page = await get<Page>(
      `/jobs/${inAddress(job)}/${what}?columns=${table.columns.join(',')}` +
        `&after=${after}&limit=${rowsOfPage}`,
      signal,
    );
    table.append(page);
    seen(table.count);
    if (!(page.next > after)) break;
    after = page.next;
  } while (table.count < mostRows);
  return table;
}
