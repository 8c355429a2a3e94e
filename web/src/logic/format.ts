// Numbers, times and sizes as text for people. Everything takes what a server may send: what is not
// a finite number becomes a dash.

export const dash = '–';

function isNumber(value: unknown): value is number {
  return typeof value === 'number' && Number.isFinite(value);
}

/** "1,204,311" */
export function whole(value: unknown): string {
  return isNumber(value) ? Math.round(value).toLocaleString('en-GB') : dash;
}

/** "812", "12.4 k", "1.20 M", "3.45 G" */
export function short(value: unknown): string {
  if (!isNumber(value)) return dash;
  const size = Math.abs(value);
  if (size < 1) return value === 0 ? '0' : value.toPrecision(2);
  if (size < 1e4) return Math.round(value).toLocaleString('en-GB');
  if (size < 1e6) return `${(value / 1e3).toFixed(1)} k`;
  if (size < 1e9) return `${(value / 1e6).toFixed(2)} M`;
  return `${(value / 1e9).toFixed(2)} G`;
}

/** Of a figure of quality: "11.27", "0.8612", "1.3e-7" */
export function figure(value: unknown): string {
  if (!isNumber(value)) return dash;
  if (Number.isInteger(value)) return whole(value);
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e6) return value.toExponential(2);
  return value.toPrecision(4);
}

/** "39 ms", "0.24 s", "12.3 s", "4 min 05 s", "3 h 04 min", "2 d 03 h" */
export function duration(seconds: unknown): string {
  if (!isNumber(seconds) || seconds < 0) return dash;
  if (seconds === 0) return '0 s';
  if (seconds < 0.0995) return `${Math.max(1, Math.round(1000 * seconds))} ms`;
  if (seconds < 0.995) return `${seconds.toFixed(2)} s`;
  if (seconds < 59.95) return `${seconds.toFixed(1)} s`;
  const s = Math.round(seconds);
  const two = (n: number) => String(n).padStart(2, '0');
  if (s < 3600) return `${Math.floor(s / 60)} min ${two(s % 60)} s`;
  if (s < 86400) return `${Math.floor(s / 3600)} h ${two(Math.floor((s % 3600) / 60))} min`;
  return `${Math.floor(s / 86400)} d ${two(Math.floor((s % 86400) / 3600))} h`;
}

/** "512 B", "84.2 MiB", "1.50 GiB" */
export function bytes(value: unknown): string {
  if (!isNumber(value)) return dash;
  const units = ['B', 'KiB', 'MiB', 'GiB', 'TiB', 'PiB'];
  let size = value;
  let unit = 0;
  while (Math.abs(size) >= 1024 && unit < units.length - 1) {
    size /= 1024;
    ++unit;
  }
  const digits = unit === 0 || size >= 100 ? 0 : size >= 10 ? 1 : 2;
  return `${size.toFixed(digits)} ${units[unit]}`;
}

/** Rounded down, so that only what is done is 100 %. */
export function percent(share: unknown): string {
  if (!isNumber(share)) return dash;
  return `${Math.floor(100 * clampedShare(share) + 1e-9)} %`;
}

export function clampedShare(share: unknown): number {
  return isNumber(share) ? Math.min(1, Math.max(0, share)) : 0;
}

/** "2026-11-30 04:12:31" in the viewer's zone; 0 and nonsense are a dash. */
export function moment(ms: unknown): string {
  if (!isNumber(ms) || ms <= 0 || ms > 8.64e15) return dash;
  const d = new Date(ms);
  const two = (n: number) => String(n).padStart(2, '0');
  const day = `${d.getFullYear()}-${two(d.getMonth() + 1)}-${two(d.getDate())}`;
  return `${day} ${two(d.getHours())}:${two(d.getMinutes())}:${two(d.getSeconds())}`;
}

/** "12 s ago", "4 min ago", "3 h ago", "2 d ago" */
export function ago(ms: unknown, nowMs: number): string {
  if (!isNumber(ms) || ms <= 0) return dash;
  const s = Math.max(0, Math.round((nowMs - ms) / 1000));
  if (s < 60) return `${s} s ago`;
  if (s < 3600) return `${Math.floor(s / 60)} min ago`;
  if (s < 86400) return `${Math.floor(s / 3600)} h ago`;
  return `${Math.floor(s / 86400)} d ago`;
}

/** "1 task", "3 tasks" */
export function counted(count: number, thing: string): string {
  return `${whole(count)} ${thing}${count === 1 ? '' : 's'}`;
}

/** "1.37 × the mean" is `ratio(max, mean)`. */
export function ratio(top: number, bottom: number): string {
  return bottom > 0 && Number.isFinite(top) ? (top / bottom).toFixed(2) : dash;
}
