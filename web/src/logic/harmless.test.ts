import { describe, expect, it } from 'vitest';
import { harmlessName, harmlessText } from './harmless';

describe('text from outside', () => {
  it('shows control characters and changes of direction instead of obeying them', () => {
    expect(harmlessText('a\u0007b\u202ec\u200f\u2066')).toBe('a\\u0007b\\u202ec\\u200f\\u2066');
    expect(harmlessText('a\u2028b\ufeff')).toBe('a\\u2028b\\ufeff');
  });
  it('keeps line ends and tabs where several lines are wanted, and not in names', () => {
    expect(harmlessText('a\n\tb')).toBe('a\n\tb');
    expect(harmlessName('a\n\tb')).toBe('a\\n\\tb');
  });
  it('keeps letters of all scripts and markup as it is', () => {
    expect(harmlessName('Flügel 翼 جناح <b>')).toBe('Flügel 翼 جناح <b>');
  });
  it('cuts names by characters, not through one', () => {
    expect(harmlessName('😀'.repeat(5), 3)).toBe('😀😀…');
    expect(harmlessName('abc', 3)).toBe('abc');
  });
  it('takes what is not text', () => {
    expect(harmlessName(undefined)).toBe('');
    expect(harmlessName(7)).toBe('7');
  });
});
