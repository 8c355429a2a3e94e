// Text from outside (names, messages, hosts) as it may be shown: control characters and those that
// turn the direction of writing become visible, and what is too long is cut.

const longestName = 300;
const controls =
  /[\u0000-\u0008\u000b\u000c\u000e-\u001f\u007f-\u009f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff]/g;

function visible(character: string): string {
  return `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`;
}

/** Of several lines: line ends and tabs stay. */
export function harmlessText(text: unknown): string {
  if (typeof text !== 'string') return text === undefined || text === null ? '' : String(text);
  return text.replace(controls, visible);
}

/** On one line, at most 300 characters. */
export function harmlessName(text: unknown, longest = longestName): string {
  const line = harmlessText(text).replace(/[\t\r\n]/g, (c) => (c === '\t' ? '\\t' : '\\n'));
  const characters = Array.from(line);
  return characters.length <= longest ? line : `${characters.slice(0, longest - 1).join('')}…`;
}
