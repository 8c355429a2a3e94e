// Addresses in the browser: links that change the page without loading it anew, and the route that
// is shown.

import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import type { Route } from '../logic/router';
import { routeOf } from '../logic/router';

const listeners = new Set<() => void>();

export function goTo(address: string): void {
  if (address !== window.location.pathname) window.history.pushState(null, '', address);
  for (const listener of listeners) listener();
}

export function useRoute(): Route {
  const [path, set] = useState(window.location.pathname);
  useEffect(() => {
    const changed = () => set(window.location.pathname);
    listeners.add(changed);
    window.addEventListener('popstate', changed);
    return () => {
      listeners.delete(changed);
      window.removeEventListener('popstate', changed);
    };
  }, []);
  return routeOf(path);
}

interface LinkProps {
  to: string;
  class?: string | undefined;
  current?: boolean;
  children: ComponentChildren;
}

export function Link({ to, current, children, class: look }: LinkProps) {
  const follow = (event: MouseEvent) => {
    if (event.button !== 0 || event.metaKey || event.ctrlKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    goTo(to);
  };
  return (
    <a href={to} class={look} onClick={follow} aria-current={current ? 'page' : undefined}>
      {children}
    </a>
  );
}
