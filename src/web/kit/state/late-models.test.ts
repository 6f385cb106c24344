import { effectScope, nextTick, shallowRef, watch } from 'vue';
import { describe, expect, it, vi } from 'vitest';

import { LateModels, lateModel } from './late-models';

describe('a model that comes late', () => {
  it('is one for a page, and another one for the next page', () => {
    const model = lateModel(() => shallowRef(0));
    const [page, next] = [{ late: new LateModels() }, { late: new LateModels() }];
    model(page).value = 5;
    expect([model(page).value, model(next).value]).toEqual([5, 0]);
  });

  it('watches until the page is closed, not only as long as the component that asked first', async () => {
    const [source, seen] = [shallowRef(0), vi.fn()];
    const model = lateModel(() => watch(source, (value: number) => seen(value)));
    const scope = effectScope();
    const page = scope.run(() => ({ late: new LateModels() }))!;
    const component = effectScope();
    component.run(() => model(page));
    component.stop();
    source.value = 1;
    await nextTick();
    scope.stop();
    source.value = 2;
    await nextTick();
    expect(seen.mock.calls).toEqual([[1]]);
  });
});
