import { describe, expect, it } from 'vitest';

import { readyPart } from '#editor/parts/ready-parts';
import { createOwnParts, PARTS_KEY, type PartStore } from './own-parts';

/** A browser's storage; `isFull`: it takes nothing more. */
function storage(
  kept: Readonly<Record<string, string>> = {},
): PartStore & { readonly texts: Map<string, string>; isFull: boolean } {
  const texts = new Map(Object.entries(kept));
  return {
    texts,
    isFull: false,
    getItem: (key) => texts.get(key) ?? null,
    setItem(key, text) {
      if (this.isFull) throw new Error('QuotaExceededError');
      texts.set(key, text);
    },
  };
}

const namesIn = (store: PartStore | null): readonly string[] =>
  createOwnParts(store).parts.value.map(({ name }) => name);

describe('own parts', () => {
  it('are there again after a reload, with what is in them', () => {
    const store = storage();
    createOwnParts(store).keep('My bend', readyPart('curve'));
    const [part] = createOwnParts(store).parts.value;
    expect(part).toMatchObject({ name: 'My bend', clip: readyPart('curve') });
  });

  it('get another name, and are taken away and put back in their place', () => {
    const store = storage();
    const own = createOwnParts(store);
    const [one] = ['One', 'Two', 'Three'].map((name) => own.keep(name, readyPart('gap')));
    own.rename(one!.id, 'First');
    const back = own.remove(own.parts.value[1]!.id);
    expect(namesIn(store)).toEqual(['First', 'Three']);
    back();
    expect(namesIn(store)).toEqual(['First', 'Two', 'Three']);
  });

  it('all stay if two tabs have some', () => {
    const store = storage();
    const [one, other] = [createOwnParts(store), createOwnParts(store)];
    one.keep('Of this tab', readyPart('gap'));
    other.keep('Of the other', readyPart('gap'));
    expect(namesIn(store)).toEqual(['Of this tab', 'Of the other']);
    one.look();
    expect(one.parts.value).toHaveLength(2);
  });

  it('are counted and stay as they are stored if they cannot be read', () => {
    const strange = { id: 'own-1', name: 'Of a later version', clip: { format: 'parcours-objects', course: { version: 99 } } }; // prettier-ignore
    const store = storage({ [PARTS_KEY]: JSON.stringify({ version: 1, parts: [strange, 7] }) });
    const own = createOwnParts(store);
    expect([own.parts.value, own.unread.value]).toEqual([[], 2]);
    own.keep('New', readyPart('gap'));
    expect(own.parts.value).toMatchObject([{ id: 'own-2' }]);
    expect(JSON.parse(store.texts.get(PARTS_KEY)!)).toMatchObject({ parts: [strange, 7, { name: 'New' }] });
  });

  it('are begun anew where no list is stored, and what was there is put aside, each time', () => {
    const store = storage({ [PARTS_KEY]: '{"parts": [' });
    const own = createOwnParts(store);
    expect(own.unread.value).toBe(1);
    own.keep('New', readyPart('gap'));
    expect(namesIn(store)).toEqual(['New']);
    expect(store.texts.get(`${PARTS_KEY}.unread-1`)).toBe('{"parts": [');
    store.texts.set(PARTS_KEY, 'nonsense');
    createOwnParts(store).keep('Newer', readyPart('gap'));
    expect(store.texts.get(`${PARTS_KEY}.unread-2`)).toBe('nonsense');
  });

  it('hold as long as the page does where the browser stores nothing, and say so', () => {
    const store = storage();
    const own = createOwnParts(store);
    own.keep('Stored', readyPart('gap'));
    store.isFull = true;
    own.keep('Not stored', readyPart('gap'));
    own.look();
    expect([own.parts.value.length, own.isUnsaved.value, namesIn(store)]).toEqual([2, true, ['Stored']]);
    store.isFull = false;
    own.keep('Third', readyPart('gap'));
    expect([own.isUnsaved.value, namesIn(store)]).toEqual([false, ['Stored', 'Not stored', 'Third']]);
    const none = createOwnParts(null);
    none.keep('Only here', readyPart('gap'));
    expect([none.parts.value.length, none.isUnsaved.value]).toEqual([1, true]);
  });
});
