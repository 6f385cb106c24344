import { beforeEach, describe, expect, it } from 'vitest';

import { memoryStorage } from '../../../session/work/storage/memory-storage';
import { createOwnBlocks } from './own-blocks';

describe('the teacher’s own sentences', () => {
  let store: Storage;
  beforeEach(() => (store = memoryStorage()));

  it('are there again on the next visit, each once, and nothing is left of the last that goes', () => {
    const own = createOwnBlocks(store);
    for (const text of ['  Prima!  ', 'Nochmals.', 'Prima!', ' ']) own.keep(text);
    expect(createOwnBlocks(store).all.value).toEqual(['Nochmals.', 'Prima!']);
    own.forget('Prima!');
    own.forget('Nochmals.');
    expect(store.length).toBe(0);
  });

  it('are at most twenty, and unreadable ones count as none', () => {
    const own = createOwnBlocks(null);
    for (let number = 0; number < 25; number += 1) own.keep(`Satz ${String(number)}`);
    expect([own.all.value.length, own.all.value[0]]).toEqual([20, 'Satz 5']);
    store.setItem('parcours.blocks', '{"a":');
    expect(createOwnBlocks(store).all.value).toEqual([]);
  });
});
