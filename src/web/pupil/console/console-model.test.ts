import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { ConsoleModel } from './console-model';

const model = () => new ConsoleModel(() => null);
const texts = ({ entries }: ConsoleModel) =>
  entries.value.map((entry) => (entry.kind === 'text' ? entry.text : entry.kind));
const report = { failure: { type: 'ValueError', message: 'no', traceback: '' }, source: null, table: null };

describe('what the console shows', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('gathers output and shows it 50 ms later in one go', () => {
    const console = model();
    console.write('a');
    vi.advanceTimersByTime(49);
    console.write('b\n');
    expect(texts(console)).toEqual([]);
    vi.advanceTimersByTime(1);
    expect(texts(console)).toEqual(['ab\n']);
  });

  it('shows later output 50 ms after it came, not after the first', () => {
    const console = model();
    console.write('a\n');
    vi.advanceTimersByTime(50);
    console.write('b\n');
    expect(texts(console)).toEqual(['a\n']);
    vi.advanceTimersByTime(50);
    expect(texts(console)).toEqual(['a\nb\n']);
  });

  it('leaves the same list in place while nothing comes', () => {
    const console = model();
    console.write('a\n');
    vi.advanceTimersByTime(50);
    const { value } = console.entries;
    vi.advanceTimersByTime(1000);
    expect(console.entries.value).toBe(value);
  });

  it('puts the page’s own words behind the output before them, at once', () => {
    const console = model();
    console.write('a\n');
    console.addNote('console.stopped');
    expect(texts(console)).toEqual(['a\n', 'note']);
    console.write('b\n');
    console.startRun(2);
    expect(texts(console)).toEqual(['a\n', 'note', 'b\n', 'run']);
  });

  it('has news when the program writes or fails, not when the page says something', () => {
    const console = model();
    console.startRun(1);
    console.addNote('console.stopped');
    expect(console.isNew.value).toBe(false);
    console.write('a');
    vi.advanceTimersByTime(50);
    expect(console.isNew.value).toBe(true);
    console.isNew.value = false;
    console.addError(null, report);
    expect(console.isNew.value).toBe(true);
  });

  it('cleared, forgets also what was about to be shown', () => {
    const console = model();
    console.write('a\n');
    vi.advanceTimersByTime(50);
    console.write('b\n');
    console.clear();
    vi.advanceTimersByTime(100);
    expect(texts(console)).toEqual([]);
    expect(console.isNew.value).toBe(false);
    expect(console.toText()).toBe('');
  });

  it('is what the program wrote as text, the latest included, without the page’s own words', () => {
    const console = model();
    console.startRun(1);
    console.write('a\n');
    console.addNote('console.stopped');
    console.write('b');
    expect(console.toText()).toBe('a\nb');
  });
});
