// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import type { SchoolClass } from '#school-class/school-class';

import { ClassBook } from './class-book';
import type { KeptClasses } from './kept-classes';

const named = (name: string): SchoolClass => ({ name, scale: null, pupils: [], tasks: [], results: [] });

/** A book whose browser writes when it is told to. */
function slowBook() {
  const writes: { readonly name: string; readonly end: () => void }[] = [];
  const kept: Pick<KeptClasses, 'read' | 'write' | 'forget'> = {
    read: () => Promise.resolve([]),
    write: (_, schoolClass) =>
      writes.at(-1)?.name === schoolClass.name
        ? Promise.resolve(schoolClass) // it is there already
        : new Promise((resolve) => writes.push({ name: schoolClass.name, end: () => resolve(schoolClass) })),
    forget: () => Promise.resolve(),
  };
  return { book: new ClassBook(kept as KeptClasses), writes };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe('a class that the browser stores', () => {
  it('would be lost with the page until its last change is written', async () => {
    const { book, writes } = slowBook();
    book.add(named('8b'), false);
    void book.keep(true);
    await vi.advanceTimersByTimeAsync(0);
    expect([writes.length, book.isUnsaved.value]).toEqual([1, true]);
    writes[0]!.end();
    await vi.advanceTimersByTimeAsync(0);
    expect(book.isUnsaved.value).toBe(false);

    book.change(() => named('8c'));
    expect(book.isUnsaved.value).toBe(true);
    await vi.advanceTimersByTimeAsync(5_000);
    expect(writes.map(({ name }) => name)).toEqual(['8b', '8c']);
    expect(book.isUnsaved.value).toBe(true);
    writes[1]!.end();
    await vi.advanceTimersByTimeAsync(5_000);
    expect([book.isUnsaved.value, writes.length]).toEqual([false, 2]);
  });
});

describe('a class that is begun before the stored ones have been read', () => {
  it('stays beside them, is the one in sight, and is stored under a key of its own', async () => {
    let arrive: (found: Awaited<ReturnType<KeptClasses['read']>>) => void = () => undefined;
    const written: string[][] = [];
    const book = new ClassBook({
      read: () => new Promise((resolve) => (arrive = resolve)),
      write: (key, schoolClass) => {
        written.push([key, schoolClass.name]);
        return Promise.resolve(schoolClass);
      },
      forget: () => Promise.resolve(),
    } as Pick<KeptClasses, 'read' | 'write' | 'forget'> as KeptClasses);
    book.add(named('new'), false);
    const mine = book.chosen.value?.key ?? '';
    void book.keep(true);
    book.change((now) => ({ ...now, name: 'newer' }));
    await vi.advanceTimersByTimeAsync(1000);
    expect(written).toEqual([]);
    // The stored one may have come from a tab that made the same key.
    arrive([{ key: mine, schoolClass: named('old') }]);
    await vi.advanceTimersByTimeAsync(5000);
    expect(book.classes.value.map(({ schoolClass }) => schoolClass.name)).toEqual(['old', 'newer']);
    expect(book.chosen.value?.schoolClass.name).toBe('newer');
    expect(new Set(book.classes.value.map(({ key }) => key)).size).toBe(2);
    expect(written.filter(([key]) => key === mine).map(([, name]) => name)).not.toContain('newer');
    expect(written.at(-1)?.[1]).toBe('newer');
  });
});

describe('the class that is meant', () => {
  it('is the only one, or the one that was chosen: the first of several is only in sight', () => {
    const { book } = slowBook();
    const stored = ['8a', '8b'].map((name) => ({ key: name, schoolClass: named(name), isKept: true, stored: null, inFile: null })); // prettier-ignore
    book.classes.value = stored.slice(0, 1);
    expect(book.certain.value?.key).toBe('8a');
    book.classes.value = stored;
    expect([book.chosen.value?.key, book.certain.value]).toEqual(['8a', null]);
    book.choose('8b');
    expect([book.chosen.value?.key, book.certain.value?.key]).toEqual(['8b', '8b']);
  });
});
