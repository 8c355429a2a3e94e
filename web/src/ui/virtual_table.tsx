// A table of any length of which only the rows in view are in the document. Its head sorts; the
// scrolling part takes the keys of the browser.

import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { rowsInView } from '../logic/sort_filter';

export interface Column {
  key: string;
  words: string;
  isNumber?: boolean;
  /** Left out on narrow screens. */
  isExtra?: boolean;
  cell: (row: number) => ComponentChildren;
}

export interface Sorting {
  key: string;
  descending: boolean;
}

interface TableProps {
  label: string;
  columns: readonly Column[];
  rows: Uint32Array;
  rowKey: (row: number) => number;
  sorting: Sorting;
  onSort: (sorting: Sorting) => void;
  onOpen: (row: number) => void;
}

const rowHeight = 32;

function cellClass(column: Column): string {
  return `${column.isNumber ? 'number' : ''} ${column.isExtra ? 'extra' : ''}`.trim();
}

function Head({ columns, sorting, onSort }: Pick<TableProps, 'columns' | 'sorting' | 'onSort'>) {
  return (
    <thead>
      <tr aria-rowindex={1}>
        {columns.map((column) => {
          const isBy = sorting.key === column.key;
          const order = isBy ? (sorting.descending ? 'descending' : 'ascending') : 'none';
          return (
            <th key={column.key} scope="col" class={cellClass(column)} aria-sort={order}>
              <button
                type="button"
                class="sort"
                onClick={() =>
                  onSort({
                    key: column.key,
                    descending: isBy ? !sorting.descending : column.isNumber === true,
                  })
                }
              >
                {column.words}
                <span aria-hidden="true" class="order">
                  {isBy ? (sorting.descending ? '↓' : '↑') : ''}
                </span>
              </button>
            </th>
          );
        })}
      </tr>
    </thead>
  );
}

export function VirtualTable(props: TableProps) {
  const { label, columns, rows, rowKey, onOpen } = props;
  const scroller = useRef<HTMLDivElement>(null);
  const [view, set] = useState({ top: 0, height: 600 });
  useEffect(() => {
    const element = scroller.current!;
    const look = () => set({ top: element.scrollTop, height: element.clientHeight });
    const sizes = new ResizeObserver(look);
    sizes.observe(element);
    element.addEventListener('scroll', look, { passive: true });
    return () => {
      sizes.disconnect();
      element.removeEventListener('scroll', look);
    };
  }, []);
  const { first, last, before, after } = rowsInView(rows.length, rowHeight, view.top, view.height);
  const shown = Array.from(rows.subarray(first, last));
  return (
    <div class="scroller tall" ref={scroller} tabIndex={0} role="region" aria-label={label}>
      <table aria-rowcount={rows.length + 1} aria-label={label}>
        <Head {...props} />
        <tbody>
          {before > 0 && <tr class="gap" style={{ height: `${before}px` }} aria-hidden="true" />}
          {shown.map((row, i) => (
            <tr
              key={rowKey(row)}
              class="opens"
              aria-rowindex={first + i + 2}
              onClick={(event) => {
                if (!(event.target as Element).closest('a')) onOpen(row);
              }}
            >
              {columns.map((column) => (
                <td key={column.key} class={cellClass(column)}>
                  {column.cell(row)}
                </td>
              ))}
            </tr>
          ))}
          {after > 0 && <tr class="gap" style={{ height: `${after}px` }} aria-hidden="true" />}
        </tbody>
      </table>
    </div>
  );
}
