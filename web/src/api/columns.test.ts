import { afterEach, describe, expect, it, vi } from 'vitest';
import type { Page } from './columns';
import { ColumnTable, fetchTable } from './columns';

const columns = { numbers: ['task', 'seconds'], texts: ['kind'] };

afterEach(() => vi.unstubAllGlobals());

function serving(pages: Page[]) {
  const asked: string[] = [];
  vi.stubGlobal('fetch', async (address: string) => {
    asked.push(address);
    return new Response(JSON.stringify(pages[asked.length - 1]));
  });
  return asked;
}

describe('a table by columns', () => {
  it('takes columns by name, in whatever order they come', () => {
    const table = new ColumnTable(columns.numbers, columns.texts);
    table.append({ columns: ['kind', 'task'], rows: [['mesh', 7]], next: 0 });
    expect([table.number('task')[0], table.text('kind')[0], table.number('seconds')[0]]).toEqual([7, 'mesh', 0]);
  });
  it('makes 0 and nothing of what is of another form', () => {
    const table = new ColumnTable(columns.numbers, columns.texts);
    table.append({ columns: ['task', 'kind', 'seconds'], rows: [['x', 5, null], [{}, null, 'NaN'], []], next: 0 });
    expect([...table.number('task')]).toEqual([0, 0, 0]);
    expect([...table.text('kind')]).toEqual(['', '', '']);
    table.append({ columns: null, rows: 'no' } as unknown as Page);
    expect(table.count).toBe(3);
  });
  it('is fetched page by page', async () => {
    const asked = serving([
      { columns: ['task'], rows: [[1], [2]], next: 2 },
      { columns: ['task'], rows: [[3]], next: 0 },
    ]);
    const seen: number[] = [];
    const table = await fetchTable('a/b', 'tasks', columns, new AbortController().signal, (n) => seen.push(n));
    expect(table.count).toBe(3);
    expect(seen).toEqual([2, 3]);
    expect(asked[0]).toBe('/api/v1/jobs/a%2Fb/tasks?columns=task,seconds,kind&after=0&limit=20000');
    expect(asked[1]).toContain('after=2');
  });
  it('does not go round in circles after a server that does', async () => {
    const page = { columns: ['task'], rows: [[1]], next: 1 };
    const asked = serving([page, page, page, page]);
    await fetchTable('j', 'tasks', columns, new AbortController().signal, () => undefined);
    expect(asked.length).toBe(2);
  });
});
