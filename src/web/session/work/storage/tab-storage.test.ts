import { describe, expect, it } from 'vitest';

import { createTabStorage, renameTab, type TextStore } from './tab-storage';

/** A store like the browser's, with room for `room` characters. */
function store(room = Infinity): TextStore & { readonly all: Map<string, string> } {
  const all = new Map<string, string>();
  return {
    all,
    get length() {
      return all.size;
    },
    key: (index) => [...all.keys()][index] ?? null,
    getItem: (key) => all.get(key) ?? null,
    removeItem: (key) => all.delete(key),
    setItem(key, value) {
      const others = [...all].reduce((sum, [k, v]) => sum + (k === key ? 0 : v.length), 0);
      if (others + value.length > room) throw new Error('quota');
      all.set(key, value);
    },
  };
}

describe('the storage of a tab', () => {
  let count = 0;
  const newName = (): string => `t${String((count += 1)).padStart(4, '0')}`;

  it('gives a reloaded tab its own work back, whatever other tabs did meanwhile', () => {
    const local = store();
    const [first, second] = [store(), store()];
    createTabStorage(first, local, newName).save('mine');
    createTabStorage(second, local, newName).save('theirs');
    expect(createTabStorage(first, local, newName).load()).toBe('mine');
  });

  it('opens a new tab with what was saved last, without touching the other tab’s copy', () => {
    const local = store();
    const first = createTabStorage(store(), local, newName);
    first.save('mine');
    const fresh = createTabStorage(store(), local, newName);
    expect(fresh.load()).toBe('mine');
    fresh.save('changed');
    expect([...local.all.values()]).toContain('mine');
  });

  it('finds the work again after the browser crashed and forgot the session', () => {
    const local = store();
    createTabStorage(store(), local, newName).save('work');
    expect(createTabStorage(store(), local, newName).load()).toBe('work');
  });

  it('keeps the copy of every tab, however many there are', () => {
    const local = store();
    for (let i = 0; i < 9; i += 1) createTabStorage(store(), local, newName).save(`work ${i}`);
    const copies = [...local.all].filter(([key]) => key.startsWith('parcours.copy.')).map(([, text]) => text);
    expect(copies).toEqual(Array.from({ length: 9 }, (_, i) => `work ${i}`));
  });

  it('opens the copy that was saved later', () => {
    const [local, session] = [store(), store()];
    const tab = createTabStorage(session, local, newName);
    tab.save('{"savedMs":7,"version":1}');
    session.setItem('parcours.work', '{"savedMs":5,"version":1}'); // as a browser restores it after a crash
    expect(createTabStorage(session, local, newName).load()).toBe('{"savedMs":7,"version":1}');
  });

  it('gives a duplicated tab a copy of its own', () => {
    const local = store();
    const original = store();
    createTabStorage(original, local, newName).save('one');
    const duplicate = store();
    for (const [key, text] of original.all) duplicate.setItem(key, text);
    renameTab(duplicate, newName);
    createTabStorage(duplicate, local, newName).save('two');
    createTabStorage(original, local, newName).save('one again');
    expect([...local.all.values()]).toEqual(expect.arrayContaining(['one again', 'two']));
  });

  it('says so when there is no room, and gives up no copy of another tab', () => {
    const local = store(120);
    createTabStorage(store(), local, newName).save('a'.repeat(60));
    expect(createTabStorage(store(), local, newName).save('b'.repeat(60))).toBe(false);
    expect([...local.all.values()]).toContain('a'.repeat(60));
  });

  it('works without any storage', () => {
    const none: TextStore = {
      length: 0,
      key: () => null,
      removeItem: () => undefined,
      getItem: () => {
        throw new Error('denied');
      },
      setItem: () => {
        throw new Error('denied');
      },
    };
    const tab = createTabStorage(none, none, newName);
    expect(tab.load()).toBeNull();
    expect(tab.save('x')).toBe(false);
  });
});
