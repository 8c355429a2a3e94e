import { describe, expect, it } from 'vitest';
import { ago, bytes, counted, duration, figure, percent, ratio, short, whole } from './format';

describe('numbers as text', () => {
  it('show a dash for what is not a finite number', () => {
    for (const form of [whole, short, figure, duration, bytes, percent]) {
      for (const value of [undefined, null, NaN, Infinity, '7', {}]) expect(form(value)).toBe('–');
    }
  });
  it('group digits and shorten large counts', () => {
    expect(whole(1204311)).toBe('1,204,311');
    expect(short(9999)).toBe('9,999');
    expect(short(12_400)).toBe('12.4 k');
    expect(short(1_204_311)).toBe('1.20 M');
    expect(short(3.45e9)).toBe('3.45 G');
    expect(short(0)).toBe('0');
  });
  it('keep four figures of a quality', () => {
    expect(figure(11.274)).toBe('11.27');
    expect(figure(0.00000013)).toBe('1.30e-7');
    expect(figure(12)).toBe('12');
  });
  it('never round a share up to 100 %', () => {
    expect(percent(0.9999)).toBe('99 %');
    expect(percent(1)).toBe('100 %');
    expect(percent(0.29)).toBe('29 %');
    expect(percent(-1)).toBe('0 %');
    expect(percent(7)).toBe('100 %');
  });
});

describe('durations', () => {
  it('carry over to the next unit', () => {
    expect(duration(0)).toBe('0 s');
    expect(duration(0.00001)).toBe('1 ms');
    expect(duration(0.0389)).toBe('39 ms');
    expect(duration(0.0996)).toBe('0.10 s');
    expect(duration(0.996)).toBe('1.0 s');
    expect(duration(59.94)).toBe('59.9 s');
    expect(duration(59.96)).toBe('1 min 00 s');
    expect(duration(3599.6)).toBe('1 h 00 min');
    expect(duration(3600)).toBe('1 h 00 min');
    expect(duration(86400 * 2 + 3 * 3600)).toBe('2 d 03 h');
  });
  it('are not negative', () => {
    expect(duration(-1)).toBe('–');
    expect(ago(2000, 1000)).toBe('0 s ago');
  });
});

describe('sizes and counts', () => {
  it('use binary units', () => {
    expect(bytes(512)).toBe('512 B');
    expect(bytes(1024)).toBe('1.00 KiB');
    expect(bytes(8 * 2 ** 30)).toBe('8.00 GiB');
    expect(bytes(144 * 2 ** 30)).toBe('144 GiB');
  });
  it('say one thing and several', () => {
    expect(counted(1, 'task')).toBe('1 task');
    expect(counted(0, 'task')).toBe('0 tasks');
  });
  it('give no ratio to nothing', () => {
    expect(ratio(3, 2)).toBe('1.50');
    expect(ratio(3, 0)).toBe('–');
  });
});
