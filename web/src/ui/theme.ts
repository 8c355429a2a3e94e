// Dark or light: as the system prefers, or as the viewer chose (kept in localStorage). The root
// element says which in `data-theme`; canvases take their colours from the same style sheet.

export type Choice = 'auto' | 'light' | 'dark';

const key = 'tetfarm-theme';
const media = window.matchMedia('(prefers-color-scheme: dark)');
const listeners = new Set<() => void>();
let palette: Record<string, string> = {};

function stored(): Choice {
  try {
    const value = window.localStorage.getItem(key);
    return value === 'light' || value === 'dark' ? value : 'auto';
  } catch {
    return 'auto';
  }
}

let choice = stored();

function apply(): void {
  const isDark = choice === 'dark' || (choice === 'auto' && media.matches);
  document.documentElement.dataset.theme = isDark ? 'dark' : 'light';
  palette = {};
  for (const listener of listeners) listener();
}

export function startTheme(): void {
  media.addEventListener('change', apply);
  apply();
}

export const themeChoice = (): Choice => choice;

export function chooseTheme(next: Choice): void {
  choice = next;
  try {
    window.localStorage.setItem(key, next);
  } catch {
    // A browser that keeps nothing forgets the choice with the page.
  }
  apply();
}

export function onTheme(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** The value of a custom property of the style sheet, such as `colour('ink')`. */
export function colour(name: string): string {
  return (palette[name] ??= getComputedStyle(document.documentElement)
    .getPropertyValue(`--${name}`)
    .trim());
}

/** For canvases: the page's font. */
export function fontOf(sizePx: number): string {
  return `${sizePx}px ${getComputedStyle(document.body).fontFamily}`;
}
