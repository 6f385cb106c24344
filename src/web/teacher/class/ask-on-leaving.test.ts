// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { shallowRef } from 'vue';

import { ahead } from '#check/testing/tasks';

import { askOnLeaving } from './ask-on-leaving';
import { classWith, program } from './model/testing/class';

/** True if the browser would ask. */
function asks(): boolean {
  const leaving = new Event('beforeunload', { cancelable: true });
  dispatchEvent(leaving);
  return leaving.defaultPrevented;
}

describe('leaving the page of a class', () => {
  it('asks only while notes or results would be lost', async () => {
    const { model } = classWith();
    const isKept = shallowRef(false);
    askOnLeaving(model, { isKept });
    expect(asks()).toBe(false);
    await model.add([program('Ada', ahead(3000))]);
    model.write('Ada', 'gut');
    expect(asks()).toBe(true);
    isKept.value = true;
    expect(asks()).toBe(false);
    isKept.value = false;
    model.noteSaved();
    expect(asks()).toBe(false);
    model.write('Ada', 'sehr gut');
    expect(asks()).toBe(true);
    model.clear();
    expect(asks()).toBe(false);
  });
});
